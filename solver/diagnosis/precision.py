"""How sure the result is: standard errors from the final Jacobian."""

from __future__ import annotations

import numpy as np

from ..full import FullProblem, Pose
from ..values import Array
from .freedoms import NULL_TOLERANCE


def focal_sigma(full: FullProblem, x: Pose) -> float:
    """Standard error of the log focal length, from the drawing's own misfit."""
    at = full.evaluate(x)
    r, _ = full.jacobian(x)
    # In the directions that keep the constraints: weighing these against the drawing instead would
    # drown what little a view from afar says of its focal length.
    N = tangent(at.H)
    A = N.T @ at.A @ N
    spare = max(1, len(r) - N.shape[1] + 1)
    noise = max(float(r @ r) / spare, 1e-14)
    values, vectors = np.linalg.eigh(A)
    share = vectors.T @ N[3]
    floor = 1e-13 * float(values.max())
    if float(np.sum(share[values <= floor] ** 2)) > 1e-6:
        return float("inf")
    variance = noise * float(np.sum(share**2 / np.maximum(values, floor)))
    # d log f = -f d kappa
    return float(np.exp(x.log_focal) * np.sqrt(variance))


def tangent(H: Array) -> Array:
    """Orthonormal columns that span the null space of H."""
    if not len(H):
        return np.eye(H.shape[1])
    if len(H) > H.shape[1]:
        # The triangular factor has the same null space, and no long columns of U.
        H = np.asarray(np.linalg.qr(H, mode="r"))
    _, s, Vt = np.linalg.svd(H)
    rank = int(np.count_nonzero(s > NULL_TOLERANCE * max(float(s[0]), 1e-300)))
    return np.asarray(Vt[rank:].T)
