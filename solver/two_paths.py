"""Pairs of edges that meet, all at once.

Terms
-----
half-edge
    An edge as seen from one of its ends, its source; the other end is its target.
two-path
    Two edges that meet: from one neighbour of a vertex, the middle, to another.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .values import IntArray, kept


@dataclass(frozen=True, slots=True, eq=False)
class TwoPaths:
    """Two-paths a - middle - c and their edges, (p,) int arrays.

    Those about one middle stand together, middles in the order in which edges first name them; the
    edge to `a` was drawn before that to `c`.
    """

    middle: IntArray
    a: IntArray
    c: IntArray
    to_a: IntArray
    to_c: IntArray

    def __len__(self) -> int:
        return len(self.middle)


@kept
def two_paths(ends: IntArray, n: int, room: int) -> TwoPaths:
    """The two-paths of edges between n vertices; of a tangle, no more than there is room for.

    Parameters
    ----------
    ends : (m, 2) int array
        Read-only.
    n, room : int
    """
    starts, count = ends.reshape(-1), 2 * len(ends)
    first_named = np.zeros(n, dtype=np.int64)
    first_named[starts[::-1]] = np.arange(count)[::-1]
    # Sorted by source; the half-edge's own number comes along, the other way round it is k ^ 1.
    half = np.sort(first_named[starts] * count + np.arange(count)) % max(1, count)
    source, target = starts[half], starts[half ^ 1]
    begins = run_begins(source)
    i, j = pairs_of_runs(np.diff(begins, append=count), room)
    edge = half >> 1
    return TwoPaths(source[i], target[i], target[j], edge[i], edge[j])


def run_begins(values: IntArray) -> IntArray:
    """Where runs of equal values begin."""
    begins = np.ones(len(values), dtype=bool)
    np.not_equal(values[1:], values[:-1], out=begins[1:])
    return np.flatnonzero(begins)


def pairs_of_runs(lengths: IntArray, room: int) -> tuple[IntArray, IntArray]:
    """All pairs of places i < j within runs of so many places that follow each other.

    Where there are more than there is room for, the longest runs are left out.
    """
    pairs = lengths * (lengths - 1) // 2
    places, begins = np.arange(int(lengths.sum())), np.cumsum(lengths)
    after = np.repeat(begins, lengths) - places - 1
    if int(pairs.sum()) > room:
        order = np.argsort(pairs, kind="stable")
        fits = np.empty(len(pairs), dtype=bool)
        fits[order] = np.cumsum(pairs[order]) <= room
        after *= np.repeat(fits, lengths)
    i = np.repeat(places, after)
    j = np.arange(len(i)) - np.repeat(np.cumsum(after) - after, after) + i + 1
    return i, j
