"""Parallel edges ([Lau10] 4.2, third energy term).

As printed, the paper's term is 1 / (angle - 90)^2, which is smallest, not zero, for parallel lines.
The cross product of the two directions is zero for them and smooth there.
"""

from __future__ import annotations

import numpy as np

from ..geometry import GENERATORS, cross
from ..values import Array
from .base import TINY, IntArray, Linearised, at_both_ends, two_edges

_SIGNS = np.array([[-1.0], [1.0]])


def parallel(X: Array, pairs: IntArray) -> Linearised:
    """The cross product of two edges' directions, three residuals a pair.

    r = û x v̂,  dr/du = -[v̂]x (I - û û^T) / |u|,  dr/dv = [û]x (I - v̂ v̂^T) / |v|.

    Parameters
    ----------
    X : (n, 3) array
    pairs : (k, 4) int array
        (a, b, c, d) for the edges a-b and c-d.
    """
    units, lengths = two_edges(X, pairs)
    r = cross(units[:, 0], units[:, 1])
    # [v]x u u^T = -r u^T and [u]x v v^T = r v^T, so that no matrices have to be multiplied.
    turned = (_SIGNS * units[:, ::-1] @ GENERATORS).reshape(-1, 2, 3, 3)
    by_edge = turned - r[:, None, :, None] * units[:, :, None]
    by_edge /= np.maximum(lengths, TINY)[..., None, None]
    by_edge = by_edge.transpose(0, 2, 1, 3).reshape(-1, 2, 3)
    return Linearised(r.reshape(-1), pairs, at_both_ends(by_edge).reshape(-1, 3))
