"""From annotations to few unknowns: object axes and shared coordinates (reduction of [Lau10] 4.2).

The paper gives a ground vertex two dimensions and the completed corner of a right-angled
quadrilateral none. The same idea, taken to its end: in axes along which the object's edges run,
vertices *share* coordinates, and right angles, parallels and the ground hold by construction.

Terms
-----
object axes
    Three perpendicular directions, axis 0, 1, 2, along which the direction classes with the most
    drawn length run; the third may be without any edge.
coordinate
    One number along one object axis, shared by all vertices that the annotations tie together.
vertical
    The object axis square to the ground, where there is one.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .annotations import Annotation, Ground, OnFace
from .directions import Directions, direction_classes
from .graph import SketchGraph
from .union_find import UnionFind

IntArray = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Structure:
    """What the annotations say about the unknowns.

    Parameters
    ----------
    directions : Directions
    axis_of_class : mapping of class to axis
        The classes that run along an object axis.
    edge_axis : (m,) int array
        The axis of each edge, -1 for edges along none.
    edge_across : (m, 3) bool array
        Whether the edge is perpendicular to the axis by construction.
    coordinate : (n + k, 3) int array
        Index of the shared coordinate along each axis, of each vertex and then of each circle's
        centre.
    radius : (k,) int array
        Index of each circle's radius, behind the coordinates.
    n_coordinates : int
        Coordinates and radii together.
    vertical : int or None
    has_axes : bool
        False where no two perpendicular classes are known; the axes are then arbitrary.
    contradiction : bool
        True where annotations cannot all hold, whatever the drawing.
    """

    directions: Directions
    axis_of_class: dict[int, int]
    edge_axis: IntArray
    edge_across: NDArray[np.bool_]
    coordinate: IntArray
    radius: IntArray
    n_coordinates: int
    vertical: int | None
    has_axes: bool
    contradiction: bool


def build_structure(
    graph: SketchGraph, annotations: Iterable[Annotation] | None = None
) -> Structure:
    """Reason out axes and shared coordinates.

    Parameters
    ----------
    graph : SketchGraph
    annotations : iterable of Annotation, optional
        Those to use; by default all of the graph's.
    """
    said = tuple(graph.annotations.values() if annotations is None else annotations)
    directions = direction_classes(graph, said)
    axes = _choose_axes(graph, directions)
    axis_of_class = {c: k for k, c in enumerate(axes)}
    edge_axis, edge_across = _edges_on_axes(graph, directions, axis_of_class)
    ground = _ground_vertices(said)
    vertical = _vertical_axis(graph, edge_axis, edge_across, ground) if axes else None
    if graph.circles and vertical is None:
        # Circles are horizontal: some axis must be vertical.
        vertical = _most_upright_axis(graph, edge_axis) if axes else 2
    coordinate = _share_coordinates(graph, edge_axis, edge_across, said, vertical)
    edge_axis, edge_across, collapsed = _edges_by_coordinates(graph, coordinate)
    n_shared = int(coordinate.max()) + 1 if coordinate.size else 0
    return Structure(
        directions=directions,
        axis_of_class=axis_of_class,
        edge_axis=edge_axis,
        edge_across=edge_across,
        coordinate=coordinate,
        radius=n_shared + np.arange(len(graph.circles)),
        n_coordinates=n_shared + len(graph.circles),
        vertical=vertical,
        has_axes=bool(axes),
        contradiction=directions.contradiction or collapsed,
    )


def _choose_axes(graph: SketchGraph, directions: Directions) -> tuple[int, ...]:
    """The mutually perpendicular triple (else pair) of classes with the most drawn length."""
    if directions.contradiction:
        return ()
    drawn: dict[int, float] = {}
    for c, (v, w) in zip(directions.class_of, graph.edges.values(), strict=True):
        (x0, y0), (x1, y1) = graph.vertices[v], graph.vertices[w]
        drawn[c] = drawn.get(c, 0.0) + float(np.hypot(x1 - x0, y1 - y0))
    best: tuple[int, ...] = ()
    best_score = (0, 0.0)
    perp = directions.perpendicular
    for a in sorted(perp):
        for b in sorted(c for c in perp[a] if c > a):
            thirds = sorted(c for c in perp[a] & perp[b] if c > b)
            for axes in [(a, b), *((a, b, c) for c in thirds)]:
                score = (len(axes), sum(drawn[i] for i in axes))
                if score > best_score:
                    best, best_score = axes, score
    return best


def _edges_on_axes(
    graph: SketchGraph, directions: Directions, axis_of_class: dict[int, int]
) -> tuple[IntArray, NDArray[np.bool_]]:
    n_edges = len(graph.edges)
    edge_axis = np.full(n_edges, -1, dtype=np.int64)
    edge_across = np.zeros((n_edges, 3), dtype=bool)
    for e, c in enumerate(directions.class_of):
        if c in axis_of_class:
            edge_axis[e] = axis_of_class[c]
            edge_across[e] = True
            edge_across[e, axis_of_class[c]] = False
            continue
        for other in directions.perpendicular.get(c, ()):
            if other in axis_of_class:
                edge_across[e, axis_of_class[other]] = True
    return _along_third_axis(edge_axis, edge_across)


def _along_third_axis(
    edge_axis: IntArray, edge_across: NDArray[np.bool_]
) -> tuple[IntArray, NDArray[np.bool_]]:
    """What is perpendicular to two axes runs along the third."""
    free = (edge_axis < 0) & (edge_across.sum(axis=1) == 2)
    edge_axis[free] = np.argmin(edge_across[free], axis=1)
    return edge_axis, edge_across


def _vertical_axis(
    graph: SketchGraph,
    edge_axis: IntArray,
    edge_across: NDArray[np.bool_],
    ground: list[str],
) -> int | None:
    """The axis to which all edges between ground vertices are square and most others climb."""
    if not ground:
        return None
    on_ground = set(ground)
    inside = [v in on_ground and w in on_ground for v, w in graph.edges.values()]
    joining = [(v in on_ground) != (w in on_ground) for v, w in graph.edges.values()]
    flat = edge_across[np.array(inside, dtype=bool)].all(axis=0)
    if not any(inside) and not any(joining):
        return None
    climbing = edge_axis[np.array(joining, dtype=bool)]
    scores = [(int(np.count_nonzero(climbing == k)), -k) if flat[k] else (-1, -k) for k in range(3)]
    best = max(range(3), key=lambda k: scores[k])
    sure = scores[best][0] > 0 or (scores[best][0] == 0 and int(flat.sum()) == 1)
    return best if sure else None


def _most_upright_axis(graph: SketchGraph, edge_axis: IntArray) -> int:
    """The axis whose edges are drawn most upright, by their mean lean."""
    leans = np.full(3, np.inf)
    for k in range(3):
        drawn = [ends for ends, a in zip(graph.edges.values(), edge_axis, strict=True) if a == k]
        deltas = [np.subtract(graph.vertices[w], graph.vertices[v]) for v, w in drawn]
        if deltas:
            total = np.sum([np.abs(d) for d in deltas], axis=0)
            leans[k] = np.arctan2(total[0], total[1])
    return int(np.argmin(leans))


def _share_coordinates(
    graph: SketchGraph,
    edge_axis: IntArray,
    edge_across: NDArray[np.bool_],
    said: tuple[Annotation, ...],
    vertical: int | None,
) -> IntArray:
    index = {v: i for i, v in enumerate(graph.vertices)}
    n_points = len(index) + len(graph.circles)
    circle = {c: len(index) + i for i, c in enumerate(graph.circles)}
    sets = UnionFind(3 * n_points)
    for across, (v, w) in zip(edge_across, graph.edges.values(), strict=True):
        for axis in np.flatnonzero(across).tolist():
            sets.union(3 * index[v] + axis, 3 * index[w] + axis)
    if vertical is not None:
        on_ground = [index[v] for v in _ground_vertices(said)]
        on_ground += [circle[c] for c in ground_circles(graph)]
        _share(sets, [3 * i + vertical for i in on_ground])
        for r in graph.revolutions.values():
            for k in {0, 1, 2} - {vertical}:
                _share(sets, [3 * circle[c] + k for c in (r.ground, r.bottom, r.top)])
    touching: dict[str, list[str]] = {}
    for annotation in said:
        if isinstance(annotation, OnFace):
            touching.setdefault(annotation.face, []).append(annotation.vertex)
    axis_between = {
        frozenset(ends): int(k) for ends, k in zip(graph.edges.values(), edge_axis, strict=True)
    }
    for id_, face in (graph.faces or {}).items():
        in_plane = [v for loop in face.loops for v in loop] + touching.get(id_, [])
        for k in _square_axes(face.loop, sets, index, axis_between):
            _share(sets, [3 * index[v] + k for v in in_plane])
    labels = np.array(sets.labels(), dtype=np.int64)
    _, coordinate = np.unique(labels, return_inverse=True)
    return coordinate.reshape(n_points, 3).astype(np.int64)


def _share(sets: UnionFind, members: list[int]) -> None:
    for i in members[1:]:
        sets.union(members[0], i)


def _square_axes(
    loop: tuple[str, ...],
    sets: UnionFind,
    index: dict[str, int],
    axis_between: dict[frozenset[str], int],
) -> list[int]:
    """The axes to which a planar face is square: edges along the two others, or shared already."""
    along = {axis_between.get(frozenset((loop[k - 1], loop[k])), -1) for k in range(len(loop))}
    shared = [k for k in range(3) if len({sets.find(3 * index[v] + k) for v in loop}) == 1]
    return [k for k in range(3) if k in shared or {0, 1, 2} - {k} <= along]


def ground_circles(graph: SketchGraph) -> list[str]:
    """The circles that stand on the ground: each revolution's first ([Lau10] 4.2)."""
    return sorted({r.ground for r in graph.revolutions.values()})


def _ground_vertices(said: tuple[Annotation, ...]) -> list[str]:
    return sorted({v for a in said if isinstance(a, Ground) for v in a.vertices})


def _edges_by_coordinates(
    graph: SketchGraph, coordinate: IntArray
) -> tuple[IntArray, NDArray[np.bool_], bool]:
    """Which edges run along or across which axis, now that coordinates are shared.

    The last value tells whether some edge's two ends came out as one and the same point.
    """
    index = {v: i for i, v in enumerate(graph.vertices)}
    ends = np.array([[index[v], index[w]] for v, w in graph.edges.values()], dtype=np.int64)
    ends = ends.reshape(-1, 2)
    across = coordinate[ends[:, 0]] == coordinate[ends[:, 1]]
    axis = np.where(across.sum(axis=1) == 2, np.argmin(across, axis=1), -1)
    return axis.astype(np.int64), across, bool((across.sum(axis=1) == 3).any())
