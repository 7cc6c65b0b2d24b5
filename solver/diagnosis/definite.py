"""Whether a matrix surely is positive definite: then nothing is open, and much is quickly known."""

from __future__ import annotations

import numpy as np
from scipy.linalg.lapack import dposv

from ..values import Array

#: Eigenvalues of a matrix with ones on its diagonal above this are not 0 by rounding.
SURELY_DEFINITE = 1e-11


def safe_inverse(A: Array) -> Array | None:
    """The inverse of a symmetric matrix that surely is positive definite; None where in doubt."""
    scale = np.sqrt(np.maximum(A.ravel()[:: len(A) + 1], 1e-300))
    _, inverse, failed = dposv(A / (scale[:, None] * scale), np.eye(len(A)))
    # The largest eigenvalue of the inverse is no larger than its trace.
    if failed or not float(inverse.trace()) < 1 / SURELY_DEFINITE:
        return None
    return np.asarray(inverse / (scale[:, None] * scale))
