"""Pieces: the boxes of shared space, and who owns each.

Terms
-----
piece
    A box of shared space with its owner; everybody else is cut back there.
"""

from __future__ import annotations

from dataclasses import dataclass

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
    """

    low_mm: Corner
    high_mm: Corner
    owner: int
    rivals: tuple[int, ...]
    slack: Slack = NO_SLACK

    def given_to(self, wall: int) -> Piece:
        """The same piece with another owner."""
        rivals = tuple(w for w in (self.owner, *self.rivals) if w != wall)
        return Piece(self.low_mm, self.high_mm, wall, rivals)
