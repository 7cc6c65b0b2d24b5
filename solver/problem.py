"""A graph as numbers: normalised positions, weights, and the constraints left over.

Terms
-----
image unit
    Half the longer side of the photo; positions count from the principal point. Normalised so,
    residuals, focal lengths and steps are all about 1.
leftover constraint
    What an annotation says beyond what the shared coordinates already hold by construction.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from .annotations import Angle, EqualLength, SymmetryPlane
from .camera import Camera
from .circles import DrawnCircles, drawn_circles
from .energies import ENERGIES, Linearised
from .geometry import diagonal
from .graph import SketchGraph
from .named_faces import named_faces
from .rims import Rims, rims_of
from .sizes import Diameters, proportional_diameters
from .structure import Structure, common_axis
from .topology import MAX_KEPT, Topology, topology_of
from .values import Array, BoolArray, IntArray, kept

#: How well people draw: things they imagine, as a part of the drawing's diagonal (1 to 2 %),
#: and things they trace on the photo, px. Imagined vertices lean together: however many there are,
#: they tell no more of the camera than so many independent ones.
IMAGINED_SIGMA = 0.02
TRACED_SIGMA_PX = 1.5
MANY_IMAGINED = 8


@dataclass(frozen=True, slots=True, eq=False)
class Block:
    """Leftover constraints of one energy.

    Parameters
    ----------
    energy : str
        Name in ENERGIES.
    items : (k, 4) int array
        Vertex indices, as the energy wants them.
    owners : tuple of str
        For each item the annotation (or face) that asks for it.
    wanted : (k, 2) array or None
        Only for length_ratio and angle.
    """

    energy: str
    items: IntArray
    owners: tuple[str, ...]
    wanted: Array | None = None

    def evaluate(self, X: Array) -> Linearised:
        """Residuals and derivatives at the positions X (n, 3)."""
        if self.wanted is None:
            return ENERGIES[self.energy](X, self.items)
        return ENERGIES[self.energy](X, self.items, self.wanted)

    def evaluate_all(self, shapes: Array) -> Linearised:
        """The same of several shapes (k, n, 3) at once, as if they were one of k n vertices."""
        k, n, _ = shapes.shape
        apart = self.items + n * np.arange(k)[:, None, None]
        wanted = None if self.wanted is None else np.tile(self.wanted, (k, 1))
        all_of_them = replace(self, items=apart.reshape(-1, 4), wanted=wanted)
        return all_of_them.evaluate(shapes.reshape(-1, 3))


@dataclass(frozen=True, slots=True, eq=False)
class Problem:
    """Everything the numeric steps need.

    Parameters
    ----------
    points : (n, 2) array
        Drawn positions, image units from the principal point.
    weights : (n,) array
        How far each drawn position is to be trusted, 1 for imagined ones.
    circles : DrawnCircles
    ends : (m, 2) int array
        Vertex indices of each edge.
    structure : Structure
    blocks : tuple of Block
    diameters : Diameters
    rims : Rims
    px_per_unit : float
    log_focal_prior : float or None
        Logarithm of a known focal length in image units.
    camera : Camera or None
        The camera where it is known beforehand ([Lau10] 4.3, first method).
    """

    points: Array
    weights: Array
    circles: DrawnCircles
    ends: IntArray
    structure: Structure
    blocks: tuple[Block, ...]
    diameters: Diameters
    rims: Rims
    px_per_unit: float
    log_focal_prior: float | None
    camera: Camera | None = None

    @property
    def up_in_cam(self) -> Array | None:
        """The known upward direction in the camera frame, where there is a vertical to meet it."""
        if self.camera is None or self.structure.vertical is None:
            return None
        return np.asarray(self.camera.rotation_cam_from_world[:, 2])


@kept
def build_problem(graph: SketchGraph, structure: Structure) -> Problem:
    """Turn a graph and its structure into numbers."""
    unit = image_unit_px(graph)
    topology = topology_of(graph)
    focal = graph.camera.focal_px if graph.camera is not None else None
    if focal is None and graph.photo is not None:
        focal = graph.photo.focal_px
    weights, traced = _weights(graph)
    return Problem(
        points=(graph.positions_px - np.array(graph.principal_point_px)) / unit,
        weights=weights,
        circles=drawn_circles(graph, unit, traced),
        ends=topology.ends,
        structure=structure,
        blocks=leftover_constraints(graph, structure),
        diameters=proportional_diameters(graph, structure),
        rims=rims_of(graph, structure),
        px_per_unit=unit,
        log_focal_prior=None if focal is None else float(np.log(focal / unit)),
        camera=graph.camera,
    )


def image_unit_px(graph: SketchGraph) -> float:
    """Half the longer side of the photo, px; without one, of the drawing."""
    if graph.photo is not None:
        return max(graph.photo.width_px, graph.photo.height_px) / 2
    pixels = _drawn_positions(graph)
    extent = float(np.ptp(pixels, axis=0).max()) if len(pixels) else 0.0
    # People draw an object over about 60 % of a page.
    return extent / 2 / 0.6 if extent > 0 else 1.0


def _drawn_positions(graph: SketchGraph) -> Array:
    """Vertices and the ends of the ellipses' axes, px."""
    ends = [p for c in graph.circles.values() for p in (*c.a, *c.b)]
    return np.vstack([graph.positions_px, np.array(ends, dtype=float).reshape(-1, 2)])


