"""How long an edge is, how wide a circle."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import stops
from ..hit_testing import circle_at, edge_at
from ..preview import Preview
from ..questions import Question, about_circle, about_edge, about_selection
from ..selection import Selection
from .base import Pointer, Tool

if TYPE_CHECKING:
    from ..drawing import Drawing
    from ..plane import Point


class LengthTool(Tool):
    """Asks for the length of the edge, or the diameter of the circle, that is clicked."""

    NAME = "length"
    KEY = "D"
    TITLE = "Length, diameter"

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._lit = Selection()

    @property
    def hint(self) -> str:
        """See `Tool`."""
        return "Click an edge or a circle and type its size (21 cm, 2*18 mm + 5); empty removes it"

    def begin_with(self, chosen: Selection) -> None:
        """See `Tool`: asks for the size of the one thing that was selected."""
        question = about_selection(self.drawing.graph, chosen)
        if question is not None:
            self.drawing.ask(question)

    def size_meant(self) -> Question | None:
        """See `Tool`: of what is pointed at."""
        return about_selection(self.drawing.graph, self._lit)

    def stops(self, reach_px: float) -> list[Point]:
        """See `Tool`."""
        return [*stops.edges(self.drawing.graph), *stops.circles(self.drawing.graph)]

    def preview(self) -> Preview:
        """See `Tool`."""
        return Preview(lit=self._lit)

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        graph, reach = self.drawing.graph, 1.5 * pointer.reach_px
        edge = edge_at(graph, pointer.point_px, reach)
        circle = None if edge else circle_at(graph, pointer.point_px, reach)
        self._lit = Selection(
            edges=frozenset(filter(None, (edge,))), circles=frozenset(filter(None, (circle,)))
        )

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        graph = self.drawing.graph
        for edge in self._lit.edges:
            self.drawing.ask(about_edge(graph, edge))
        for circle in self._lit.circles:
            self.drawing.ask(about_circle(graph, circle))

    def graph_replaced(self) -> None:
        """See `Tool`."""
        self._lit = Selection()
