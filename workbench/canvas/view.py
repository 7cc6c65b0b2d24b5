"""The sketch over its photo: shown, drawn and annotated with the tools."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import chain
from typing import TYPE_CHECKING

from . import context_menu, keys, style
from .drawing import Listener
from .evident import taken
from .extent import sketch_size
from .key_cursor import KeyCursor
from .length_editor import LengthEditor
from .photo_view import ZOOM_STEP, PhotoView
from .qt import QtCore, QtGui, position_of
from .questions import Question
from .scene import Findings
from .selection import Selection
from .sketch_painting import SketchPainting
from .stops import place_of
from .tool_at_work import ToolAtWork
from .tools import KEYS
from .tools.base import Pointer

if TYPE_CHECKING:
    from ...solver.camera import Camera
    from ...solver.graph import Point, SketchGraph
    from .attraction import Attraction
    from .evident import Suggestion
    from .lifted import LiftedView
    from .questions import KnownRectangle
    from .solved import Solved

_Qt = QtCore.Qt


class SketchView(PhotoView):
    """A photo with a sketch over it.

    Signals
    -------
    graph_edited(object, str)
        A person changed the sketch: the new SketchGraph, and words for the undo list.
    undo_asked(), redo_asked()
        The keys for it were pressed here; the graph itself has no history.
    tool_changed(str)
        Another tool is at work: its name.
    hint_changed(str)
        What to do next, in one line.
    graph_shown(object)
        Another SketchGraph is shown, many a second in the middle of a drag.
    selection_changed(object)
        Something else is selected: a Selection.
    helpers_changed()
        Something that helps the hand was switched on or off.
    rectangle_told(object)
        The camera is wanted: a KnownRectangle, or None to look for the printed marker.
    """

    graph_edited = QtCore.Signal(object, str)
    undo_asked = QtCore.Signal()
    redo_asked = QtCore.Signal()
    tool_changed = QtCore.Signal(str)
    hint_changed = QtCore.Signal(str)
    graph_shown = QtCore.Signal(object)
    selection_changed = QtCore.Signal(object)
    helpers_changed = QtCore.Signal()
    rectangle_told = QtCore.Signal(object)

    def __init__(
        self,
        graph: SketchGraph,
        image: QtGui.QImage | None = None,
        parent: QtGui.QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._hint = ""
        self._no_key_yet = False
        self._told: tuple[SketchGraph, Selection] = (graph, Selection())
        listener = Listener(
            self.graph_edited.emit, self._refresh, self._ask, self.rectangle_told.emit
        )
        self._drawing = ToolAtWork(graph, listener)
        self._cursor = KeyCursor(self._drawing)
        #: What is shown with the sketch, and in which language.
        self.painting = SketchPainting(self._drawing, self._cursor)
        self._drawing.attraction.patch = self.grey_around
        self._editor = LengthEditor(self.viewport(), self._drawing.answer)
        self._refresh()
        self.set_photo(image, sketch_size(graph))

    def in_words(self, words: str) -> str:
        """Words in the person's language."""
        return self.painting.in_words(words)

    @property
    def graph(self) -> SketchGraph:
        """The graph that is shown, in the middle of a drag too."""
        return self._drawing.graph

    @property
    def is_in_hand(self) -> bool:
        """Whether what is shown is in the middle of a drag, and not the document's."""
        return self._drawing.graph is not self._drawing.committed

    def set_graph(self, graph: SketchGraph) -> None:
        """Show another graph; ends a drag that is going on."""
        self._drawing.replace_graph(graph)

    def set_findings(self, loose: tuple[str, ...], conflicts: tuple[str, ...]) -> None:
        """Show which vertices are not held yet, and which annotations disagree."""
        self.painting.findings = Findings(frozenset(loose), frozenset(conflicts))
        self.viewport().update()

    def set_lifted(self, lifted: LiftedView) -> None:
        """Show where the lifted shape lies in the photo."""
        self.painting.lifted = lifted
        self.viewport().update()

    @property
    def lifted(self) -> LiftedView:
        """Where the lifted shape lies in the photo."""
        return self.painting.lifted

    def set_rectangle(self, rectangle: KnownRectangle | None) -> None:
        """Take what on the ground tells the camera, to be shown and dragged by its tool."""
        self._drawing.set_rectangle(rectangle)

    def show_camera(self, camera: Camera | None) -> None:
        """Show how the ground would lie with another known camera; None goes back."""
        if camera is None:
            self._drawing.give_up()
        else:
            self._drawing.show(replace(self._drawing.committed, camera=camera))

    def edit(self, graph: SketchGraph, words: str) -> None:
        """Make a graph that was edited elsewhere the document's, as one step to undo."""
        self._drawing.commit(graph, words)

    def go_to(self, id_: str) -> None:
        """Select a vertex, an edge, a circle or an annotation, and bring it into view."""
        one = frozenset((id_,))
        self.select(Selection(one, one, one, one))
        self._bring_into_view(place_of(self.graph, self.selection))
        self.setFocus()

    @property
    def suggestions(self) -> tuple[Suggestion, ...]:
        """What the lift makes evident, for a person to take."""
        return self.painting.ghosts.suggestions

    def set_suggestions(self, suggestions: tuple[Suggestion, ...]) -> None:
        """Show as ghosts what the lift makes evident."""
        self.painting.ghosts.offer(self.graph, suggestions)
        self.viewport().update()

    def take_suggestions(self, suggestions: tuple[Suggestion, ...] | None = None) -> None:
        """Say what was suggested, all of it or some, in one step to undo."""
        chosen = self.suggestions if suggestions is None else suggestions
        committed = self._drawing.committed
        if chosen and self.graph is committed:
            self._drawing.commit(taken(committed, chosen), "Take suggestions")

    @property
    def selection(self) -> Selection:
        """What is selected."""
        return self._drawing.selection

    def select(self, selection: Selection) -> None:
        """Select something else."""
        self._drawing.select(selection)

    @property
    def findings(self) -> Findings:
        """Which vertices are not held yet, and which annotations disagree."""
        return self.painting.findings

    def set_solved(self, solved: Solved | None) -> None:
        """Take the last good solution: for faces, the camera and what is hidden."""
        self._drawing.set_solved(solved)

    def toggle_construction(self) -> None:
        """Make what is selected construction, or part of the object again."""
        self._drawing.toggle_construction()

    def toggle_numbers(self) -> None:
        """Show how many parameters each vertex has, or no longer."""
        self.painting.numbers.toggle()
        self.helpers_changed.emit()
        self.viewport().update()

    def toggle_grid(self) -> None:
        """Show the grid on the ground, and have the pen stick to it, or no longer."""
        attraction = self._drawing.attraction
        attraction.grid_shown = not attraction.grid_shown
        self.helpers_changed.emit()
        self.viewport().update()

    def toggle_photo_edges(self) -> None:
        """Have the photo's straight edges attract the pen, or no longer."""
        attraction = self._drawing.attraction
        attraction.photo_edges = not attraction.photo_edges
        self.helpers_changed.emit()

    @property
    def attraction(self) -> Attraction:
        """What attracts the pen besides the drawing."""
        return self._drawing.attraction

    @property
    def tool_name(self) -> str:
        """The tool at work."""
        return self._drawing.tool.NAME

    @property
    def hint(self) -> str:
        """What to do next, in one line."""
        return self._drawing.tool.hint

    def use_tool(self, name: str) -> None:
        """Take another tool."""
        self._editor.close_unsaid()
        self._cursor.tool_changed()
        self._telling_of_the_tool(lambda: self._drawing.use(name))

    def _refresh(self) -> None:
        """Something to be seen has changed."""
        self.show_cursor()
        self.viewport().update()
        if self._hint != self.hint:
            self._hint = self.hint
            self.hint_changed.emit(self._hint)
        (graph, selection), self._told = self._told, (self.graph, self.selection)
        if graph is not self.graph:
            self.painting.ghosts.follow(self.graph)
            self.graph_shown.emit(self.graph)
        if selection != self.selection:
            self.selection_changed.emit(self.selection)

    def drawForeground(self, painter: QtGui.QPainter, area: QtCore.QRectF) -> None:  # noqa: N802
        """Paint the sketch, in screen px."""
        painter.save()
        painter.resetTransform()
        self.painting.paint(painter, self._way_to_screen())
        painter.restore()

    def _on_screen(self, point_px: Point) -> Point:
        return self._way_to_screen()(point_px)

    def _way_to_screen(self) -> Callable[[Point], Point]:
        """From photo to screen, in plain numbers: a sketch has many points."""
        way = self.viewportTransform()
        zoom, left, top = way.m11(), way.dx(), way.dy()
        return lambda point_px: (zoom * point_px[0] + left, zoom * point_px[1] + top)

    # Mouse

    def mousePressEvent(self, event: QtGui.QMouseEvent) -> None:  # noqa: N802  Qt's names
        """Take hold of the photo, or let the tool work; the right button ends it, or has a menu."""
        super().mousePressEvent(event)
        self._editor.close_unsaid()
        if event.button() == _Qt.LeftButton and not self.is_panning:
            self._press_at(self._pointer(event))
        elif event.button() == _Qt.RightButton and self._drawing.right(self._pointer(event)):
            self._open_menu(self.viewport().mapToGlobal(position_of(event)))

    def _open_menu(self, at: QtCore.QPoint) -> None:
        always = chain(
            context_menu.about_suggestions(self.take_suggestions) if self.suggestions else (),
            context_menu.about_sketch(self._drawing),
            context_menu.about_photo(self.fit),
        )
        parts = (context_menu.about_selection(self._drawing), always)
        context_menu.open_menu(self, parts, self.in_words, at)

    def mouseMoveEvent(self, event: QtGui.QMouseEvent) -> None:  # noqa: N802
        """Pan, or let the tool follow."""
        super().mouseMoveEvent(event)
        self._cursor.hide()
        if not self.is_panning:
            pointer = self._pointer(event)
            self._drawing.move(pointer)
            self._point_at_ghosts(pointer.point_px, is_free=not event.buttons())

    def _press_at(self, pointer: Pointer) -> None:
        """Take the ghost that is pointed at, or let the tool work."""
        if self.painting.ghosts.lit is not None:
            self.take_suggestions((self.painting.ghosts.lit,))
        else:
            self._drawing.press(pointer)

    def mouseReleaseEvent(self, event: QtGui.QMouseEvent) -> None:  # noqa: N802
        """Let go of the photo, or let the tool end."""
        was_panning = self.is_panning
        super().mouseReleaseEvent(event)
        if event.button() == _Qt.LeftButton and not was_panning:
            self._drawing.release(self._pointer(event))

    def _point_at_ghosts(self, place_px: Point | None, *, is_free: bool) -> None:
        """Light the ghost under the pointer; it is there for who selects, and draws nothing."""
        looks = is_free and self.tool_name == "select" and place_px is not None
        # What is nearer is meant: the plus of a short edge lies close to its vertices.
        lit = [self.graph.vertices.get(v) for v in self._drawing.preview.lit.vertices]
        others = [self._on_screen(vertex_px) for vertex_px in lit if vertex_px is not None]
        if self.painting.ghosts.point_at(self._on_screen(place_px) if looks else None, others):
            self._refresh()

    def cursor_shape(self) -> _Qt.CursorShape:
        """See `PhotoView.cursor_shape`; a cross draws, what can be moved says so."""
        shape = super().cursor_shape()
        if shape != _Qt.ArrowCursor:
            return shape
        if self.painting.ghosts.lit is not None:
            return _Qt.PointingHandCursor
        tool = self._drawing.tool
        return _Qt.SizeAllCursor if tool.can_move else _Qt.CrossCursor if tool.CROSS else shape

    def _pointer(self, event: QtGui.QMouseEvent) -> Pointer:
        point = self.mapToScene(position_of(event))
        twice = event.type() == QtCore.QEvent.MouseButtonDblClick
        return replace(self._pointer_at((point.x(), point.y()), event.modifiers()), is_second=twice)

    def _pointer_at(self, place_px: Point, held: _Qt.KeyboardModifiers) -> Pointer:
        free = bool(held & _Qt.ControlModifier)
        adding = free or bool(held & _Qt.ShiftModifier)
        return Pointer(place_px, style.REACH_PX / self.zoom, adding, free)

    # Keys

    def event(self, event: QtCore.QEvent) -> bool:
        """Claim our keys before FreeCAD's shortcuts: Delete would delete the selected object."""
        self._note_first_key(event)
        if event.type() == QtCore.QEvent.ShortcutOverride and (
            keys.meaning(event) or self._sized_by(event)
        ):
            event.accept()
            return True
        if event.type() == QtCore.QEvent.KeyPress and keys.meaning(event) == "next":
            # Else Qt would go on to the next widget.
            self.keyPressEvent(event)
            return True
        return super().event(event)

    def _note_first_key(self, event: QtCore.QEvent) -> None:
        """Take a key whose press was kept from us: Qt took it for the rest of a shortcut."""
        kind = event.type()
        if kind == QtCore.QEvent.FocusIn:
            self._no_key_yet = event.reason() == _Qt.MouseFocusReason
        elif kind in (QtCore.QEvent.ShortcutOverride, QtCore.QEvent.KeyPress):
            self._no_key_yet = False
        elif kind == QtCore.QEvent.KeyRelease and self._no_key_yet and keys.meaning(event):
            self._no_key_yet = False
            self.keyPressEvent(event)

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:  # noqa: N802
        """Do what a key means; for zooming and panning see `PhotoView`."""
        meaning = keys.meaning(event)
        if meaning in KEYS:
            self.use_tool(KEYS[meaning])
            return
        if self._point_by_key(event, meaning):
            return
        question = self._sized_by(event)
        if question is not None:
            self._ask(question, event.text())
            return
        action = {
            "undo": self.undo_asked.emit,
            "redo": self.redo_asked.emit,
            "escape": self._escape,
            "enter": self._drawing.enter,
            "delete": self._drawing.delete,
            "all": self._select_all,
            "paste": self.paste,
            "suggestions": self.take_suggestions,
            "construction": self.toggle_construction,
            "numbers": self.toggle_numbers,
            "grid": self.toggle_grid,
            "photo_edges": self.toggle_photo_edges,
            "zoom_in": lambda: self._zoom_by_key(ZOOM_STEP),
            "zoom_out": lambda: self._zoom_by_key(1 / ZOOM_STEP),
        }.get(meaning)
        if action is None:
            super().keyPressEvent(event)
        else:
            action()

    def _sized_by(self, event: QtGui.QKeyEvent) -> Question | None:
        """Whose size a number means that a key begins; FreeCAD has other uses for these keys."""
        begins = keys.begins_number(event) and not self.is_in_hand
        return self._drawing.tool.size_meant() if begins else None

    def _point_by_key(self, event: QtGui.QKeyEvent, meaning: str) -> bool:
        """Point, push or click by a key, if it means that."""
        push, step = keys.push_of(event), keys.step_of(event)
        pointer = self._pointer_at(self._cursor.place_px or (0.0, 0.0), event.modifiers())
        if push is not None and self.tool_name == "select" and self.selection:
            self._drawing.push((push[0] / self.zoom, push[1] / self.zoom))
        elif step is not None:
            by_px = (step[0] / self.zoom, step[1] / self.zoom)
            # The key that makes the steps fine has another meaning for the pen.
            plain = self._pointer_at(pointer.point_px, _Qt.NoModifier)
            self._bring_into_view(self._cursor.step(by_px, self._hand_px(), plain))
        elif meaning == "next":
            way = -1 if event.key() == _Qt.Key_Backtab else 1
            self._bring_into_view(self._cursor.go_on(way, replace(pointer, adding=False)))
        elif meaning in ("pan", "click") and self._cursor.place_px is not None:
            if not event.isAutoRepeat():
                self._press_at(pointer)
                self._drawing.release(pointer)
        else:
            return False
        self._point_at_ghosts(self._cursor.place_px, is_free=True)
        return True

    def _hand_px(self) -> Point:
        """Where the mouse is in the photo; the middle of the view where it is elsewhere."""
        area, pos = self.viewport().rect(), self.viewport().mapFromGlobal(QtGui.QCursor.pos())
        point = self.mapToScene(pos if area.contains(pos) else area.center())
        return (point.x(), point.y())

    def _bring_into_view(self, place_px: Point | None) -> None:
        if place_px is not None:
            self.ensureVisible(QtCore.QRectF(QtCore.QPointF(*place_px), QtCore.QSizeF(1, 1)))
        self.viewport().update()

    def _zoom_by_key(self, factor: float) -> None:
        """Zoom at the keyboard's cursor, or at the middle."""
        anchor = self.transformationAnchor()
        self.setTransformationAnchor(QtGui.QGraphicsView.AnchorViewCenter)
        self.zoom_by(factor)
        self.setTransformationAnchor(anchor)
        if self._cursor.place_px is not None:
            self.centerOn(QtCore.QPointF(*self._cursor.place_px))

    def _escape(self) -> None:
        self._telling_of_the_tool(self._drawing.escape)

    def _select_all(self) -> None:
        self._telling_of_the_tool(self._drawing.select_all)

    def _telling_of_the_tool(self, action: Callable[[], None]) -> None:
        """Do what may take another tool."""
        before = self.tool_name
        action()
        if self.tool_name != before:
            self.tool_changed.emit(self.tool_name)

    def _ask(self, question: Question, begun: str = "") -> None:
        x, y = self._on_screen(question.at_px)
        self._editor.open(question, QtCore.QPoint(round(x), round(y)), begun)
