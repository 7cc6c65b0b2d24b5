"""Drawings whose directions lean: errors of a hand that go together.

People draw a whole direction towards a wrong vanishing point, and all lengths along it too long or
too short. The ends then meet well, but no right-angled shape fits, and the full step turns camera
and shape until they share the blame. Where the drawing itself shows that its errors go together,
they are taken for what they are, and the shape is the one from which they lead to the drawing.

Terms
-----
lean
    A small matrix E (3, 3), object axes: the hand drew c + E (c - middle) where the shape has c.
    Its numbers are normal, with standard deviations that people have (LEAN_SIGMA, LENGTH_SIGMA).
marginal misfit
    |r|^2 with the best lean, plus what that lean costs: with D the derivatives of r by E and P the
    lean's precisions against the noise, |r|^2 - r^T D^T (P + D D^T)^-1 D r.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from itertools import islice

import numpy as np

from .candidates import drawn_diagonal, is_settled, reading_of
from .diagnosis import Reading, standard_errors
from .diagnosis.precision import tangent
from .full import DRAWING_SIGMA, FocalPrior, FullProblem, Pose
from .graph import SketchGraph
from .initial import views
from .least_squares import EXACT_COST, minimise
from .lifting import Lifted, initial_pose, told_focal
from .problem import TRACED_SIGMA_PX, Problem, build_problem
from .solution import Solution
from .starting.focal_prior import USUAL, spare_observations
from .starting.warm_start import pose_from
from .structure import Structure
from .values import Array, Stop, kept
from .world import camera_above_ground

#: How far directions lean (3 to 10 degrees, by component) and how far lengths are off, rad, parts.
LEAN_SIGMA, LENGTH_SIGMA = 0.08, 0.03
#: The same may be smaller, in these parts: a slight lean must not move the shape much.
SCALES = np.array([1.0, 0.5, 0.25, 0.125])
#: How well ends meet (RMS of a vertex, in parts of the drawing's diagonal), and how sure that is
#: (standard deviation of the logarithm).
ENDS_RMS, ENDS_LOG_SIGMA = 0.006, 0.8
#: The noises among which the likeliest is looked for, in the same parts.
NOISES = np.geomspace(3e-5, 0.05, 61)
#: Odds (logarithm) that a drawing has to show before its errors count as going together: 20 to 1,
#: commonly called strong evidence. 2,880 drawings with independent errors come out with it as they
#: do where no lean is looked for.
PLAIN_ODDS = 3.0
#: And that which is missed by so much without a lean (RMS, parts of its diagonal), as few miss it
#: whose errors are independent.
FAR_RMS, FAR_ODDS = 0.012, 0.7
#: What a lean adds to a shape's freedoms: the rest is turn and size, which are free already.
LEAN_FREEDOMS = 3
#: A lean that is less likely than this adds little to what is large in standard errors.
HARDLY = 0.05
#: Iterations from the shape without a lean to the one with it, and the gain that ends them.
MAX_ITERATIONS = 60
ENOUGH = 1e-7
#: No hand leans so far that it misses the drawing by this (RMS, parts of its diagonal): of 700
#: whose shape was found the worst missed by 0.053, those of another shape by 0.11 and more.
TOO_FAR_RMS = 0.07
#: Views that the lines tell, from which a lean is begun where the shape without one leads too far.
N_VIEWS = 3
#: Directions of the lean that the drawing feels less than this part of the others.
UNFELT = 1e-4


@dataclass(frozen=True, slots=True)
class LeaningHand:
    """How a drawing that leans was drawn.

    Parameters
    ----------
    noise : float
        Standard deviation of a drawn coordinate, image units: how exactly ends meet.
    scale : float
        How far it leans, in parts of what is usual.
    """

    noise: float
    scale: float = 1.0


class LeaningProblem(FullProblem):
    """The full step by the marginal misfit of what is imagined; what is traced does not lean.

    Parameters
    ----------
    problem : Problem
    prior : FocalPrior or None
    hand : LeaningHand
    """

    def __init__(self, problem: Problem, prior: FocalPrior | None, hand: LeaningHand) -> None:
        super().__init__(problem, prior)
        self.hand = hand
        self._precision = np.diag((hand.noise / (hand.scale * _lean_sigmas())) ** 2)

    def weighed_as(self, problem: Problem) -> LeaningProblem:
        """The same with the weights of another problem."""
        return LeaningProblem(problem, self.prior, self.hand)

    def misfit(self, x: Pose) -> float:
        """The marginal misfit."""
        D, r = by_lean(self, x), self.rows_of_vertices(x)[0]
        felt = D @ r
        return float(r @ r - felt @ np.linalg.solve(self._precision + D @ D.T, felt))

    def _of_drawing(self, x: Pose) -> tuple[Array, Array]:
        if self._last.normal is None or self._last.normal[0] is not x:
            rows = self.rows_of_vertices(x)
            A, b = self.vertices.normal_equations(rows)
            D = by_lean(self, x)
            both = D @ np.column_stack([self.vertices.dense(rows), rows[0]])
            shared = both[:, :-1].T @ np.linalg.solve(self._precision + D @ D.T, both)
            self._last.normal = (x, A - shared[:, :-1], b - shared[:, -1])
        return self._last.normal[1:]


def by_lean(full: FullProblem, x: Pose) -> Array:
    """Derivatives of r by the nine numbers of E, (9, 2 n)."""
    rows, imagined = full.rows_of_vertices(x), (full.problem.weights <= 1.0).astype(float)
    c = x.g[full.coordinate[: full.n_vertices]]
    middle = (imagined @ c) / max(1.0, float(imagined.sum()))
    off = ((c - middle) * imagined[:, None]).T
    slopes = rows[5:, None, :].reshape(3, 1, 2, -1) * off[None, :, None, :]
    return np.asarray(slopes.reshape(9, -1))


@kept
def _evidence(full: FullProblem, told: FocalPrior | None, x: Pose) -> _Evidence:
    """What the drawing shows of a lean, all else free to follow it, to first order about x."""
    plain = _plain(full, told)
    rows = plain.rows_of_vertices(x)
    D, r = by_lean(plain, x), rows[0]
    at = plain.evaluate(x)
    B = D @ plain.vertices.dense(rows)
    if plain.up is not None:
        B[:, :3] = B[:, :3] @ np.outer(plain.up, plain.up)
    if plain.problem.camera is not None:
        B[:, 3] = 0.0
    A, b = at.A.copy(), at.b
    if len(at.h):
        N = tangent(at.H)
        A, B, b = N.T @ A @ N, B @ N, N.T @ b
    A[np.diag_indices(len(A))] += 1e-12 * float(A.trace())
    taken = np.linalg.solve(A, np.column_stack([B.T, b]))
    sigmas = _lean_sigmas()
    S = (D @ D.T - B @ taken[:, :-1]) * np.outer(sigmas, sigmas)
    felt = (D @ r - B @ taken[:, -1]) * sigmas
    values, vectors = np.linalg.eigh(S)
    seen = values > UNFELT * max(float(values[-1]), 1e-300)
    squares = (felt @ vectors[:, seen]) ** 2 / values[seen]
    rest = float(r @ r - b @ taken[:, -1] - squares.sum())
    spare = max(spare_observations(plain, x) + (plain.prior is not None), len(squares))
    return _Evidence(values[seen], squares, max(rest, 1e-30), spare - len(squares))


@dataclass(frozen=True, slots=True, eq=False)
class _Evidence:
    """Squares of what is left over once everything else followed the drawing.

    Parameters
    ----------
    variances : (k,) array
        By which a usual lean adds to the noise in the k directions where it can be seen.
    squares : (k,) array
        Seen in these directions.
    rest : float
        Sum of the squares in all others.
    n_rest : int
        How many those are.
    """

    variances: Array
    squares: Array
    rest: float
    n_rest: int

    def log_odds(self, noises: Array, scales: Array = SCALES) -> tuple[float, LeaningHand]:
        """Of a lean against none, each with its likeliest noise; and the likeliest hand."""
        usual = ENDS_RMS * noises[-1] / NOISES[-1]
        prior = -0.5 * (np.log(noises / usual) / ENDS_LOG_SIGMA) ** 2
        prior -= 0.5 * (2 * self.n_rest * np.log(noises) + self.rest / noises**2)
        scales = np.append(scales, 0.0)
        v = noises[:, None] ** 2 + scales[:, None, None] ** 2 * self.variances
        likely = prior - 0.5 * (np.log(v) + self.squares / v).sum(axis=2)
        best = likely.max(axis=1)
        k = int(best[:-1].argmax())
        odds = float(best[k] - best[-1])
        return odds, LeaningHand(float(noises[int(likely[k].argmax())]), float(scales[k]))


def as_leaning(graph: SketchGraph, lifted: Lifted, stop: Stop) -> Lifted | None:
    """The reading with a lean, begun from the one without; None where the drawing shows none."""
    last = lifted.minimum
    if not can_lean(lifted.problem) or last.cost <= EXACT_COST or not np.isfinite(last.cost):
        return None
    told = None if lifted.focal_assumed else told_focal(lifted.problem)
    x, iterations = last.x, last.iterations
    if lifted.doubtful or not last.converged:
        # Far from all shapes only the one with a lean is a place to look around from.
        full = leaning_problem(lifted.problem, told, _usual_hand(lifted.problem))
        begun = minimise(full, x, max_iterations=MAX_ITERATIONS, enough=1e-3, near=True, stop=stop)
        x, iterations = begun.x, iterations + begun.iterations
    hand = shown_hand(lifted.full, told, x)
    if hand is None:
        return None
    found = _leaned(graph, leaning_problem(lifted.problem, told, hand), x, stop)
    if found is None or _is_too_far(found):
        found = _from_the_lines(graph, lifted, told, stop)
    if found is None or found.above < lifted.above:
        return None
    iterations += found.minimum.iterations
    return replace(
        found,
        minimum=replace(found.minimum, iterations=iterations),
        focal_assumed=lifted.focal_assumed,
    )


def as_leaning_near(
    graph: SketchGraph, structure: Structure, start: Solution, stop: Stop
) -> Lifted | None:
    """The same from a solution that is known; None also where that leads nowhere good."""
    problem = build_problem(graph, structure)
    x = pose_from(start, graph, problem) if can_lean(problem) else None
    if x is None:
        return None
    told = told_focal(problem)
    hand = shown_hand(FullProblem(problem, told), told, x)
    if hand is None:
        return None
    found = _leaned(graph, leaning_problem(problem, told, hand), x, stop)
    return found if found is not None and found.above else None


def _is_too_far(found: Lifted) -> bool:
    """Whether the drawing would have to lean as no hand does."""
    r = found.full.rows_of_vertices(found.minimum.x)[0]
    rms = math.sqrt(float(r @ r) / max(1, len(found.problem.points)))
    return rms > TOO_FAR_RMS * drawn_diagonal(found.problem)


def _from_the_lines(
    graph: SketchGraph, lifted: Lifted, told: FocalPrior | None, stop: Stop
) -> Lifted | None:
    """Begun from what the lines tell: the best shape without a lean is far where they lean much."""
    full = leaning_problem(lifted.problem, told, _usual_hand(lifted.problem))
    first = (initial_pose(lifted.problem, view) for view in views(lifted.problem))
    begun = [
        minimise(full, pose, max_iterations=MAX_ITERATIONS, enough=1e-3, stop=stop)
        for pose in islice(first, N_VIEWS)
        if pose is not None
    ]
    above = [m for m in begun if camera_above_ground(graph, full.problem, m.x)]
    best = min(above or begun, key=lambda m: m.cost, default=None)
    hand = None if best is None else shown_hand(lifted.full, told, best.x)
    if best is None or hand is None:
        return None
    found = _leaned(graph, leaning_problem(lifted.problem, told, hand), best.x, stop)
    return None if found is None or _is_too_far(found) else found


def _leaned(graph: SketchGraph, full: LeaningProblem, x: Pose, stop: Stop) -> Lifted | None:
    minimum = minimise(full, x, max_iterations=MAX_ITERATIONS, enough=ENOUGH, near=True, stop=stop)
    above = camera_above_ground(graph, full.problem, minimum.x)
    found = Lifted(full.problem, full, minimum, above)
    return found if is_settled(found) else None


def can_lean(problem: Problem) -> bool:
    """Whether a lean is looked for at all."""
    return problem.structure.has_axes and not len(problem.circles) and len(problem.points) > 0


def shown_hand(full: FullProblem, told: FocalPrior | None, x: Pose) -> LeaningHand | None:
    """How a drawing that leans was drawn; None where it shows no lean.

    Parameters
    ----------
    full : FullProblem
        Without a lean.
    told : FocalPrior or None
        What the photo's file says.
    x : Pose
        Near the minimum with or without a lean.
    """
    plain = _plain(full, told)
    odds, hand = _evidence(full, told, x).log_odds(_noises(plain))
    r = plain.rows_of_vertices(x)[0]
    far = float(r @ r) > (FAR_RMS * drawn_diagonal(plain.problem)) ** 2 * full.n_vertices
    return hand if odds >= (FAR_ODDS if far else PLAIN_ODDS) else None


def _plain(full: FullProblem, told: FocalPrior | None) -> FullProblem:
    """Without a lean, weighed as hands draw."""
    problem = _as_drawn(full.problem)
    return full.with_prior(told) if problem is full.problem else FullProblem(problem, told)


def _noises(plain: FullProblem) -> Array:
    return np.asarray(NOISES * drawn_diagonal(plain.problem) / math.sqrt(2))


def with_a_possible_lean(lifted: Lifted, sigmas: Array) -> Array:
    """Standard errors of the edges' lengths where a drawing that shows no lean may have one.

    A few lines cannot tell whether a hand leans. Beforehand the usual lean is as likely as none;
    what the drawing says of it decides how much its own standard errors count.

    Parameters
    ----------
    lifted : Lifted
    sigmas : (m,) array
        Without a lean, in parts of the lengths.
    """
    full, last = lifted.full, lifted.minimum
    if isinstance(full, LeaningProblem) or last.cost <= EXACT_COST or not can_lean(lifted.problem):
        return sigmas
    told = None if lifted.focal_assumed else told_focal(lifted.problem)
    plain = _plain(full, told)
    odds, hand = _evidence(full, told, last.x).log_odds(_noises(plain), SCALES[:1])
    likely = 1 / (1 + math.exp(-odds)) if odds > math.log(HARDLY) else 0.0
    if not likely:
        return sigmas
    leaning = standard_errors(leaning_problem(lifted.problem, told, hand), last.x).lengths
    return np.asarray(np.sqrt((1 - likely) * sigmas**2 + likely * leaning**2))


def leaning_problem(problem: Problem, told: FocalPrior | None, hand: LeaningHand) -> LeaningProblem:
    """The full step for what such a hand drew; the usual focal length is expected."""
    prior = None if problem.camera is not None else told or USUAL
    if prior is not None:
        prior = replace(prior, sigma=prior.sigma * DRAWING_SIGMA / hand.noise)
    return LeaningProblem(_as_drawn(problem), prior, hand)


def _usual_hand(problem: Problem) -> LeaningHand:
    return LeaningHand(ENDS_RMS * drawn_diagonal(problem) / math.sqrt(2))


def leaning_reading(graph: SketchGraph, leaning: Lifted, without: Lifted) -> Reading:
    """How well a shape with a lean follows the drawing, to be compared with others.

    Parameters
    ----------
    graph : SketchGraph
    leaning : Lifted
        What `as_leaning` gave.
    without : Lifted
        From what; its weights count.
    """
    assert isinstance(leaning.full, LeaningProblem)
    full = leaning.full.weighed_as(without.problem)
    found = reading_of(graph, replace(leaning, problem=without.problem, full=full))
    return replace(found, n_free=found.n_free + LEAN_FREEDOMS)


def _as_drawn(problem: Problem) -> Problem:
    """With traced vertices weighed against how well imagined ends meet: their lean is no noise."""
    traced = problem.weights > 1.0
    if not bool(traced.any()):
        return problem
    diagonal_px = drawn_diagonal(problem) * problem.px_per_unit
    ratio = max(1.0 + 1e-9, ENDS_RMS * diagonal_px / TRACED_SIGMA_PX)
    return replace(problem, weights=np.where(traced, ratio, 1.0))


def _lean_sigmas() -> Array:
    """(9,) standard deviations of E, row by row."""
    sigmas = np.full((3, 3), LEAN_SIGMA)
    np.fill_diagonal(sigmas, LENGTH_SIGMA)
    return sigmas.ravel()
