"""Small geometry shared by the solver's parts."""

from __future__ import annotations

import math

import numpy as np

from .values import Array

#: The matrices [u]x of u = x, y and z, (3, 9): u @ GENERATORS is [u]x, row by row.
GENERATORS = np.array(
    [
        [[0.0, 0, 0], [0, 0, -1], [0, 1, 0]],
        [[0, 0, 1], [0, 0, 0], [-1, 0, 0]],
        [[0, -1, 0], [1, 0, 0], [0, 0, 0]],
    ]
).reshape(3, 9)


def cross(u: Array, v: Array) -> Array:
    """Cross products of vectors (..., 3), broadcast.

    The same as `numpy.cross`, without its handling of other shapes, which takes longer than the
    arithmetic for the few vectors of a sketch.
    """
    u0, u1, u2 = u[..., 0], u[..., 1], u[..., 2]
    v0, v1, v2 = v[..., 0], v[..., 1], v[..., 2]
    x = u1 * v2 - u2 * v1
    w = np.empty((*x.shape, 3))
    w[..., 0], w[..., 1], w[..., 2] = x, u2 * v0 - u0 * v2, u0 * v1 - u1 * v0
    return w


def cross_columns(u: Array, v: Array) -> Array:
    """Cross products of vectors that stand in columns, (3, n); those of v may be more."""
    w = np.empty_like(v)
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        np.multiply(u[i], v[j], out=w[k])
        w[k] -= u[j] * v[i]
    return w


def diagonal(points: Array) -> float:
    """Of the box around points (n, d); 0 where there are none."""
    if not len(points):
        return 0.0
    # Along the other axis numpy takes eight times as long.
    rows = np.ascontiguousarray(points.T)
    return math.hypot(*(rows.max(axis=1) - rows.min(axis=1)).tolist())


def rotation(turn: Array) -> Array:
    """The rotation matrix of a rotation vector (3,), rad, by Rodrigues' formula."""
    x, y, z = turn.tolist()
    angle = math.sqrt(x * x + y * y + z * z)
    # sin(a) / a and (1 - cos(a)) / a^2 without cancellation.
    half = math.sin(angle / 2) / angle if angle > 1e-8 else 0.5
    a = math.sin(angle) / angle if angle > 1e-8 else 1.0
    b = 2 * half * half
    return np.array(
        [
            [1 - b * (y * y + z * z), b * x * y - a * z, b * x * z + a * y],
            [b * x * y + a * z, 1 - b * (x * x + z * z), b * y * z - a * x],
            [b * x * z - a * y, b * y * z + a * x, 1 - b * (x * x + y * y)],
        ]
    )
