"""Two edges that meet at a given angle: what people say of corners beyond the right ones."""

from __future__ import annotations

import numpy as np

from ..values import Array
from .base import TINY, IntArray, Linearised, at_both_ends, two_edges, unit_vectors


def angle(X: Array, corners: IntArray, wanted: Array) -> Linearised:
    """The angle between two edges less the wanted one, radians.

    With u = X_b - X_a, v = X_c - X_a', unit vectors û, v̂ and p the unit vector of v̂'s part square
    to û: r = atan2(|v̂ - (û . v̂) û|, û . v̂) - w,  dr/du = -p / |u|.

    Its slope is the same everywhere, where that of the cosine falls to 0 at flat angles.

    Parameters
    ----------
    X : (n, 3) array
    corners : (k, 4) int array
        Each edge as (from, to): (a, b, a', c); at one vertex a = a'.
    wanted : (k, 2) array
        The angle w of each corner in radians, above 0 and below pi; the second column is not used.
    """
    units, lengths = two_edges(X, corners)
    cosine = np.einsum("ki,ki->k", units[:, 0], units[:, 1])
    across, sines = unit_vectors(units[:, ::-1] - cosine[:, None, None] * units)
    by_edge = -across / np.maximum(lengths, TINY)[..., None]
    r = np.arctan2(sines[:, 0], cosine) - wanted[:, 0]
    return Linearised(r, corners, at_both_ends(by_edge).reshape(-1, 3))
