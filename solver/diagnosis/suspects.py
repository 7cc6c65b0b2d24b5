"""Which annotations the drawing and the other annotations speak against.

Each annotation is taken as an observation that may be a blunder, as geodesists test theirs
(Baarda's data snooping): what leaving it out would gain follows from one linearisation.

Terms
-----
soft problem
    Every vertex is free, and every annotation pulls as a spring; a false one gives way instead of
    bending everything else.
gain
    By how much the sum of squares falls when an annotation's rows are left out.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from ..annotations import Length, OnFace, Parallel, RightAngle, SymmetryPlane
from ..full import EXIF_LOG_SIGMA, FocalPrior, FullProblem, Pose
from ..geometry import diagonal
from ..graph import SketchGraph
from ..initial import USUAL_LOG_FOCAL, lift_linear, starts
from ..least_squares import Evaluation
from ..problem import Problem, build_problem
from ..structure import Structure, build_structure
from ..topology import MAX_KEPT, Topology, topology_of
from ..values import Array, IntArray, Stop
from .again import KnownShape

#: How far a hand strays from the line that it means, RMS in parts of the drawing's diagonal.
HAND_SIGMA = 0.007
#: A spring gives way by this (radians, parts of a length) where the drawing gives way by its error.
SPRING_SIGMA = 0.02
SOFT_FOCAL_SIGMA = 0.7
#: Springs drawn further than this yield.
YIELD = 2 * SPRING_SIGMA
#: Where all annotations are to be reached, stiff springs pull from afar and soft ones do not jam.
YIELDS, LONG_ITERATIONS = (5 * YIELD, YIELD, 100 * YIELD), 15
#: With so many unknowns only the first of these is tried, for the sake of time.
MANY_UNKNOWNS = 100
#: Iterations to compare beginnings, and to go on from the best one; views of each beginning.
FIRST_ITERATIONS, ITERATIONS, VIEWS = 4, 6, 3
#: From so many beginnings it goes on, until what is to blame is found; those are the same whose
#: energies differ by less than this part.
BEST_BEGINNINGS, SAME_ENERGY = 3, 1e-3
#: Which kinds of annotations have a say in where the soft problem begins: one false one spoils all
#: that follows from it.
KINDS_OF_BEGINNINGS = ((RightAngle, Parallel, SymmetryPlane), (RightAngle,))
#: Beyond so many unknowns the soft problem takes too long; only what the structure does not hold
#: by construction is then looked at.
MAX_UNKNOWNS = 330


@dataclass(frozen=True, slots=True)
class Suspect:
    """An annotation and how much speaks against it: the fall of the Bayesian information."""

    id: str
    weight: float


@dataclass(frozen=True, slots=True, eq=False)
class Relaxed:
    """A shape that follows the drawing, and the annotations as far as they let it.

    Parameters
    ----------
    shape : KnownShape
    suspects : list of Suspect
        Annotations that something speaks against, the most suspicious first.
    """

    shape: KnownShape
    suspects: list[Suspect]


def relax(
    graph: SketchGraph, problem: Problem, pose: Pose, stop: Stop, *, lost: bool
) -> Iterator[Relaxed]:
    """Let the annotations give way, and see which one does most: from the likeliest beginning on.

    Parameters
    ----------
    graph : SketchGraph
        What is solved.
    problem : Problem
        Its numbers.
    pose : Pose
        The result so far, from which only the camera and the depths are used.
    stop : callable
        Asked at each step; True ends the search with the best so far.
    lost : bool
        Whether the result is so bad that other beginnings may be better at once.
    """
    n_points = len(problem.points) + len(problem.circles)
    if 3 * n_points > MAX_UNKNOWNS:
        full = FullProblem(problem, None)
        yield _told(full, pose, leftover_suspects(graph, full, pose))
        return
    soft = softened(graph, problem)
    owners = row_owners(graph, soft)
    stiffness = spring_stiffness(problem)
    springs = _Springs(soft, stiffness, YIELD, stop)
    own = [begin(soft.problem, problem.structure, pose)]
    waiting = [] if lost else [own]
    tried: list[float] = []
    for begun in [*waiting, [*(own if lost else []), *other_beginnings(graph, soft.problem)]]:
        first = sorted(springs.all_relaxed(begun, FIRST_ITERATIONS), key=lambda t: t[1])
        for x, energy in first[:BEST_BEGINNINGS]:
            if stop():
                return
            x, energy = springs.relaxed(x, ITERATIONS)
            if not any(abs(energy - e) < SAME_ENERGY * energy for e in tried):
                tried.append(energy)
                yield _told(soft, x, weigh(soft, x, owners, stiffness))


def false_together(graph: SketchGraph, stop: Stop) -> list[str]:
    """Annotations that give way where all pull on the drawing's shape, the most strained first.

    For several that are false together: no single one is to blame then.
    """
    problem = build_problem(graph, build_structure(graph, {}))
    if 3 * (len(problem.points) + len(problem.circles)) > MAX_UNKNOWNS:
        return []
    soft = softened(graph, problem)
    springs = _Springs(soft, spring_stiffness(problem), YIELD, stop)
    tried = springs.all_relaxed(other_beginnings(graph, soft.problem), FIRST_ITERATIONS)
    if not tried:
        return []
    x, _ = springs.relaxed(min(tried, key=lambda t: t[1])[0], ITERATIONS)
    h = np.abs(soft.constraints(x)[0])
    owned = rows_of_owners(row_owners(graph, soft))
    strain = {id_: float(h[rows].max()) for id_, rows in owned.items()}
    # Of those that ask for the same, the one that asks for least.
    found = [k for k in strain if strain[k] > YIELD]
    return sorted(found, key=lambda k: (-round(strain[k], 6), len(owned[k])))


def beginnings(
    graph: SketchGraph, problem: Problem, pose: Pose, stop: Stop
) -> Iterator[KnownShape]:
    """Shapes from which all annotations may be reached, the nearest first, for each yield."""
    unknowns = 3 * (len(problem.points) + len(problem.circles))
    if unknowns > MAX_UNKNOWNS:
        return
    soft = softened(graph, problem)
    begun = [begin(soft.problem, problem.structure, pose), *other_beginnings(graph, soft.problem)]
    for strain in YIELDS if unknowns < MANY_UNKNOWNS else YIELDS[:1]:
        springs = _Springs(soft, spring_stiffness(problem), strain, stop)
        tried = springs.all_relaxed(begun, LONG_ITERATIONS)
        for x, _ in sorted(tried, key=lambda t: t[1])[:2]:
            yield KnownShape.at(soft, x)


def _told(full: FullProblem, x: Pose, found: list[Suspect]) -> Relaxed:
    return Relaxed(KnownShape.at(full, x), found)


def leftover_suspects(graph: SketchGraph, full: FullProblem, pose: Pose) -> list[Suspect]:
    """The same at a solution, among the annotations that are not held by construction."""
    owners = row_owners(graph, full)
    if not owners:
        return []
    return weigh(full, pose, owners, spring_stiffness(full.problem))


def spring_stiffness(problem: Problem) -> float:
    """The weight of a spring's square against a square in the image."""
    extent = diagonal(np.vstack([problem.points, problem.circles.centres]))
    drawn = HAND_SIGMA * max(extent, 1e-6) / np.sqrt(2)
    return float((drawn / SPRING_SIGMA) ** 2)


