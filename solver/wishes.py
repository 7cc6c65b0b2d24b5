"""Sizes that a person wishes, though the drawing shows others.

Terms
-----
size
    A length or a diameter that is said. The first one tells how big everything is; each further
    one is a proportion, which the drawing tells as well.
wish
    A size that contradicts the drawing. It is no mistake but a design: the camera stays that of the
    drawing, and the shape is stretched, in steps, as if all edges were elastic bars: what need not
    change does not, and what lies along a wished size changes in proportion.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from scipy.sparse import bmat, csc_array, identity
from scipy.sparse.linalg import splu

from .annotations import Annotation, Diameter, Length
from .blaming import HELD, is_settled
from .diagnosis import freedoms, pose_near, without
from .full import FullProblem, Pose
from .graph import SketchGraph
from .least_squares import MAX_DENSE, Minimum
from .lifting import Lifted, lift
from .problem import build_problem
from .structure import Structure, build_structure
from .values import Array, Stop
from .world import camera_above_ground

#: In one step sizes change by so much against each other, logarithm of the ratio.
STRIDE = 0.2
#: Newton steps onto the constraints, at each.
MAX_STEPS = 12


def wishes_of(graph: SketchGraph) -> tuple[str, ...]:
    """The annotations that say sizes, but for the first length or else diameter."""
    lengths = [id_ for id_, a in graph.annotations.items() if isinstance(a, Length)]
    diameters = [id_ for id_, a in graph.annotations.items() if isinstance(a, Diameter)]
    return tuple([*lengths, *diameters][1:])


def drawn_shape(graph: SketchGraph, wishes: tuple[str, ...], stop: Stop) -> Lifted | None:
    """The shape that the drawing shows without some sizes; None where that is in doubt."""
    plain = without(graph, *wishes)
    structure = build_structure(plain)
    lifted = None if structure.contradiction else lift(plain, structure, stop, wary=True)
    if lifted is None or lifted.doubtful or not is_settled(lifted) or not lifted.above:
        return None
    names = [*plain.vertices, *plain.circles]
    return None if freedoms(lifted.full, lifted.minimum.x, names).count else lifted


def fulfilled(graph: SketchGraph, structure: Structure, drawn: Lifted, stop: Stop) -> Lifted | None:
    """The shape with the wished sizes, seen by the drawing's camera; None where none was found.

    Parameters
    ----------
    graph : SketchGraph
    structure : Structure
    drawn : Lifted
        What `drawn_shape` gave.
    stop : callable
    """
    measured = _measured(graph, drawn)
    n = 1 + int(_farthest(graph, measured) / STRIDE)
    x = _beginning(graph, structure, drawn)
    for k in range(1, n + 1):
        full = FullProblem(build_problem(_on_the_way(graph, measured, k / n), structure), None)
        before, x = x, _nearest(full, x, stop)
        if stop() or _worst(full, x) > HELD or _turns_over(full, before, x):
            return None
    n_iterations = drawn.minimum.iterations + n
    minimum = Minimum(x, n_iterations, True, full.merit(x, 0.0))
    return Lifted(full.problem, full, minimum, camera_above_ground(graph, full.problem, x))


def _nearest(full: FullProblem, x: Pose, stop: Stop) -> Pose:
    """The shape with the constraints held that is stretched least, the reference size kept."""
    wanted = _reference_size(full, x)[0]
    for _ in range(MAX_STEPS):
        h, H = full.constraints(x)
        size, by_g = _reference_size(full, x)
        h, H = np.append(h, (size - wanted) / wanted), np.vstack([H[:, 4:], by_g / wanted])
        if float(np.abs(h).max()) < 1e-15 or stop():
            break
        x = replace(x, g=x.g + _gentlest_step(h, H, _strain(full, x)))
    return x


def _strain(full: FullProblem, x: Pose) -> Array:
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
    return E


def _gentlest_step(h: Array, H: Array, E: Array) -> Array:
    """The step that takes h to 0 with the least energy."""
    n, k = H.shape[1], len(h)
    # Where nothing is stretched, the smallest step.
    W = E.T @ E
    W[np.diag_indices(n)] += 1e-6 * float(np.diag(W).max(initial=1.0))
    slack = 1e-12 * float(np.abs(H).max(initial=1.0)) ** 2
    right = np.concatenate([np.zeros(n), -h])
    if n + k <= MAX_DENSE:
        dense = np.block([[W, H.T], [H, -slack * np.eye(k)]])
        return np.asarray(np.linalg.solve(dense, right)[:n])
    system = bmat([[csc_array(W), csc_array(H.T)], [csc_array(H), -slack * identity(k)]], "csc")
    return np.asarray(splu(system).solve(right)[:n])


def _reference_size(full: FullProblem, x: Pose) -> tuple[float, Array]:
    """What the first size measures, up to one common factor, and its derivatives."""
    diameters = full.problem.diameters
    by_g = np.zeros(full.m)
    if diameters.reference_edge is None:
        by_g[diameters.reference_radius] = 2.0
        return 2 * float(x.g[diameters.reference_radius]), by_g
    v, w = full.coordinate[diameters.reference_edge]
    along = x.g[w] - x.g[v]
    size = float(np.linalg.norm(along))
    np.add.at(by_g, w, along / size)
    np.add.at(by_g, v, -along / size)
    return size, by_g


def _worst(full: FullProblem, x: Pose) -> float:
    h, _ = full.constraints(x)
    depth = full.positions(x) @ x.R[2]
    return float(np.abs(h).max(initial=0.0)) if depth.min(initial=1.0) > 0 else np.inf


def _turns_over(full: FullProblem, before: Pose, after: Pose) -> bool:
    """Whether an edge points the other way now: lengths do not tell, people do."""
    at = full.coordinate[full.problem.ends]
    old, new = (g[at[:, 1]] - g[at[:, 0]] for g in (before.g, after.g))
    return bool((np.einsum("ij,ij->i", old, new) < 0).any())


def _farthest(graph: SketchGraph, measured: Mapping[str, float]) -> float:
    """How far sizes are from those that are drawn: the range of the logarithms of their ratios."""
    ratios = [_size_mm(graph.annotations[id_]) / size for id_, size in measured.items()]
    return float(np.ptp(np.log(ratios)))


def _beginning(graph: SketchGraph, structure: Structure, drawn: Lifted) -> Pose:
    x = drawn.minimum.x
    in_cam = drawn.full.positions(x) @ x.R.T
    problem = build_problem(graph, structure)
    return pose_near(problem, in_cam, x.g[drawn.problem.structure.radius], x.log_focal)


def _measured(graph: SketchGraph, drawn: Lifted) -> Mapping[str, float]:
    """What the drawing shows the sizes to be, up to one common factor."""
    x = drawn.minimum.x
    X = drawn.full.positions(x)
    vertex = {v: k for k, v in enumerate(graph.vertices)}
    radii = x.g[drawn.problem.structure.radius].tolist()
    radius = dict(zip(graph.circles, radii, strict=True))
    found: dict[str, float] = {}
    for id_, annotation in graph.annotations.items():
        if isinstance(annotation, Length):
            v, w = graph.edges[annotation.edge]
            found[id_] = float(np.linalg.norm(X[vertex[v]] - X[vertex[w]]))
        elif isinstance(annotation, Diameter):
            found[id_] = 2 * radius[annotation.circle]
    return found


def _on_the_way(graph: SketchGraph, measured: Mapping[str, float], part: float) -> SketchGraph:
    """The graph with sizes between those that are drawn (part 0) and those that are said (1)."""
    if part == 1.0:
        return graph
    changed: dict[str, Annotation] = {}
    for id_, size in measured.items():
        said = graph.annotations[id_]
        wanted = float(size ** (1 - part) * _size_mm(said) ** part)
        if isinstance(said, Length):
            changed[id_] = replace(said, length_mm=wanted)
        elif isinstance(said, Diameter):
            changed[id_] = replace(said, diameter_mm=wanted)
    return replace(graph, annotations={**graph.annotations, **changed})


def _size_mm(annotation: Annotation) -> float:
    """The size that an annotation says; 0 where it says none."""
    if isinstance(annotation, Length):
        return annotation.length_mm
    return annotation.diameter_mm if isinstance(annotation, Diameter) else 0.0
