"""Right angles: one corner, or all four of a quadrilateral."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ....solver.annotations import RightAngle
from ....solver.editing.annotating import annotate
from ....solver.editing.elements import delete
from ....solver.graph import SketchGraph
from .. import stops
from ..hit_testing import Corner, corner_at
from ..loops import quad_around
from ..preview import Preview
from .base import Pointer, Tool

if TYPE_CHECKING:
    from ..drawing import Drawing
    from ..plane import Point
    from ..selection import Selection

#: A corner is meant up to this many times the reach from its vertex; further off, a quadrilateral.
CORNER_REACH = 2.5


class RightAngleTool(Tool):
    """Marks right angles ([Lau10] 3.2); where all are marked, takes them back."""

    NAME = "right_angle"
    KEY = "A"
    TITLE = "Right angle"
    WORDS = "Mark right angle"

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._corners: tuple[Corner, ...] = ()

    @property
    def hint(self) -> str:
        """See `Tool`."""
        return "Click an angle near its corner, or inside a quadrilateral for all four"

    @classmethod
    def says(cls, graph: SketchGraph, chosen: Selection) -> SketchGraph | None:
        """See `Tool`: between two edges that meet in a vertex."""
        edges = tuple(sorted(chosen.edges))
        if len(edges) != 2:
            return None
        corner = {*graph.edges[edges[0]]} & {*graph.edges[edges[1]]}
        said = graph if len(corner) != 1 else annotate(graph, RightAngle(*corner, edges))[0]
        return None if said is graph else said

    def stops(self, reach_px: float) -> list[Point]:
        """See `Tool`."""
        graph = self.drawing.graph
        # Off the vertex, inside the angle, and near enough to mean it.
        return [*stops.loops(graph), *stops.corners(graph, reach_px)]

    def preview(self) -> Preview:
        """See `Tool`."""
        return Preview(corners=self._corners)

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        graph = self.drawing.graph
        corner = corner_at(graph, pointer.point_px, CORNER_REACH * pointer.reach_px)
        quad = None if corner else quad_around(graph, pointer.point_px)
        self._corners = (corner,) if corner else quad.angles if quad else ()

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if not self._corners:
            return
        graph = self.drawing.committed
        angles = [_right_angle(graph, corner) for corner in self._corners]
        marked = graph
        for angle in angles:
            marked, _ = annotate(marked, angle)
        if marked is not graph:
            self.drawing.commit(marked, self.WORDS)
        else:
            said = [annotate(graph, angle)[1] for angle in angles]
            self.drawing.commit(delete(graph, annotations=said), "Remove right angle")

    def graph_replaced(self) -> None:
        """See `Tool`."""
        self._corners = ()


def _right_angle(graph: SketchGraph, corner: Corner) -> RightAngle:
    at, along, across = corner
    edges = (graph.edge_between(at, along), graph.edge_between(at, across))
    return RightAngle(at, tuple(edge for edge in edges if edge is not None))