def _weights(graph: SketchGraph) -> tuple[Array, float]:
    """Weights of the vertices, and the weight of what is traced.

    It is the ratio of the two standard deviations where all edges of a vertex are traced, else 1;
    where nothing is imagined, there is nothing to weigh it against.
    """
    if not graph.construction:
        return np.ones(len(graph.vertices)), 1.0
    pixels = _drawn_positions(graph)
    traced = set(graph.construction)
    real = {v for id_, ends in graph.edges.items() if id_ in traced for v in ends}
    imagined = {v for id_, ends in graph.edges.items() if id_ not in traced for v in ends}
    if not imagined and all(c in traced for c in graph.circles):
        return np.ones(len(graph.vertices)), 1.0
    leaning = np.sqrt(max(1.0, len(imagined) / MANY_IMAGINED))
    ratio = max(1.0, float(leaning) * IMAGINED_SIGMA * diagonal(pixels) / TRACED_SIGMA_PX)
    weights = [ratio if v in real - imagined else 1.0 for v in graph.vertices]
    return np.array(weights), ratio


def leftover_constraints(graph: SketchGraph, structure: Structure) -> tuple[Block, ...]:
    """The constraints that shared coordinates do not already hold."""
    topology = topology_of(graph)
    relations = _leftover_relations(topology, structure)
    found: dict[str, list[tuple[tuple[int, ...], str, tuple[float, float]]]] = {}
    for name, items, owner, wanted in [*relations, *_leftover_planes(graph, topology, structure)]:
        found.setdefault(name, []).append((items, owner, wanted))
    blocks = []
    for name, entries in found.items():
        items, owners, lengths = zip(*entries, strict=True)
        wishes = np.array(lengths, dtype=float) if name in WITH_WANTED else None
        blocks.append(Block(name, np.array(items, dtype=np.int64), tuple(owners), wishes))
    return tuple(blocks)


#: Energies that take what is wanted.
WITH_WANTED = ("length_ratio", "angle")
_Item = tuple[str, tuple[int, ...], str, tuple[float, float]]
_ONE = (1.0, 1.0)


@lru_cache(maxsize=MAX_KEPT)
def _leftover_relations(topology: Topology, structure: Structure) -> tuple[_Item, ...]:
    """What holds between edges: it does not ask for the drawing."""
    return tuple(_Relations(topology, structure).all())


