"""Radial distortion: where a lens shows what a pinhole would show elsewhere.

Terms
-----
k
    What is seen at r from the principal point belongs at r (1 + k r^2), r in half diagonals of the
    photo; negative for pincushions, positive for barrels (D. C. Brown, Close-range camera
    calibration, 1971).
bow
    How far a straight edge lies beside the line between its ends where k is 1, px.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..solver.values import Array

#: No usual lens bends more: beyond, the inverse would fold over.
MOST_K = 0.3
#: Where the bow of lenses is reckoned; it grows evenly with k.
_SMALL = 0.02


@dataclass(frozen=True, slots=True, eq=False)
class Radial:
    """How a lens with its middle there moves what it shows.

    Parameters
    ----------
    principal_px : (2,) array
    half_diagonal_px : float
    """

    principal_px: Array
    half_diagonal_px: float

    @classmethod
    def of(cls, grey: Array, principal_px: Array | None = None) -> Radial:
        """Of a photo (height, width); its middle is the principal point where none is given."""
        size = np.array(grey.shape[1::-1], dtype=float)
        principal = size / 2 if principal_px is None else np.asarray(principal_px, dtype=float)
        return cls(principal, float(np.linalg.norm(size)) / 2)

    def straightened(self, points_px: Array, k: float) -> Array:
        """Where points (..., 2) of the photo belong."""
        off = (np.asarray(points_px, dtype=float) - self.principal_px) / self.half_diagonal_px
        longer = 1 + k * np.sum(off**2, axis=-1, keepdims=True)
        return np.asarray(self.principal_px + off * longer * self.half_diagonal_px)

    def bent(self, points_px: Array, k: float) -> Array:
        """Where points (..., 2) of the straight photo are seen; the inverse of `straightened`."""
        off = (np.asarray(points_px, dtype=float) - self.principal_px) / self.half_diagonal_px
        right = np.linalg.norm(off, axis=-1)
        r = right.copy()
        for _ in range(12):
            r = r - (r * (1 + k * r**2) - right) / (1 + 3 * k * r**2)
        factor = np.where(right > 0, r / np.maximum(right, 1e-300), 1.0)
        return np.asarray(self.principal_px + off * factor[..., None] * self.half_diagonal_px)

    def bow(self, p_px: Array, q_px: Array, t: Array) -> Array:
        """How far a straight edge between two places is beside their chord at t, px for k = 1."""
        ends = self.straightened(np.array([p_px, q_px]), _SMALL)
        seen = self.bent(ends[0] + np.outer(t, ends[1] - ends[0]), _SMALL)
        along = (q_px - p_px) / np.linalg.norm(q_px - p_px)
        return np.asarray((seen - p_px) @ [-along[1], along[0]] / _SMALL)
