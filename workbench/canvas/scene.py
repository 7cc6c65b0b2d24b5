"""What is painted of a sketch, in screen px: plain numbers, no Qt."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from .marks import Marks
from .said import Places

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph
    from .symbols import Point, Stroke


@dataclass(frozen=True, slots=True)
class Findings:
    """What the solver found: vertices that nothing holds yet, annotations that disagree."""

    loose: frozenset[str] = frozenset()
    conflicts: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class Part:
    """One of the two parts of a sketch in the hand: what moves, with all that hangs on it, or not.

    Parameters
    ----------
    moved : frozenset of vertices and circles
    moves : bool
        Which part it is.
    """

    moved: frozenset[str]
    moves: bool

    def has(self, ids: Iterable[str]) -> bool:
        """Whether what lies between some vertices or circles belongs to it."""
        return self.moved.isdisjoint(ids) != self.moves


@dataclass(frozen=True, slots=True)
class Scene:
    """What is painted.

    Parameters
    ----------
    graph : SketchGraph
    marks : Marks
    screen : mapping of vertex to screen position
    circles : mapping of circle to its outline on the screen
    findings : Findings
    rings : tuple of lines
        Of surfaces of revolution, see `turning.rings_of`.
    numbers : mapping of vertex to number
        How many parameters each has, where that is shown ([Lau10] Figure 5).
    part : Part or None
        What of it is painted; all where there is none.
    mirrored : mapping of vertex to screen position
        Of the copies that symmetry planes make.
    """

    graph: SketchGraph
    marks: Marks
    screen: dict[str, Point]
    circles: dict[str, Stroke] = field(default_factory=dict)
    findings: Findings = Findings()
    rings: tuple[Stroke, ...] = ()
    numbers: Mapping[str, int] = field(default_factory=dict)
    part: Part | None = None
    mirrored: Mapping[str, Point] = field(default_factory=dict)

    def outline(self, loop: Iterable[str]) -> Stroke:
        """Screen positions of a face's corners; none where a mirrored one is not known yet."""
        found = [self.screen.get(v) or self.mirrored.get(v) for v in loop]
        return tuple(p for p in found if p is not None) if None not in found else ()

    def ends(self, edge: str) -> tuple[Point, Point]:
        """Screen positions of an edge's two ends."""
        v, w = self.graph.edges[edge]
        return self.screen[v], self.screen[w]

    def shows(self, *ids: str) -> bool:
        """Whether what lies between some vertices or circles is painted."""
        return self.part is None or self.part.has(ids)

    def shows_edge(self, edge: str) -> bool:
        """Whether an edge is painted, and what lies on it."""
        return self.part is None or self.part.has(self.graph.edges[edge])

    @property
    def places(self) -> Places:
        """Where the symbols of annotations lie."""
        return Places(self.graph, self.marks, self.screen, self.circles)
