"""Selecting and moving."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from ....solver.editing import rounds
from ....solver.editing.elements import merge_vertices
from .. import style
from ..hit_testing import AxisEnd, axis_end_at, circle_at, edge_at, inside_box, vertex_at
from ..plane import Point, on_line
from ..preview import Preview
from ..questions import Question, about_selection
from ..said import annotation_at, on_photo, seen_at_vertex
from ..selection import Selection
from ..snapping import Snap, SnapKind
from .base import TREMBLE, Pointer, Tool

if TYPE_CHECKING:
    from ..drawing import Drawing


#: A grip stays on its axis up to this many times the reach beside it; further off, the axis turns.
STRAIGHT = 1.5
#: This near, in parts of the reach, a vertex comes before the symbols about it.
ON_IT = 0.6


class SelectTool(Tool):
    """Click, Shift-click or box to select, drag to move, drop on a vertex to merge."""

    NAME = "select"
    KEY = "S"
    TITLE = "Select"
    CROSS = False

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._lit = Selection()
        self._pressed_at: Point | None = None
        self._moved: frozenset[str] = frozenset()
        self._under: Selection = Selection()
        self._box: tuple[Point, Point] | None = None
        self._target: Snap | None = None
        self._led: Snap | None = None
        self._is_drag = False
        self._grip: AxisEnd | None = None
        self._was_chosen = self._is_second = False

    @property
    def hint(self) -> str:
        """See `Tool`."""
        if self.drawing.selection.annotations:
            return "Delete takes back what is said; a second click, or Enter, changes a size"
        if self.drawing.selection:
            return "Drag to move, Shift-click to add, Delete; type a length; right click shows more"
        return "Click or box to select; drag vertices, edges, circles and their grips to move them"

    @property
    def can_move(self) -> bool:
        """See `Tool`."""
        return bool(self._lit) and not self._lit.annotations

    def preview(self) -> Preview:
        """See `Tool`."""
        graph = self.drawing.graph
        gripped = {self._grip[0]} if self._grip is not None else set()
        circles = (self._lit.circles | self.drawing.selection.circles | gripped) & set(
            graph.circles
        )
        grips = [p for c in sorted(circles) for p in (*graph.circles[c].a, *graph.circles[c].b)]
        return Preview(
            lit=self._lit, box=self._box, snap=self._target or self._led, grips=tuple(grips)
        )

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        self._pressed_at, self._is_drag = pointer.point_px, False
        self._is_second = pointer.is_second
        self._under = self._hit(pointer)
        self._was_chosen = self._under == self.drawing.selection
        self._grip = None if self._under.annotations else self._grip_at(pointer)
        self._take(pointer)

    def _take(self, pointer: Pointer) -> None:
        """Select what is under the pointer; where nothing is, begin a box."""
        if not self._under:
            self._box = (pointer.point_px, pointer.point_px)
            return
        chosen = self.drawing.selection
        if pointer.adding:
            self.drawing.select(chosen.toggled(self._under))
        elif not self._under.touches(chosen):
            self.drawing.select(self._under)
        self._moved = self._movable()

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if self._pressed_at is None:
            self._lit = self._hit(pointer)
        elif self._box is not None:
            self._box = (self._pressed_at, pointer.point_px)
        elif self._is_drag or pointer.is_far_from(self._pressed_at, TREMBLE):
            if self._under.annotations and not self._is_drag:
                self._take_below(pointer)
            if self._box is None:
                self._is_drag = True
                self._drag(pointer)

    def _take_below(self, pointer: Pointer) -> None:
        """Take what lies below a symbol, which itself cannot be moved."""
        start = replace(pointer, point_px=self._pressed_at)
        self._under, self._grip = self._element(start), self._grip_at(start)
        self.drawing.select(Selection())
        self._take(start)

    def release(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if self._pressed_at is None:
            return
        if self._box is not None:
            self._take_box(pointer)
        elif self._is_drag:
            self._drop()
        elif not pointer.adding:
            # Pressed on a part of the selection and not dragged: this part was meant.
            self.drawing.select(self._said_there() if self._was_chosen else self._under)
        self._forget()
        self._lit = self._hit(pointer)

    def _said_there(self) -> Selection:
        """What a second click means: what a vertex shows to be said of it; a size, to be typed.

        On an edge or a circle only a double click, which nobody makes by mistake.
        """
        graph = self.drawing.graph
        for vertex in self._under.vertices:
            said = next(seen_at_vertex(graph, vertex), None)
            if said is not None:
                return Selection(annotations=frozenset((said,)))
        if self._under.annotations or self._is_second:
            self.enter()
        return self._under

    def enter(self) -> None:
        """See `Tool`: asks for the size of what is selected."""
        question = self.size_meant()
        if question is not None:
            self.drawing.ask(question)

    def size_meant(self) -> Question | None:
        """See `Tool`: of what is selected."""
        return about_selection(self.drawing.graph, self.drawing.selection)

    def right(self, pointer: Pointer) -> bool:
        """See `Tool`: has a menu, about what is pointed at or what is selected with it."""
        if self._pressed_at is not None:
            return False
        under = self._hit(pointer)
        if not under.touches(self.drawing.selection):
            self.drawing.select(under)
        return True

    def cancel(self) -> bool:
        """See `Tool`."""
        begun = self._pressed_at is not None
        self._forget()
        if begun:
            self.drawing.give_up()
        return begun

    def graph_replaced(self) -> None:
        """See `Tool`."""
        self._forget()
        self._lit = Selection()

    def _forget(self) -> None:
        self._pressed_at = self._box = self._target = self._led = None
        self._is_drag = False
        self._grip = None

    def _hit(self, pointer: Pointer) -> Selection:
        graph, reach = self.drawing.graph, pointer.reach_px
        if vertex_at(graph, pointer.point_px, ON_IT * reach) is None:
            size = reach / style.REACH_PX
            said = annotation_at(on_photo(graph, self.drawing.marks, size), pointer.point_px)
            if said is not None:
                return Selection(annotations=frozenset((said,)))
        return self._element(pointer)

    def _element(self, pointer: Pointer) -> Selection:
        """What is drawn under the pointer, whatever is said there."""
        graph, reach = self.drawing.graph, pointer.reach_px
        vertex = vertex_at(graph, pointer.point_px, reach)
        if vertex is not None:
            return Selection(vertices=frozenset((vertex,)))
        grip = self._grip_at(pointer)
        if grip is not None:
            return Selection(circles=frozenset((grip[0],)))
        edge = edge_at(graph, pointer.point_px, 0.7 * reach)
        if edge is not None:
            return Selection(edges=frozenset((edge,)))
        circle = circle_at(graph, pointer.point_px, 0.7 * reach)
        return Selection() if circle is None else Selection(circles=frozenset((circle,)))

    def _grip_at(self, pointer: Pointer) -> AxisEnd | None:
        """The grip of a circle under the pointer, where no vertex lies on it."""
        graph, reach = self.drawing.graph, pointer.reach_px
        if vertex_at(graph, pointer.point_px, reach) is not None:
            return None
        return axis_end_at(graph, pointer.point_px, reach, graph.circles)

    def _movable(self) -> frozenset[str]:
        """The selected vertices, and those of the selected edges."""
        chosen, edges = self.drawing.selection, self.drawing.graph.edges
        return chosen.vertices | {v for edge in chosen.edges for v in edges[edge]}

    def _drag(self, pointer: Pointer) -> None:
        if self._grip is not None:
            self._pull(pointer, self._grip)
            return
        du = pointer.point_px[0] - self._pressed_at[0]
        dv = pointer.point_px[1] - self._pressed_at[1]
        self.drawing.show(self.drawing.moved((du, dv)))
        self._target = None if pointer.is_free else self._merging(pointer)
        self._led = None
        if self._target is None and not pointer.is_free:
            self._attract(pointer)

    def _attract(self, pointer: Pointer) -> None:
        """Have a single vertex stick to what attracts the pen."""
        if len(self._moved) != 1 or not self._under.vertices or self.drawing.selection.circles:
            return
        (vertex,) = self._moved
        place = self.drawing.graph.vertices[vertex]
        at = self.drawing.attracted(Snap(SnapKind.FREE, place), pointer.reach_px)
        if at.kind is not SnapKind.FREE:
            self._led = at
            before = self.drawing.committed
            self.drawing.show(rounds.move(before, {vertex: at.point_px}, {}))

    def _pull(self, pointer: Pointer, grip: AxisEnd) -> None:
        """Pull an axis end: to a vertex, along its axis, or else anywhere."""
        before, (circle, axis, end) = self.drawing.committed, grip
        drawn, to_px = before.circles[circle], pointer.point_px
        self._target = None
        if not pointer.is_free:
            near = vertex_at(before, to_px, pointer.reach_px)
            along = on_line(to_px, *getattr(drawn, axis))
            if near is not None:
                to_px = before.vertices[near]
                self._target = Snap(SnapKind.VERTEX, to_px, near)
            elif not pointer.is_far_from(along, STRAIGHT):
                to_px = along
        pulled = rounds.pulled(drawn, axis, end, to_px)
        self.drawing.show(rounds.move(before, {}, {circle: pulled}))

    def _merging(self, pointer: Pointer) -> Snap | None:
        """The vertex that a single dragged one would become one with."""
        if len(self._moved) != 1 or not self._under.vertices or self.drawing.selection.circles:
            return None
        (vertex,) = self._moved
        graph = self.drawing.graph
        here = graph.vertices[vertex]
        other = vertex_at(graph, here, 0.7 * pointer.reach_px, self._moved)
        if other is None:
            return None
        return Snap(SnapKind.VERTEX, graph.vertices[other], other)

    def _drop(self) -> None:
        graph, count = self.drawing.graph, len(self._moved)
        if self._grip is not None:
            self.drawing.commit(graph, "Change circle")
        elif self._target is not None:
            (vertex,) = self._moved
            merged = merge_vertices(graph, self._target.target, vertex)
            self.drawing.commit(merged, "Merge vertices")
        else:
            alone = count == 1 and not self.drawing.selection.circles
            self.drawing.commit(graph, "Move vertex" if alone else "Move")

    def _take_box(self, pointer: Pointer) -> None:
        inside = Selection()
        if pointer.is_far_from(self._pressed_at):
            inside = inside_box(self.drawing.graph, self._pressed_at, pointer.point_px)
        chosen = self.drawing.selection
        self.drawing.select(chosen.united(inside) if pointer.adding else inside)
