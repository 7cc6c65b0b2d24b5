"""How a surface of revolution looks while it is drawn: its axis and rings; pure, no Qt.

Terms
-----
ring
    The circle that a point of the profile stands for ([Lau10] 3.1), as an ellipse between those of
    the bottom and the top circle. The solve makes it exact; this guides the hand until then.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from ...solver.graph import Ellipse, SketchGraph
from .plane import Point, middle
from .symbols import ellipse


def axis_line(circles: Sequence[Ellipse]) -> tuple[Point, ...]:
    """The rotational axis, through the centres of the circles and a little beyond them."""
    centres = [middle((*drawn.a, *drawn.b)) for drawn in circles]
    first, last = centres[0], max(centres, key=lambda c: math.dist(c, centres[0]))
    du, dv = (0.15 * (last[k] - first[k]) for k in (0, 1))
    return ((first[0] - du, first[1] - dv), (last[0] + du, last[1] + dv))


def ring_through(bottom: Ellipse, top: Ellipse, point_px: Point) -> Ellipse | None:
    """The ring on whose side a point lies; None for a point on the axis.

    Parameters
    ----------
    bottom, top : Ellipse
    point_px : (u, v)
    """
    low, high = (middle((*drawn.a, *drawn.b)) for drawn in (bottom, top))
    du, dv = _unit(bottom.a)
    nu, nv = -dv, du
    # How far up the point is, measured across the circles' long axes.
    height = (high[0] - low[0]) * nu + (high[1] - low[1]) * nv
    part = 0.0
    if abs(height) > 1e-9:
        part = ((point_px[0] - low[0]) * nu + (point_px[1] - low[1]) * nv) / height
    u, v = (low[k] + part * (high[k] - low[k]) for k in (0, 1))
    radius = math.dist((u, v), point_px)
    if radius == 0:
        return None
    flat = _flatness(bottom) + part * (_flatness(top) - _flatness(bottom))
    minor = radius * max(0.0, min(1.0, flat))
    return Ellipse(
        ((u - radius * du, v - radius * dv), (u + radius * du, v + radius * dv)),
        ((u - minor * nu, v - minor * nv), (u + minor * nu, v + minor * nv)),
    )


def _unit(axis: tuple[Point, Point]) -> Point:
    length = math.dist(*axis) or 1.0
    return ((axis[1][0] - axis[0][0]) / length, (axis[1][1] - axis[0][1]) / length)


def _flatness(drawn: Ellipse) -> float:
    return math.dist(*drawn.b) / (math.dist(*drawn.a) or 1.0)


def rings_of(graph: SketchGraph) -> list[tuple[Point, ...]]:
    """The axes of all surfaces of revolution, and the rings between their circles."""
    lines: list[tuple[Point, ...]] = []
    for turned in graph.revolutions.values():
        drawn = [graph.circles[c] for c in (turned.ground, turned.bottom, turned.top)]
        between = [graph.vertices[v] for v in turned.profile[1:-1]]
        rings = [ring_through(*drawn[1:], place) for place in between]
        lines += [ellipse(ring.a, ring.b) for ring in rings if ring is not None]
        lines.append(axis_line(drawn))
    return lines
