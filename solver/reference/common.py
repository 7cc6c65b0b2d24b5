"""What both reference methods share: the energies of [Lau10] 4.2, the simplex search, the way out.

Terms
-----
drawing unit
    A hundredth of the drawn vertices' diagonal. The paper gives no unit of length; with this one
    an error of a hundredth of the drawing weighs about as much as an error of one degree, which
    is how its weights (0.4 for the projection, 0.5 for angles) look meant.
drawing frame
    x right and y down from the principal point, z away from the eye, in drawing units.
vec
    The vector of a drawn line, one endpoint subtracted from the other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy import optimize

from ..annotations import (
    Annotation,
    EqualLength,
    Ground,
    Length,
    OnFace,
    Parallel,
    RightAngle,
)
from ..graph import SketchGraph
from ..values import Array, frozen_mapping

IntArray = NDArray[np.int64]
Stop = Callable[[], bool]

#: [Lau10] 4.2: "The weights are 0.5, 10, and 10, respectively."
RIGHT_ANGLE_WEIGHT, EQUAL_LENGTH_WEIGHT, PARALLEL_WEIGHT = 0.5, 10.0, 10.0
#: The drawing's diagonal in drawing units.
DIAGONAL = 100.0
#: Stands for the energy of what is no photograph: a vertex behind the eye, or one that is further
#: away than `FAR` drawing units.
IMPOSSIBLE = 1e12
FAR = 1e5
_TINY = 1e-12


# --- the energies -----------------------------------------------------------------------------


def angle_deg(u: Array, v: Array) -> Array:
    """Angles between vectors (k, 3), degrees, (k,); 90 where one has no length."""
    lengths = np.sqrt(np.einsum("ij,ij->i", u, u) * np.einsum("ij,ij->i", v, v))
    cosine = np.einsum("ij,ij->i", u, v) / np.maximum(lengths, _TINY)
    return np.asarray(np.degrees(np.arccos(np.minimum(np.maximum(cosine, -1.0), 1.0))))


def right_angle_energy(u: Array, v: Array) -> float:
    """Sum over i of (angle e_i - 90 degrees)^2."""
    off = angle_deg(u, v) - 90.0
    return float(off @ off)


def equal_length_energy(vec: Array, next_vec: Array) -> float:
    """Sum over s and i of (len(vec_i) - len(vec_i+1))^2, square drawing units."""
    off = np.linalg.norm(vec, axis=1) - np.linalg.norm(next_vec, axis=1)
    return float(off @ off)


def parallel_energy_as_printed(vec: Array, next_vec: Array) -> float:
    """Sum over s and i of 1 / (angle(vec_i, vec_i+1) - 90 degrees)^2, as [Lau10] prints it.

    For parallel lines it is 1 / 8100, its smallest value and not zero; at right angles it has a
    pole. Within 80 degrees of parallel it stays below 0.01, so that beside the other terms it
    only forbids right angles. The methods use `parallel_energy`.
    """
    off = angle_deg(vec, next_vec) - 90.0
    return float(np.sum(1.0 / np.maximum(off**2, _TINY)))


def parallel_energy(vec: Array, next_vec: Array) -> float:
    """Sum over s and i of (angle to being parallel)^2, square degrees: the reading chosen.

    90 - abs(angle - 90) is 0 for parallel lines of either sense and grows where the printed term
    grows; squared, it is of the kind of the right angles' term.
    """
    off = 90.0 - np.abs(angle_deg(vec, next_vec) - 90.0)
    return float(off @ off)


@dataclass(frozen=True, slots=True, eq=False)
class GeometricConstraints:
    """The weighted sum of the geometric energies of one sketch.

    Parameters
    ----------
    right_angles, equal_lengths, parallels : (k, 4) int arrays
        Two lines a row, as vertices (from, to, from, to).
    on_face : (k, 4) int array
        Three corners of a face, then a vertex that lies in it.
    """

    right_angles: IntArray
    equal_lengths: IntArray
    parallels: IntArray
    on_face: IntArray

    def energy(self, X: Array) -> float:
        """The energy of the vertices X (n, 3), drawing units."""
        total = 0.0
        if len(self.right_angles):
            total += RIGHT_ANGLE_WEIGHT * right_angle_energy(*_lines(X, self.right_angles))
        if len(self.equal_lengths):
            total += EQUAL_LENGTH_WEIGHT * equal_length_energy(*_lines(X, self.equal_lengths))
        if len(self.parallels):
            total += PARALLEL_WEIGHT * parallel_energy(*_lines(X, self.parallels))
        if len(self.on_face):
            # Not in the paper: the line from the face to the vertex is square to its normal.
            a, b, c, d = (X[i] for i in self.on_face.T)
            total += RIGHT_ANGLE_WEIGHT * right_angle_energy(np.cross(b - a, c - b), d - b)
        return total


def _lines(X: Array, rows: IntArray) -> tuple[Array, Array]:
    corners = X[rows]
    return corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 2]


# --- the drawing ------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True, eq=False)
class Drawing:
    """A sketch graph as the reference methods see it.

    Parameters
    ----------
    graph : SketchGraph
    p : (n, 2) array
        [Lau10]'s p: the drawn vertices, drawing units from the principal point.
    px_per_unit : float
    focal : float
        Where the search for the focal length begins, drawing units.
    constraints : GeometricConstraints
    ground : tuple of int
        Indices of the ground vertices.
    rectangles : tuple of 4-tuples of int
        The quadrilaterals all of whose angles are annotated as right.
    """

    graph: SketchGraph
    p: Array
    px_per_unit: float
    focal: float
    constraints: GeometricConstraints
    ground: tuple[int, ...]
    rectangles: tuple[tuple[int, int, int, int], ...]


#: Longer side of the photo to focal length where the photo does not tell: a usual phone.
USUAL_FOCAL = 0.8


def read_drawing(graph: SketchGraph) -> Drawing:
    """Take from a sketch graph what the paper's method uses."""
    index = {v: i for i, v in enumerate(graph.vertices)}
    pixels = np.array(list(graph.vertices.values()), dtype=float)
    diagonal = float(np.linalg.norm(np.ptp(pixels, axis=0)))
    px_per_unit = diagonal / DIAGONAL
    said = tuple(graph.annotations.values())
    return Drawing(
        graph=graph,
        p=(pixels - np.array(graph.principal_point_px)) / px_per_unit,
        px_per_unit=px_per_unit,
        focal=_focal_px(graph, diagonal) / px_per_unit,
        constraints=_constraints(graph, index, said),
        ground=tuple(sorted({index[v] for a in said if isinstance(a, Ground) for v in a.vertices})),
        rectangles=tuple(_rectangles(graph, index)),
    )


