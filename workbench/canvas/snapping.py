"""Where a press lands: on a vertex, an edge or its middle near the pointer. Pure, no Qt."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

from ...solver.editing import add_vertex, split_edge
from .hit_testing import edge_at, nearest_on, vertex_at
from .plane import middle

if TYPE_CHECKING:
    from ...solver.graph import Point, SketchGraph


class SnapKind(Enum):
    """What a position sticks to."""

    FREE = "free"
    VERTEX = "vertex"
    EDGE = "edge"
    MIDPOINT = "midpoint"


@dataclass(frozen=True, slots=True)
class Snap:
    """A position, and the element that it sticks to."""

    kind: SnapKind
    point_px: Point
    target: str | None = None


def snap(
    graph: SketchGraph, point_px: Point, reach_px: float, but: frozenset[str] = frozenset()
) -> Snap:
    """What a photo position sticks to: vertices before midpoints before edges.

    Parameters
    ----------
    graph : SketchGraph
    point_px : (u, v)
    reach_px : float
        In photo px.
    but : frozenset of ids
        Vertices and edges that attract nothing.
    """
    vertex = vertex_at(graph, point_px, reach_px, but)
    if vertex is not None:
        return Snap(SnapKind.VERTEX, graph.vertices[vertex], vertex)
    edge = edge_at(graph, point_px, reach_px, but)
    if edge is None:
        return Snap(SnapKind.FREE, point_px)
    halfway = middle([graph.vertices[v] for v in graph.edges[edge]])
    if math.dist(halfway, point_px) <= reach_px:
        return Snap(SnapKind.MIDPOINT, halfway, edge)
    return Snap(SnapKind.EDGE, nearest_on(graph, edge, point_px), edge)


def place(graph: SketchGraph, at: Snap) -> tuple[SketchGraph, str]:
    """The graph with a vertex where a snap is, and its id: the one there, or a new one.

    A new one on an edge splits it. What the snap stuck to may be gone by now.
    """
    if at.kind is SnapKind.VERTEX and at.target in graph.vertices:
        return graph, at.target
    if at.kind in (SnapKind.EDGE, SnapKind.MIDPOINT) and at.target in graph.edges:
        return split_edge(graph, at.target, at.point_px)
    return add_vertex(graph, at.point_px)
