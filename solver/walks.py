"""Walking round the drawings in several planes at once.

Terms
-----
half-edge
    An edge walked in one direction within one plane; that of the edge walked back is its neighbour
    in the list, k ^ 1.
node
    A vertex in one of the planes.
cycle
    Half-edges one after the other, always turning off to the next one in turn: with the inside on
    the left, a minimal loop; or the way round a whole part of the drawing.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from .merging import first_members
from .two_paths import run_begins
from .values import Array, BoolArray, IntArray, kept

T = TypeVar("T")

#: From this number of nodes on angles are compared by themselves: in one number with so many nodes
#: they would lose digits.
MANY_NODES = 1_000_000


@dataclass(frozen=True, slots=True, eq=False)
class HalfEdges:
    """The plane and the first vertex of each half-edge."""

    plane: IntArray
    start: IntArray


@dataclass(frozen=True, slots=True, eq=False)
class Walk:
    """The cycles of half-edges.

    Parameters
    ----------
    order : (h,) int array
        Half-edges, cycle by cycle; each cycle begins at its smallest vertex.
    first : (c,) int array
        Where each cycle begins in that order.
    vertices, ascending : (h,) int arrays
        The vertices in that order, and sorted within each cycle.
    simple : (c,) bool array
        Whether a cycle passes each vertex once.
    plane : (c,) int array
        The plane of each cycle.
    """

    order: IntArray
    first: IntArray
    vertices: IntArray
    ascending: IntArray
    simple: BoolArray
    plane: IntArray

    def runs(self, values: tuple[T, ...], cycles: IntArray) -> list[tuple[T, ...]]:
        """What belongs to each of some cycles, of values in the order of the walk."""
        first, last = self.first[cycles], np.append(self.first, len(self.order))[cycles + 1]
        return [values[a:b] for a, b in zip(first.tolist(), last.tolist(), strict=True)]

    def least_vertices(self, cycles: IntArray) -> IntArray:
        """The four least vertices of each of some cycles, -1 where there are no more, (k, 4)."""
        lengths = np.diff(self.first, append=len(self.order))[cycles]
        places = self.first[cycles, None] + np.arange(4)
        there = np.arange(4) < lengths[:, None]
        return np.where(there, self.ascending[np.where(there, places, 0)], -1)


def without_dead_ends(plane: IntArray, ends: IntArray, n: int) -> HalfEdges:
    """The half-edges of edges in planes, those left out that hang on one end, one after the other.

    Parameters
    ----------
    plane : (k,) int array
    ends : (k, 2) int array
        Vertices of each edge.
    n : int
        Number of vertices.
    """
    start = ends.reshape(-1)
    walked = HalfEdges(np.repeat(plane, 2), start)
    if not len(start):
        return walked
    nodes = walked.plane * n + start
    degrees = np.bincount(nodes)
    if int(degrees[nodes].min()) > 1:
        return walked
    _, node, degrees = np.unique(nodes, return_inverse=True, return_counts=True)
    left, at = degrees.tolist(), node.reshape(-1).tolist()
    around: list[list[int]] = [[] for _ in left]
    for half_edge, i in enumerate(at):
        around[i].append(half_edge)
    stays = np.ones(len(at), dtype=bool)
    hanging = [i for i, degree in enumerate(left) if degree == 1]
    while hanging:
        for half_edge in around[hanging.pop()]:
            if stays[half_edge]:
                stays[half_edge] = stays[half_edge ^ 1] = False
                other = at[half_edge ^ 1]
                left[other] -= 1
                if left[other] == 1:
                    hanging.append(other)
    return HalfEdges(walked.plane[stays], start[stays])


def walk_round(walked: HalfEdges, angles: Array, n: int) -> Walk:
    """Walk round all cycles.

    Parameters
    ----------
    walked : HalfEdges
    angles : (h,) array
        Direction of each half-edge in its plane, rad.
    n : int
        Number of vertices.
    """
    nodes = walked.plane * n + walked.start
    # The next one clockwise from where we came keeps the loop's inside on the left.
    # Planes come in order.
    if (int(walked.plane[-1]) + 1) * n < MANY_NODES:
        order = np.argsort(8 * nodes + angles, kind="stable")
    else:
        order = np.lexsort((angles, nodes))
    first = run_begins(nodes[order])
    before = np.arange(-1, len(order) - 1)
    before[first] = np.append(first[1:], len(order)) - 1
    clockwise = np.empty_like(order)
    clockwise[order] = order[before]
    following = clockwise[np.arange(len(nodes)) ^ 1]
    # Moving vertices about seldom changes what follows what.
    return _cycles(n, nodes.tobytes(), following.tobytes())


@kept
def _cycles(n: int, node_bytes: bytes, following_bytes: bytes) -> Walk:
    nodes = np.frombuffer(node_bytes, dtype=np.int64)
    following = np.frombuffer(following_bytes, dtype=np.int64)
    count = len(nodes)
    by_node = np.argsort(nodes, kind="stable")
    rank = np.empty(count, dtype=np.int64)
    rank[by_node] = np.arange(count)
    start = _least_ahead(rank, following)
    begins = start == rank
    # Cycles in the order of their starts.
    number = np.cumsum(begins[by_node]) - 1
    cycle = number[start]
    lengths = np.bincount(cycle)
    first = np.cumsum(lengths) - lengths
    left = _steps_to(begins, following)
    order = np.empty(count, dtype=np.int64)
    order[first[cycle] + np.where(begins, 0, lengths[cycle] - left)] = np.arange(count)
    planes, vertices = np.divmod(nodes[order], n)
    in_cycle = np.repeat(np.arange(len(first)) * n, lengths)
    ascending = np.sort(in_cycle + vertices)
    simple = np.ones(len(first), dtype=bool)
    simple[ascending[1:][ascending[1:] == ascending[:-1]] // n] = False
    return Walk(order, first, vertices, ascending - in_cycle, simple, planes[first])


def _least_ahead(rank: IntArray, following: IntArray) -> IntArray:
    """The least rank in the cycle of each half-edge; it looks twice as far ahead each time."""
    while True:
        ahead = rank[following]
        if (ahead >= rank).all():
            return rank
        rank, following = np.minimum(rank, ahead), following[following]


def _steps_to(marked: BoolArray, following: IntArray) -> IntArray:
    """How many steps it is from each half-edge to the next marked one; 0 from those."""
    ahead = np.where(marked, np.arange(len(marked)), following)
    steps = (~marked).astype(np.int64)
    while not marked[ahead].all():
        steps, ahead = steps + steps[ahead], ahead[ahead]
    return steps


def connected_parts(walked: HalfEdges, walk: Walk, n: int) -> IntArray:
    """The connected part of its plane's drawing that each cycle belongs to, (c,)."""
    names, node = np.unique(walked.plane * n + walked.start, return_inverse=True)
    node = node.reshape(-1)
    parts = first_members(node.reshape(-1, 2), len(names))
    return np.asarray(parts[node[walk.order[walk.first]]])
