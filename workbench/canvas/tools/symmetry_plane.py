"""Symmetry planes: suggested near the middle of an edge, or picked middle by middle."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ....solver.annotations import SymmetryPlane
from ....solver.editing.annotating import annotate
from ....solver.editing.elements import delete
from .. import stops
from ..preview import Preview
from ..selection import Selection
from ..symmetry import halved_with, midpoint_at, midpoint_px, outline_of
from .base import Pointer, Tool

if TYPE_CHECKING:
    from ..drawing import Drawing
    from ..plane import Point

#: A middle is meant up to this many times the reach from it.
MIDDLE_REACH = 1.5


class SymmetryPlaneTool(Tool):
    """Takes a suggested plane with one click, or takes one back; Shift picks single middles."""

    NAME = "symmetry_plane"
    KEY = "M"
    TITLE = "Symmetry plane"

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._lit: tuple[str, ...] = ()
        self._picked: tuple[str, ...] = ()

    @property
    def hint(self) -> str:
        """See `Tool`."""
        if self._picked:
            return "Shift-click more middles, then Enter or right click; Esc to give up"
        return "Click the middle of an edge that the plane halves; Shift-click picks one by one"

    def stops(self, reach_px: float) -> list[Point]:
        """See `Tool`."""
        return stops.edges(self.drawing.graph)

    def preview(self) -> Preview:
        """See `Tool`."""
        graph = self.drawing.graph
        edges = [e for e in dict.fromkeys((*self._picked, *self._lit)) if e in graph.edges]
        middles = tuple(midpoint_px(graph, e) for e in edges)
        plane = (outline_of(middles),) if len(middles) > 1 else ()
        return Preview(lit=Selection(edges=frozenset(edges)), guides=plane, grips=middles)

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        graph = self.drawing.graph
        edge = midpoint_at(graph, pointer.point_px, MIDDLE_REACH * pointer.reach_px)
        if edge is None:
            self._lit = ()
        elif pointer.adding or self._picked:
            self._lit = (edge,)
        else:
            said = graph.annotations_of("symmetry_plane").values()
            there = next((a.midpoints_of for a in said if edge in a.midpoints_of), None)
            self._lit = there or halved_with(graph, edge, self.drawing.solved)

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if not self._lit:
            return
        if pointer.adding or self._picked:
            (edge,) = self._lit
            others = tuple(e for e in self._picked if e != edge)
            self._picked = others if edge in self._picked else (*others, edge)
        else:
            self._say(self._lit)

    def finish(self) -> None:
        """See `Tool`."""
        picked = tuple(e for e in self._picked if e in self.drawing.committed.edges)
        self.cancel()
        if picked:
            self._say(picked)

    def _say(self, edges: tuple[str, ...]) -> None:
        """Say that a plane halves the edges; take it back where just that is said."""
        graph = self.drawing.committed
        marked, id_ = annotate(graph, SymmetryPlane(edges))
        if marked is graph:
            self.drawing.commit(delete(graph, annotations=(id_,)), "Remove symmetry plane")
        else:
            self.drawing.commit(marked, "Mark symmetry plane")

    def cancel(self) -> bool:
        """See `Tool`."""
        begun = bool(self._picked)
        self._lit, self._picked = (), ()
        return begun
