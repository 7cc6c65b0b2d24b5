"""Short closed chains of edges: triangles and quadrilaterals, planar or not."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .merging import are_among
from .topology import Topology
from .two_paths import pairs_of_runs, run_begins, two_paths
from .values import IntArray, kept

#: A tangle in which everything is joined to everything has more two-paths and closed chains than
#: can be looked at; an object has a few for each edge.
MAX_TWO_PATHS = 200_000
MAX_QUADRILATERALS = 20_000


@dataclass(frozen=True, slots=True, eq=False)
class Chains:
    """Short closed chains of edges, (k, 3) and (k, 4) edges in order around, each once."""

    triangles: IntArray
    quadrilaterals: IntArray


def chains(topology: Topology) -> Chains:
    """All closed chains of three and of four edges (of a tangle, as many as are allowed)."""
    return _chains(topology.ends, len(topology.vertices))


@kept
def _chains(ends: IntArray, n: int) -> Chains:
    # Whatever is said of the edges, their chains stay.
    paths = two_paths(ends, n, MAX_TWO_PATHS)
    # From the lower end to the higher one; two edges between the same vertices are no path.
    turned, proper = paths.a > paths.c, paths.a != paths.c
    low, high = np.minimum(paths.a, paths.c), np.maximum(paths.a, paths.c)
    sides = np.column_stack(
        [np.where(turned, paths.to_c, paths.to_a), np.where(turned, paths.to_a, paths.to_c)]
    )
    # A triangle is met from its three vertices: the greatest one counts. A quadrilateral is met
    # from both of its diagonals: the one that ends at its least vertex counts.
    last = np.flatnonzero(proper & (paths.middle > high))
    first = np.flatnonzero(proper & (low < paths.middle))
    return Chains(
        _triangles(ends, (low * n + high)[last], sides[last], n),
        _quadrilaterals((low * n + high)[first], sides[first]),
    )


def _triangles(ends: IntArray, across: IntArray, sides: IntArray, n: int) -> IntArray:
    """Two-paths whose ends an edge joins."""
    code = ends.min(axis=1) * n + ends.max(axis=1)
    closed = np.flatnonzero(are_among(across, code, n * n))
    if not len(closed):
        return np.zeros((0, 3), dtype=np.int64)
    known, first = np.unique(code, return_index=True)
    joining = first[np.searchsorted(known, across[closed])]
    return np.column_stack([joining, sides[closed, ::-1]])


def _quadrilaterals(across: IntArray, sides: IntArray) -> IntArray:
    """Two-paths between the same two vertices, in pairs."""
    bits = len(across).bit_length()
    order = np.sort((across << bits) + np.arange(len(across)))
    begins = run_begins(order >> bits)
    i, j = pairs_of_runs(np.diff(begins, append=len(order)), MAX_QUADRILATERALS)
    sides = sides[order & ((1 << bits) - 1)]
    # Two edges between the same vertices would make one with a side twice.
    whole = np.flatnonzero((sides[i] != sides[j]).all(axis=1))
    return np.hstack([sides[i[whole]], sides[j[whole], ::-1]])
