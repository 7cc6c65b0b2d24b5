"""What of a sketch does not change while its vertices are moved, as numbers.

Terms
-----
topology
    Ids, edges, faces and annotations of a graph, without drawn positions. Reasoning about
    annotations needs nothing else, so it is done once and kept while a person drags.
two-path
    Two edges that meet: from one neighbour of a vertex to another.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import chain
from threading import Lock
from typing import Any

import numpy as np

from .annotations import ANNOTATIONS, Annotation
from .graph import Face, Revolution, SketchGraph
from .values import IntArray, kept

#: Topologies that are remembered: a few sketches, each with some edits.
MAX_KEPT = 16
#: A tangle in which everything is joined to everything has more two-paths and closed chains than
#: can be looked at; an object has a few for each edge.
MAX_TWO_PATHS = 200_000
MAX_QUADRILATERALS = 20_000


@dataclass(frozen=True, slots=True, eq=False)
class Topology:
    """Ids and relations of a graph, and their numbers in the graph's own order.

    Parameters
    ----------
    vertices, edges, circles : mappings of id to index
    ends : (m, 2) int array
        Vertex indices of each edge.
    revolutions, faces : as in SketchGraph
    right_angles : (k, 3) int array
        Vertex and the two edges of each annotated right angle.
    kinds : tuple of str
        Of each annotation.
    by_kind : mapping of kind to tuple of (id, Annotation)
    parallels : tuple of int arrays
        Edges of each parallel annotation and of each symmetry plane.
    ground : (g,) int array
        Vertices annotated as on the ground, each once.
    """

    vertices: Mapping[str, int]
    edges: Mapping[str, int]
    circles: Mapping[str, int]
    ends: IntArray
    revolutions: Mapping[str, Revolution]
    faces: Mapping[str, Face] | None
    right_angles: IntArray
    kinds: tuple[str, ...]
    by_kind: Mapping[str, tuple[tuple[str, Any], ...]]
    parallels: tuple[IntArray, ...]
    ground: IntArray


@kept
def topology_of(graph: SketchGraph) -> Topology:
    """The topology of a graph; the same object for graphs that differ in positions only."""
    key = (
        tuple(graph.vertices),
        graph.edges,
        tuple(graph.circles),
        graph.revolutions,
        graph.faces,
        graph.annotations,
    )
    with _lock:
        for i, (known, topology) in enumerate(_kept):
            if _same(known, key):
                _kept.insert(0, _kept.pop(i))
                return topology
    topology = topology_with(graph, graph.annotations)
    with _lock:
        _kept.insert(0, (key, topology))
        del _kept[MAX_KEPT:]
    return topology


def forget_topologies() -> None:
    """Begin anew, as for sketches never seen: what measures a solve from nothing needs this."""
    with _lock:
        _kept.clear()


_Key = tuple[Any, ...]
_kept: list[tuple[_Key, Topology]] = []
_lock = Lock()


def _same(known: _Key, key: _Key) -> bool:
    """Equality that asks for the order of ids as well: numbers go by it."""
    return all(
        a is b or (a == b and (not a or not b or list(a) == list(b)))
        for a, b in zip(known, key, strict=True)
    )


def topology_with(graph: SketchGraph, annotations: Mapping[str, Annotation]) -> Topology:
    """The topology of a graph with some of its annotations, or others."""
    vertices = {v: i for i, v in enumerate(graph.vertices)}
    edges = {e: i for i, e in enumerate(graph.edges)}
    by_kind: dict[str, list[tuple[str, Any]]] = {kind: [] for kind in ANNOTATIONS}
    kinds = tuple([a.kind for a in annotations.values()])
    for kind, item in zip(kinds, annotations.items(), strict=True):
        by_kind[kind].append(item)
    corners = [a for _, a in by_kind["right_angle"]]
    at = indices(vertices, [a.at for a in corners])
    between = indices(edges, chain.from_iterable([a.between for a in corners]))
    together = [a.edges for _, a in by_kind["parallel"]]
    together += [a.midpoints_of for _, a in by_kind["symmetry_plane"]]
    ground = {v for _, a in by_kind["ground"] for v in a.vertices}
    ends = indices(vertices, chain.from_iterable(graph.edges.values()))
    return Topology(
        vertices=vertices,
        edges=edges,
        circles={c: i for i, c in enumerate(graph.circles)},
        ends=ends.reshape(-1, 2),
        revolutions=graph.revolutions,
        faces=graph.faces,
        kinds=kinds,
        by_kind={kind: tuple(items) for kind, items in by_kind.items()},
        right_angles=np.column_stack([at, between.reshape(-1, 2)]),
        parallels=tuple(indices(edges, group) for group in together),
        ground=np.sort(indices(vertices, ground)),
    )


def indices(index: Mapping[str, int], ids: Iterable[str]) -> IntArray:
    """The numbers of ids."""
    return np.array(list(map(index.__getitem__, ids)), dtype=np.int64)


@dataclass(frozen=True, slots=True, eq=False)
class Chains:
    """Short closed chains of edges, (k, 3) and (k, 4) edges in order around, each once."""

    triangles: IntArray
    quadrilaterals: IntArray


def chains(topology: Topology) -> Chains:
    """All closed chains of three and of four edges (of a tangle, as many as are allowed)."""
    ends = topology.ends
    edges = np.arange(len(ends))
    source = np.concatenate([ends[:, 0], ends[:, 1]])
    target = np.concatenate([ends[:, 1], ends[:, 0]])
    edge = np.concatenate([edges, edges])
    order = np.lexsort((target, source))
    paths = _two_paths(source[order], target[order], edge[order])
    return Chains(_triangles(ends, paths), _quadrilaterals(paths))


def _two_paths(source: IntArray, target: IntArray, edge: IntArray) -> IntArray:
    """Rows (a, middle, c, edge to a, edge to c) with a < c; half-edges come sorted by source."""
    found = [np.zeros((0, 5), dtype=np.int64)]
    vertex, first, degree = np.unique(source, return_index=True, return_counts=True)
    room = MAX_TWO_PATHS
    for d in np.unique(degree).tolist():
        pairs = d * (d - 1) // 2
        at = np.flatnonzero(degree == d)[: room // max(1, pairs)]
        if not len(at):
            continue
        p, q = np.triu_indices(d, 1)
        room -= len(at) * len(p)
        i, j = first[at, None] + p, first[at, None] + q
        middle = np.broadcast_to(vertex[at, None], i.shape)
        found.append(
            np.stack([target[i], middle, target[j], edge[i], edge[j]], axis=-1).reshape(-1, 5)
        )
    paths = np.concatenate(found)
    # Two edges between the same vertices are no path.
    return np.asarray(paths[paths[:, 0] < paths[:, 2]])


def _triangles(ends: IntArray, paths: IntArray) -> IntArray:
    last = paths[(paths[:, 1] > paths[:, 0]) & (paths[:, 1] > paths[:, 2])]
    n = int(ends.max(initial=0)) + 1
    low, high = ends.min(axis=1), ends.max(axis=1)
    code, first = np.unique(low * n + high, return_index=True)
    wanted = last[:, 0] * n + last[:, 2]
    at = np.minimum(np.searchsorted(code, wanted), max(0, len(code) - 1))
    if not len(code):
        return np.zeros((0, 3), dtype=np.int64)
    closed = code[at] == wanted
    return np.column_stack([first[at[closed]], last[closed, 4], last[closed, 3]])


def _quadrilaterals(paths: IntArray) -> IntArray:
    """Two-paths between the same two vertices, in pairs."""
    found = [np.zeros((0, 4), dtype=np.int64)]
    n = int(paths[:, :3].max(initial=0)) + 1
    code = paths[:, 0] * n + paths[:, 2]
    # Sorted by the chain's two opposite vertices, the middles in order.
    order = np.lexsort((paths[:, 1], code))
    paths, code = paths[order], code[order]
    _, first, count = np.unique(code, return_index=True, return_counts=True)
    room = MAX_QUADRILATERALS
    for k in np.unique(count[count > 1]).tolist():
        at = first[count == k][: room // (k * (k - 1) // 2)]
        if not len(at):
            continue
        p, q = np.triu_indices(k, 1)
        room -= len(at) * len(p)
        b, d = paths[(at[:, None] + p).reshape(-1)], paths[(at[:, None] + q).reshape(-1)]
        # Each chain is met from both of its diagonals: the one with its first vertex counts.
        once = b[:, 0] < np.minimum(b[:, 1], d[:, 1])
        b, d = b[once], d[once]
        found.append(np.column_stack([b[:, 3], b[:, 4], d[:, 4], d[:, 3]]))
    return np.concatenate(found)
