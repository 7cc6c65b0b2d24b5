"""Surfaces of revolution: three circles, then the side ([Lau10] 3.1, Figure 3)."""

from __future__ import annotations

import math
from itertools import pairwise, takewhile
from typing import TYPE_CHECKING

from ....solver.editing.elements import add_edge
from ....solver.editing.rounds import add_circle, set_revolution
from ..hit_testing import circle_at
from ..plane import Point
from ..preview import Preview
from ..selection import Selection
from ..snapping import Snap, SnapKind, place, snap
from ..symbols import ellipse
from ..turning import axis_line, ring_through
from .base import DRAG, Pointer
from .circle import BoxedTool

if TYPE_CHECKING:
    from ....solver.graph import SketchGraph
    from ..drawing import Drawing

_HINTS = (
    "Drag the circle where it stands on the ground or table, or click one that is drawn",
    "Drag the bottom circle of the new object, or click one that is drawn",
    "Drag the top circle of the new object, or click one that is drawn",
)


class RevolutionTool(BoxedTool):
    """Draws the ground, the bottom and the top circle, then the side from bottom to top.

    The surface is there from the first line of the side on; each further line changes it.
    """

    NAME = "revolution"
    KEY = "V"
    TITLE = "Surface of revolution"

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._circles: tuple[str, ...] = ()
        self._profile: tuple[str, ...] = ()
        self._lit: str | None = None

    @property
    def hint(self) -> str:
        """See `Tool`."""
        if not self._has_circles:
            return _HINTS[len(self._circles)]
        if self._start is None:
            return "Click where the side begins, at the edge of the bottom circle"
        return "Click along the side, up to the edge of the top circle; Enter or right click ends"

    @property
    def _has_circles(self) -> bool:
        return len(self._circles) == 3

    def preview(self) -> Preview:
        """See `Tool`."""
        graph = self.drawing.graph
        chosen = frozenset(c for c in (*self._circles, self._lit) if c in graph.circles)
        lit = Selection(circles=chosen)
        if not self._has_circles:
            shown, drawn = self._shown(), self._ellipse()
            axis = ()
            if len(self._circles) == 2 and drawn is not None:
                axis = (axis_line([*self._ellipses(), drawn]),)
            guides = (*shown.guides, *axis)
            return Preview(lit=lit, strokes=shown.strokes, guides=guides, snap=shown.snap)
        return self._side(graph)

    def _ellipses(self) -> list:
        graph = self.drawing.graph
        return [graph.circles[c] for c in self._circles if c in graph.circles]

    def _side(self, graph: SketchGraph) -> Preview:
        """The axis, and the ring through the pointer."""
        guides = [axis_line(self._ellipses())]
        strokes: tuple[tuple[Point, ...], ...] = ()
        if self._end is not None:
            ring = ring_through(*self._ellipses()[1:], self._end.point_px)
            if ring is not None:
                guides.append(ellipse(ring.a, ring.b))
            if self._start is not None:
                strokes = ((self._start.point_px, self._end.point_px),)
        return Preview(strokes=strokes, guides=tuple(guides), snap=self._end)

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if not self._has_circles:
            super().move(pointer)
            graph, reach = self.drawing.graph, 0.7 * pointer.reach_px
            taken = frozenset(self._circles)
            here = self._start is None and circle_at(graph, pointer.point_px, reach, taken)
            self._lit = here or None
            return
        self._reach_px, self._lit = pointer.reach_px, None
        free = Snap(SnapKind.FREE, pointer.point_px)
        at = snap(self.drawing.committed, pointer.point_px, pointer.reach_px)
        # The side is no line of the drawing: it ends on circles and vertices, and splits nothing.
        is_end = at.kind in (SnapKind.VERTEX, SnapKind.AXIS_END)
        self._end = at if is_end and not pointer.is_free else free

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if self._lit is not None:
            self._take_circle(self._lit)
            self._lit = None
        else:
            super().press(pointer)

    def release(self, pointer: Pointer) -> None:
        """See `Tool`: the side goes on from where a drag of it ended."""
        if not self._has_circles:
            super().release(pointer)
            return
        pressed_at, self._pressed_at = self._pressed_at, None
        if pressed_at is not None and pointer.is_far_from(pressed_at):
            self.move(pointer)
            if self._start is not None:
                self._draw()

    def finish(self) -> None:
        """See `Tool`."""
        self.cancel()

    def cancel(self) -> bool:
        """See `Tool`."""
        begun = super().cancel() or bool(self._circles)
        self._circles, self._profile, self._lit = (), (), None
        return begun

    def graph_replaced(self) -> None:
        """See `Tool`: goes on with what is still there."""
        graph = self.drawing.graph
        there = all(c in graph.circles for c in self._circles)
        sides = pairwise(self._profile)
        if not there or any(
            v not in graph.vertices or w not in graph.vertices or graph.edge_between(v, w) is None
            for v, w in sides
        ):
            self._go_back(graph)

    def _go_back(self, graph: SketchGraph) -> None:
        """Keep the circles and the part of the side that are still there."""
        self._start = self._pressed_at = None
        circles, profile = self._circles, self._profile
        self._circles = tuple(takewhile(graph.circles.__contains__, circles))
        self._profile = ()
        for said in graph.revolutions.values():
            if (said.ground, said.bottom, said.top) == self._circles:
                self._profile = said.profile
        if self._has_circles and self._profile and set(self._profile) <= set(profile):
            last = self._profile[-1]
            self._start = Snap(SnapKind.VERTEX, graph.vertices[last], last)

    def _take_circle(self, circle: str) -> None:
        self._circles = (*self._circles, circle)
        self._start = self._end = None

    def _draw(self) -> None:
        if self._has_circles:
            self._draw_side()
            return
        drawn, self._start = self._ellipse(), None
        if drawn is not None:
            larger, circle = add_circle(self.drawing.committed, drawn)
            self._take_circle(circle)
            self.drawing.commit(larger, "Draw circle")

    def _draw_side(self) -> None:
        start, end = self._start, self._end
        if math.dist(start.point_px, end.point_px) < DRAG * self._reach_px:
            # Twice at one place: done.
            self.cancel()
            return
        graph, v = place(self.drawing.committed, start)
        graph, w = place(graph, end)
        profile = self._profile or (v,)
        if w in profile:
            return
        graph, _ = add_edge(graph, v, w)
        top = self._circles[2]
        self._profile = (*profile, w)
        self._start = Snap(SnapKind.VERTEX, graph.vertices[w], w)
        graph, _ = set_revolution(graph, self._circles, self._profile)
        on_top = graph.vertices[w] in (*graph.circles[top].a, *graph.circles[top].b)
        if on_top:
            self.cancel()
        self.drawing.commit(graph, "Draw side")
