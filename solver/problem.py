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

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .annotations import (
    EqualLength,
    Ground,
    Length,
    OnFace,
    Parallel,
    RightAngle,
    SymmetryPlane,
)
from .camera import Camera
from .circles import DrawnCircles, drawn_circles
from .energies import ENERGIES, Linearised
from .graph import SketchGraph
from .sizes import Diameters, proportional_diameters
from .structure import Structure
from .values import Array, IntArray

#: How well people draw: things they imagine, as a part of the drawing's diagonal (FACTS: 0.5 to
#: 2 %), and things they trace on the photo, px.
IMAGINED_SIGMA = 0.007
TRACED_SIGMA_PX = 1.5


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
        Only for length_ratio.
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
    px_per_unit: float
    log_focal_prior: float | None
    camera: Camera | None = None

    @property
    def up_in_cam(self) -> Array | None:
        """The known upward direction in the camera frame, where there is a vertical to meet it."""
        if self.camera is None or self.structure.vertical is None:
            return None
        return np.asarray(self.camera.rotation_cam_from_world[:, 2])


def build_problem(graph: SketchGraph, structure: Structure) -> Problem:
    """Turn a graph and its structure into numbers."""
    pixels = np.array(list(graph.vertices.values()), dtype=float).reshape(-1, 2)
    unit = image_unit_px(graph)
    index = {v: i for i, v in enumerate(graph.vertices)}
    ends = np.array([[index[v], index[w]] for v, w in graph.edges.values()], dtype=np.int64)
    focal = graph.camera.focal_px if graph.camera is not None else None
    if focal is None and graph.photo is not None:
        focal = graph.photo.focal_px
    weights, traced = _weights(graph)
    return Problem(
        points=(pixels - np.array(graph.principal_point_px)) / unit,
        weights=weights,
        circles=drawn_circles(graph, unit, traced),
        ends=ends.reshape(-1, 2),
        structure=structure,
        blocks=leftover_constraints(graph, structure),
        diameters=proportional_diameters(graph, structure),
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
    return np.array([*graph.vertices.values(), *ends], dtype=float).reshape(-1, 2)


def _weights(graph: SketchGraph) -> tuple[Array, float]:
    """Weights of the vertices, and the weight of what is traced.

    It is the ratio of the two standard deviations where all edges of a vertex are traced, else 1.
    """
    pixels = _drawn_positions(graph)
    traced = set(graph.construction)
    real = {v for id_, ends in graph.edges.items() if id_ in traced for v in ends}
    imagined = {v for id_, ends in graph.edges.items() if id_ not in traced for v in ends}
    diagonal = float(np.linalg.norm(np.ptp(pixels, axis=0))) if len(pixels) else 0.0
    ratio = max(1.0, IMAGINED_SIGMA * diagonal / TRACED_SIGMA_PX)
    weights = [ratio if v in real - imagined else 1.0 for v in graph.vertices]
    return np.array(weights), ratio


def leftover_constraints(graph: SketchGraph, structure: Structure) -> tuple[Block, ...]:
    """The constraints that shared coordinates do not already hold."""
    compiler = _Compiler(graph, structure)
    found: dict[str, list[tuple[tuple[int, ...], str, tuple[float, float]]]] = {}
    for name, items, owner, wanted in compiler.all():
        found.setdefault(name, []).append((items, owner, wanted))
    blocks = []
    for name, entries in found.items():
        items, owners, lengths = zip(*entries, strict=True)
        ratios = np.array(lengths, dtype=float) if name == "length_ratio" else None
        blocks.append(Block(name, np.array(items, dtype=np.int64), tuple(owners), ratios))
    return tuple(blocks)


_Item = tuple[str, tuple[int, ...], str, tuple[float, float]]
_ONE = (1.0, 1.0)


class _Compiler:
    """Walks the annotations and yields (energy, vertex indices, owner, wanted lengths)."""

    def __init__(self, graph: SketchGraph, structure: Structure) -> None:
        self.graph = graph
        self.structure = structure
        self.index = {v: i for i, v in enumerate(graph.vertices)}
        self.edge = {e: i for i, e in enumerate(graph.edges)}

    def all(self) -> Iterator[_Item]:
        for id_, a in self.graph.annotations.items():
            if isinstance(a, RightAngle):
                yield from self.right_angle(id_, a)
            elif isinstance(a, Parallel):
                yield from self.parallels(id_, a.edges)
            elif isinstance(a, EqualLength):
                yield from self.equal_lengths(id_, a)
            elif isinstance(a, SymmetryPlane):
                yield from self.symmetry(id_, a)
            elif isinstance(a, OnFace) and self.graph.faces and a.face in self.graph.faces:
                loop = self.graph.faces[a.face].loop
                yield from self.in_plane(id_, loop, [a.vertex])
        yield from self.ground()
        yield from self.lengths()
        for id_, face in (self.graph.faces or {}).items():
            rest = [v for loop in face.loops for v in loop]
            yield from self.in_plane(id_, face.loop, rest)

    def _ends(self, edge: str) -> tuple[int, int]:
        v, w = self.graph.edges[edge]
        return (self.index[v], self.index[w])

    def right_angle(self, id_: str, a: RightAngle) -> Iterator[_Item]:
        i, j = (self.edge[e] for e in a.between)
        axis, across = self.structure.edge_axis, self.structure.edge_across
        if (axis[i] >= 0 and across[j, axis[i]]) or (axis[j] >= 0 and across[i, axis[j]]):
            return
        yield ("right_angle", self._from_corner(a, 0) + self._from_corner(a, 1), id_, _ONE)

    def _from_corner(self, a: RightAngle, k: int) -> tuple[int, int]:
        v, w = self.graph.edges[a.between[k]]
        return (self.index[a.at], self.index[w if v == a.at else v])

    def parallels(self, id_: str, edges: tuple[str, ...]) -> Iterator[_Item]:
        axis = self.structure.edge_axis
        first = self.edge[edges[0]]
        for e in edges[1:]:
            if axis[first] < 0 or axis[first] != axis[self.edge[e]]:
                yield ("parallel", self._ends(edges[0]) + self._ends(e), id_, _ONE)

    def equal_lengths(self, id_: str, a: EqualLength) -> Iterator[_Item]:
        coordinate = self.structure.coordinate
        for e in a.edges[1:]:
            pairs = [
                {frozenset(pair) for pair in coordinate[list(self._ends(x))].T.tolist()}
                for x in (a.edges[0], e)
            ]
            if pairs[0] != pairs[1]:
                yield ("length_ratio", self._ends(a.edges[0]) + self._ends(e), id_, _ONE)

    def lengths(self) -> Iterator[_Item]:
        """Given lengths as ratios to the first one."""
        given = [(id_, a) for id_, a in self.graph.annotations.items() if isinstance(a, Length)]
        for id_, a in given[1:]:
            first = given[0][1]
            wanted = (first.length_mm, a.length_mm)
            yield ("length_ratio", self._ends(first.edge) + self._ends(a.edge), id_, wanted)

    def symmetry(self, id_: str, a: SymmetryPlane) -> Iterator[_Item]:
        yield from self.parallels(id_, a.midpoints_of)
        for e in a.midpoints_of[1:]:
            yield ("symmetry", self._ends(a.midpoints_of[0]) + self._ends(e), id_, _ONE)

    def ground(self) -> Iterator[_Item]:
        if self.structure.vertical is not None:
            return
        said = [(id_, a) for id_, a in self.graph.annotations.items() if isinstance(a, Ground)]
        vertices = list(dict.fromkeys(v for _, a in said for v in a.vertices))
        if said:
            yield from self.in_plane(said[0][0], tuple(vertices), vertices)

    def in_plane(self, owner: str, loop: tuple[str, ...], rest: list[str]) -> Iterator[_Item]:
        """Vertices in the plane of a loop, those left out that span it."""
        together = [self.index[v] for v in dict.fromkeys([*loop, *rest])]
        coordinate = self.structure.coordinate
        if len(loop) < 3 or any(len(set(coordinate[together, k].tolist())) == 1 for k in range(3)):
            return
        base = self._spanning_three([self.index[v] for v in loop])
        for i in together:
            if i not in base:
                yield ("planarity", (*base, i), owner, _ONE)

    def _spanning_three(self, loop: list[int]) -> tuple[int, int, int]:
        """Three vertices far apart as drawn: drawn apart means apart in space too."""
        pixels = np.array(list(self.graph.vertices.values()))[loop]
        a = 0
        b = int(np.argmax(np.linalg.norm(pixels - pixels[a], axis=1)))
        along: NDArray[np.float64] = pixels[b] - pixels[a]
        offset = pixels - pixels[a]
        c = int(np.argmax(np.abs(along[0] * offset[:, 1] - along[1] * offset[:, 0])))
        return (loop[a], loop[b], loop[c])
