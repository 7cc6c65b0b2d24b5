"""Edges that are equally long."""

from __future__ import annotations

from ....solver.annotations import EqualLength
from .groups import GroupTool


class EqualLengthTool(GroupTool):
    """Says that edges are equally long."""

    NAME = "equal_length"
    KEY = "E"
    TITLE = "Equal length"
    GROUP = EqualLength
    WORDS = "Mark equal length"

    @property
    def hint(self) -> str:
        """See `Tool`."""
        return "Click edges that are equally long, then Enter or right click"
