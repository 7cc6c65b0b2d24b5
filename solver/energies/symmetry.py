"""Symmetry planes: the line between two midpoints is square to the edges ([Lau10] 3.2)."""

from __future__ import annotations

import numpy as np

from ..values import Array
from .base import TINY, IntArray, Linearised, gather, perpendicular_part, unit_vectors


def symmetry(X: Array, pairs: IntArray) -> Linearised:
    """How far two midpoints lie apart along the edges that the plane crosses.

    With u = X_b - X_a and w = (X_c + X_d - X_a - X_b) / 2: r = û . w / |u|, in lengths of the
    first edge; dr/dw = û / |u|,  dr/du = (w - (û . w) û) / |u|^2 - r û / |u|.

    Parameters
    ----------
    X : (n, 3) array
    pairs : (k, 4) int array
        (a, b, c, d) for the edges a-b and c-d, which other residuals keep parallel.
    """
    a, b, c, d = pairs.T
    u, length = unit_vectors(X[b] - X[a])
    length = np.maximum(length, TINY)[:, None]
    w = (X[c] + X[d] - X[a] - X[b]) / 2
    r = np.einsum("ij,ij->i", u, w) / length[:, 0]
    dw = u / length
    du = perpendicular_part(u, w) / length**2 - r[:, None] * u / length
    rows = np.arange(len(pairs))
    terms = [
        (rows, c, dw / 2),
        (rows, d, dw / 2),
        (rows, a, -dw / 2 - du),
        (rows, b, -dw / 2 + du),
    ]
    return gather(r, terms)
