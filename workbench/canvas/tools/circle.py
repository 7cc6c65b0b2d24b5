"""Circles: one drag gives the box around the ellipse ([Lau10] 3.1)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ....solver.editing.rounds import add_circle, ellipse_in_box
from ....solver.graph import Ellipse
from ..hit_testing import vertex_at
from ..plane import Point
from ..preview import Preview
from ..questions import Question, about_circle
from ..snapping import Snap, SnapKind
from ..symbols import ellipse
from .base import Pointer, TwoPointTool

if TYPE_CHECKING:
    from ..drawing import Drawing


class BoxedTool(TwoPointTool):
    """Draws an ellipse by the box around it; its axis ends stick to vertices."""

    def move(self, pointer: Pointer) -> None:
        """See `TwoPointTool`: only what the ellipse itself would touch attracts."""
        self._reach_px = pointer.reach_px
        self._end = Snap(SnapKind.FREE, pointer.point_px)
        if self._start is not None and not pointer.is_free:
            self._end = self._touching(pointer)

    def _touching(self, pointer: Pointer) -> Snap:
        """The corner of the box with which an axis end meets a vertex near it."""
        graph, (u, v) = self.drawing.committed, self._start.point_px
        end_u, end_v = pointer.point_px
        beside = vertex_at(graph, (end_u, (v + end_v) / 2), pointer.reach_px)
        if beside is not None:
            at = graph.vertices[beside]
            return Snap(SnapKind.VERTEX, (at[0], 2 * at[1] - v), beside)
        above = vertex_at(graph, ((u + end_u) / 2, end_v), pointer.reach_px)
        if above is not None:
            at = graph.vertices[above]
            return Snap(SnapKind.VERTEX, (2 * at[0] - u, at[1]), above)
        return Snap(SnapKind.FREE, pointer.point_px)

    def _ellipse(self) -> Ellipse | None:
        """The ellipse that would be drawn; None where it has no width or height."""
        if self._start is None or self._end is None:
            return None
        (u1, v1), (u2, v2) = self._start.point_px, self._end.point_px
        if min(abs(u2 - u1), abs(v2 - v1)) < self._reach_px / 2:
            return None
        return ellipse_in_box((u1, v1), (u2, v2))

    def _shown(self) -> Preview:
        """The ellipse with its box, and the vertex that it touches."""
        drawn = self._ellipse()
        if drawn is None:
            return Preview()
        (u1, v1), (u2, v2) = self._start.point_px, self._end.point_px
        box: tuple[Point, ...] = ((u1, v1), (u2, v1), (u2, v2), (u1, v2), (u1, v1))
        touched = None
        if self._end.target in self.drawing.graph.vertices:
            place = self.drawing.graph.vertices[self._end.target]
            touched = Snap(SnapKind.VERTEX, place, self._end.target)
        return Preview(strokes=(ellipse(drawn.a, drawn.b),), guides=(box,), snap=touched)


class CircleTool(BoxedTool):
    """Draws a horizontal circle as the ellipse that it is seen as."""

    NAME = "circle"
    KEY = "C"
    TITLE = "Circle"

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        #: The circle that was drawn last.
        self._drawn = ""

    @property
    def hint(self) -> str:
        """See `Tool`."""
        if self._start is None:
            return "Drag a box around a horizontal circle as it is seen: its ellipse fills the box"
        return "Let go, or click, at the opposite corner of the box; Esc to give up"

    def preview(self) -> Preview:
        """See `Tool`."""
        return self._shown()

    def _draw(self) -> None:
        drawn, self._start = self._ellipse(), None
        if drawn is not None:
            graph, self._drawn = add_circle(self.drawing.committed, drawn)
            self.drawing.commit(graph, "Draw circle")

    def size_meant(self) -> Question | None:
        """See `Tool`: of the circle that was drawn last."""
        graph = self.drawing.graph
        return about_circle(graph, self._drawn) if self._drawn in graph.circles else None
