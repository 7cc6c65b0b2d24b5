"""What a click probably means: pure functions on the graph, no Qt."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from .plane import cross_themselves, is_inside, middle

if TYPE_CHECKING:
    from ...solver.graph import Point, SketchGraph
    from .hit_testing import Corner

Quad = tuple[str, str, str, str]


def quads(graph: SketchGraph) -> Iterator[Quad]:
    """All quadrilaterals: four edges around four vertices, no edge across, no sides crossing."""
    neighbours: dict[str, set[str]] = {v: set() for v in graph.vertices}
    for v, w in graph.edges.values():
        neighbours[v].add(w)
        neighbours[w].add(v)
    order = {v: k for k, v in enumerate(graph.vertices)}
    for v, around in neighbours.items():
        for a, b in combinations(sorted(around, key=order.__getitem__), 2):
            for w in neighbours[a] & neighbours[b]:
                # Each comes up from both of its diagonals, and from both ends: once is enough.
                is_first = order[v] < min(order[w], order[a], order[b])
                across = b in neighbours[a] or w in neighbours[v]
                quad = (v, a, w, b)
                if is_first and not across and not cross_themselves(_points(graph, quad)):
                    yield quad


def _points(graph: SketchGraph, loop: tuple[str, ...]) -> list[Point]:
    return [graph.vertices[v] for v in loop]


def quad_around(graph: SketchGraph, point_px: Point) -> Quad | None:
    """The quadrilateral that a photo position means: around it, its middle the nearest.

    In a box drawn with its hidden edges every place lies in several; each has a place of its own
    about its middle.
    """

    def distance(quad: Quad) -> float:
        return math.dist(middle(_points(graph, quad)), point_px)

    around = (quad for quad in quads(graph) if is_inside(point_px, _points(graph, quad)))
    return min(around, key=distance, default=None)


def corners_of(quad: Quad) -> tuple[Corner, ...]:
    """The four corners of a quadrilateral."""
    return tuple((quad[k], quad[k - 1], quad[(k + 1) % 4]) for k in range(4))
