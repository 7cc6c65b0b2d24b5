"""The shapes of annotation symbols: pure geometry on screen positions, no Qt.

Terms
-----
point
    ``(x, y)`` in screen px.
stroke
    A tuple of points, joined by straight lines.
"""

from __future__ import annotations

import math

Point = tuple[float, float]
Stroke = tuple[Point, ...]


def right_angle(corner: Point, along: Point, across: Point, size_px: float) -> Stroke:
    """The small square in a right angle, in the perspective of its two edges.

    Parameters
    ----------
    corner : point
        Where the edges meet.
    along, across : point
        The edges' other ends.
    size_px : float
        Side of the square; less where an edge is short.
    """
    first, second = (_part(corner, end, size_px) for end in (along, across))
    far = (first[0] + second[0] - corner[0], first[1] + second[1] - corner[1])
    return (first, far, second)


def _part(start: Point, end: Point, size_px: float) -> Point:
    """A point on the way to `end`: `size_px` away, but no further than a third of the way."""
    length = math.dist(start, end)
    part = min(1 / 3, size_px / length) if length > 0 else 0.0
    return (start[0] + part * (end[0] - start[0]), start[1] + part * (end[1] - start[1]))


def ticks(
    start: Point,
    end: Point,
    count: int,
    size_px: float,
    spacing_px: float,
    shift_px: float = 0.0,
) -> list[Stroke]:
    """Short strokes across the middle of an edge: edges with equally many are equally long.

    `shift_px` moves them along the edge, towards the right.
    """
    (dx, dy), middles = _marks(*_rightwards(start, end), count, spacing_px, shift_px)
    half = size_px / 2
    return [((x - half * dy, y + half * dx), (x + half * dy, y - half * dx)) for x, y in middles]


def arrows(
    start: Point,
    end: Point,
    count: int,
    size_px: float,
    spacing_px: float,
    shift_px: float = 0.0,
) -> list[Stroke]:
    """Arrow heads along an edge: edges with equally many are parallel; `shift_px` as for ticks."""
    (dx, dy), middles = _marks(*_rightwards(start, end), count, spacing_px, shift_px)
    half = size_px / 2
    return [
        (
            (x - half * dx - half * dy, y - half * dy + half * dx),
            (x + half * dx, y + half * dy),
            (x - half * dx + half * dy, y - half * dy - half * dx),
        )
        for x, y in middles
    ]


def _rightwards(start: Point, end: Point) -> tuple[Point, Point]:
    """The edge turned so that all arrows of parallel edges point the same way on the screen."""
    return (start, end) if (start[0], start[1]) <= (end[0], end[1]) else (end, start)


def _marks(
    start: Point, end: Point, count: int, spacing_px: float, shift_px: float = 0.0
) -> tuple[Point, list[Point]]:
    """The edge's direction, and `count` places about its middle."""
    length = math.dist(start, end) or 1.0
    dx, dy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    offsets = [shift_px + (k - (count - 1) / 2) * spacing_px for k in range(count)]
    return (dx, dy), [(middle[0] + o * dx, middle[1] + o * dy) for o in offsets]


def beside(start: Point, end: Point, centre: Point, size: Point, distance_px: float) -> Point:
    """Where a label goes: beside the middle of an edge, on the side away from `centre`.

    Parameters
    ----------
    start, end : point
        The edge.
    centre : point
        The middle of the drawing.
    size : (width, height)
        Of the label, px.
    distance_px : float
        Between edge and label.

    Returns
    -------
    point
        The label's middle.
    """
    (dx, dy), [(x, y)] = _marks(start, end, 1, 0.0)
    side = 1.0 if (x - centre[0]) * -dy + (y - centre[1]) * dx >= 0 else -1.0
    away = side * (distance_px + (abs(dy) * size[0] + abs(dx) * size[1]) / 2)
    return (x - away * dy, y + away * dx)


def ground(place: Point, size_px: float) -> list[Stroke]:
    """A line with slanted ones below it: the ground, as engineers draw it.

    Parameters
    ----------
    place : point
        The middle of the line.
    size_px : float
        Its length.
    """
    (x, y), half = place, size_px / 2
    slant = 0.4 * half, 0.5 * half
    starts = [x + k * half for k in (-0.6, 0.1, 0.8)]
    slants = [((start, y), (start - slant[0], y + slant[1])) for start in starts]
    return [((x - half, y), (x + half, y)), *slants]


def diamond(place: Point, size_px: float) -> Stroke:
    """A small diamond about a place."""
    (x, y), r = place, size_px
    return ((x - r, y), (x, y - r), (x + r, y), (x, y + r), (x - r, y))


def ellipse(a: tuple[Point, Point], b: tuple[Point, Point], corners: int = 72) -> Stroke:
    """An ellipse as a closed stroke, from antipodal points on its two axes."""
    x, y = (a[0][0] + a[1][0]) / 2, (a[0][1] + a[1][1]) / 2
    (ax, ay), (bx, by) = (((q[0] - p[0]) / 2, (q[1] - p[1]) / 2) for p, q in (a, b))
    angles = [2 * math.pi * k / corners for k in range(corners + 1)]
    return tuple(
        (x + ax * math.cos(t) + bx * math.sin(t), y + ay * math.cos(t) + by * math.sin(t))
        for t in angles
    )
