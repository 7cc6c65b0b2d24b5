"""Shapes after the full step, how well they follow the drawing, and whether they hold.

Terms
-----
candidate
    A shape after the full step, whatever it is called there.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from .diagnosis import KnownShape, Reading, pose_near, spring_stiffness
from .full import FullProblem, Pose
from .geometry import diagonal
from .graph import SketchGraph
from .least_squares import Minimum, minimise
from .problem import Problem, build_problem
from .structure import build_structure
from .values import Stop
from .world import camera_above_ground, ground_indices, is_upright, nothing_sinks

#: Iterations from a shape that is known already.
NEAR_ITERATIONS = 40
#: Constraints whose residuals (radians, parts of a length) are below this hold.
HELD = 1e-8
#: Parts so many times nearer or farther than the rest have flown off.
FLOWN = 20.0
#: Beyond these it is a tangle, no sketch: free coordinates, and numbers in their conditions' table.
MAX_COORDINATES = 900
MAX_NUMBERS = 500_000


class Candidate(Protocol):
    """A shape after the full step."""

    @property
    def problem(self) -> Problem: ...
    @property
    def full(self) -> FullProblem: ...
    @property
    def minimum(self) -> Minimum[Pose]: ...
    @property
    def above(self) -> bool: ...


@dataclass(frozen=True, slots=True, eq=False)
class Near:
    """A shape after the full step, begun from one that was known, or just as it was guessed."""

    problem: Problem
    full: FullProblem
    minimum: Minimum[Pose]
    above: bool
    as_guessed: bool = False


def reading_of(graph: SketchGraph, lifted: Candidate) -> Reading:
    """How well a shape follows the drawing, and with how many freedoms."""
    full, x = lifted.full, lifted.minimum.x
    observed = 2 * full.n_vertices + full.problem.circles.supports.size
    _, H = full.constraints(x)
    held = int(np.linalg.matrix_rank(H, tol=1e-7)) if H.size else 0
    idle = full.idle_directions(x)
    turning = int(np.linalg.matrix_rank(idle)) if len(idle) else 0
    # What does not hold counts as a spring that is drawn.
    misfit = full.with_prior(None).merit(x, spring_stiffness(full.problem))
    return Reading(
        misfit=misfit / drawn_diagonal(full.problem) ** 2,
        n_observed=observed,
        n_free=4 + full.m - 1 - turning - held,
        plausible=(lifted.above or not ground_indices(graph))
        and (lifted.minimum.converged or is_held(lifted))
        and nothing_sinks(graph, full.problem, x)
        and is_upright(graph, full.problem, x),
        converged=is_settled(lifted),
    )


def drawing_rms(lifted: Candidate) -> float:
    """How far a shape stays from the drawing, RMS in parts of its diagonal.

    All vertices count alike: what is traced weighs more in the solve, but is no farther off.
    """
    full = lifted.full
    n = 2 * full.n_vertices + full.problem.circles.supports.size
    if bool((full.problem.weights != 1.0).any()):
        alike = np.ones(len(full.problem.weights))
        full = FullProblem(replace(full.problem, weights=alike), None)
    misfit = full.with_prior(None).merit(lifted.minimum.x, spring_stiffness(full.problem))
    return math.sqrt(2 * misfit / max(1, n)) / drawn_diagonal(full.problem)


def drawn_diagonal(problem: Problem) -> float:
    """The drawing's diagonal, image units."""
    drawn = problem.points
    if len(problem.circles):
        centres, semi = problem.circles.centres[:, None], problem.circles.semi_axes
        drawn = np.vstack([drawn, (centres + semi).reshape(-1, 2), (centres - semi).reshape(-1, 2)])
    return max(diagonal(drawn), 1e-6)


def lift_near(graph: SketchGraph, near: KnownShape, stop: Stop) -> Near | None:
    """The full step alone, begun from a shape that is known already."""
    structure = build_structure(graph)
    if structure.contradiction or structure.n_coordinates > MAX_COORDINATES:
        return None
    problem = build_problem(graph, structure)
    full = FullProblem(problem, None)
    start = pose_near(problem, near)
    minimum = minimise(full, start, max_iterations=NEAR_ITERATIONS, enough=1e-6, stop=stop)
    if not np.isfinite(minimum.cost):
        return None
    return Near(problem, full, minimum, camera_above_ground(graph, problem, minimum.x))


def is_settled(lifted: Candidate) -> bool:
    """Whether the full step came to its end, with all annotations held and no part flown off."""
    return lifted.minimum.converged and is_held(lifted)


def is_held(lifted: Candidate) -> bool:
    """Whether all annotations hold and no part flew off, be it the best such shape or not."""
    h, _ = lifted.full.constraints(lifted.minimum.x)
    return float(np.abs(h).max(initial=0.0)) < HELD and _is_together(lifted)


def _is_together(lifted: Candidate) -> bool:
    """Whether all of it is about as far away: parts that hardly hang on fly to the eye."""
    x = lifted.minimum.x
    depth = lifted.full.positions(x) @ x.R[2]
    usual = float(np.median(depth)) if len(depth) else 1.0
    return bool((depth > usual / FLOWN).all() and (depth < usual * FLOWN).all())