def softened(graph: SketchGraph, problem: Problem) -> FullProblem:
    """The soft problem: no coordinate is shared but those that are tied without an annotation."""
    free = _freed(topology_of(graph), problem.structure)
    known = problem.log_focal_prior
    # From afar all springs are soft: a wide prior keeps the camera near where people stand.
    prior = FocalPrior(USUAL_LOG_FOCAL, SOFT_FOCAL_SIGMA)
    if known is not None:
        prior = FocalPrior(known, EXIF_LOG_SIGMA)
    return FullProblem(build_problem(graph, free), prior)


def unshared(soft: FullProblem, full: FullProblem, x: Pose) -> Pose:
    """The same shape where no coordinate is shared."""
    structure, g = soft.problem.structure, np.zeros(soft.m)
    g[structure.coordinate] = full.positions(x)
    g[structure.radius] = x.g[full.problem.structure.radius]
    return Pose(x.R, x.log_focal, g)


@lru_cache(maxsize=MAX_KEPT)
def _freed(topology: Topology, tied: Structure) -> Structure:
    """The structure of the soft problem; one and the same while vertices move, as `tied` is."""
    coordinate = _own_coordinates(topology, tied)
    n_free = int(coordinate.max(initial=-1)) + 1
    return replace(
        tied,
        edge_axis=np.full_like(tied.edge_axis, -1),
        edge_across=np.zeros_like(tied.edge_across),
        coordinate=coordinate,
        radius=n_free + np.arange(len(tied.radius)),
        n_coordinates=n_free + len(tied.radius),
        balances=tied.balances[:0],
        balance_owners=(),
        # Circles know their normal by it.
        vertical=tied.vertical if len(tied.radius) else None,
        has_axes=False,
    )


