"""SolveSpace's solver (PyPI ``slvs``) on the part of a sketch that it can express.

It knows points in 3D, perpendicular lines, equal lengths, distances and points in a plane; neither
drawing nor camera. Redundant constraints make it fail, so that independent ones are picked for it:
greedily, by the rank of their derivatives at the truth. Its parallel constraint starts a hidden
scale at 0 and goes astray; parallels are told as right angles with what is square to one of them,
and so is a vertex on a face.
"""

from __future__ import annotations

import importlib.util
import time
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...solver.annotations import EqualLength, Ground, Length, OnFace, Parallel, RightAngle
from ...solver.energies import length_ratio, right_angle
from ...solver.synthetic import Shape, shape_error, v
from ...solver.values import Array

HEADING = (
    "slvs: the constraints alone, independent ones picked beforehand (not timed), from a good\n"
    "start: the true vertices, each displaced by 0.1 % of the diameter."
)
#: How far the start is from the truth, in parts of the diameter.
START = 0.001
#: What is left of a row after projection, in parts of its length, if it is a new one.
NEW = 1e-7

Line = tuple[int, int]


def missing() -> str:
    """A sentence where the package is not there, else nothing."""
    if importlib.util.find_spec("slvs") is None:
        return "slvs: left out, the package is not installed (pip install slvs)."
    return ""


@dataclass(frozen=True, slots=True)
class Constraint:
    """One equation: what it is, the lines or the point it speaks of, and its value."""

    kind: str  # "perpendicular", "equal", "distance", "ground"
    lines: tuple[Line, ...] = ()
    point: int = -1
    value: float = 0.0


@dataclass(frozen=True, slots=True)
class Task:
    """Independent constraints of one shape."""

    constraints: tuple[Constraint, ...]


def independent_constraints(shape: Shape) -> Task:
    """Pick constraints, each as long as it is independent of those before."""
    basis = np.empty((0, shape.X.size))
    picked = []
    for constraint in _candidates(shape):
        row = _row(shape.X, constraint)
        rest = row / max(float(np.linalg.norm(row)), 1e-300)
        for _ in range(2):
            rest = rest - basis.T @ (basis @ rest)
        size = float(np.linalg.norm(rest))
        if size > NEW:
            basis = np.vstack([basis, rest / size])
            picked.append(constraint)
    return Task(tuple(picked))


def _candidates(shape: Shape) -> Iterator[Constraint]:
    edge = {f"e{k}": ends for k, ends in enumerate(shape.edges)}
    index = {v(i): i for i in range(len(shape.X))}
    square = _square_edges(shape)
    said = shape.annotations.values()
    for a in said:
        if isinstance(a, Ground):
            yield from (Constraint("ground", point=index[i]) for i in a.vertices)
        elif isinstance(a, Length):
            yield Constraint("distance", (edge[a.edge],), value=a.length_mm)
    for a in said:
        if isinstance(a, RightAngle):
            yield Constraint("perpendicular", (edge[a.between[0]], edge[a.between[1]]))
        elif isinstance(a, EqualLength):
            for e, f in zip(a.edges, a.edges[1:], strict=False):
                yield Constraint("equal", (edge[e], edge[f]))
        elif isinstance(a, Parallel):
            first, *others = a.edges
            for e in others:
                for s in square.get(first, ()):
                    yield Constraint("perpendicular", (edge[e], edge[s]))
        elif isinstance(a, OnFace) and shape.faces is not None:
            loop = [index[i] for i in shape.faces[a.face].loop]
            for s in _square_to_face(shape, loop, square):
                yield Constraint("perpendicular", ((loop[0], index[a.vertex]), edge[s]))


def _square_edges(shape: Shape) -> dict[str, list[str]]:
    """For each edge those that are annotated as square to it."""
    square: dict[str, list[str]] = {}
    for a in shape.annotations.values():
        if isinstance(a, RightAngle):
            e, f = a.between
            square.setdefault(e, []).append(f)
            square.setdefault(f, []).append(e)
    return square


