"""Sizes that a person wishes, though the drawing shows others.

Terms
-----
size
    A length, a diameter or an angle that is said. The first length or diameter tells how big
    everything is, where no known camera does; each further one is a proportion, which the drawing
    tells as well, and so is each angle.
wish
    A size that contradicts the drawing. It is no mistake but a design: the camera stays that of the
    drawing, and the shape is stretched, in steps, as if all edges were elastic bars: what need not
    change does not, what lies along a wished size changes in proportion, and what is traced stays.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from operator import itemgetter

import numpy as np

from .annotations import Angle, Annotation, Diameter, Length
from .candidates import HELD, is_settled
from .closer_look import DOUBTFUL_RMS
from .diagnosis import freedoms, pose_in, without
from .elastic import gentlest_step
from .full import FullProblem, Pose
from .graph import SketchGraph
from .least_squares import Minimum
from .lifting import Lifted, lift
from .problem import build_problem
from .structure import Structure, build_structure
from .topology import topology_of
from .values import Array, IntArray, Stop
from .world import camera_above_ground, ground_indices

#: In one step sizes change by so much against each other, logarithm of the ratio.
STRIDE = 0.2
#: Newton steps onto the constraints, at each.
MAX_STEPS = 12
#: What is traced is really there: it gives way so many times less than what is imagined.
TRACED_STIFFNESS = 1e4


def sizes_of(graph: SketchGraph) -> dict[str, bool]:
    """The annotations that say sizes, and whether of what is traced: such first, and lengths."""
    traced = _traced(graph)
    said = topology_of(graph).by_kind
    found = {id_: a.edge in traced for id_, a in said["length"]}
    found |= {id_: a.circle in traced for id_, a in said["diameter"]}
    found = dict(sorted(found.items(), key=itemgetter(1), reverse=True))
    return found | {id_: traced.issuperset(a.between) for id_, a in said["angle"]}


def proportions_of(graph: SketchGraph) -> tuple[str, ...]:
    """The annotations that say sizes beyond the first, which only tells how big everything is."""
    sizes = tuple(sizes_of(graph))
    return sizes[_first_of(graph) is not None :]


def _first_of(graph: SketchGraph) -> str | None:
    """The annotation of the first length or diameter."""
    first = next(iter(sizes_of(graph)), None)
    return None if first is None or isinstance(graph.annotations[first], Angle) else first


def _traced(graph: SketchGraph) -> frozenset[str]:
    """Construction that is drawn on real things, no line of dimension between made vertices."""
    if not graph.construction:
        return frozenset()
    helping = set(graph.construction)
    made = {v for id_, ends in graph.edges.items() if id_ not in helping for v in ends}
    return frozenset(id_ for id_ in helping if not made.issuperset(graph.edges.get(id_, ("",))))


def drawn_shape(graph: SketchGraph, wishes: tuple[str, ...], stop: Stop) -> Lifted | None:
    """The shape that the drawing shows without some sizes; None where that is in doubt."""
    plain = without(graph, *wishes)
    structure = build_structure(plain)
    lifted = (
        None if structure.contradiction else lift(plain, structure, stop, doubt_rms=DOUBTFUL_RMS)
    )
    if lifted is None or lifted.doubtful or not is_settled(lifted) or not lifted.above:
        return None
    names = [*plain.vertices, *plain.circles]
    return None if freedoms(lifted.full, lifted.minimum.x, names).count else lifted


def fulfilled(
    graph: SketchGraph,
    structure: Structure,
    drawn: Lifted,
    stop: Stop,
    *,
    eye_mm: float | None = None,
) -> Lifted | None:
    """The shape with the wished sizes, seen by the drawing's camera; None where none was found.

    Parameters
    ----------
    graph : SketchGraph
    structure : Structure
    drawn : Lifted
        The shape without them, such as `drawn_shape` gives.
    stop : callable
    eye_mm : float, optional
        How high over the ground a known camera is, where that tells how big everything is.
    """
    x = pose_in(build_problem(graph, structure), drawn.full, drawn.minimum.x)
    scale = _scale_of(graph, structure, x, eye_mm)
    measured = _measured_mm(graph, structure, x, scale.unit_mm)
    n = 1 + int(_farthest(graph, measured) / STRIDE)
    for k in range(1, n + 1):
        on_the_way = _on_the_way(graph, measured, k / n)
        full = FullProblem(build_problem(on_the_way, structure), None)
        before, x = x, _nearest(on_the_way, full, x, scale, stop)
        off = [*full.constraints(x)[0], *scale.rows(on_the_way, structure, x)[0]]
        held = np.abs(off).max(initial=0.0) < HELD and _is_before_the_eye(full, x)
        if stop() or not held or _turns_over(full, before, x):
            return None
    n_iterations = drawn.minimum.iterations + n
    minimum = Minimum(x, n_iterations, True, full.merit(x, 0.0))
    above = camera_above_ground(graph, full.problem, x)
    return Lifted(full.problem, full, minimum, above, drawn=drawn)


@dataclass(frozen=True, slots=True)
class _Scale:
    """How big everything is, while shapes are stretched.

    Parameters
    ----------
    first : str or None
        The annotation of the size that is told in mm; all others are told by their ratios to it.
        None where only angles are said: stretching least, everything stays as big as it is.
    unit_mm : float
        Of the shared coordinates.
    ground : int or None
        The coordinate of the ground, which stays under a known camera.
    level : float
    """

    first: str | None
    unit_mm: float
    ground: int | None = None
    level: float = 1.0

    def rows(self, graph: SketchGraph, structure: Structure, x: Pose) -> tuple[Array, Array]:
        """How far the first size is off, and the ground, in parts; derivatives by coordinates."""
        h: list[float] = []
        H: list[Array] = []
        if self.first is not None:
            wanted = _said(graph.annotations[self.first]) / self.unit_mm
            size, by_g = _size_at(graph, structure, x, self.first)
            h, H = [size / wanted - 1], [by_g / wanted]
        if self.ground is not None:
            h.append(float(x.g[self.ground]) / self.level - 1)
            H.append(np.eye(1, len(x.g), self.ground)[0] / self.level)
        return np.array(h), np.array(H).reshape(len(h), len(x.g))


def _scale_of(graph: SketchGraph, structure: Structure, x: Pose, eye_mm: float | None) -> _Scale:
    first = _first_of(graph)
    if eye_mm is None or structure.vertical is None:
        if first is None:
            return _Scale(None, 1.0)
        said_mm = _said(graph.annotations[first])
        return _Scale(first, said_mm / _size_at(graph, structure, x, first)[0])
    # All of the ground shares one coordinate, and the eye is at the origin.
    ground = int(structure.coordinate[ground_indices(graph)[0], structure.vertical])
    level = float(x.g[ground])
    return _Scale(first, eye_mm / abs(level), ground, level)


def _nearest(graph: SketchGraph, full: FullProblem, x: Pose, scale: _Scale, stop: Stop) -> Pose:
    """The shape with the constraints held that is stretched least."""
    for _ in range(MAX_STEPS):
        h, H = full.constraints(x)
        own, by_g = scale.rows(graph, full.problem.structure, x)
        h, H = np.append(h, own), np.vstack([H[:, 4:], by_g])
        if float(np.abs(h).max()) < 1e-15 or stop():
            break
        x = replace(x, g=x.g + gentlest_step(h, H, _strain(graph, full, x)))
    return x


def _strain(graph: SketchGraph, full: FullProblem, x: Pose) -> Array:
    """What a change of the coordinates does to edges and radii; its square is elastic energy."""
    at = full.coordinate[full.problem.ends]
    first, second = at[:, 0].reshape(-1), at[:, 1].reshape(-1)
    along = x.g[at[:, 1]] - x.g[at[:, 0]]
    roots = np.repeat(np.sqrt(np.maximum(np.linalg.norm(along, axis=1), 1e-12)), 3)
    radius = full.problem.structure.radius
    E = np.zeros((len(first) + len(radius), full.m))
    rows = np.arange(len(first))
    np.add.at(E, (rows, second), 1 / roots)
    np.add.at(E, (rows, first), -1 / roots)
    E[len(first) + np.arange(len(radius)), radius] = 1 / np.sqrt(np.maximum(x.g[radius], 1e-12))
    real = _traced_coordinates(graph, full)
    stays = np.zeros((len(real), full.m))
    stays[np.arange(len(real)), real] = TRACED_STIFFNESS * float(np.abs(E).max(initial=1.0))
    return np.vstack([E, stays])


def _traced_coordinates(graph: SketchGraph, full: FullProblem) -> IntArray:
    """The shared coordinates of what is traced: it is where it is."""
    traced = _traced(graph)
    ends = full.problem.ends[[id_ in traced for id_ in graph.edges]]
    circles = np.flatnonzero([id_ in traced for id_ in graph.circles])
    at = full.coordinate[[*ends.reshape(-1), *(full.n_vertices + circles)]]
    return np.unique(np.append(at, full.problem.structure.radius[circles])).astype(np.int64)


def _is_before_the_eye(full: FullProblem, x: Pose) -> bool:
    return bool((full.positions(x) @ x.R[2] > 0).all())


def _turns_over(full: FullProblem, before: Pose, after: Pose) -> bool:
    """Whether an edge points the other way now: lengths do not tell, people do."""
    at = full.coordinate[full.problem.ends]
    old, new = (g[at[:, 1]] - g[at[:, 0]] for g in (before.g, after.g))
    return bool((np.einsum("ij,ij->i", old, new) < 0).any())


def _farthest(graph: SketchGraph, measured: Mapping[str, float]) -> float:
    """How far sizes are from those that are drawn: the range of the logarithms of their ratios."""
    ratios = [_said(graph.annotations[id_]) / size for id_, size in measured.items()]
    return float(np.ptp(np.log([1.0, *ratios])))


def _measured_mm(
    graph: SketchGraph, structure: Structure, x: Pose, unit_mm: float
) -> Mapping[str, float]:
    """What the sizes are in a pose, mm and degrees."""
    units = {id_: _unit(graph.annotations[id_], unit_mm) for id_ in sizes_of(graph)}
    return {id_: unit * _size_at(graph, structure, x, id_)[0] for id_, unit in units.items()}


def _unit(annotation: Annotation, unit_mm: float) -> float:
    return 180.0 / math.pi if isinstance(annotation, Angle) else unit_mm


def _size_at(graph: SketchGraph, structure: Structure, x: Pose, id_: str) -> tuple[float, Array]:
    """What an annotation's size measures, in the pose's unit or radians, and its derivatives."""
    said, topology, by_g = graph.annotations[id_], topology_of(graph), np.zeros(len(x.g))
    if isinstance(said, Angle):
        return _angle_at(graph, structure, x, id_), by_g
    if isinstance(said, Diameter):
        radius = structure.radius[topology.circles[said.circle]]
        by_g[radius] = 2.0
        return 2 * float(x.g[radius]), by_g
    assert isinstance(said, Length)
    v, w = structure.coordinate[topology.ends[topology.edges[said.edge]]]
    along = x.g[w] - x.g[v]
    size = float(np.linalg.norm(along))
    np.add.at(by_g, w, along / size)
    np.add.at(by_g, v, -along / size)
    return size, by_g


def _angle_at(graph: SketchGraph, structure: Structure, x: Pose, id_: str) -> float:
    """What a corner measures, radians."""
    (block,) = (b for b in build_problem(graph, structure).blocks if b.energy == "angle")
    k = block.owners.index(id_)
    assert block.wanted is not None
    off = block.evaluate(x.g[structure.coordinate]).residual
    return float(off[k] + block.wanted[k, 0])


def _on_the_way(graph: SketchGraph, measured: Mapping[str, float], part: float) -> SketchGraph:
    """The graph with sizes between those that are drawn (part 0) and those that are said (1)."""
    if part == 1.0:
        return graph
    changed: dict[str, Annotation] = {}
    for id_, size in measured.items():
        said = graph.annotations[id_]
        wanted = float(size ** (1 - part) * _said(said) ** part)
        if isinstance(said, Length):
            changed[id_] = replace(said, length_mm=wanted)
        elif isinstance(said, Diameter):
            changed[id_] = replace(said, diameter_mm=wanted)
        elif isinstance(said, Angle):
            changed[id_] = replace(said, angle_deg=wanted)
    return replace(graph, annotations={**graph.annotations, **changed})


def _said(annotation: Annotation) -> float:
    """The size that an annotation says, mm or degrees; 0 where it says none."""
    if isinstance(annotation, Angle):
        return annotation.angle_deg
    if isinstance(annotation, Length):
        return annotation.length_mm
    return annotation.diameter_mm if isinstance(annotation, Diameter) else 0.0
