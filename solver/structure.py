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

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .annotations import Annotation
from .directions import Directions, direction_classes
from .graph import Revolution, SketchGraph
from .merging import first_members, numbered
from .named_faces import NamedFaces, named_faces
from .topology import MAX_KEPT, Topology, topology_of, topology_with
from .unlike_angles import angles_clash
from .values import Array, BoolArray, IntArray, kept


@dataclass(frozen=True, slots=True, eq=False)
class Structure:
    """What the annotations say about the unknowns.

    Parameters
    ----------
    directions : Directions
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
    balances : (b, 4) int array
        Coordinates i, j, k, l with g_i + g_j = g_k + g_l: the ends of two edges that run along an
        axis and cross the same plane of symmetry.
    balance_owners : tuple of str
        The annotation that asks for each.
    vertical : int or None
    has_axes : bool
        False where no two perpendicular classes are known; the axes are then arbitrary.
    contradiction : bool
        True where annotations cannot all hold, whatever the drawing.
    """

    directions: Directions
    edge_axis: IntArray
    edge_across: BoolArray
    coordinate: IntArray
    radius: IntArray
    n_coordinates: int
    balances: IntArray
    balance_owners: tuple[str, ...]
    vertical: int | None
    has_axes: bool
    contradiction: bool


def build_structure(
    graph: SketchGraph, annotations: Mapping[str, Annotation] | None = None
) -> Structure:
    """Reason out axes and shared coordinates.

    Parameters
    ----------
    graph : SketchGraph
    annotations : mapping of id to Annotation, optional
        Those to use; by default all of the graph's.
    """
    if annotations is None:
        topology = topology_of(graph)
        axes = _axes(graph, topology, _kept_directions(topology))
        return _kept_sharing(topology, _kept_directions(topology), *axes)
    topology = topology_with(graph, annotations)
    return structure_along(graph, topology, direction_classes(topology))


def structure_along(graph: SketchGraph, topology: Topology, directions: Directions) -> Structure:
    """The same where it is known already which directions there are."""
    return _share(topology, directions, *_axes(graph, topology, directions))


@kept
def _axes(
    graph: SketchGraph, topology: Topology, directions: Directions
) -> tuple[tuple[int, ...], int | None]:
    """The object axes, and that which is upright where something needs one."""
    axes = _choose_axes(_drawn_lengths(graph, topology), directions)
    # Circles are horizontal, and a camera that is known knows the ground: some axis is vertical.
    if not graph.circles and (graph.camera is None or not len(topology.ground)):
        return axes, None
    return axes, _most_upright_axis(graph, topology, directions, axes)


@lru_cache(maxsize=MAX_KEPT)
def _kept_directions(topology: Topology) -> Directions:
    return direction_classes(topology)


@lru_cache(maxsize=MAX_KEPT)
def _kept_sharing(
    topology: Topology, directions: Directions, axes: tuple[int, ...], upright: int | None
) -> Structure:
    return _share(topology, directions, axes, upright)


def _share(
    topology: Topology, directions: Directions, axes: tuple[int, ...], upright: int | None
) -> Structure:
    """The structure in the chosen axes."""
    edge_axis, edge_across = _edges_on_axes(topology, directions, axes)
    vertical = _vertical_axis(topology, edge_axis, edge_across) if axes else None
    if vertical is None and axes and upright is not None and len(topology.ground):
        # Nothing says that the ground is square to an axis.
        return _share(topology, directions, (), 2)
    vertical = upright if vertical is None else vertical
    coordinate = _share_coordinates(topology, edge_axis, edge_across, vertical)
    edge_axis, edge_across, collapsed = _edges_by_coordinates(topology, coordinate)
    n_shared = int(coordinate.max()) + 1 if coordinate.size else 0
    clash = angles_clash(topology, directions, edge_axis, edge_across)
    balances, balance_owners = _balances(topology, edge_axis, coordinate)
    return Structure(
        directions=directions,
        edge_axis=edge_axis,
        edge_across=edge_across,
        coordinate=coordinate,
        radius=n_shared + np.arange(len(topology.circles)),
        n_coordinates=n_shared + len(topology.circles),
        balances=balances,
        balance_owners=balance_owners,
        vertical=vertical,
        has_axes=bool(axes),
        contradiction=directions.contradiction or collapsed or clash,
    )


