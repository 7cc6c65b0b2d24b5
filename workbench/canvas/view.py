"""The sketch over its photo: shown, and its vertices dragged."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import overlay, style, symbols
from .editing import move_vertex
from .hit_testing import vertex_at
from .marks import marks_of
from .photo_view import PhotoView
from .qt import QtCore, QtGui

if TYPE_CHECKING:
    from ...solver.graph import Point, SketchGraph

_Qt = QtCore.Qt

#: Without a photo, the sketch lies on an empty area at least this large, px.
LEAST_SIZE = (800.0, 600.0)


class SketchView(PhotoView):
    """A photo with a sketch over it.

    Signals
    -------
    graph_edited(object, str)
        A person changed the sketch: the new SketchGraph, and words for the undo list.
    undo_asked(), redo_asked()
        The keys for it were pressed here; the graph itself has no history.
    """

    graph_edited = QtCore.Signal(object, str)
    undo_asked = QtCore.Signal()
    redo_asked = QtCore.Signal()

    def __init__(
        self,
        graph: SketchGraph,
        image: QtGui.QImage | None = None,
        parent: QtGui.QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._hovered: str | None = None
        self._dragged: str | None = None
        self._grip = QtCore.QPointF()
        self.set_graph(graph)
        self.set_photo(image, sketch_size(graph))

    @property
    def graph(self) -> SketchGraph:
        """The graph that is shown, in the middle of a drag too."""
        return self._graph

    def set_graph(self, graph: SketchGraph) -> None:
        """Show another graph; ends a drag that is going on."""
        self._graph = self._before = graph
        self._marks = marks_of(graph)
        self._dragged = None
        if self._hovered not in graph.vertices:
            self._hovered = None
        self.viewport().update()

    def drawForeground(self, painter: QtGui.QPainter, area: QtCore.QRectF) -> None:  # noqa: N802
        """Paint the sketch, in screen px."""
        graph = self._graph
        screen = {v: self._on_screen(point) for v, point in graph.vertices.items()}
        circles = {
            c: symbols.ellipse(
                tuple(map(self._on_screen, drawn.a)), tuple(map(self._on_screen, drawn.b))
            )
            for c, drawn in graph.circles.items()
        }
        painter.save()
        painter.resetTransform()
        scene = overlay.Scene(graph, self._marks, screen, circles, self._hovered)
        overlay.paint(painter, scene)
        painter.restore()

    def _on_screen(self, point_px: Point) -> Point:
        point = self.viewportTransform().map(QtCore.QPointF(*point_px))
        return (point.x(), point.y())

    # Mouse

    def mousePressEvent(self, event: QtGui.QMouseEvent) -> None:  # noqa: N802  Qt's names
        """Take hold of a vertex, or of the photo."""
        super().mousePressEvent(event)
        if event.button() == _Qt.LeftButton and not self.is_panning:
            self._take_hold(event.pos())

    def mouseMoveEvent(self, event: QtGui.QMouseEvent) -> None:  # noqa: N802
        """Pan, drag, or light up what is under the pointer."""
        super().mouseMoveEvent(event)
        if self._dragged is not None:
            self._drag_to(event.pos())
        elif not self.is_panning:
            self._hover(event.pos())

    def mouseReleaseEvent(self, event: QtGui.QMouseEvent) -> None:  # noqa: N802
        """Let go; a vertex that was moved is an edit."""
        super().mouseReleaseEvent(event)
        if self._dragged is not None and event.button() == _Qt.LeftButton:
            self._let_go()

    def cursor_shape(self) -> _Qt.CursorShape:
        """See `PhotoView.cursor_shape`; a vertex can be moved."""
        shape = super().cursor_shape()
        on_vertex = self._hovered is not None and shape == _Qt.ArrowCursor
        return _Qt.SizeAllCursor if on_vertex else shape

    def _vertex_under(self, pos: QtCore.QPoint) -> str | None:
        point = self.mapToScene(pos)
        return vertex_at(self._graph, (point.x(), point.y()), style.REACH_PX / self.zoom)

    def _hover(self, pos: QtCore.QPoint) -> None:
        found = self._vertex_under(pos)
        if found != self._hovered:
            self._hovered = found
            self.show_cursor()
            self.viewport().update()

    def _take_hold(self, pos: QtCore.QPoint) -> None:
        vertex = self._vertex_under(pos)
        if vertex is None:
            return
        self._before = self._graph
        self._dragged = self._hovered = vertex
        # Where in the handle it was taken: without this the vertex would jump to the pointer.
        self._grip = QtCore.QPointF(*self._graph.vertices[vertex]) - self.mapToScene(pos)

    def _drag_to(self, pos: QtCore.QPoint) -> None:
        point = self.mapToScene(pos) + self._grip
        self._graph = move_vertex(self._before, self._dragged, (point.x(), point.y()))
        self.viewport().update()

    def _let_go(self) -> None:
        vertex, self._dragged = self._dragged, None
        if self._graph.vertices[vertex] != self._before.vertices[vertex]:
            self.graph_edited.emit(self._graph, "Move vertex")

    # Keys

    def event(self, event: QtCore.QEvent) -> bool:
        """Claim our keys before FreeCAD's shortcuts: Delete would delete the selected object."""
        if event.type() == QtCore.QEvent.ShortcutOverride and _is_ours(event):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:  # noqa: N802
        """Undo, redo, Escape to give up a drag; else see `PhotoView`."""
        if event.matches(QtGui.QKeySequence.Undo):
            self.undo_asked.emit()
        elif _is_redo(event):
            self.redo_asked.emit()
        elif event.key() == _Qt.Key_Escape and self._dragged is not None:
            self.set_graph(self._before)
        else:
            super().keyPressEvent(event)


def _is_redo(event: QtGui.QKeyEvent) -> bool:
    """The system's own key for it, or Ctrl+Y, which many expect."""
    ctrl_y = event.key() == _Qt.Key_Y and event.modifiers() == _Qt.ControlModifier
    return ctrl_y or event.matches(QtGui.QKeySequence.Redo)


def _is_ours(event: QtGui.QKeyEvent) -> bool:
    if event.matches(QtGui.QKeySequence.Undo) or _is_redo(event):
        return True
    ours = (
        _Qt.Key_Space,
        _Qt.Key_F,
        _Qt.Key_Home,
        _Qt.Key_Escape,
        _Qt.Key_Delete,
        _Qt.Key_Backspace,
    )
    return event.key() in ours and event.modifiers() == _Qt.NoModifier


def sketch_size(graph: SketchGraph) -> tuple[float, float]:
    """The photo's size as the sketch knows it; without a photo, room for the drawing."""
    if graph.photo is not None:
        return (float(graph.photo.width_px), float(graph.photo.height_px))
    us = [u for u, _ in graph.vertices.values()]
    vs = [v for _, v in graph.vertices.values()]
    return (max(us, default=0.0) + 50.0, max(vs, default=0.0) + 50.0) if us else LEAST_SIZE