def _square_to_face(shape: Shape, loop: list[int], square: dict[str, list[str]]) -> list[str]:
    """Edges that are annotated as square to two neighbouring sides of a face."""
    id_of = {frozenset(ends): f"e{k}" for k, ends in enumerate(shape.edges)}
    sides = [id_of[frozenset(loop[k : k + 2])] for k in (0, 1)]
    return sorted(set(square.get(sides[0], ())) & set(square.get(sides[1], ())))[:1]


def _row(X: Array, constraint: Constraint) -> Array:
    row = np.zeros(X.shape)
    if constraint.kind == "ground":
        row[constraint.point, 2] = 1.0
    elif constraint.kind == "distance":
        a, b = constraint.lines[0]
        row[b], row[a] = X[b] - X[a], X[a] - X[b]
    else:
        energy = right_angle if constraint.kind == "perpendicular" else length_ratio
        pair = np.array([[*constraint.lines[0], *constraint.lines[1]]])
        linearised = energy(X, pair)
        np.add.at(row, linearised.vertex, linearised.value)
    return row.reshape(-1)


def displaced(shape: Shape, rng: np.random.Generator) -> Array:
    """A good start: the truth with each vertex displaced by 0.1 % of the diameter (RMS)."""
    diameter = float(np.linalg.norm(np.ptp(shape.X, axis=0)))
    step = START * diameter / np.sqrt(3)
    return np.asarray(shape.X + step * rng.normal(size=shape.X.shape))


def measure(task: Task, shape: Shape, start: Array) -> tuple[float | None, float]:
    """Solve; the shape's error (None where slvs gives up) and the time, ms."""
    began = time.process_time()
    X = _solved(task, start)
    ms = (time.process_time() - began) * 1e3
    if X is None:
        return None, ms
    return shape_error(shape, {v(i): x for i, x in enumerate(X)}), ms


def median_ms(shape: Shape, runs: int, tries: int = 2) -> float:
    """Median time over some starts, of each the fastest of some tries, ms."""
    task = independent_constraints(shape)
    starts = [displaced(shape, np.random.default_rng(run)) for run in range(runs)]
    times = [min(measure(task, shape, start)[1] for _ in range(tries)) for start in starts]
    return float(np.median(times))


def _solved(task: Task, start: Array) -> Array | None:
    import slvs

    # Its own helpers abort the process on 3D lines; the plain call does what is asked. All its
    # functions want every argument, by position.
    kinds, free, none = slvs.ConstraintType, slvs.E_FREE_IN_3D, slvs.E_NONE
    slvs.clear_sketch()
    origin = slvs.add_point_3d(1, 0.0, 0.0, 0.0)
    ground = slvs.add_workplane(1, origin, slvs.add_normal_3d(1, 1.0, 0.0, 0.0, 0.0))
    points = [slvs.add_point_3d(2, *map(float, x)) for x in start]
    lines: dict[Line, object] = {}

    def line(ends: Line) -> object:
        if ends not in lines:
            lines[ends] = slvs.add_line_3d(2, points[ends[0]], points[ends[1]])
        return lines[ends]

    for c in task.constraints:
        if c.kind == "ground":
            arguments = (kinds.PT_IN_PLANE, free, 0.0, points[c.point], none, ground, none)
        elif c.kind == "distance":
            a, b = c.lines[0]
            arguments = (kinds.PT_PT_DISTANCE, free, c.value, points[a], points[b], none, none)
        else:
            kind = kinds.PERPENDICULAR if c.kind == "perpendicular" else kinds.EQUAL_LENGTH_LINES
            arguments = (kind, free, 0.0, none, none, line(c.lines[0]), line(c.lines[1]))
        slvs.add_constraint(2, *arguments)
    if slvs.solve_sketch(2, False)["result"] not in (0, 4):  # okay, redundant but okay
        return None
    found = [[slvs.get_param_value(p) for p in point["param"][:3]] for point in points]
    return np.array(found)
