"""How long an edge is."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..hit_testing import edge_at
from ..preview import Preview, Selection
from .base import Pointer, Tool

if TYPE_CHECKING:
    from ..drawing import Drawing


class LengthTool(Tool):
    """Asks for the length of the edge that is clicked."""

    NAME = "length"
    KEY = "D"
    TITLE = "Length"

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._edge: str | None = None

    @property
    def hint(self) -> str:
        """See `Tool`."""
        return "Click an edge, type its length (210, 21 cm, 3/4 in) and Enter; empty removes it"

    def preview(self) -> Preview:
        """See `Tool`."""
        edges = frozenset() if self._edge is None else frozenset((self._edge,))
        return Preview(lit=Selection(edges=edges))

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        self._edge = edge_at(self.drawing.graph, pointer.point_px, 1.5 * pointer.reach_px)

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if self._edge is not None:
            self.drawing.ask_for_length(self._edge)

    def graph_replaced(self) -> None:
        """See `Tool`."""
        self._edge = None
