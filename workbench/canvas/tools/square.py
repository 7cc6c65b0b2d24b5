"""Squares: rectangles with equal sides ([Lau10] 3.1)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ....solver.annotations import EqualLength
from ....solver.editing.annotating import annotate
from .rectangle import RectangleTool

if TYPE_CHECKING:
    from ....solver.graph import SketchGraph


class SquareTool(RectangleTool):
    """Draws a square by its diagonal: four right angles and four equal sides."""

    NAME = "square"
    KEY = "Q"
    TITLE = "Square"
    WORDS = "Draw square"
    SQUARE = True

    def _with_more(self, graph: SketchGraph, edges: list[str]) -> SketchGraph:
        return annotate(graph, EqualLength(tuple(edges)))[0]
