"""Selecting and moving."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ....solver.editing import merge_vertices, move_vertices
from ..hit_testing import edge_at, inside_box, vertex_at
from ..plane import Point
from ..preview import Preview, Selection
from ..snapping import Snap, SnapKind
from .base import TREMBLE, Pointer, Tool

if TYPE_CHECKING:
    from ..drawing import Drawing


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
        self._is_drag = False

    @property
    def hint(self) -> str:
        """See `Tool`."""
        if self.drawing.selection:
            return "Drag to move, Delete to remove, X for construction; Shift-click adds"
        return "Click or box to select; drag vertices and edges to move them"

    @property
    def can_move(self) -> bool:
        """See `Tool`."""
        return bool(self._lit)

    def preview(self) -> Preview:
        """See `Tool`."""
        return Preview(lit=self._lit, box=self._box, snap=self._target)

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        self._pressed_at, self._is_drag = pointer.point_px, False
        self._under = self._hit(pointer)
        if not self._under:
            self._box = (pointer.point_px, pointer.point_px)
            return
        chosen = self.drawing.selection
        if pointer.adding:
            self.drawing.select(chosen.toggled(self._under))
        elif not (self._under.vertices & chosen.vertices or self._under.edges & chosen.edges):
            self.drawing.select(self._under)
        self._moved = self._movable()

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if self._pressed_at is None:
            self._lit = self._hit(pointer)
        elif self._box is not None:
            self._box = (self._pressed_at, pointer.point_px)
        elif self._is_drag or pointer.is_far_from(self._pressed_at, TREMBLE):
            self._is_drag = True
            self._drag(pointer)

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
            self.drawing.select(self._under)
        self._forget()
        self._lit = self._hit(pointer)

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
        self._pressed_at = self._box = self._target = None
        self._is_drag = False

    def _hit(self, pointer: Pointer) -> Selection:
        graph = self.drawing.graph
        vertex = vertex_at(graph, pointer.point_px, pointer.reach_px)
        if vertex is not None:
            return Selection(vertices=frozenset((vertex,)))
        edge = edge_at(graph, pointer.point_px, 0.7 * pointer.reach_px)
        return Selection() if edge is None else Selection(edges=frozenset((edge,)))

    def _movable(self) -> frozenset[str]:
        """The selected vertices, and those of the selected edges."""
        chosen, edges = self.drawing.selection, self.drawing.graph.edges
        return chosen.vertices | {v for edge in chosen.edges for v in edges[edge]}

    def _drag(self, pointer: Pointer) -> None:
        before = self.drawing.committed
        du = pointer.point_px[0] - self._pressed_at[0]
        dv = pointer.point_px[1] - self._pressed_at[1]
        places = {v: before.vertices[v] for v in self._moved}
        moved = {v: (u + du, w + dv) for v, (u, w) in places.items()}
        self.drawing.show(move_vertices(before, moved))
        self._target = self._merging(pointer)

    def _merging(self, pointer: Pointer) -> Snap | None:
        """The vertex that a single dragged one would become one with."""
        if len(self._moved) != 1 or not self._under.vertices:
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
        if self._target is not None:
            (vertex,) = self._moved
            merged = merge_vertices(graph, self._target.target, vertex)
            self.drawing.commit(merged, "Merge vertices")
        else:
            self.drawing.commit(graph, "Move vertex" if count == 1 else "Move")

    def _take_box(self, pointer: Pointer) -> None:
        inside = Selection()
        if pointer.is_far_from(self._pressed_at):
            inside = inside_box(self.drawing.graph, self._pressed_at, pointer.point_px)
        chosen = self.drawing.selection
        self.drawing.select(chosen.united(inside) if pointer.adding else inside)
