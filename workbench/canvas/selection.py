"""What of a sketch is selected."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ...solver.annotations import targets_of

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph


@dataclass(frozen=True, slots=True)
class Selection:
    """Vertices, edges, circles and annotations that are selected."""

    vertices: frozenset[str] = frozenset()
    edges: frozenset[str] = frozenset()
    circles: frozenset[str] = frozenset()
    annotations: frozenset[str] = frozenset()

    def __bool__(self) -> bool:
        return bool(self.vertices or self.edges or self.circles or self.annotations)

    def touches(self, other: Selection) -> bool:
        """Whether something is in both."""
        return bool(
            self.vertices & other.vertices
            or self.edges & other.edges
            or self.circles & other.circles
            or self.annotations & other.annotations
        )

    def toggled(self, other: Selection) -> Selection:
        """With what is in one of the two, without what is in both."""
        return Selection(
            vertices=self.vertices ^ other.vertices,
            edges=self.edges ^ other.edges,
            circles=self.circles ^ other.circles,
            annotations=self.annotations ^ other.annotations,
        )

    def united(self, other: Selection) -> Selection:
        """With what is in either of the two."""
        return Selection(
            vertices=self.vertices | other.vertices,
            edges=self.edges | other.edges,
            circles=self.circles | other.circles,
            annotations=self.annotations | other.annotations,
        )

    def with_targets(self, graph: SketchGraph) -> Selection:
        """With the vertices, edges and circles that its annotations name."""
        there = self.annotations & set(graph.annotations)
        named = [targets_of(graph.annotations[a]) for a in there]
        return Selection(
            vertices=self.vertices.union(*(n.get("vertex", ()) for n in named)),
            edges=self.edges.union(*(n.get("edge", ()) for n in named)),
            circles=self.circles.union(*(n.get("circle", ()) for n in named)),
            annotations=self.annotations,
        )


NOTHING = Selection()
