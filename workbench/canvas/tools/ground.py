"""What stands on the ground."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ....solver.editing.annotating import on_ground, toggle_ground
from .. import stops
from ..hit_testing import edge_at, inside_box, vertex_at
from ..loops import quad_around
from ..plane import Point
from ..preview import Preview
from ..selection import Selection
from .base import Pointer, Tool

if TYPE_CHECKING:
    from ....solver.graph import SketchGraph
    from ..drawing import Drawing


class GroundTool(Tool):
    """Puts vertices on the ground and takes them off it: by click, box, edge or whole loop."""

    NAME = "ground"
    KEY = "G"
    TITLE = "Ground"
    WORDS = "Mark ground"

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._lit: frozenset[str] = frozenset()
        self._pressed_at: Point | None = None
        self._box: tuple[Point, Point] | None = None

    @property
    def hint(self) -> str:
        """See `Tool`."""
        return "Click what stands on the ground: vertices, edges, the middle of a face; or box them"

    @classmethod
    def says(cls, graph: SketchGraph, chosen: Selection) -> SketchGraph | None:
        """See `Tool`: all vertices, and those of the edges, stand on it."""
        if len(chosen.vertices) + len(chosen.edges) < 2:
            return None
        named = chosen.vertices.union(*(graph.edges[e] for e in chosen.edges))
        new = sorted(named - on_ground(graph))
        return toggle_ground(graph, new) if new else None

    def stops(self, reach_px: float) -> list[Point]:
        """See `Tool`."""
        graph = self.drawing.graph
        return [*stops.loops(graph), *stops.vertices(graph)]

    def preview(self) -> Preview:
        """See `Tool`."""
        return Preview(lit=Selection(vertices=self._lit), box=self._box)

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        # A press while a box is drawn: its release was lost, and this one's ends it.
        if self._pressed_at is None:
            self._pressed_at = pointer.point_px

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        graph = self.drawing.graph
        if self._pressed_at is None:
            self._lit = self._meant(pointer)
        elif self._box is not None or pointer.is_far_from(self._pressed_at):
            self._box = (self._pressed_at, pointer.point_px)
            self._lit = inside_box(graph, *self._box).vertices

    def _meant(self, pointer: Pointer) -> frozenset[str]:
        """The vertices of what is under the pointer."""
        graph, reach = self.drawing.graph, pointer.reach_px
        vertex = vertex_at(graph, pointer.point_px, 1.5 * reach)
        if vertex is not None:
            return frozenset((vertex,))
        edge = edge_at(graph, pointer.point_px, 0.7 * reach)
        if edge is not None:
            return frozenset(graph.edges[edge])
        quad = quad_around(graph, pointer.point_px)
        return frozenset() if quad is None else frozenset(quad.outline)

    def release(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if self._pressed_at is None:
            return
        self.move(pointer)
        chosen = sorted(self._lit & set(self.drawing.committed.vertices))
        self.cancel()
        if chosen:
            self.drawing.commit(toggle_ground(self.drawing.committed, chosen), self.WORDS)

    def cancel(self) -> bool:
        """See `Tool`."""
        begun = self._pressed_at is not None
        self._pressed_at = self._box = None
        self._lit = frozenset()
        return begun