class _Relations:
    """Walks the annotations and yields (energy, vertex indices, owner, wanted lengths)."""

    def __init__(self, topology: Topology, structure: Structure) -> None:
        self.topology = topology
        self.structure = structure
        ends = structure.coordinate[topology.ends]
        # What an edge measures along each axis: two coordinates, in whichever order.
        self.spans = np.sort(ends, axis=1).reshape(-1, 6)

    def all(self) -> Iterator[_Item]:
        yield from self.right_angles()
        said = self.topology.by_kind
        for id_, a in said["parallel"]:
            yield from self.parallels(id_, a.edges)
        for id_, a in said["equal_length"]:
            yield from self.equal_lengths(id_, a)
        for id_, a in said["symmetry_plane"]:
            yield from self.symmetry(id_, a)
        for id_, a in said["angle"]:
            yield self.angle(id_, a)
        yield from self.lengths()

    def _ends(self, edge: str) -> tuple[int, int]:
        v, w = self.topology.ends[self.topology.edges[edge]].tolist()
        return (v, w)

    def right_angles(self) -> Iterator[_Item]:
        at, i, j = self.topology.right_angles.T
        axis, across = self.structure.edge_axis, self.structure.edge_across
        held = (axis[i] >= 0) & across[j, axis[i]] | (axis[j] >= 0) & across[i, axis[j]]
        left = np.flatnonzero(~held)
        at, i, j = at[left], i[left], j[left]
        # The other end of an edge is what its ends have beside this one.
        both = self.topology.ends.sum(axis=1)
        corners = np.column_stack([at, both[i] - at, at, both[j] - at]).tolist()
        for k, corner in zip(self.topology.right_angle_places[left].tolist(), corners, strict=True):
            yield ("right_angle", tuple(corner), self.topology.annotations[k], _ONE)

    def _from(self, vertex: int, edge: int) -> tuple[int, int]:
        v, w = self.topology.ends[edge].tolist()
        return (vertex, w if v == vertex else v)

    def parallels(self, id_: str, edges: tuple[str, ...]) -> Iterator[_Item]:
        axis = self.structure.edge_axis[[self.topology.edges[e] for e in edges]]
        for e, k in zip(edges[1:], axis[1:].tolist(), strict=True):
            if k < 0 or k != axis[0]:
                yield ("parallel", self._ends(edges[0]) + self._ends(e), id_, _ONE)

    def equal_lengths(self, id_: str, a: EqualLength) -> Iterator[_Item]:
        spans = self.spans[[self.topology.edges[e] for e in a.edges]]
        differs = (spans != spans[0]).any(axis=1)
        for k in np.flatnonzero(differs).tolist():
            yield ("length_ratio", self._ends(a.edges[0]) + self._ends(a.edges[k]), id_, _ONE)

    def angle(self, id_: str, a: Angle) -> _Item:
        at, edges = self.topology.vertices[a.at], self.topology.edges
        first, second = (self._from(at, edges[e]) for e in a.between)
        return ("angle", first + second, id_, (math.radians(a.angle_deg), 0.0))

    def lengths(self) -> Iterator[_Item]:
        """Given lengths as ratios to the first one."""
        given = self.topology.by_kind["length"]
        for id_, a in given[1:]:
            first = given[0][1]
            wanted = (first.length_mm, a.length_mm)
            yield ("length_ratio", self._ends(first.edge) + self._ends(a.edge), id_, wanted)

    def symmetry(self, id_: str, a: SymmetryPlane) -> Iterator[_Item]:
        edges = [self.topology.edges[e] for e in a.midpoints_of]
        if common_axis(self.structure.edge_axis[edges]) is not None:
            # `Structure.balances` say it.
            return
        yield from self.parallels(id_, a.midpoints_of)
        for e in a.midpoints_of[1:]:
            yield ("symmetry", self._ends(a.midpoints_of[0]) + self._ends(e), id_, _ONE)


