"""Planes of symmetry square to an object axis: what they say is linear in the shared coordinates.

The ends of two edges that cross such a plane are in balance: g_i + g_j = g_k + g_l. So they are
held by a projection, once and for all, where what is curved has to be put back at each step.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .structure import Structure
from .topology import MAX_KEPT
from .values import Array

#: Less than this, in parts of the shape's distance, is in balance.
EXACT = 1e-15


@dataclass(frozen=True, slots=True, eq=False)
class Balances:
    """The balances of a structure.

    Parameters
    ----------
    rows : (b, g) array
        What g has to make 0.
    held : (g, g) array
        Takes any g to the nearest one in balance.
    """

    rows: Array
    held: Array

    def __len__(self) -> int:
        return len(self.rows)

    def hold(self, g: Array) -> Array:
        """The nearest coordinates in balance; the same ones where they are."""
        off = float(np.abs(self.rows @ g).max(initial=0.0))
        return g if off <= EXACT else np.asarray(self.held @ g)


@lru_cache(maxsize=MAX_KEPT)
def balances_of(structure: Structure) -> Balances:
    """The balances that planes of symmetry ask for."""
    m = structure.n_coordinates
    rows = np.zeros((len(structure.balances), m))
    at = np.arange(len(rows))
    for column, sign in zip(structure.balances.T, (1.0, 1.0, -1.0, -1.0), strict=True):
        rows[at, column] += sign
    if not len(rows):
        return Balances(rows, np.zeros((0, 0)))
    return Balances(rows, np.eye(m) - np.linalg.pinv(rows) @ rows)
