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
    """Residuals and their derivatives, each by the positions of four vertices.

    Parameters
    ----------
    residual : (k,) array
    items : (k / r, 4) int array
        The vertices, of r residuals each.
    value : (4 k, 3) array
        d residual[row] / d X[vertex]; several triplets for one entry add up.
    """

    residual: Array
    items: IntArray
    value: Array

    @property
    def row(self) -> IntArray:
        """The residual that each value speaks of, (4 k,)."""
        return np.repeat(np.arange(len(self.residual)), 4)

    @property
    def vertex(self) -> IntArray:
        """The vertex that each value speaks of, (4 k,)."""
        each = len(self.residual) // max(1, len(self.items))
        return np.repeat(self.items, each, axis=0).reshape(-1)


def unit_vectors(u: Array) -> tuple[Array, Array]:
    """Directions and lengths of vectors (..., 3); a vector of length 0 has direction 0."""
    length = np.sqrt(np.einsum("...i,...i->...", u, u))
    return u / np.maximum(length, TINY)[..., None], length


def two_edges(X: Array, pairs: IntArray) -> tuple[Array, Array]:
    """Directions (k, 2, 3) and lengths (k, 2) of the edges a-b and c-d, for (a, b, c, d)."""
    ends = X[pairs]
    return unit_vectors(ends[:, 1::2] - ends[:, ::2])


def at_both_ends(by_edge: Array) -> Array:
    """Derivatives by the ends of two edges, (k, 4, 3), from those by the edges, (k, 2, 3)."""
    value = np.empty((len(by_edge), 4, 3))
    value[:, 1::2] = by_edge
    np.negative(by_edge, out=value[:, ::2])
    return value
