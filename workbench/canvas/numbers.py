"""The number of parameters that each vertex has ([Lau10] Figure 5), shown on demand; no Qt."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph


def _none(graph: SketchGraph) -> Mapping[str, int]:
    return {}


class Numbers:
    """Counts again when something else is drawn or said, not while it is dragged."""

    def __init__(self) -> None:
        #: Counts the parameters of a graph's vertices; the solver knows how.
        self.count: Callable[[SketchGraph], Mapping[str, int]] = _none
        self.shown = False
        self._counted: tuple[object, Mapping[str, int]] | None = None

    def toggle(self) -> None:
        """Show them, or no longer."""
        self.shown = not self.shown

    def of(self, graph: SketchGraph) -> Mapping[str, int]:
        """The numbers of a graph; none where they are not shown."""
        if not self.shown:
            return {}
        said = (graph.edges, graph.annotations, graph.faces, graph.revolutions)
        drawn = (said, tuple(graph.vertices), tuple(graph.circles))
        if self._counted is None or self._counted[0] != drawn:
            self._counted = (drawn, self.count(graph))
        return self._counted[1]
