"""What is painted besides the graph while a tool is at work."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from .selection import NOTHING, Selection

if TYPE_CHECKING:
    from .hit_testing import Corner
    from .plane import Point
    from .snapping import Snap


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
    areas : tuple of loops
        Faces that a press would take.
    guides : tuple of lines
        Fine lines that explain what is meant: an axis, say.
    grips : tuple of positions
        The axis ends of circles, to be pulled.
    """

    lit: Selection = NOTHING
    strokes: tuple[tuple[Point, ...], ...] = ()
    corners: tuple[Corner, ...] = ()
    box: tuple[Point, Point] | None = None
    snap: Snap | None = None
    areas: tuple[tuple[Point, ...], ...] = ()
    guides: tuple[tuple[Point, ...], ...] = ()
    grips: tuple[Point, ...] = ()