def _own_coordinates(topology: Topology, tied: Structure) -> IntArray:
    """Coordinates of all points, each its own, but those that are tied without an annotation.

    Circles stand on one axis, and vertices that lie on a circle are as high as it is.
    """
    coordinate = np.arange(tied.coordinate.size).reshape(tied.coordinate.shape)
    centre = {c: len(topology.vertices) + k for c, k in topology.circles.items()}
    level = [k for k in range(3) if k != tied.vertical]
    for r in topology.revolutions.values():
        on_axis = [centre[c] for c in (r.ground, r.bottom, r.top)]
        coordinate[np.ix_(on_axis, level)] = coordinate[np.ix_(on_axis[:1], level)]
    for vertex, circle in topology.rims if tied.vertical is not None else ():
        own = coordinate[vertex, tied.vertical]
        coordinate[coordinate == own] = coordinate[len(topology.vertices) + circle, tied.vertical]
    _, names = np.unique(coordinate, return_inverse=True)
    return np.asarray(names.reshape(coordinate.shape), dtype=np.int64)


def begin(soft: Problem, tied: Structure, pose: Pose) -> Pose | None:
    """Each vertex on its ray, as deep as it was."""
    seen = np.vstack([soft.points, soft.circles.centres])
    depth = pose.g[tied.coordinate] @ pose.R[2]
    usual = float(np.median(depth))
    if not usual > 0:
        return None
    depth = np.clip(depth, 0.3 * usual, 3 * usual)
    rays = np.hstack([seen / np.exp(pose.log_focal), np.ones((len(seen), 1))])
    X = (rays * depth[:, None]) @ pose.R
    places = soft.structure.coordinate.reshape(-1)
    free = np.bincount(places, X.reshape(-1)) / np.bincount(places)
    return Pose(pose.R, pose.log_focal, np.concatenate([free, pose.g[tied.radius]]))


def other_beginnings(graph: SketchGraph, soft: Problem) -> list[Pose]:
    """Beginnings that only some kinds of annotations had a say in."""
    found = []
    for kinds in KINDS_OF_BEGINNINGS:
        said = {k: a for k, a in graph.annotations.items() if isinstance(a, kinds)}
        structure = build_structure(graph, said)
        if structure.contradiction or structure.n_coordinates > MAX_UNKNOWNS:
            continue
        problem = replace(soft, structure=structure)
        for view in starts(problem)[:VIEWS]:
            g = lift_linear(problem, view.R, view.log_focal, 1e-2)
            x = begin(soft, structure, Pose(view.R, view.log_focal, g))
            found += [x] if x is not None else []
    return found


@dataclass(frozen=True, slots=True, eq=False)
class _Springs:
    """The soft problem with springs that yield more the further they are drawn (Cauchy)."""

    soft: FullProblem
    stiffness: float
    strain: float
    stop: Stop

    def all_relaxed(
        self, begun: Sequence[Pose | None], iterations: int
    ) -> list[tuple[Pose, float]]:
        """From each beginning; from none any more once it is enough."""
        return [self.relaxed(x, iterations) for x in begun if x is not None and not self.stop()]

    def relaxed(self, x: Pose, iterations: int) -> tuple[Pose, float]:
        """A few steps of Levenberg-Marquardt on |r|^2 + s sum log(1 + h^2 / c^2) c^2."""
        at, mu = self.soft.evaluate(x), 1e-3
        energy = self._energy(x, at.h)
        for _ in range(iterations):
            if self.stop():
                break
            A, b = _normal(at, self.stiffness / (1 + (at.h / self.strain) ** 2))
            diagonal = np.diag(A)
            A[np.diag_indices(len(A))] += mu * (diagonal + 1e-6 * float(diagonal.max()))
            step = np.asarray(-np.linalg.solve(A, b), dtype=np.float64)
            moved = self.soft.retract(x, step)
            after = None if moved is None else self.soft.evaluate(moved)
            new = np.inf if moved is None or after is None else self._energy(moved, after.h)
            if moved is None or after is None or not new <= energy:
                mu *= 30
                continue
            settled = new > 0.98 * energy
            x, at, energy, mu = moved, after, new, mu / 10
            if settled:
                break
        return x, energy

    def _energy(self, x: Pose, h: Array) -> float:
        springs = float(np.log1p((h / self.strain) ** 2).sum()) * self.strain**2
        return self.soft.merit(x, 0.0) + self.stiffness * springs


