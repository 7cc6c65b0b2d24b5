"""Steps that meet conditions with the least stretching, as if everything were elastic bars."""

from __future__ import annotations

import numpy as np
from scipy.sparse import bmat, csc_array, identity
from scipy.sparse.linalg import splu

from .least_squares import MAX_DENSE
from .values import Array


def gentlest_step(h: Array, H: Array, E: Array) -> Array:
    """The step that takes h to 0 with the least energy.

    Parameters
    ----------
    h : (k,) array
        The conditions as they are.
    H : (k, n) array
        Their derivatives by the unknowns.
    E : (t, n) array
        Strains by the unknowns; the energy is the sum of their squares.

    Returns
    -------
    (n,) array
    """
    n, k = H.shape[1], len(h)
    # Where nothing is stretched, the smallest step.
    W = E.T @ E
    W[np.diag_indices(n)] += 1e-6 * float(np.diag(W).max(initial=1.0))
    slack = 1e-12 * float(np.abs(H).max(initial=1.0)) ** 2
    right = np.concatenate([np.zeros(n), -h])
    if n + k <= MAX_DENSE:
        dense = np.block([[W, H.T], [H, -slack * np.eye(k)]])
        return np.asarray(np.linalg.solve(dense, right)[:n])
    system = bmat([[csc_array(W), csc_array(H.T)], [csc_array(H), -slack * identity(k)]], "csc")
    return np.asarray(splu(system).solve(right)[:n])