def _leftover_planes(
    graph: SketchGraph, topology: Topology, structure: Structure
) -> Iterator[_Item]:
    """Vertices that have to lie in one plane: faces, what touches them, a slanted ground."""
    grounds = topology.by_kind["ground"] if structure.vertical is None else ()
    touching, open_faces = _planes_left_over(topology, structure)
    if not (touching or open_faces or grounds):
        return
    assert graph.faces is not None or grounds
    planes, faces = _Planes(graph, topology, structure), graph.drawn_faces or {}
    for id_, face, vertex in touching:
        yield from planes.of(id_, faces[face].loop, [vertex])
    if grounds:
        vertices = list(dict.fromkeys(v for _, a in grounds for v in a.vertices))
        yield from planes.of(grounds[0][0], tuple(vertices), vertices)
    for id_ in open_faces:
        yield from planes.of(id_, faces[id_].loop, [v for loop in faces[id_].holes for v in loop])


@lru_cache(maxsize=MAX_KEPT)
def _planes_left_over(
    topology: Topology, structure: Structure
) -> tuple[tuple[tuple[str, str, str], ...], tuple[str, ...]]:
    """What touches a face, and the faces, that share no coordinate: (annotation, face, vertex)."""
    faces = named_faces(topology)
    if faces is None:
        return (), ()
    coordinate, names = structure.coordinate, tuple(topology.vertices)
    flat, base = faces.shared(coordinate), coordinate[faces.loops[faces.first]]

    def apart(rows: IntArray) -> BoolArray:
        face, vertex = rows.T
        together = flat[face] & (coordinate[vertex] == base[face])
        return np.asarray(~together.any(axis=1))

    loose = np.flatnonzero(apart(faces.touching)).tolist()
    face, vertex = faces.touching.T.tolist()
    touching = ((faces.touching_ids[k], faces.ids[face[k]], names[vertex[k]]) for k in loose)
    slanted = np.asarray(~flat.any(axis=1))
    # A hole may be held along another axis than the loop around it.
    slanted[faces.holes[:, 0]] = True
    return tuple(touching), tuple(faces.ids[k] for k in np.flatnonzero(slanted).tolist())


class _Planes:
    def __init__(self, graph: SketchGraph, topology: Topology, structure: Structure) -> None:
        self.vertices = topology.vertices
        # Loops are short: numbers by themselves are sooner looked at than arrays.
        self.coordinate = structure.coordinate.tolist()
        self.pixels = graph.positions_px.tolist()

    def of(self, owner: str, loop: tuple[str, ...], rest: list[str]) -> Iterator[_Item]:
        """Vertices in the plane of a loop, those left out that span it."""
        together = [self.vertices[v] for v in dict.fromkeys([*loop, *rest])]
        if len(loop) < 3 or self._share_one(together):
            return
        base = self._spanning_three([self.vertices[v] for v in loop])
        for i in together:
            if i not in base:
                yield ("planarity", (*base, i), owner, _ONE)

    def _share_one(self, together: list[int]) -> bool:
        """Whether vertices have some coordinate in common, and with it lie in a plane."""
        along_each = zip(*(self.coordinate[i] for i in together), strict=True)
        return any(len(set(along)) == 1 for along in along_each)

    def _spanning_three(self, loop: list[int]) -> tuple[int, int, int]:
        """Three vertices far apart as drawn: drawn apart means apart in space too."""
        u0, v0 = self.pixels[loop[0]]
        offset = {i: (self.pixels[i][0] - u0, self.pixels[i][1] - v0) for i in loop}
        b = max(loop, key=lambda i: math.hypot(*offset[i]))
        u, v = offset[b]
        c = max(loop, key=lambda i: abs(u * offset[i][1] - v * offset[i][0]))
        return (loop[0], b, c)


def conditions_of(graph: SketchGraph, structure: Structure) -> int:
    """How many conditions the shared coordinates still have to meet."""
    problem = build_problem(graph, structure)
    in_blocks = sum(len(block.items) for block in problem.blocks)
    return in_blocks + len(structure.balances) + len(problem.rims)
