"""How far each annotation is from being true, in the unit in which people think of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import chain

import numpy as np

from .annotations import (
    SAID,
    Angle,
    Annotation,
    Diameter,
    OnFace,
    RightAngle,
    SymmetryPlane,
)
from .geometry import cross
from .graph import Face, SketchGraph
from .solution import Residual, Residuals, SolvedCircle
from .topology import Topology, indices, topology_of
from .values import Array, IntArray, kept, rows_of


def annotation_residuals(
    graph: SketchGraph,
    vertices_mm: Mapping[str, Array],
    faces: Mapping[str, Face],
    circles: Mapping[str, SolvedCircle],
) -> Mapping[str, Residual]:
    """Residuals of all annotations.

    Right angles and parallels in degrees, all else in mm; for groups the largest deviation.
    A vertex on a face that is not there has none.
    """
    plan = _plan(topology_of(graph))
    # Mirrored copies come behind the sketch's own vertices.
    X = rows_of(vertices_mm)[: len(graph.vertices)]
    values = plan.measure(X)
    for place, annotation in plan.others:
        values[place] = _measure(annotation, graph, vertices_mm, circles)
    if plan.on_faces:
        places, off = _off_faces(plan.on_faces, faces, vertices_mm)
        values[places] = off
    told = np.isfinite(values)
    if told.all():
        return Residuals(plan.ids, values, plan.units)
    chosen = np.flatnonzero(told).tolist()
    ids = tuple(plan.ids[k] for k in chosen)
    return Residuals(ids, values[told], tuple(plan.units[k] for k in chosen))


@dataclass(frozen=True, slots=True, eq=False)
class _Groups:
    """Lists of whole numbers, one after the other, and where each begins."""

    places: IntArray
    items: IntArray
    first: IntArray

    @classmethod
    def of(cls, index: Mapping[str, int], found: Sequence[tuple[int, Sequence[str]]]) -> _Groups:
        sizes = [len(items) for _, items in found]
        return cls(
            np.array([place for place, _ in found], dtype=np.int64),
            indices(index, [*chain.from_iterable(items for _, items in found)]),
            (np.cumsum([0, *sizes[:-1]])[: len(found)]).astype(np.int64),
        )


@dataclass(frozen=True, slots=True, eq=False)
class _Plan:
    """Indices of what each annotation speaks of; `places` are those of the annotations.

    Parameters
    ----------
    ids, units : tuples of str
        Of each annotation.
    ends : (m, 2) int array
    corner_places : (k,) int array
    corners : (k, 2) int array
        The edges of each right angle.
    parallels, equals : groups of edges
    ground : groups of vertices
    length_places, length_edges, lengths_mm : (k,) arrays
    on_faces, others : annotations with their places
    """

    ids: tuple[str, ...]
    units: tuple[str, ...]
    ends: IntArray
    corner_places: IntArray
    corners: IntArray
    parallels: _Groups
    equals: _Groups
    ground: _Groups
    length_places: IntArray
    length_edges: IntArray
    lengths_mm: Array
    on_faces: tuple[tuple[int, OnFace], ...]
    others: tuple[tuple[int, Annotation], ...]

    def measure(self, X: Array) -> Array:
        """Residuals of all but the others, (n,)."""
        values = np.full(len(self.units), np.nan)
        along = X[self.ends[:, 1]] - X[self.ends[:, 0]]
        squares = np.einsum("ei,ei->e", along, along)
        lengths = np.sqrt(squares)
        values[self.corner_places] = _unsquare_deg(along, squares, self.corners)
        values[self.length_places] = np.abs(lengths[self.length_edges] - self.lengths_mm)
        if len(self.parallels.places):
            values[self.parallels.places] = _unparallel_deg(along, self.parallels)
        if len(self.equals.places):
            of_each = lengths[self.equals.items]
            longest = np.maximum.reduceat(of_each, self.equals.first)
            values[self.equals.places] = longest - np.minimum.reduceat(of_each, self.equals.first)
        if len(self.ground.places):
            heights = np.abs(X[self.ground.items, 2])
            values[self.ground.places] = np.maximum.reduceat(heights, self.ground.first)
        return values


@kept
def _plan(topology: Topology) -> _Plan:
    edges, vertices, ends = topology.edges, topology.vertices, topology.ends
    said = {
        kind: [*zip(at, (a for _, a in topology.by_kind[kind]), strict=True)]
        for kind, at in topology.places.items()
    }
    units = [RightAngle.unit] * len(topology.annotations)
    for kind, at in topology.places.items():
        for place in at:
            units[place] = SAID[kind].unit
    lengths = [a for _, a in said["length"]]
    return _Plan(
        ids=topology.annotations,
        units=tuple(units),
        ends=ends,
        corner_places=topology.right_angle_places,
        corners=topology.right_angles[:, 1:],
        parallels=_Groups.of(edges, [(k, a.edges) for k, a in said["parallel"]]),
        equals=_Groups.of(edges, [(k, a.edges) for k, a in said["equal_length"]]),
        ground=_Groups.of(vertices, [(k, a.vertices) for k, a in said["ground"]]),
        length_places=np.array(topology.places["length"], dtype=np.int64),
        length_edges=indices(edges, [a.edge for a in lengths]),
        lengths_mm=np.array([a.length_mm for a in lengths], dtype=float),
        on_faces=tuple(said["on_face"]),
        others=(*said["diameter"], *said["symmetry_plane"], *said["angle"]),
    )


def _unsquare_deg(along: Array, squares: Array, pairs: IntArray) -> Array:
    """How far the angles between pairs of edges are from right ones, |atan2(u.v, |u x v|)|."""
    i, j = pairs.T
    dot = np.einsum("ki,ki->k", along[i], along[j])
    # Exact where it matters: the difference loses digits for edges that are nearly parallel only.
    crossed = np.sqrt(np.maximum(squares[i] * squares[j] - dot * dot, 0.0))
    return np.asarray(np.degrees(np.arctan2(np.abs(dot), crossed)))


def _unparallel_deg(along: Array, groups: _Groups) -> Array:
    """The largest angle of each group's edges to its first one."""
    sizes = np.diff(groups.first, append=len(groups.items))
    firsts = np.repeat(groups.items[groups.first], sizes)
    angles = _angles_deg(along[firsts], along[groups.items])
    # An edge is parallel to itself, though its own length may be 0.
    angles[groups.first] = 0.0
    return np.asarray(np.maximum.reduceat(np.minimum(angles, 180.0 - angles), groups.first))


