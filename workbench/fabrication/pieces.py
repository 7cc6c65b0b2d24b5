"""Pieces: the boxes of shared space, and who owns each.

Terms
-----
piece
    A box of shared space with its owner; everybody else is cut back there.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

Corner = tuple[float, float, float]
#: How far a cut reaches beyond its piece: for each axis at the low and at the high end, mm.
Slack = tuple[tuple[float, float], tuple[float, float], tuple[float, float]]
NO_SLACK: Slack = ((0.0, 0.0), (0.0, 0.0), (0.0, 0.0))


@dataclass(frozen=True, slots=True)
class Piece:
    """A box of shared space: its owner, and who would take it otherwise.

    Parameters
    ----------
    low_mm, high_mm : (x, y, z) in the frame
    owner : int
    rivals : tuple of int
        Walls that could own it as well.
    slack : Slack
        Play around the piece, where it is cut out of the first rival.
    run_axis : int
        Along which its run goes; -1 where it is part of no run.
    least_mm : float
        What is narrower along the run holds nothing.
    carrier : int
        The wall whose it is between and beside tabs, and which keeps it; -1 where that is none.
    """

    low_mm: Corner
    high_mm: Corner
    owner: int
    rivals: tuple[int, ...]
    slack: Slack = NO_SLACK
    run_axis: int = -1
    least_mm: float = 0.0
    carrier: int = -1

    @property
    def carries(self) -> bool:
        """Whether it is the carrier's."""
        return self.owner == self.carrier >= 0

    def given_to(self, wall: int) -> Piece:
        """The same piece with another owner."""
        rivals = tuple(w for w in (self.owner, *self.rivals) if w != wall)
        return replace(self, owner=wall, rivals=rivals, slack=NO_SLACK)
