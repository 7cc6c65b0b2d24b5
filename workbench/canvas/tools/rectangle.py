"""Rectangles: one drag makes four edges and four right angles."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

import numpy as np

from ....solver.annotations import RightAngle
from ....solver.editing.annotating import annotate, on_ground, toggle_ground
from ....solver.editing.elements import add_edge
from ..perspective import Drag, Lie, on_plane
from ..plane import Point
from ..preview import Preview
from ..snapping import Snap, SnapKind, place, snap
from .base import TwoPointTool

if TYPE_CHECKING:
    from ....solver.graph import SketchGraph
    from ..drawing import Drawing

_HINTS = {
    Lie.LEVEL: "Drag the rectangle: it lies level; press the key again to turn it upright",
    Lie.ALONG_X: "Drag the rectangle: it stands upright; press the key again to turn it",
    Lie.ALONG_Y: "Drag the rectangle: it stands upright; press the key again for any corners",
    Lie.PHOTO: "Drag from one corner of the rectangle to the opposite one; move corners afterwards",
}
#: A place at most this high above the ground, in parts of its distance, is on it.
ON_GROUND = 1e-6


class RectangleTool(TwoPointTool):
    """Draws a rectangle by its diagonal; its corners can be moved afterwards.

    Where the perspective is known, the rectangle follows it: level first, on the ground or at the
    height where it begins, upright when its key is pressed again.
    """

    NAME = "rectangle"
    KEY = "R"
    TITLE = "Rectangle"
    WORDS: ClassVar[str] = "Draw rectangle"
    SQUARE: ClassVar[bool] = False

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._lie = Lie.LEVEL

    @property
    def hint(self) -> str:
        """See `Tool`."""
        if self._start is not None:
            return "Let go, or click, at the opposite corner; Esc to give up"
        known = self.drawing.solved is not None
        return _HINTS[self._lie if known else Lie.PHOTO]

    def again(self) -> None:
        """See `Tool`: turns the rectangle."""
        lies = list(Lie)
        self._lie = lies[(lies.index(self._lie) + 1) % len(lies)]

    def preview(self) -> Preview:
        """See `Tool`."""
        if self._start is None or self._end is None:
            return Preview(snap=self._end)
        corners = self._corners()
        return Preview(strokes=((*corners, corners[0]),), snap=self._end)

    def _corners(self) -> tuple[Point, ...]:
        in_space = self._corners_mm()
        if in_space is not None:
            return self.drawing.solved.on_photo(in_space)
        (u1, v1), (u2, v2) = self._start.point_px, self._end.point_px
        if self.SQUARE:
            side = max(abs(u2 - u1), abs(v2 - v1))
            u2 = u1 + np.copysign(side, u2 - u1)
            v2 = v1 + np.copysign(side, v2 - v1)
        return ((u1, v1), (u2, v1), (u2, v2), (u1, v2))

    def _corners_mm(self) -> np.ndarray | None:
        """The corners in space, where the perspective is known and the rectangle follows it."""
        solved = self.drawing.solved
        camera = None if solved is None else solved.solution.camera
        if camera is None or self._lie is Lie.PHOTO:
            return None
        anchor = solved.solution.vertices_mm.get(self._start.target or "")
        if anchor is None:
            up = np.array([0.0, 0.0, 1.0])
            anchor = on_plane(camera, self._start.point_px, np.zeros(3), up)
        if anchor is None:
            return None
        drag = Drag(camera, anchor, self._end.point_px)
        return drag.corners_mm(self._lie, square=self.SQUARE)

    def _draw(self) -> None:
        corners, in_space, start = self._corners(), self._corners_mm(), self._start
        self._start = None
        if self._is_flat(corners):
            return
        graph = self.drawing.committed
        loop: list[str] = []
        # The corner that was pointed at takes what it sticks to, if it lies there.
        pointed = {corners[0]: start, self._end.point_px: self._end}
        for corner in corners:
            at = next((s for p, s in pointed.items() if self._is_near(p, corner)), None)
            graph, vertex = place(graph, at or self._beside(corner))
            loop.append(vertex)
        if len(set(loop)) < 4:
            return
        graph = self._annotated(graph, loop)
        if in_space is not None and np.abs(in_space[:, 2]).max() <= ON_GROUND * np.ptp(in_space):
            new = [v for v in loop if v not in on_ground(graph)]
            graph = toggle_ground(graph, new) if new else graph
        self.drawing.commit(graph, self.WORDS)

    def _annotated(self, graph: SketchGraph, loop: list[str]) -> SketchGraph:
        """The graph with the rectangle's edges and what is true of them."""
        edges = []
        for v, w in zip(loop, (*loop[1:], loop[0]), strict=True):
            graph, edge = add_edge(graph, v, w)
            edges.append(edge)
        for k, vertex in enumerate(loop):
            graph, _ = annotate(graph, RightAngle(vertex, (edges[k - 1], edges[k])))
        return self._with_more(graph, edges)

    def _with_more(self, graph: SketchGraph, edges: list[str]) -> SketchGraph:
        """What else is true of the edges."""
        return graph

    def _is_flat(self, corners: tuple[Point, ...]) -> bool:
        us, vs = zip(*corners, strict=True)
        return min(max(us) - min(us), max(vs) - min(vs)) < self._reach_px

    def _is_near(self, place_px: Point, corner: Point) -> bool:
        return bool(np.hypot(place_px[0] - corner[0], place_px[1] - corner[1]) < 1e-6)

    def _beside(self, point_px: Point) -> Snap:
        """A corner that nobody pointed at: on a vertex that is there, but splitting no edge."""
        at = snap(self.drawing.committed, point_px, self._reach_px)
        return at if at.kind is SnapKind.VERTEX else Snap(SnapKind.FREE, point_px)