def _normal(at: Evaluation, stiffness: float | Array) -> tuple[Array, Array]:
    return at.A + (at.H.T * stiffness) @ at.H, at.b + at.H.T @ (stiffness * at.h)


def weigh(
    full: FullProblem, x: Pose, owners: Sequence[tuple[str, ...]], stiffness: float
) -> list[Suspect]:
    """What leaving out each owner's rows would gain, from one linearisation.

    With A = J^T J + s H^T H, the residuals h after the step, and L = s H A^-1 H^T, the gain of the
    rows a is s h_a^T (I - L_aa)^-1 h_a.

    Parameters
    ----------
    full : FullProblem
    x : Pose
    owners : sequence of tuples of ids
        For each row of h who asks for it.
    stiffness : float
    """
    at = full.evaluate(x)
    A, b = _normal(at, stiffness)
    A[np.diag_indices(len(A))] += 1e-12 * float(np.diag(A).max())
    solved = np.linalg.solve(A, np.column_stack([b, at.H.T]))
    step = -solved[:, 0]
    h = at.h + at.H @ step
    leverage = stiffness * (at.H @ solved[:, 1:])
    misfit = full.merit(x, 0.0) + float(step @ (2 * at.b + at.A @ step))
    total = max(misfit, 0.0) + stiffness * float(h @ h) + 1e-300
    n = 2 * full.n_vertices + full.problem.circles.supports.size + len(h)
    found = []
    for id_, rows in rows_of_owners(owners).items():
        part = np.eye(len(rows)) * (1 + 1e-9) - leverage[np.ix_(rows, rows)]
        gain = stiffness * float(h[rows] @ np.linalg.solve(part, h[rows]))
        left = max(total - gain, 1e-6 * total)
        # Each row left out could be a parameter more.
        weight = n * np.log(total / left) - len(rows) * np.log(n)
        found.append(Suspect(id_, float(weight)))
    found.sort(key=lambda s: -s.weight)
    return [s for s in found if s.weight > 0]


def rows_of_owners(owners: Sequence[tuple[str, ...]]) -> Mapping[str, list[int]]:
    """For each annotation the rows that it asks for."""
    rows: dict[str, list[int]] = {}
    for i, ids in enumerate(owners):
        for id_ in ids:
            rows.setdefault(id_, []).append(i)
    return rows


def row_owners(graph: SketchGraph, full: FullProblem) -> list[tuple[str, ...]]:
    """For each row of a problem's constraints the annotations that ask for it.

    Lengths are compared with the first one, and ground vertices with others on the ground: such
    rows are asked for by both sides. Rows that only a named face asks for have no owner.
    """
    if not full.constrained:
        return []
    names, said = list(graph.vertices), topology_of(graph).by_kind
    first = next((id_ for id_, _ in said["length"]), None)
    ground = {id_: set(a.vertices) for id_, a in said["ground"]}
    several = {id_ for kind in ("ground", "on_face", "length") for id_, _ in said[kind]}
    alone = {id_: (id_,) for id_ in graph.annotations if id_ not in several}

    def asking(owner: str, item: Sequence[int]) -> tuple[str, ...]:
        if owner in ground:
            at = {names[i] for i in item}
            return tuple(id_ for id_, vertices in ground.items() if at & vertices)
        touching = graph.annotations.get(owner)
        if isinstance(touching, OnFace) and names[item[3]] != touching.vertex:
            return ()
        if first is not None and isinstance(graph.annotations.get(owner), Length):
            return (first, owner)
        return (owner,) if owner in graph.annotations else ()

    owners: list[tuple[str, ...]] = []
    for block in full.problem.blocks:
        rows_each = 3 if block.energy == "parallel" else 1
        for owner, item in zip(block.owners, block.items.tolist(), strict=True):
            owners += [alone.get(owner) or asking(owner, item)] * rows_each
    diameters = full.problem.diameters
    owners += [(*diameters.reference_owner, owner) for owner in diameters.owners]
    # Nobody annotated that vertices lie on circles.
    owners += [()] * len(full.problem.rims)
    return owners + [(owner,) for owner in full.problem.structure.balance_owners]
