"""Boxes: the seven corners that are seen of one give the eighth, and all that is true of it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ....solver.annotations import Parallel, RightAngle
from ....solver.editing.annotating import annotate, on_ground, toggle_ground
from ....solver.editing.elements import add_edge
from ..plane import Point, line_crossing
from ..preview import Preview
from ..selection import Selection
from ..snapping import Snap, SnapKind, place
from .base import Pointer, Tool

if TYPE_CHECKING:
    from ....solver.graph import SketchGraph
    from ..drawing import Drawing

#: In the order of the clicks; the last one is hidden.
LEFT, FRONT, RIGHT, TOP_RIGHT, TOP_FRONT, TOP_LEFT, TOP_BACK, BACK = range(8)
_UP = ((FRONT, TOP_FRONT), (LEFT, TOP_LEFT), (RIGHT, TOP_RIGHT), (BACK, TOP_BACK))
_TO_LEFT = ((FRONT, LEFT), (RIGHT, BACK), (TOP_FRONT, TOP_LEFT), (TOP_RIGHT, TOP_BACK))
_TO_RIGHT = ((FRONT, RIGHT), (LEFT, BACK), (TOP_FRONT, TOP_RIGHT), (TOP_LEFT, TOP_BACK))


class BoxTool(Tool):
    """Traces a box that stands in the photo, or draws a new one: a click on each corner seen."""

    NAME = "box"
    KEY = "B"
    TITLE = "Box"

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._corners: tuple[Snap, ...] = ()
        self._at: Snap | None = None
        self._reach_px = 0.0

    @property
    def hint(self) -> str:
        """See `Tool`."""
        return (
            "Click the box's left corner on the ground",
            "Click the front corner on the ground",
            "Click the right corner on the ground",
            "Click the corner above the right one",
            "Click the corner above the front one",
            "Click the corner above the left one",
            "Click the upper corner at the back; X then makes the box construction",
        )[len(self._corners)]

    def preview(self) -> Preview:
        """See `Tool`."""
        places = [corner.point_px for corner in self._corners]
        if self._at is not None:
            places.append(self._at.point_px)
        there = range(len(places))
        lines = (*_UP, *_TO_LEFT, *_TO_RIGHT)
        drawn = tuple((places[a], places[b]) for a, b in lines if a in there and b in there)
        return Preview(strokes=drawn, snap=self._at)

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        self._reach_px = pointer.reach_px
        self._at = self.snap(pointer)

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if any(not pointer.is_far_from(corner.point_px) for corner in self._corners):
            # Twice at one place is a slip.
            return
        self._corners = (*self._corners, self._at)
        if len(self._corners) == TOP_BACK + 1:
            corners, self._corners = self._corners, ()
            self._draw(corners)

    def _draw(self, corners: tuple[Snap, ...]) -> None:
        hidden = hidden_corner([corner.point_px for corner in corners])
        if hidden is None:
            return
        graph, loop = self.drawing.committed, []
        for corner in (*corners, Snap(SnapKind.FREE, hidden)):
            graph, vertex = place(graph, corner)
            loop.append(vertex)
        if len(set(loop)) < 8:
            return
        graph, edges = _boxed(graph, loop)
        self.drawing.commit(graph, "Draw box")
        self.drawing.select(Selection(edges=frozenset(edges)))

    def cancel(self) -> bool:
        """See `Tool`."""
        begun, self._corners = bool(self._corners), ()
        return begun

    def finish(self) -> None:
        """See `Tool`."""
        self.cancel()


def hidden_corner(seen: Sequence[Point]) -> Point | None:
    """The place of the eighth corner, where the edges from its neighbours meet in perspective.

    Parameters
    ----------
    seen : sequence of (u, v)
        The other corners, in the order of the clicks.
    """
    from_left = _towards(seen[LEFT], (seen[FRONT], seen[RIGHT]), (seen[TOP_LEFT], seen[TOP_BACK]))
    from_right = _towards(seen[RIGHT], (seen[FRONT], seen[LEFT]), (seen[TOP_RIGHT], seen[TOP_BACK]))
    return line_crossing(seen[LEFT], from_left, seen[RIGHT], from_right)


def _towards(start: Point, line: tuple[Point, Point], other: tuple[Point, Point]) -> Point:
    """A second point of the line from a place to where two others vanish."""
    vanishing = line_crossing(*line, *other)
    if vanishing is not None:
        return vanishing
    return (start[0] + line[1][0] - line[0][0], start[1] + line[1][1] - line[0][1])


def _boxed(graph: SketchGraph, corners: list[str]) -> tuple[SketchGraph, list[str]]:
    """The graph with a box's edges and what is true of it, and the edges."""
    groups: list[list[str]] = []
    for lines in (_UP, _TO_LEFT, _TO_RIGHT):
        groups.append([])
        for a, b in lines:
            graph, edge = add_edge(graph, corners[a], corners[b])
            groups[-1].append(edge)
        graph, _ = annotate(graph, Parallel(tuple(groups[-1])))
    up, left, right = (group[0] for group in groups)
    for pair in ((up, left), (up, right), (left, right)):
        graph, _ = annotate(graph, RightAngle(corners[FRONT], pair))
    stands = [corners[k] for k in (LEFT, FRONT, RIGHT, BACK)]
    new = [v for v in stands if v not in on_ground(graph)]
    graph = toggle_ground(graph, new) if new else graph
    return graph, [edge for group in groups for edge in group]
