"""Groups of edges that have something in common, ended with Done ([Lau10] 3.2)."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from ....solver.annotations import EqualLength, Parallel
from ....solver.editing.annotating import set_group
from .. import stops
from ..hit_testing import edge_at
from ..preview import Preview
from ..selection import Selection
from .base import Pointer, Tool

if TYPE_CHECKING:
    from ....solver.graph import SketchGraph
    from ..drawing import Drawing
    from ..plane import Point


class GroupTool(Tool):
    """Collects edges click by click. An edge of a group that is there takes up this group again."""

    GROUP: ClassVar[type[Parallel] | type[EqualLength]]

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._lit: str | None = None
        self._group: str | None = None
        self._picked: tuple[str, ...] = ()

    @classmethod
    def says(cls, graph: SketchGraph, chosen: Selection) -> SketchGraph | None:
        """See `Tool`: one group of all edges, with those of a group that one is in."""
        if len(chosen.edges) < 2:
            return None
        groups = graph.annotations_of(cls.GROUP.kind).items()
        known = next(((id_, g.edges) for id_, g in groups if chosen.edges & {*g.edges}), (None, ()))
        new = sorted(chosen.edges.difference(known[1]))
        return set_group(graph, cls.GROUP, [*known[1], *new], known[0]) if new else None

    def stops(self, reach_px: float) -> list[Point]:
        """See `Tool`."""
        return stops.edges(self.drawing.graph)

    def preview(self) -> Preview:
        """See `Tool`."""
        return Preview(lit=Selection(edges=frozenset(filter(None, (self._lit,)))))

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        self._lit = edge_at(self.drawing.graph, pointer.point_px, 1.5 * pointer.reach_px)

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        edge = self._lit
        if edge is None:
            return
        if not self._picked and self._group is None:
            self._take_up(edge)
        elif edge in self._picked:
            self._picked = tuple(e for e in self._picked if e != edge)
        else:
            self._picked = (*self._picked, edge)
        self._show()

    def finish(self) -> None:
        """See `Tool`."""
        picked, group = self._picked, self._group
        self.cancel()
        graph = self.drawing.committed
        there = [edge for edge in picked if edge in graph.edges]
        group = group if group in graph.annotations else None
        self.drawing.commit(set_group(graph, self.GROUP, there, group), self.WORDS)

    def again(self) -> None:
        """See `Tool`: done with this group."""
        self.finish()

    def cancel(self) -> bool:
        """See `Tool`."""
        begun = bool(self._picked) or self._group is not None
        self._picked, self._group = (), None
        if begun:
            self._show()
        return begun

    def _take_up(self, edge: str) -> None:
        for id_, group in self.drawing.graph.annotations_of(self.GROUP.kind).items():
            if edge in group.edges:
                self._group, self._picked = id_, group.edges
                return
        self._picked = (edge,)

    def _show(self) -> None:
        self.drawing.select(Selection(edges=frozenset(self._picked)))
