"""Planarity: a vertex lies in the plane of three others (faces, the ground, ``on_face``)."""

from __future__ import annotations

import numpy as np

from ..geometry import cross
from ..values import Array
from .base import TINY, IntArray, Linearised, gather, perpendicular_part, unit_vectors


def planarity(X: Array, quads: IntArray) -> Linearised:
    """Triple product of the directions from the first vertex to the three others.

    r = det(û, v̂, ŵ),  dr/du = (I - û û^T) (v̂ x ŵ) / |u|, and cyclically.

    Parameters
    ----------
    X : (n, 3) array
    quads : (k, 4) int array
        Three vertices that span the plane, and the one that lies in it.
    """
    o, *others = quads.T
    units, lengths = zip(*(unit_vectors(X[i] - X[o]) for i in others), strict=True)
    r = np.einsum("ij,ij->i", units[0], cross(units[1], units[2]))
    rows = np.arange(len(quads))
    terms = []
    at_origin = np.zeros((len(quads), 3))
    for k, i in enumerate(others):
        normal = cross(units[(k + 1) % 3], units[(k + 2) % 3])
        d = perpendicular_part(units[k], normal) / np.maximum(lengths[k], TINY)[:, None]
        terms.append((rows, i, d))
        at_origin -= d
    return gather(r, [*terms, (rows, o, at_origin)])
