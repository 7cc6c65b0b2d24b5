"""What every energy returns, and the derivatives that they share."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..values import Array

IntArray = NDArray[np.int64]

#: Shorter lengths count as this: collapsed edges give large numbers, not infinite ones.
TINY = 1e-30


@dataclass(frozen=True, slots=True, eq=False)
class Linearised:
    """Residuals and their derivatives.

    Parameters
    ----------
    residual : (k,) array
    row : (t,) int array
    vertex : (t,) int array
    value : (t, 3) array
        d residual[row] / d X[vertex]; several triplets for one entry add up.
    """

    residual: Array
    row: IntArray
    vertex: IntArray
    value: Array


def unit_vectors(u: Array) -> tuple[Array, Array]:
    """Directions and lengths of vectors (k, 3); a vector of length 0 has direction 0."""
    length = np.sqrt(np.einsum("ij,ij->i", u, u))
    safe = np.maximum(length, TINY)
    return u / safe[:, None], length


def perpendicular_part(direction: Array, vector: Array) -> Array:
    """The part of each vector that is perpendicular to the direction, (k, 3)."""
    along = np.einsum("ij,ij->i", direction, vector)
    return np.asarray(vector - along[:, None] * direction)


def gather(residual: Array, terms: list[tuple[IntArray, IntArray, Array]]) -> Linearised:
    """Put (row, vertex, value) terms together."""
    rows, vertices, values = zip(*terms, strict=True)
    return Linearised(
        residual, np.concatenate(rows), np.concatenate(vertices), np.concatenate(values)
    )
