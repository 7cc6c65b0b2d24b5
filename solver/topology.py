"""What of a sketch does not change while its vertices are moved, as numbers.

Terms
-----
topology
    Ids, edges, faces and annotations of a graph, without drawn positions. Reasoning about
    annotations needs nothing else, so it is done once and kept while a person drags.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import chain, compress
from operator import itemgetter
from threading import Lock
from typing import Any

import numpy as np

from .annotations import SAID, Annotation, RightAngle
from .graph import Face, Revolution, SketchGraph
from .values import IntArray, forget_by, kept

#: Topologies that are remembered: a few sketches, each with some edits.
MAX_KEPT = 16


@dataclass(frozen=True, slots=True, eq=False)
class Topology:
    """Ids and relations of a graph, and their numbers in the graph's own order.

    Parameters
    ----------
    vertices, edges, circles : mappings of id to index
    ends : (m, 2) int array
        Vertex indices of each edge.
    revolutions, faces : as in SketchGraph
    annotations : tuple of str
        Their ids.
    right_angles : (k, 3) int array
        Vertex and the two edges of each annotated right angle.
    right_angle_places : (k,) int array
        Where these stand among the annotations.
    by_kind : mapping of kind to tuple of (id, Annotation)
        All but the right angles, the most by far.
    places : mapping of kind to tuple of int
        Where those stand among the annotations.
    parallels : tuple of int arrays
        Edges of each parallel annotation and of each symmetry plane.
    ground : (g,) int array
        Vertices annotated as on the ground, each once.
    rims : (t, 2) int array
        Vertices and the circles on which they lie (`rims`).
    """

    vertices: Mapping[str, int]
    edges: Mapping[str, int]
    circles: Mapping[str, int]
    ends: IntArray
    revolutions: Mapping[str, Revolution]
    faces: Mapping[str, Face] | None
    annotations: tuple[str, ...]
    right_angles: IntArray
    right_angle_places: IntArray
    by_kind: Mapping[str, tuple[tuple[str, Any], ...]]
    places: Mapping[str, tuple[int, ...]]
    parallels: tuple[IntArray, ...]
    ground: IntArray
    rims: IntArray


@kept
def topology_of(graph: SketchGraph) -> Topology:
    """The topology of a graph; the same object for graphs that differ in positions only."""
    key = (
        tuple(graph.vertices),
        graph.edges,
        tuple(graph.circles),
        graph.revolutions,
        graph.drawn_faces,
        graph.annotations,
        _on_rims(graph),
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


_Key = tuple[Any, ...]
_kept: list[tuple[_Key, Topology]] = []
_lock = Lock()
forget_by(_kept.clear)


def _same(known: _Key, key: _Key) -> bool:
    """Equality that asks for the order of ids as well: numbers go by it."""
    return all(
        a is b or (a == b and (not a or not b or list(a) == list(b)))
        for a, b in zip(known, key, strict=True)
    )


def topology_with(graph: SketchGraph, annotations: Mapping[str, Annotation]) -> Topology:
    """The topology of a graph with some of its annotations, or others."""
    vertices, edges, circles = (
        dict(zip(names, range(len(names)), strict=True))
        for names in (graph.vertices, graph.edges, graph.circles)
    )
    ids, said = tuple(annotations), [*annotations.values()]
    square = [isinstance(a, RightAngle) for a in said]
    corners: list[Any] = [*compress(said, square)]
    is_square = np.frombuffer(bytes(square), dtype=bool)
    by_kind: dict[str, list[tuple[str, Any]]] = {k: [] for k in SAID if k != RightAngle.kind}
    places: dict[str, list[int]] = {kind: [] for kind in by_kind}
    for place in np.flatnonzero(~is_square).tolist():
        kind = said[place].kind
        by_kind[kind].append((ids[place], said[place]))
        places[kind].append(place)
    between = indices(edges, [e for a in corners for e in a.between]).reshape(-1, 2)
    together = [a.edges for _, a in by_kind["parallel"]]
    together += [a.midpoints_of for _, a in by_kind["symmetry_plane"]]
    ground = {v for _, a in by_kind["ground"] for v in a.vertices}
    return Topology(
        vertices=vertices,
        edges=edges,
        circles=circles,
        ends=edge_ends(tuple(vertices), graph.edges),
        revolutions=graph.revolutions,
        faces=graph.drawn_faces,
        annotations=ids,
        right_angles=np.column_stack([indices(vertices, [a.at for a in corners]), between]),
        right_angle_places=np.flatnonzero(is_square),
        by_kind={kind: tuple(items) for kind, items in by_kind.items()},
        places={kind: tuple(at) for kind, at in places.items()},
        parallels=tuple(indices(edges, group) for group in together),
        ground=np.sort(indices(vertices, [*ground])),
        rims=np.array(_on_rims(graph), dtype=np.int64).reshape(-1, 2),
    )


@kept
def _on_rims(graph: SketchGraph) -> tuple[tuple[int, int], ...]:
    """Vertices drawn on axis ends of circles, and these, by number; moved together they stay so."""
    if not graph.circles:
        return ()
    drawn = [*enumerate(graph.vertices.values())]
    circles = [(k, {*c.a, *c.b}) for k, c in enumerate(graph.circles.values())]
    return tuple((i, k) for k, ends in circles for i, place in drawn if place in ends)


@kept
def edge_ends(vertices: tuple[str, ...], edges: Mapping[str, tuple[str, str]]) -> IntArray:
    """Vertex indices of each edge, (m, 2); read-only."""
    index = dict(zip(vertices, range(len(vertices)), strict=True))
    ends = indices(index, [*chain.from_iterable(edges.values())]).reshape(-1, 2)
    ends.setflags(write=False)
    return ends


def indices(index: Mapping[str, int], ids: Sequence[str]) -> IntArray:
    """The numbers of ids."""
    # At once is twice as fast as one by one; a getter of one thing gives no tuple.
    several = itemgetter(*ids)(index) if len(ids) > 1 else [index[id_] for id_ in ids]
    return np.fromiter(several, np.int64, len(ids))
