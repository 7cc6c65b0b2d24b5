"""What is under the pointer: pure functions on the graph, no Qt."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ...solver.graph import Point, SketchGraph


def vertex_at(graph: SketchGraph, point_px: Point, reach_px: float) -> str | None:
    """The vertex nearest to a photo position, if one is within reach.

    Parameters
    ----------
    graph : SketchGraph
    point_px : (u, v)
        Photo position.
    reach_px : float
        In photo px: what is within reach of the hand, divided by the zoom.
    """
    nearest = min(
        graph.vertices, key=lambda v: math.dist(graph.vertices[v], point_px), default=None
    )
    if nearest is None or math.dist(graph.vertices[nearest], point_px) > reach_px:
        return None
    return nearest
