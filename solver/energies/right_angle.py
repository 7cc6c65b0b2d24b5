"""Right angles: two edges that meet are perpendicular ([Lau10] 4.2, first energy term)."""

from __future__ import annotations

import numpy as np

from ..values import Array
from .base import TINY, IntArray, Linearised, gather, perpendicular_part, unit_vectors


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
    a, b, a2, c = corners.T
    u, length_u = unit_vectors(X[b] - X[a])
    v, length_v = unit_vectors(X[c] - X[a2])
    r = np.einsum("ij,ij->i", u, v)
    du = perpendicular_part(u, v) / np.maximum(length_u, TINY)[:, None]
    dv = perpendicular_part(v, u) / np.maximum(length_v, TINY)[:, None]
    rows = np.arange(len(corners))
    return gather(r, [(rows, b, du), (rows, a, -du), (rows, c, dv), (rows, a2, -dv)])
