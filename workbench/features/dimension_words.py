"""What a dimension's tooltip says: what it measures, in words and ids, and whether it drives."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

from .. import host
from .dimension_names import ANGLE, DIAMETER, HEIGHT, Dimension

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ...solver.dimensions.heights import Level
    from ...solver.graph import SketchGraph
    from ...solver.solution import Solution

#: World axes by the words that people use for sizes along them.
_WORDS = ("Width", "Depth", "Height")
#: So many elements at one height are named; more would fill the screen.
_NAMED = 6


class Words:
    """Describes the dimensions of a sketch that was solved."""

    def __init__(self, graph: SketchGraph, solution: Solution) -> None:
        self._graph = graph
        self._solution = solution

    def of(self, dimension: Dimension, drives: bool) -> str:
        """What the tooltip says."""
        what = {ANGLE: self._angle, DIAMETER: self._diameter, HEIGHT: self._height}
        words = what.get(dimension.prefix, self._length)(*dimension.ids)
        return f"{words}; {self._role(dimension, drives)}"

    def _role(self, dimension: Dimension, drives: bool) -> str:
        if dimension.prefix == ANGLE and self._is_square(dimension):
            words = "said to be right in the sketch"
        elif drives:
            words = "type a value or an expression"
        elif dimension.prefix == HEIGHT and self._levels[dimension.ids[0]].upright is None:
            words = "only shown: to say it, draw an upright edge from the ground to there"
        else:
            words = "follows from the drawing and the other dimensions"
        return host.translate("InContext", words)

    def _is_square(self, corner: Dimension) -> bool:
        return set(corner.ids) in self._square

    @cached_property
    def _square(self) -> list[set[str]]:
        """The corners that the sketch says to be right."""
        from ...solver.dimensions.angles import driving_angles_deg

        return [set(corner) for corner in driving_angles_deg(self._graph)]

    @cached_property
    def _levels(self) -> Mapping[str, Level]:
        from ...solver.dimensions.heights import levels

        return levels(self._graph)

    def _angle(self, first: str, second: str) -> str:
        words = host.translate("InContext", "Angle between the edges {0} and {1}")
        return words.format(first, second)

    def _diameter(self, id_: str) -> str:
        return host.translate("InContext", "Diameter of circle {}").format(id_)

    def _height(self, id_: str) -> str:
        members = self._levels[id_].members
        more = ["..."] if len(members) > _NAMED else []
        named = ", ".join([*members[:_NAMED], *more])
        return host.translate("InContext", "Height above the ground of {}").format(named)

    def _length(self, id_: str) -> str:
        v, w = self._solution.edges[id_]
        along = abs(self._solution.vertices_mm[w] - self._solution.vertices_mm[v])
        main = int(along.argmax())
        straight = along[main] > 0.999 * float((along**2).sum()) ** 0.5
        kind = host.translate("InContext", _WORDS[main] if straight else "Length")
        words = host.translate("InContext", "{0}: edge {1}, from {2} to {3}")
        return words.format(kind, id_, v, w)
