"""What is under the pointer: pure functions on the graph, no Qt.

Terms
-----
reach
    How far from an element the pointer may be, in photo px: the hand's reach divided by the zoom.
corner
    ``(at, along, across)``: a vertex and the other ends of two edges that meet there.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from itertools import pairwise
from typing import TYPE_CHECKING

from .plane import direction, foot
from .selection import Selection
from .symbols import ellipse

if TYPE_CHECKING:
    from ...solver.graph import Point, SketchGraph

Corner = tuple[str, str, str]
#: A circle, its axis "a" or "b", and which end of it, 0 or 1.
AxisEnd = tuple[str, str, int]


def vertex_at(
    graph: SketchGraph, point_px: Point, reach_px: float, but: frozenset[str] = frozenset()
) -> str | None:
    """The vertex nearest to a photo position, if one is within reach.

    Parameters
    ----------
    graph : SketchGraph
    point_px : (u, v)
        Photo position.
    reach_px : float
    but : frozenset of vertex ids
        Not these.
    """
    others = (v for v in graph.vertices if v not in but)
    nearest = min(others, key=lambda v: math.dist(graph.vertices[v], point_px), default=None)
    if nearest is None or math.dist(graph.vertices[nearest], point_px) > reach_px:
        return None
    return nearest


def edge_at(
    graph: SketchGraph, point_px: Point, reach_px: float, but: frozenset[str] = frozenset()
) -> str | None:
    """The edge nearest to a photo position, if one is within reach; `but` as for vertices."""

    def distance(edge: str) -> float:
        return math.dist(point_px, nearest_on(graph, edge, point_px))

    others = (e for e in graph.edges if e not in but)
    nearest = min(others, key=distance, default=None)
    return None if nearest is None or distance(nearest) > reach_px else nearest


def circle_at(
    graph: SketchGraph, point_px: Point, reach_px: float, but: frozenset[str] = frozenset()
) -> str | None:
    """The circle whose outline is nearest to a photo position, if it is within reach."""

    def distance(circle: str) -> float:
        line = ellipse(graph.circles[circle].a, graph.circles[circle].b)
        return min(math.dist(point_px, foot(point_px, p, q)) for p, q in pairwise(line))

    others = (c for c in graph.circles if c not in but)
    nearest = min(others, key=distance, default=None)
    return None if nearest is None or distance(nearest) > reach_px else nearest


def axis_end_at(
    graph: SketchGraph, point_px: Point, reach_px: float, of: Iterable[str]
) -> AxisEnd | None:
    """The axis end of some circles that is nearest to a photo position, if it is within reach."""
    ends = [
        (math.dist(place, point_px), (circle, axis, end))
        for circle in sorted(of)
        for axis in ("a", "b")
        for end, place in enumerate(getattr(graph.circles[circle], axis))
    ]
    distance, nearest = min(ends, default=(math.inf, None))
    return nearest if distance <= reach_px else None


def nearest_on(graph: SketchGraph, edge: str, point_px: Point) -> Point:
    """The place of an edge that is nearest to a photo position."""
    v, w = graph.edges[edge]
    return foot(point_px, graph.vertices[v], graph.vertices[w])


def inside_box(graph: SketchGraph, a: Point, b: Point) -> Selection:
    """The vertices, whole edges and circles in an upright box, by two opposite corners of it."""
    (left, right), (top, bottom) = sorted((a[0], b[0])), sorted((a[1], b[1]))

    def is_in(point_px: Point) -> bool:
        return left <= point_px[0] <= right and top <= point_px[1] <= bottom

    inside = {id_ for id_, place in graph.vertices.items() if is_in(place)}
    edges = {e for e, ends in graph.edges.items() if inside.issuperset(ends)}
    circles = {c for c, drawn in graph.circles.items() if all(map(is_in, (*drawn.a, *drawn.b)))}
    return Selection(frozenset(inside), frozenset(edges), circles=frozenset(circles))


def corner_at(graph: SketchGraph, point_px: Point, reach_px: float) -> Corner | None:
    """The corner that a photo position near a vertex points into, if there is one.

    Of the edges at the vertex these are the two between which the position lies.
    """
    vertex = vertex_at(graph, point_px, reach_px)
    if vertex is None:
        return None
    ends = [w if v == vertex else v for v, w in graph.edges.values() if vertex in (v, w)]
    if len(ends) < 2:
        return None
    here = graph.vertices[vertex]
    pointed = direction(here, point_px)
    turned = sorted(
        ends, key=lambda w: (direction(here, graph.vertices[w]) - pointed) % (2 * math.pi)
    )
    return (vertex, turned[0], turned[-1])
