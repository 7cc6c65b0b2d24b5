"""Edits of the graph that the canvas offers: a new graph each, the old one stays."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ...solver.graph import Point, SketchGraph

#: Positions are kept to a thousandth of a px: files stay short, nobody can see less.
DECIMALS = 3


def move_vertex(graph: SketchGraph, vertex: str, position_px: Point) -> SketchGraph:
    """The graph with one vertex elsewhere."""
    u, v = position_px
    moved = (round(float(u), DECIMALS), round(float(v), DECIMALS))
    return replace(graph, vertices={**graph.vertices, vertex: moved})
