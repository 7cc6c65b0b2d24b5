"""Small geometry shared by the solver's parts."""

from __future__ import annotations

import numpy as np

from .values import Array


def cross(u: Array, v: Array) -> Array:
    """Cross products of vectors (..., 3), broadcast.

    The same as `numpy.cross`, without its handling of other shapes, which takes longer than the
    arithmetic for the few vectors of a sketch.
    """
    u0, u1, u2 = u[..., 0], u[..., 1], u[..., 2]
    v0, v1, v2 = v[..., 0], v[..., 1], v[..., 2]
    return np.stack([u1 * v2 - u2 * v1, u2 * v0 - u0 * v2, u0 * v1 - u1 * v0], axis=-1)
