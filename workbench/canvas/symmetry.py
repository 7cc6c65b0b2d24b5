"""Which edges a symmetry plane probably halves ([Lau10] 3.2, Figure 6): pure, no Qt."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .plane import Point, middle

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ...solver.graph import SketchGraph
    from .solved import Solved

#: Edges whose slopes in the photo differ by less than this are similar.
SIMILAR_RAD = math.radians(12.0)
#: In space, middles this near to the plane (in parts of the object's size) lie in it.
NEAR = 0.02
#: And edges that lean from its normal by less than this (sine) cross it at right angles.
SQUARE = 0.03


def midpoint_px(graph: SketchGraph, edge: str) -> Point:
    """The middle of an edge."""
    return middle([graph.vertices[v] for v in graph.edges[edge]])


def midpoint_at(graph: SketchGraph, point_px: Point, reach_px: float) -> str | None:
    """The edge whose middle is nearest to a photo position, if it is within reach."""

    def distance(edge: str) -> float:
        return math.dist(midpoint_px(graph, edge), point_px)

    nearest = min(graph.edges, key=distance, default=None)
    return None if nearest is None or distance(nearest) > reach_px else nearest


def halved_with(graph: SketchGraph, edge: str, solved: Solved | None) -> tuple[str, ...]:
    """The edges whose middles suggest one symmetry plane with an edge's, this one first.

    Once the sketch is solved, those that the plane halves at right angles; before, those of
    similar slope in the photo.
    """
    lifted = set() if solved is None else set(solved.solution.edges)
    if edge in lifted:
        others = _halved_in_space(solved, edge, [e for e in graph.edges if e in lifted])
    else:
        slope = _slope(graph, edge)
        others = [e for e in graph.edges if _between(_slope(graph, e), slope) < SIMILAR_RAD]
    return (edge, *(e for e in others if e != edge))


def _slope(graph: SketchGraph, edge: str) -> float:
    (u1, v1), (u2, v2) = (graph.vertices[v] for v in graph.edges[edge])
    return math.atan2(v2 - v1, u2 - u1) % math.pi


def _between(a: float, b: float) -> float:
    """The angle between two lines, given by their slopes."""
    difference = abs(a - b) % math.pi
    return min(difference, math.pi - difference)


def _halved_in_space(solved: Solved, edge: str, edges: Iterable[str]) -> list[str]:
    at = solved.solution.vertices_mm
    ends = {e: [at[v] for v in solved.solution.edges[e]] for e in edges}
    p, q = ends[edge]
    normal = (q - p) / max(float(np.linalg.norm(q - p)), 1e-300)
    size = float(np.ptp(np.array(list(at.values())), axis=0).max())
    found = []
    for e, (a, b) in ends.items():
        along = (b - a) / max(float(np.linalg.norm(b - a)), 1e-300)
        off = abs(float(((a + b) / 2 - (p + q) / 2) @ normal))
        lean = float(np.linalg.norm(along - (along @ normal) * normal))
        if off <= NEAR * size and lean <= SQUARE:
            found.append(e)
    return found


def outline_of(points: Iterable[Point]) -> tuple[Point, ...]:
    """The line that shows a plane through some points: around them, closed; straight for two."""
    points = sorted(set(points))
    if len(points) < 3:
        return tuple(points)
    lower, upper = _half_hull(points), _half_hull(points[::-1])
    return (*lower[:-1], *upper[:-1], lower[0])


def _half_hull(points: list[Point]) -> list[Point]:
    """One side of the convex hull (Andrew's monotone chain)."""
    hull: list[Point] = []
    for p in points:
        while len(hull) > 1:
            (au, av), (bu, bv) = hull[-2], hull[-1]
            if (bu - au) * (p[1] - av) - (bv - av) * (p[0] - au) > 0:
                break
            hull.pop()
        hull.append(p)
    return hull
