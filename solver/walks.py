"""Walking round the drawings in several planes at once.

Terms
-----
half-edge
    An edge walked in one direction within one plane; that of the edge walked back is its neighbour
    in the list, k ^ 1.
cycle
    Half-edges one after the other, always turning off to the next one in turn: with the inside on
    the left, a minimal loop; or the way round a whole part of the drawing.
loop
    The vertices of a cycle.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from .union_find import UnionFind
from .values import Array, BoolArray, IntArray, kept

Loop = tuple[int, ...]


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
        Half-edges, cycle by cycle.
    first : (c,) int array
        Where each cycle begins in that order.
    loops : tuple of loops
        Each begins at its smallest vertex.
    simple : (c,) bool array
        Whether a cycle passes each vertex once.
    plane, part : (c,) int arrays
        The plane of each cycle, and the connected part of the drawing there.
    """

    order: IntArray
    first: IntArray
    loops: tuple[Loop, ...]
    simple: BoolArray
    plane: IntArray
    part: IntArray


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
    _, node, degrees = np.unique(walked.plane * n + start, return_inverse=True, return_counts=True)
    if degrees.min(initial=2) > 1:
        return walked
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
    order = np.lexsort((angles, nodes))
    sorted_nodes = nodes[order]
    first = np.flatnonzero(np.append(True, sorted_nodes[1:] != sorted_nodes[:-1]))
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
    ahead = np.frombuffer(following_bytes, dtype=np.int64).tolist()
    vertex, seen = (nodes % n).tolist(), bytearray(len(ahead))
    order: list[int] = []
    firsts, loops = [], []
    for start in np.argsort(nodes, kind="stable").tolist():
        if seen[start]:
            continue
        firsts.append(len(order))
        k = start
        while not seen[k]:
            seen[k] = 1
            order.append(k)
            k = ahead[k]
        loops.append(tuple([vertex[k] for k in order[firsts[-1] :]]))
    places, first = np.array(order, dtype=np.int64), np.array(firsts, dtype=np.int64)
    _, local = np.unique(nodes[places], return_inverse=True)
    return Walk(
        places,
        first,
        tuple(loops),
        np.array([len(set(loop)) == len(loop) for loop in loops], dtype=bool),
        nodes[places[first]] // n,
        _parts(local.reshape(-1).tolist(), [*firsts, len(order)]),
    )


def _parts(nodes: list[int], firsts: list[int]) -> IntArray:
    """For each cycle the connected part that its nodes belong to."""
    sets = UnionFind(max(nodes, default=-1) + 1)
    for first, last in pairwise(firsts):
        for i in nodes[first + 1 : last]:
            sets.union(nodes[first], i)
    return np.array([sets.find(nodes[first]) for first in firsts[:-1]], dtype=np.int64)
