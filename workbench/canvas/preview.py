"""What is painted besides the graph while a tool is at work."""

from __future__ import annotations

from dataclasses import dataclass

from .hit_testing import Corner
from .plane import Point
from .snapping import Snap


@dataclass(frozen=True, slots=True)
class Selection:
    """Vertices and edges that are selected."""

    vertices: frozenset[str] = frozenset()
    edges: frozenset[str] = frozenset()

    def __bool__(self) -> bool:
        return bool(self.vertices or self.edges)

    def toggled(self, other: Selection) -> Selection:
        """With what is in one of the two, without what is in both."""
        return Selection(self.vertices ^ other.vertices, self.edges ^ other.edges)

    def united(self, other: Selection) -> Selection:
        """With what is in either of the two."""
        return Selection(self.vertices | other.vertices, self.edges | other.edges)


@dataclass(frozen=True, slots=True)
class Preview:
    """What a tool shows; positions in photo px.

    Parameters
    ----------
    lit : Selection
        What a press would take.
    strokes : tuple of lines
        What a press or letting go would draw.
    corners : tuple of Corner
        Right angles that a press would mark.
    box : two opposite corners, or None
        The box that is drawn to select.
    snap : Snap or None
        Where a press would land.
    """

    lit: Selection = Selection()
    strokes: tuple[tuple[Point, ...], ...] = ()
    corners: tuple[Corner, ...] = ()
    box: tuple[Point, Point] | None = None
    snap: Snap | None = None
