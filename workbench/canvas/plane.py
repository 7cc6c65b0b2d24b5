"""Small plane geometry on photo positions: pure, no Qt."""

from __future__ import annotations

import math
from collections.abc import Sequence

Point = tuple[float, float]


def middle(points: Sequence[Point]) -> Point:
    """The mean of some points."""
    us, vs = zip(*points, strict=True)
    return (sum(us) / len(us), sum(vs) / len(vs))


def foot(point: Point, start: Point, end: Point) -> Point:
    """The place of a segment that is nearest to a point."""
    du, dv = end[0] - start[0], end[1] - start[1]
    square = du * du + dv * dv
    if square == 0:
        return start
    part = ((point[0] - start[0]) * du + (point[1] - start[1]) * dv) / square
    part = max(0.0, min(1.0, part))
    return (start[0] + part * du, start[1] + part * dv)


def on_line(point: Point, start: Point, through: Point) -> Point:
    """The place of the whole line through two others that is nearest to a point."""
    du, dv = through[0] - start[0], through[1] - start[1]
    square = du * du + dv * dv
    if square == 0:
        return start
    part = ((point[0] - start[0]) * du + (point[1] - start[1]) * dv) / square
    return (start[0] + part * du, start[1] + part * dv)


def is_inside(point: Point, polygon: Sequence[Point]) -> bool:
    """Whether a point lies in a polygon, by counting the sides that a ray crosses."""
    inside = False
    for (u1, v1), (u2, v2) in zip(polygon, (*polygon[1:], polygon[0]), strict=True):
        crosses = (v1 > point[1]) != (v2 > point[1])
        if crosses and point[0] < u1 + (point[1] - v1) / (v2 - v1) * (u2 - u1):
            inside = not inside
    return inside


def direction(start: Point, end: Point) -> float:
    """The angle of the way from one point to another, 0 to 2 pi, clockwise as seen."""
    return math.atan2(end[1] - start[1], end[0] - start[0]) % (2 * math.pi)


def line_crossing(a: Point, b: Point, c: Point, d: Point) -> Point | None:
    """Where the whole lines through two pairs of points cross; None where they are parallel."""
    du, dv = b[0] - a[0], b[1] - a[1]
    eu, ev = d[0] - c[0], d[1] - c[1]
    sine = du * ev - dv * eu
    if abs(sine) <= 1e-9 * math.hypot(du, dv) * math.hypot(eu, ev):
        return None
    part = ((c[0] - a[0]) * ev - (c[1] - a[1]) * eu) / sine
    return (a[0] + part * du, a[1] + part * dv)


def crossing(a: Point, b: Point, c: Point, d: Point) -> Point | None:
    """Where two segments cross each other, if they do, their ends not counted."""
    return line_crossing(a, b, c, d) if _cross(a, b, c, d) else None


def cross_themselves(polygon: Sequence[Point]) -> bool:
    """Whether the opposite sides of a quadrilateral cross each other."""
    a, b, c, d = polygon
    return _cross(a, b, c, d) or _cross(b, c, d, a)


def _cross(a: Point, b: Point, c: Point, d: Point) -> bool:
    return _side(a, b, c) * _side(a, b, d) < 0 and _side(c, d, a) * _side(c, d, b) < 0


def _side(a: Point, b: Point, p: Point) -> float:
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
