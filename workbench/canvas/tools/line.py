"""Lines: click after click, or one a drag."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ....solver.editing.elements import add_edge
from ..preview import Preview
from ..questions import Question, about_edge
from ..snapping import Lead, Snap, SnapKind, place
from .base import DRAG, Pointer, TwoPointTool

if TYPE_CHECKING:
    from ..drawing import Drawing


class LineTool(TwoPointTool):
    """Draws edges; each click goes on from the last one."""

    NAME = "line"
    KEY = "L"
    TITLE = "Line"

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        #: The edge that was drawn last.
        self._drawn = ""

    @property
    def hint(self) -> str:
        """See `Tool`."""
        if self._start is None:
            return "Click the start of the line, or drag"
        if self._drawn:
            return "Click the next end, or type how long the last line is; right click stops"
        return "Click the end of the line; right click stops; Ctrl: no snapping, Shift: crossings"

    def size_meant(self) -> Question | None:
        """See `Tool`: of the line that was drawn last."""
        graph = self.drawing.graph
        return about_edge(graph, self._drawn) if self._drawn in graph.edges else None

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if self._start is None:
            self._drawn = ""
        super().press(pointer)

    def preview(self) -> Preview:
        """See `Tool`."""
        if self._start is None or self._end is None:
            return Preview(snap=self._end)
        return Preview(strokes=((self._start.point_px, self._end.point_px),), snap=self._end)

    def move(self, pointer: Pointer) -> None:
        """See `Tool`: led by directions that are there, and by the perspective."""
        self._reach_px = pointer.reach_px
        lead = None
        if self._start is not None:
            solved = self.drawing.solved
            vanishing = () if solved is None else solved.vanishing_px
            lead = Lead(self._start.point_px, vanishing)
        self._end = self.snap(pointer, lead)

    def graph_replaced(self) -> None:
        """See `Tool`: goes on drawing if the start is still there."""
        on_vertex = self._start is not None and self._start.kind is SnapKind.VERTEX
        if on_vertex and self._start.target not in self.drawing.graph.vertices:
            self.cancel()

    def _draw(self) -> None:
        graph, v = place(self.drawing.committed, self._start)
        graph, w = place(graph, self._end)
        if v == w or math.dist(graph.vertices[v], graph.vertices[w]) < DRAG * self._reach_px:
            # Twice at one place: done.
            self._start = None
            return
        was_there = self._end.kind is SnapKind.VERTEX
        graph, self._drawn = add_edge(graph, v, w)
        self.drawing.commit(graph, "Draw line")
        # Where a line comes back to the drawing, a loop is closed as a rule.
        self._start = None if was_there else Snap(SnapKind.VERTEX, graph.vertices[w], w)
