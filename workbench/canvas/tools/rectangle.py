"""Rectangles: one drag makes four edges and four right angles."""

from __future__ import annotations

from ....solver.annotating import annotate
from ....solver.annotations import RightAngle
from ....solver.editing import add_edge
from ..plane import Point
from ..preview import Preview
from ..snapping import Snap, SnapKind, place, snap
from .base import TwoPointTool


class RectangleTool(TwoPointTool):
    """Draws an upright rectangle by its diagonal; its corners can be moved afterwards."""

    NAME = "rectangle"
    KEY = "R"
    TITLE = "Rectangle"

    @property
    def hint(self) -> str:
        """See `Tool`."""
        if self._start is None:
            return "Drag from one corner of the rectangle to the opposite one"
        return "Let go, or click, at the opposite corner; Esc to give up"

    def preview(self) -> Preview:
        """See `Tool`."""
        if self._start is None or self._end is None:
            return Preview(snap=self._end)
        corners = self._corners()
        return Preview(strokes=((*corners, corners[0]),), snap=self._end)

    def _corners(self) -> tuple[Point, Point, Point, Point]:
        (u1, v1), (u2, v2) = self._start.point_px, self._end.point_px
        return ((u1, v1), (u2, v1), (u2, v2), (u1, v2))

    def _draw(self) -> None:
        start, self._start = self._start, None
        (u1, v1), (u2, v2) = start.point_px, self._end.point_px
        if min(abs(u2 - u1), abs(v2 - v1)) < self._reach_px:
            return
        graph = self.drawing.committed
        loop: list[str] = []
        for at in (start, self._beside((u2, v1)), self._end, self._beside((u1, v2))):
            graph, vertex = place(graph, at)
            loop.append(vertex)
        if len(set(loop)) < 4:
            return
        edges = []
        for v, w in zip(loop, (*loop[1:], loop[0]), strict=True):
            graph, edge = add_edge(graph, v, w)
            edges.append(edge)
        for k, vertex in enumerate(loop):
            graph, _ = annotate(graph, RightAngle(vertex, (edges[k - 1], edges[k])))
        self.drawing.commit(graph, "Draw rectangle")

    def _beside(self, point_px: Point) -> Snap:
        """A corner that nobody pointed at: on a vertex that is there, but splitting no edge."""
        at = snap(self.drawing.committed, point_px, self._reach_px)
        return at if at.kind is SnapKind.VERTEX else Snap(SnapKind.FREE, point_px)