def _focal_px(graph: SketchGraph, diagonal: float) -> float:
    if graph.camera is not None:
        return float(graph.camera.focal_px)
    if graph.photo is None:
        return 2.0 * diagonal
    usual = USUAL_FOCAL * max(graph.photo.width_px, graph.photo.height_px)
    return float(graph.photo.focal_px or usual)


def _constraints(
    graph: SketchGraph, index: Mapping[str, int], said: Iterable[Annotation]
) -> GeometricConstraints:
    rows: dict[str, list[tuple[int, ...]]] = {}

    def line(edge: str, start: str | None = None) -> tuple[int, int]:
        v, w = graph.edges[edge]
        return (index[w], index[v]) if start == w else (index[v], index[w])

    for a in said:
        if isinstance(a, RightAngle):
            rows.setdefault(a.kind, []).append(
                (*line(a.between[0], a.at), *line(a.between[1], a.at))
            )
        elif isinstance(a, EqualLength | Parallel):
            rows.setdefault(a.kind, []).extend(
                (*line(e), *line(following)) for e, following in pairwise(a.edges)
            )
        elif isinstance(a, OnFace) and graph.faces is not None and a.face in graph.faces:
            loop = graph.faces[a.face].loop
            rows.setdefault(a.kind, []).append((*(index[v] for v in loop[:3]), index[a.vertex]))
    kinds = (RightAngle.kind, EqualLength.kind, Parallel.kind, OnFace.kind)
    return GeometricConstraints(
        *(np.array(rows.get(kind, []), dtype=np.int64).reshape(-1, 4) for kind in kinds)
    )


def _rectangles(
    graph: SketchGraph, index: Mapping[str, int]
) -> Iterable[tuple[int, int, int, int]]:
    """The quadrilaterals with four annotated right angles, each once, in the drawing's order."""
    corners: set[tuple[int, frozenset[int]]] = set()
    for a in graph.annotations.values():
        if isinstance(a, RightAngle):
            ends = {v for e in a.between for v in graph.edges[e]} - {a.at}
            corners.add((index[a.at], frozenset(index[v] for v in ends)))
    arms: dict[int, list[frozenset[int]]] = {}
    for at, ends_ in sorted(corners, key=lambda c: (c[0], sorted(c[1]))):
        arms.setdefault(at, []).append(ends_)
    seen: set[frozenset[int]] = set()
    for b, pairs in sorted(arms.items()):
        for pair in (p for p in pairs if len(p) == 2):
            a, c = sorted(pair)
            for d in sorted({v for p in arms.get(a, []) if b in p for v in p} - {b}):
                loop = ((a, frozenset({b, d})), (c, frozenset({b, d})), (d, pair))
                if d != c and all(k in corners for k in loop) and {a, b, c, d} not in seen:
                    seen.add(frozenset({a, b, c, d}))
                    yield (a, b, c, d)


