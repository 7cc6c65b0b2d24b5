"""Whether a matrix surely is positive definite: then nothing is open, and much is quickly known."""

from __future__ import annotations

import numpy as np
from scipy.linalg.lapack import dpotrf, dpotri

from ..values import Array

#: Eigenvalues of a matrix with ones on its diagonal above this are not 0 by rounding.
SURELY_DEFINITE = 1e-11


def safe_inverse(A: Array) -> Array | None:
    """The inverse of a symmetric matrix that surely is positive definite; None where in doubt."""
    scale = np.sqrt(np.maximum(A.ravel()[:: len(A) + 1], 1e-300))
    both = scale[:, None] * scale
    factor, failed = dpotrf(A / both, clean=1)
    if failed:
        return None
    half, _ = dpotri(factor)
    diagonal = half.diagonal().copy()
    # The largest eigenvalue of the inverse is no larger than its trace.
    if not float(diagonal.sum()) < 1 / SURELY_DEFINITE:
        return None
    inverse = half + half.T
    inverse.flat[:: len(A) + 1] = diagonal
    return np.asarray(inverse / both)
