"""Whether a matrix surely is positive definite: then nothing is open, and much is quickly known."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.linalg.lapack import dpocon, dpotrf, dpotri, dpotrs

from ..values import Array

#: Eigenvalues of a matrix with ones on its diagonal above this are not 0 by rounding.
SURELY_DEFINITE = 1e-11


@dataclass(frozen=True, slots=True, eq=False)
class Definite:
    """A symmetric matrix that surely is positive definite, factored.

    Parameters
    ----------
    scale : (n,) array
        By which rows and columns are divided, so that its diagonal is 1.
    factor : (n, n) array
        The upper Cholesky factor of what is left.
    """

    scale: Array
    factor: Array

    @classmethod
    def of(cls, A: Array) -> Definite | None:
        """None where in doubt."""
        scale = np.sqrt(np.maximum(A.ravel()[:: len(A) + 1], 1e-300))
        unit = A / (scale[:, None] * scale)
        factor, failed = dpotrf(unit, clean=1)
        if failed:
            return None
        # The inverse's norm is the largest eigenvalue at least.
        norm = float(np.abs(unit).sum(axis=0).max())
        inverse_norm, _ = dpocon(factor, norm)
        return cls(scale, factor) if inverse_norm * norm > SURELY_DEFINITE else None

    def solve(self, b: Array) -> Array:
        """The inverse times b, (n,) or (n, k)."""
        columns = b.reshape(len(b), -1) / self.scale[:, None]
        solved, _ = dpotrs(self.factor, columns)
        return np.asarray(solved / self.scale[:, None]).reshape(b.shape)


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
