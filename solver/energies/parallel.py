"""Parallel edges ([Lau10] 4.2, third energy term).

As printed, the paper's term is 1 / (angle - 90)^2, which is smallest, not zero, for parallel lines.
The cross product of the two directions is zero for them and smooth there.
"""

from __future__ import annotations

import numpy as np

from ..geometry import cross
from ..values import Array
from .base import TINY, IntArray, Linearised, gather, unit_vectors


def parallel(X: Array, pairs: IntArray) -> Linearised:
    """The cross product of two edges' directions, three residuals a pair.

    r = û x v̂,  dr/du = -[v̂]x (I - û û^T) / |u|,  dr/dv = [û]x (I - v̂ v̂^T) / |v|.

    Parameters
    ----------
    X : (n, 3) array
    pairs : (k, 4) int array
        (a, b, c, d) for the edges a-b and c-d.
    """
    a, b, c, d = pairs.T
    u, length_u = unit_vectors(X[b] - X[a])
    v, length_v = unit_vectors(X[d] - X[c])
    du = -_cross_matrices(v) @ _projectors(u) / np.maximum(length_u, TINY)[:, None, None]
    dv = _cross_matrices(u) @ _projectors(v) / np.maximum(length_v, TINY)[:, None, None]
    rows = np.arange(3 * len(pairs))
    a, b, c, d = (np.repeat(i, 3) for i in (a, b, c, d))
    du, dv = du.reshape(-1, 3), dv.reshape(-1, 3)
    terms = [(rows, b, du), (rows, a, -du), (rows, d, dv), (rows, c, -dv)]
    return gather(cross(u, v).reshape(-1), terms)


def _cross_matrices(u: Array) -> Array:
    """[u]x with [u]x w = u x w, (k, 3, 3)."""
    m = np.zeros((len(u), 3, 3))
    m[:, 0, 1], m[:, 0, 2] = -u[:, 2], u[:, 1]
    m[:, 1, 0], m[:, 1, 2] = u[:, 2], -u[:, 0]
    m[:, 2, 0], m[:, 2, 1] = -u[:, 1], u[:, 0]
    return m


def _projectors(u: Array) -> Array:
    """I - u u^T, (k, 3, 3)."""
    return np.eye(3) - u[:, :, None] * u[:, None, :]
