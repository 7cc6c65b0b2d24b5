"""Right angles: two edges that meet are perpendicular ([Lau10] 4.2, first energy term)."""

from __future__ import annotations

import numpy as np

from ..values import Array
from .base import TINY, IntArray, Linearised, at_both_ends, two_edges


def right_angle(X: Array, corners: IntArray) -> Linearised:
    """The cosine between two edges.

    With u = X_b - X_a, v = X_c - X_a and unit vectors û, v̂:
    r = û . v̂,  dr/du = (v̂ - r û) / |u|.

    [Lau10] takes the angle less 90 degrees; the cosine has the same zeros and no kink.

    Parameters
    ----------
    X : (n, 3) array
    corners : (k, 4) int array
        Each edge as (from, to): (a, b, a', c); at one vertex a = a'.
    """
    units, lengths = two_edges(X, corners)
    r = np.einsum("ki,ki->k", units[:, 0], units[:, 1])
    by_edge = (units[:, ::-1] - r[:, None, None] * units) / np.maximum(lengths, TINY)[..., None]
    return Linearised(r, corners, at_both_ends(by_edge).reshape(-1, 3))
