"""Lengths of edges in proportion: equal lengths and given lengths ([Lau10] 4.2, second term).

One picture never tells the size, so given lengths enter as their ratios and the overall size is set
at the end. Equal lengths are the ratio 1.
"""

from __future__ import annotations

import numpy as np

from ..values import Array
from .base import TINY, IntArray, Linearised, at_both_ends, two_edges


def length_ratio(X: Array, pairs: IntArray, wanted: Array | None = None) -> Linearised:
    """Relative difference of two lengths, each measured in its wanted length.

    With p = |u| / L_u, q = |v| / L_v: r = (p - q) / (p + q), free of the overall size;
    dr/dp = 2 q / (p + q)^2, dr/dq = -2 p / (p + q)^2.

    Parameters
    ----------
    X : (n, 3) array
    pairs : (k, 4) int array
        (a, b, c, d) for the edges a-b and c-d.
    wanted : (k, 2) array, optional
        L_u and L_v of each pair, mm; by default 1.
    """
    units, lengths = two_edges(X, pairs)
    measured = lengths if wanted is None else lengths / wanted
    total = np.maximum(measured.sum(axis=1), TINY)
    slopes = measured[:, ::-1] * (np.array([2.0, -2.0]) / total[:, None] ** 2)
    if wanted is not None:
        slopes /= wanted
    r = (measured[:, 0] - measured[:, 1]) / total
    return Linearised(r, pairs, at_both_ends(slopes[..., None] * units).reshape(-1, 3))