def _angles_deg(u: Array, v: Array) -> Array:
    # atan2 keeps its accuracy near 0 and 90 degrees, where acos loses half the digits.
    w = cross(u, v)
    sine = np.sqrt(np.einsum("ki,ki->k", w, w))
    return np.asarray(np.degrees(np.arctan2(sine, np.einsum("ki,ki->k", u, v))))


def _measure(
    annotation: Annotation,
    graph: SketchGraph,
    at: Mapping[str, Array],
    circles: Mapping[str, SolvedCircle],
) -> float:
    """The residual of an annotation of which a sketch has few."""
    if isinstance(annotation, Diameter):
        return abs(2 * circles[annotation.circle].radius_mm - annotation.diameter_mm)
    if isinstance(annotation, SymmetryPlane):
        edges = [graph.edges[e] for e in annotation.midpoints_of]
        return _off_middle(np.array([[at[v], at[w]] for v, w in edges]))
    if isinstance(annotation, Angle):
        ends = (set(graph.edges[e]) - {annotation.at} for e in annotation.between)
        u, v = (at[end.pop()] - at[annotation.at] for end in ends)
        return abs(float(_angles_deg(u[None], v[None])[0]) - annotation.angle_deg)
    raise TypeError(f"no residual of {annotation.kind}")


def _off_middle(ends: Array) -> float:
    """How far the middles of edges (k, 2, 3) are from the plane square to the first one."""
    first = ends[0, 1] - ends[0, 0]
    normal = first / max(float(np.linalg.norm(first)), 1e-300)
    middles = ends.mean(axis=1)
    return float(np.abs((middles - middles[0]) @ normal).max())


def _off_faces(
    said: Sequence[tuple[int, OnFace]], faces: Mapping[str, Face], at: Mapping[str, Array]
) -> tuple[list[int], list[float]]:
    """How far vertices are off their faces' planes; left out where there is no such face."""
    by_size: dict[int, list[tuple[int, OnFace]]] = {}
    for place, a in said:
        if a.face in faces:
            by_size.setdefault(len(faces[a.face].loop), []).append((place, a))
    places: list[int] = []
    off: list[float] = []
    for group in by_size.values():
        corners = np.array([[at[v] for v in faces[a.face].loop] for _, a in group])
        middles = corners.mean(axis=1)
        normals = np.linalg.svd(corners - middles[:, None])[2][:, 2]
        points = np.array([at[a.vertex] for _, a in group])
        places += [place for place, _ in group]
        off += np.abs(np.einsum("ki,ki->k", points - middles, normals)).tolist()
    return places, off