def _drawn_lengths(graph: SketchGraph, topology: Topology) -> Array:
    at = graph.positions_px
    delta = at[topology.ends[:, 1]] - at[topology.ends[:, 0]]
    return np.asarray(np.hypot(delta[:, 0], delta[:, 1]))


def _choose_axes(lengths: Array, directions: Directions) -> tuple[int, ...]:
    """The mutually perpendicular triple (else pair) of classes with the most drawn length."""
    if directions.contradiction:
        return ()
    drawn = np.bincount(directions.class_of, lengths).tolist()
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
    topology: Topology, directions: Directions, axes: tuple[int, ...]
) -> tuple[IntArray, BoolArray]:
    n_edges = len(topology.edges)
    axis = np.full(n_edges, -1, dtype=np.int64)
    across = np.zeros((n_edges, 3), dtype=bool)
    for k, c in enumerate(axes):
        across[list(directions.perpendicular.get(c, ())), k] = True
    # An axis is across to both others, whether any edge runs along them or not.
    for k, c in enumerate(axes):
        axis[c] = k
        across[c] = np.arange(3) != k
    return _along_third_axis(axis[directions.class_of], across[directions.class_of])


def _along_third_axis(edge_axis: IntArray, edge_across: BoolArray) -> tuple[IntArray, BoolArray]:
    """What is perpendicular to two axes runs along the third."""
    free = (edge_axis < 0) & (edge_across.sum(axis=1) == 2)
    edge_axis[free] = np.argmin(edge_across[free], axis=1)
    return edge_axis, edge_across


def _vertical_axis(topology: Topology, edge_axis: IntArray, edge_across: BoolArray) -> int | None:
    """The axis to which the edges between ground vertices are square and most others climb.

    Two of them along the other axes are enough: a wrong ground vertex then shows as a clash.
    """
    on_ground = np.zeros(len(topology.vertices), dtype=bool)
    on_ground[topology.ground] = True
    grounded = on_ground[topology.ends]
    inside = grounded.all(axis=1)
    joining = grounded.any(axis=1) & ~inside
    if not inside.any() and not joining.any():
        return None
    flat: BoolArray = np.all(edge_across[inside], axis=0)
    along = set(edge_axis[inside].tolist())
    climbing = edge_axis[joining]
    scores = [(-1, -k) for k in range(3)]
    for k in range(3):
        if flat[k] or {0, 1, 2} - {k} <= along:
            square = 0 if flat.any() else int(np.count_nonzero(edge_across[inside, k]))
            scores[k] = (square + int(np.count_nonzero(climbing == k)), -k)
    best = max(range(3), key=lambda k: scores[k])
    first, second = sorted((count for count, _ in scores), reverse=True)[:2]
    sure = first > max(0, second) or (first == 0 and int(flat.sum()) == 1)
    return best if sure else None


def _most_upright_axis(
    graph: SketchGraph, topology: Topology, directions: Directions, axes: tuple[int, ...]
) -> int:
    """The axis whose edges are drawn most upright, by their mean lean."""
    if not axes:
        return 2
    edge_axis, _ = _edges_on_axes(topology, directions, axes)
    at = graph.positions_px
    delta = np.abs(at[topology.ends[:, 1]] - at[topology.ends[:, 0]])
    leans = np.full(3, np.inf)
    for k in range(3):
        total = delta[edge_axis == k].sum(axis=0)
        if (edge_axis == k).any():
            leans[k] = np.arctan2(total[0], total[1])
    return int(np.argmin(leans))


