"""Planarity: a vertex lies in the plane of three others (faces, the ground, ``on_face``)."""

from __future__ import annotations

import numpy as np

from ..geometry import cross
from ..values import Array
from .base import TINY, IntArray, Linearised, unit_vectors


def planarity(X: Array, quads: IntArray) -> Linearised:
    """Triple product of the directions from the first vertex to the three others.

    r = det(û, v̂, ŵ),  dr/du = (I - û û^T) (v̂ x ŵ) / |u|, and cyclically.

    Parameters
    ----------
    X : (n, 3) array
    quads : (k, 4) int array
        Three vertices that span the plane, and the one that lies in it.
    """
    at = X[quads].transpose(1, 0, 2)
    units, lengths = unit_vectors(at[1:] - at[0])
    normals = cross(units[[1, 2, 0]], units[[2, 0, 1]])
    # Each normal times its own direction is the same product.
    r = np.einsum("ki,ki->k", units[0], normals[0])
    value = np.empty((len(quads), 4, 3))
    by_edge = (normals - r[:, None] * units) / np.maximum(lengths, TINY)[..., None]
    value[:, 1:] = by_edge.transpose(1, 0, 2)
    np.negative(by_edge.sum(axis=0), out=value[:, 0])
    return Linearised(r, quads, value.reshape(-1, 3))
