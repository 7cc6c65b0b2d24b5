"""Edges that are parallel."""

from __future__ import annotations

from ....solver.annotations import Parallel
from .groups import GroupTool


class ParallelTool(GroupTool):
    """Says that edges are parallel."""

    NAME = "parallel"
    KEY = "P"
    TITLE = "Parallel"
    GROUP = Parallel
    WORDS = "Mark parallel"

    @property
    def hint(self) -> str:
        """See `Tool`."""
        return "Click edges that are parallel, then Enter or right click"
