"""Short closed chains of edges: triangles and quadrilaterals, planar or not.

Terms
-----
half-edge
    An edge as seen from one of its ends, its source; the other end is its target.
two-path
    Two edges that meet: from one neighbour of a vertex, the middle, to another.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .merging import are_among
from .topology import Topology
from .values import IntArray

#: A tangle in which everything is joined to everything has more two-paths and closed chains than
#: can be looked at; an object has a few for each edge.
MAX_TWO_PATHS = 200_000
MAX_QUADRILATERALS = 20_000


@dataclass(frozen=True, slots=True, eq=False)
class Chains:
    """Short closed chains of edges, (k, 3) and (k, 4) edges in order around, each once."""

    triangles: IntArray
    quadrilaterals: IntArray


@dataclass(frozen=True, slots=True, eq=False)
class _TwoPaths:
    """Vertices a < c and the middle between them; the edges from the middle to both, (p,)."""

    a: IntArray
    middle: IntArray
    c: IntArray
    to_a: IntArray
    to_c: IntArray

    def __getitem__(self, chosen: IntArray) -> _TwoPaths:
        parts = (self.a, self.middle, self.c, self.to_a, self.to_c)
        return _TwoPaths(*(part[chosen] for part in parts))


def chains(topology: Topology) -> Chains:
    """All closed chains of three and of four edges (of a tangle, as many as are allowed)."""
    ends, n = topology.ends, len(topology.vertices)
    paths = _two_paths(ends, n)
    return Chains(_triangles(ends, paths, n), _quadrilaterals(paths, n))


def _two_paths(ends: IntArray, n: int) -> _TwoPaths:
    m = len(ends)
    # Half-edges by source and then by target: one sort of both, and of their own number.
    (v, w), own = ends.T, np.arange(m)
    code = np.concatenate([(v * n + w) * 2 * m + own, (w * n + v) * 2 * m + own + m])
    half = np.sort(code) % max(1, 2 * m)
    source, target = np.concatenate([v, w])[half], np.concatenate([w, v])[half]
    edge = half % max(1, m)
    i, j = _pairs_of_runs(np.bincount(source, minlength=n), MAX_TWO_PATHS)
    paths = _TwoPaths(target[i], source[i], target[j], edge[i], edge[j])
    # Two edges between the same vertices are no path.
    return paths[np.flatnonzero(paths.a < paths.c)]


def _pairs_of_runs(lengths: IntArray, room: int) -> tuple[IntArray, IntArray]:
    """All pairs i < j within runs of so many places, one run after the other; no more than room."""
    first = np.cumsum(lengths) - lengths
    lower, upper = [np.zeros(0, dtype=np.int64)], [np.zeros(0, dtype=np.int64)]
    for length in np.flatnonzero(np.bincount(lengths)).tolist():
        pairs = length * (length - 1) // 2
        at = first[np.flatnonzero(lengths == length)[: room // max(1, pairs)]]
        if pairs and len(at):
            p, q = _pairs_below(length)
            lower.append((at[:, None] + p).reshape(-1))
            upper.append((at[:, None] + q).reshape(-1))
            room -= len(at) * pairs
    return np.concatenate(lower), np.concatenate(upper)


@lru_cache(maxsize=16)
def _pairs_below(n: int) -> tuple[IntArray, IntArray]:
    """All pairs of numbers i < j < n."""
    i, j = np.triu_indices(n, 1)
    return i, j


def _triangles(ends: IntArray, paths: _TwoPaths, n: int) -> IntArray:
    # Each is met from its three vertices: the greatest one counts.
    last = paths[np.flatnonzero((paths.middle > paths.a) & (paths.middle > paths.c))]
    code = ends.min(axis=1) * n + ends.max(axis=1)
    closed = last[np.flatnonzero(are_among(last.a * n + last.c, code, n * n))]
    if not len(closed.a):
        return np.zeros((0, 3), dtype=np.int64)
    known, first = np.unique(code, return_index=True)
    joining = first[np.searchsorted(known, closed.a * n + closed.c)]
    return np.column_stack([joining, closed.to_c, closed.to_a])


def _quadrilaterals(paths: _TwoPaths, n: int) -> IntArray:
    """Two-paths between the same two vertices, in pairs."""
    # Each is met from both of its diagonals: the one that ends at its first vertex counts.
    paths = paths[np.flatnonzero(paths.a < paths.middle)]
    bits = len(paths.a).bit_length()
    code = np.sort((paths.a * n + paths.c << bits) + np.arange(len(paths.a)))
    between = code >> bits
    begins = np.flatnonzero(np.append(True, between[1:] != between[:-1]))
    lengths = np.diff(begins, append=len(code))
    i, j = _pairs_of_runs(lengths, MAX_QUADRILATERALS)
    paths = paths[code & ((1 << bits) - 1)]
    return np.column_stack([paths.to_a[i], paths.to_c[i], paths.to_c[j], paths.to_a[j]])
