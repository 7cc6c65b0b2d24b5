"""Lengths of edges in proportion: equal lengths and given lengths ([Lau10] 4.2, second term).

One picture never tells the size, so given lengths enter as their ratios and the overall size is set
at the end. Equal lengths are the ratio 1.
"""

from __future__ import annotations

import numpy as np

from ..values import Array
from .base import TINY, IntArray, Linearised, gather, unit_vectors


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
    if wanted is None:
        wanted = np.ones((len(pairs), 2))
    a, b, c, d = pairs.T
    u, length_u = unit_vectors(X[b] - X[a])
    v, length_v = unit_vectors(X[d] - X[c])
    p, q = length_u / wanted[:, 0], length_v / wanted[:, 1]
    total = np.maximum(p + q, TINY)
    du = (2 * q / total**2 / wanted[:, 0])[:, None] * u
    dv = (-2 * p / total**2 / wanted[:, 1])[:, None] * v
    rows = np.arange(len(pairs))
    return gather((p - q) / total, [(rows, b, du), (rows, a, -du), (rows, d, dv), (rows, c, -dv)])