#: Kinds that the paper's energies speak of; a length sets the size when all is done.
KNOWN_KINDS = frozenset(a.kind for a in (RightAngle, EqualLength, Parallel, Ground, Length))


def unknown_annotations(graph: SketchGraph) -> tuple[str, ...]:
    """The ids of the annotations that the reference methods leave out."""
    given = graph.faces or {}
    return tuple(
        id_
        for id_, a in graph.annotations.items()
        if a.kind not in KNOWN_KINDS and not (isinstance(a, OnFace) and a.face in given)
    )


# --- the search -------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Limits:
    """Where the searches end; [Lau10] does not say.

    Parameters
    ----------
    evaluations_per_dimension : int
        Evaluations of the function that one optimisation may take, for each of its dimensions.
    tolerance : float
        An optimisation ends when the simplex is smaller than this (drawing units) and its values
        differ by less.
    restarts : int or None
        How many vertices are re-initialised in turn; None: all of them, as in the paper.
    seed : int
        Of the random depths.
    """

    evaluations_per_dimension: int = 400
    tolerance: float = 1e-4
    restarts: int | None = None
    seed: int = 0


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """Where a search ended: the unknowns, the energy, the evaluations it took."""

    x: Array
    energy: float
    evaluations: int


def nelder_mead(energy: Callable[[Array], float], x0: Array, step: Array, limits: Limits) -> Found:
    """Minimise by the simplex method, begun as GSL's nmsimplex begins: x0, and x0 + step_i e_i."""
    n = len(x0)
    simplex = np.vstack([x0, x0 + np.diag(step)])
    found = optimize.minimize(
        energy,
        x0,
        method="Nelder-Mead",
        options={
            "initial_simplex": simplex,
            "maxfev": limits.evaluations_per_dimension * n,
            "maxiter": limits.evaluations_per_dimension * n,
            "xatol": limits.tolerance,
            "fatol": limits.tolerance,
        },
    )
    return Found(np.asarray(found.x, dtype=float), float(found.fun), int(found.nfev))


# --- the camera -------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True, eq=False)
class View:
    """The camera of [Lau10] 4.3: position, orientation and focal length, drawing units.

    ``x_in_cam = rotation @ (x - position)``
    """

    position: Array
    rotation: Array
    focal: float

    def moved(self, change: Array) -> View:
        """The camera changed by seven numbers: position, a turn (rad), log of the focal length."""
        return View(
            self.position + change[:3],
            turn(change[3:6]) @ self.rotation,
            self.focal * float(np.exp(min(max(change[6], -20.0), 20.0))),
        )

    def project(self, X: Array) -> Array | None:
        """The image (n, 2) of vertices; None where one is not before the eye, or too far away."""
        in_cam = (X - self.position) @ self.rotation.T
        depth = in_cam[:, 2:]
        if not (depth.min() > 1e-3 and depth.max() < FAR):
            return None
        return np.asarray(self.focal * in_cam[:, :2] / depth)

    def projection_energy(self, X: Array, p: Array) -> float:
        """Square of the norm of p - p', square drawing units."""
        seen = self.project(X)
        return IMPOSSIBLE if seen is None else float(np.sum((seen - p) ** 2))


def view_along_z(focal: float) -> View:
    """The camera as far before z = 0 as its focal length: it sees the drawing where it is drawn."""
    return View(np.array([0.0, 0.0, -focal]), np.eye(3), focal)


def turn(rotation_vector: Array) -> Array:
    """The rotation about a vector by its length in rad (Rodrigues), (3, 3)."""
    x, y, z = rotation_vector
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    angle = float(np.sqrt(x * x + y * y + z * z))
    if angle < 1e-8:
        return np.asarray(np.eye(3) + K)
    return np.asarray(
        np.eye(3) + np.sin(angle) / angle * K + (1 - np.cos(angle)) / angle**2 * (K @ K)
    )


def camera_steps(drawing: Drawing) -> Array:
    """First steps of the seven numbers of the camera."""
    distance = 0.05 * drawing.focal
    return np.array([distance, distance, distance, 0.05, 0.05, 0.05, 0.1])


@dataclass(frozen=True, slots=True, eq=False)
class Reference:
    """What a reference method found, before it is put on the ground.

    Parameters
    ----------
    X : (n, 3) array
        Vertices, drawing units, any frame.
    view : View
    evaluations : int
    notes : mapping of word to number
        What the search did, for the curious.
    """

    X: Array
    view: View
    evaluations: int
    notes: Mapping[str, float] = field(default_factory=lambda: frozen_mapping({}))
