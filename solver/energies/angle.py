"""Two edges that meet at a given angle: what people say of corners beyond the right ones."""

from __future__ import annotations

import numpy as np

from ..values import Array
from .base import TINY, IntArray, Linearised, gather, perpendicular_part, unit_vectors


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
    a, b, a2, c = corners.T
    u, length_u = unit_vectors(X[b] - X[a])
    v, length_v = unit_vectors(X[c] - X[a2])
    from_u, sine = unit_vectors(perpendicular_part(u, v))
    from_v, _ = unit_vectors(perpendicular_part(v, u))
    r = np.arctan2(sine, np.einsum("ij,ij->i", u, v)) - wanted[:, 0]
    du = -from_u / np.maximum(length_u, TINY)[:, None]
    dv = -from_v / np.maximum(length_v, TINY)[:, None]
    rows = np.arange(len(corners))
    return gather(r, [(rows, b, du), (rows, a, -du), (rows, c, dv), (rows, a2, -dv)])
