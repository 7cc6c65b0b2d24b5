"""Symmetry planes: the line between two midpoints is square to the edges ([Lau10] 3.2)."""

from __future__ import annotations

import numpy as np

from ..values import Array
from .base import TINY, IntArray, Linearised, unit_vectors


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
    (x0, x1, x2, x3) = X[pairs].transpose(1, 0, 2)
    u, length = unit_vectors(x1 - x0)
    length = np.maximum(length, TINY)[:, None]
    w = (x2 + x3 - x0 - x1) / 2
    r = np.einsum("ki,ki->k", u, w)[:, None]
    half = u / (2 * length)
    du = (w - 2 * r * u) / length**2
    value = np.stack([-half - du, du - half, half, half], axis=1)
    return Linearised((r / length)[:, 0], pairs, value.reshape(-1, 3))