def _share_coordinates(
    topology: Topology, edge_axis: IntArray, edge_across: BoolArray, vertical: int | None
) -> IntArray:
    n_points = len(topology.vertices) + len(topology.circles)
    edge, axis = np.nonzero(edge_across)
    pairs = [3 * topology.ends[edge] + axis[:, None]]
    if vertical is not None:
        circle = {c: len(topology.vertices) + i for c, i in topology.circles.items()}
        ground = [*topology.ground.tolist(), *(circle[r.ground] for r in _turned(topology))]
        pairs.append(_chain([3 * i + vertical for i in ground]))
        for r in _turned(topology):
            on_axis = [3 * circle[c] for c in (r.ground, r.bottom, r.top)]
            pairs += [_chain([i + k for i in on_axis]) for k in {0, 1, 2} - {vertical}]
        rims = topology.rims + np.array([0, len(topology.vertices)])
        pairs.append(3 * rims + vertical)
    shared = first_members(np.vstack(pairs), 3 * n_points)
    faces = named_faces(topology)
    if faces is not None:
        shared = _share_in_faces(faces, edge_axis, shared)
    return numbered(shared, 3 * n_points)[1].reshape(n_points, 3)


def _balances(
    topology: Topology, edge_axis: IntArray, coordinate: IntArray
) -> tuple[IntArray, tuple[str, ...]]:
    """What symmetry planes that are square to an axis say of coordinates, and which of them."""
    found: list[tuple[int, ...]] = []
    owners: list[str] = []
    for id_, a in topology.by_kind["symmetry_plane"]:
        edges = [topology.edges[e] for e in a.midpoints_of]
        k = common_axis(edge_axis[edges])
        if k is None:
            continue
        first, *others = np.sort(coordinate[topology.ends[edges], k], axis=1).tolist()
        found += [(*first, *other) for other in others if other != first]
        owners += [id_] * (len(found) - len(owners))
    return np.array(found, dtype=np.int64).reshape(-1, 4), tuple(owners)


def common_axis(axes: IntArray) -> int | None:
    """The axis along which all of some edges run, if there is one."""
    first = int(axes[0])
    return first if first >= 0 and bool((axes == first).all()) else None


def _turned(topology: Topology) -> list[Revolution]:
    return list(topology.revolutions.values())


def _chain(members: list[int]) -> IntArray:
    """Pairs that tie all members together."""
    return np.array([members[:-1], members[1:]], dtype=np.int64).T.reshape(-1, 2)


def _share_in_faces(faces: NamedFaces, edge_axis: IntArray, shared: IntArray) -> IntArray:
    """A named face that is square to an axis ties that coordinate for all that lies in it."""
    # A side that is not drawn, -1, is along none.
    axis = np.append(edge_axis, -1)[faces.edges]
    runs = np.logical_or.reduceat(axis[:, None] == np.arange(3), faces.first)
    # Edges along the two other axes.
    across = runs[:, [1, 2, 0]] & runs[:, [2, 0, 1]]
    base = 3 * faces.loops[faces.first]
    inside = np.column_stack([faces.face, faces.loops]), faces.holes, faces.touching
    face, vertex = np.vstack(inside).T
    while True:
        square = across | faces.shared(shared.reshape(-1, 3))
        at, k = np.nonzero(square[face])
        pairs = np.column_stack([shared[base[face[at]] + k], shared[3 * vertex[at] + k]])
        if (pairs[:, 0] == pairs[:, 1]).all():
            return shared
        # What is tied may make other faces square.
        shared = first_members(pairs, len(shared))[shared]


def _edges_by_coordinates(
    topology: Topology, coordinate: IntArray
) -> tuple[IntArray, BoolArray, bool]:
    """Which edges run along or across which axis, now that coordinates are shared.

    The last value tells whether some edge's two ends came out as one and the same point.
    """
    ends = topology.ends
    across = coordinate[ends[:, 0]] == coordinate[ends[:, 1]]
    axis = np.where(across.sum(axis=1) == 2, np.argmin(across, axis=1), -1)
    return axis.astype(np.int64), across, bool((across.sum(axis=1) == 3).any())
