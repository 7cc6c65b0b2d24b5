"""Quadrilaterals of a drawing, which a click in their middle means: pure, no Qt.

Terms
-----
straight vertex
    One where two edges go on in one line: a shelf's corner on the upright that it has split.
side
    The vertices from one corner to the next, both included, straight ones between them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING

from .plane import cross_themselves, is_inside, middle

if TYPE_CHECKING:
    from ...solver.graph import Point, SketchGraph
    from .hit_testing import Corner

Side = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Quad:
    """A quadrilateral by its four sides, each from one corner to the next one."""

    sides: tuple[Side, Side, Side, Side]

    @property
    def corners(self) -> tuple[str, ...]:
        """Its four corners, around."""
        return tuple(side[0] for side in self.sides)

    @property
    def outline(self) -> tuple[str, ...]:
        """All its vertices, around, straight ones too."""
        return tuple(v for side in self.sides for v in side[:-1])

    @property
    def angles(self) -> tuple[Corner, ...]:
        """Its four angles: each corner with the vertices next to it on both sides."""
        return tuple((side[0], self.sides[k - 1][-2], side[1]) for k, side in enumerate(self.sides))


def quads(graph: SketchGraph) -> Iterator[Quad]:
    """All quadrilaterals: four sides around four corners, none across, none crossing."""
    sides = _sides(graph)
    order = {v: k for k, v in enumerate(graph.vertices)}
    for v, around in sides.items():
        for a, b in combinations(sorted(around, key=order.__getitem__), 2):
            for w in sides[a].keys() & sides[b].keys():
                # Each comes up from both of its diagonals, and from both ends: once is enough.
                is_first = order[v] < min(order[w], order[a], order[b])
                across = b in sides[a] or w in sides[v]
                if not is_first or across or cross_themselves(_points(graph, (v, a, w, b))):
                    continue
                quad = Quad((sides[v][a], sides[a][w], sides[w][b], sides[b][v]))
                if len(set(quad.outline)) == len(quad.outline):
                    yield quad


def _points(graph: SketchGraph, loop: tuple[str, ...]) -> list[Point]:
    return [graph.vertices[v] for v in loop]


def _sides(graph: SketchGraph) -> dict[str, dict[str, Side]]:
    """From each vertex the sides to others: its edges, and straight on from there."""
    edges: dict[str, dict[str, str]] = {v: {} for v in graph.vertices}
    for edge, (v, w) in graph.edges.items():
        edges[v][w] = edges[w][v] = edge
    groups = [set(a.edges) for a in graph.annotations_of("parallel").values()]
    return {v: dict(_from(graph, v, edges, groups)) for v in graph.vertices}


def _from(
    graph: SketchGraph,
    start: str,
    edges: Mapping[str, Mapping[str, str]],
    groups: list[set[str]],
) -> Iterator[tuple[str, Side]]:
    # Sides of one edge last: where a longer one ends at the same vertex, the edge counts.
    for first in edges[start]:
        side = [start, first]
        while True:
            *_, before, here = side
            ahead = [
                w
                for w in edges[here]
                if w not in side and _is_straight(graph, (before, here, w), edges, groups)
            ]
            if len(ahead) != 1:
                break
            side.append(ahead[0])
            yield ahead[0], tuple(side)
    for first in edges[start]:
        yield first, (start, first)


def _is_straight(
    graph: SketchGraph,
    three: tuple[str, str, str],
    edges: Mapping[str, Mapping[str, str]],
    groups: list[set[str]],
) -> bool:
    """Whether two edges that meet are said to be parallel, as the halves of a split one are.

    How they look says nothing: edges of two directions often lie in line in the photo.
    """
    before, here, ahead = three
    p, q, r = _points(graph, three)
    goes_on = (q[0] - p[0]) * (r[0] - q[0]) + (q[1] - p[1]) * (r[1] - q[1]) > 0
    pair = {edges[before][here], edges[here][ahead]}
    return goes_on and any(pair <= group for group in groups)


def quad_around(graph: SketchGraph, point_px: Point) -> Quad | None:
    """The quadrilateral that a photo position means: around it, its middle the nearest.

    In a box drawn with its hidden edges every place lies in several; each has a place of its own
    about its middle.
    """

    def distance(quad: Quad) -> float:
        return math.dist(middle(_points(graph, quad.corners)), point_px)

    around = (q for q in quads(graph) if is_inside(point_px, _points(graph, q.outline)))
    return min(around, key=distance, default=None)
