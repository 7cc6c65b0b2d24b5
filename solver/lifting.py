"""Which views are tried and which reading is kept: the two optimisations of [Lau10] 4.2.

Terms
-----
reading
    A shape and a camera that a drawing may mean: views lead to them, several often to the same.
float
    See `floating`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import islice

import numpy as np

from .candidates import drawing_rms
from .closer_look import BARELY, SMALL_LOOK_RMS, first_rms
from .diagnosis import focal_sigma
from .full import EXIF_LOG_SIGMA, FocalPrior, FullProblem, Pose
from .graph import SketchGraph
from .initial import LOG_FOCAL_RANGE, Start, lift_linear, miss_of_rays, views
from .least_squares import ENOUGH, EXACT_COST, Minimum, minimise
from .problem import Problem, build_problem
from .solution import Solution
from .starting.floating import depths_along, floats_matter, lifts, same_lift
from .starting.focal_prior import USUAL, spare_observations, tighter, usual_prior
from .starting.near_and_far import near_and_far_exchanged
from .starting.warm_start import pose_from
from .structure import Structure
from .values import Array, Stop
from .world import camera_above_ground, ground_indices, lean

#: Views that are carried on to the full step.
MAX_STARTS = 9
#: After so many views in a row that led to readings known by then, no other one is tried.
AGREEING = 3
#: Iterations to tell promising views from others, views that are finished, iterations for those.
TRIAL_ITERATIONS = 14
TRIAL_ENOUGH = 1e-3
SOME_ITERATIONS = 4
#: What gained no more and still costs so much more than the best is not looked at again.
SETTLED = 1.1
#: From one minimum to that with another prior: gains below this part of the cost are enough.
NEXT_ENOUGH = 1e-7
#: A change of the usual focal length's weight that is none.
SAME_WEIGHT = 1e-3
MAX_FINISHED = 2
MAX_ITERATIONS = 100
#: Along constraints that forbid a move to second order only (right angles at right-angled shapes)
#: steps creep without end; gains below this part of the cost say nothing about the shape.
INSIGNIFICANT = 1e-4
#: A view that in so many more iterations gains less than this part of its distance to the best is
#: not carried on.
REACH = 0.25
#: Views whose lines fit so many times worse than those of one that was finished are not tried
#: (measured: what won never fitted 2.5 times worse).
RIVAL = 3.0
#: A log focal length less certain than this counts as not determined by the sketch.
UNSURE_FOCAL_SIGMA = 0.3
#: Exact drawings in parallel projection are met so well by vertex, image units squared, from as far
#: as can be.
PARALLEL_COST = 1e-10
#: So near to a reading that was found, in parts of the size, all ways lead to it.
SAME_SHAPE = 2e-3
#: Views so near to each other (cosine of the axes, log focal length) lead to the same reading: of
#: 279 that began as near to another one, all did.
SAME_AXES, SAME_FOCAL = 0.9986, 0.3
#: Pulls to equal depths, and how many times the miss of the rays outweighs it.
PULLS = (1e-3, 1e-2, 1e-1, 1.0)
OUTWEIGHS = 3.0
#: Readings whose misfits differ by less than this factor fit about equally well.
CLOSE_CALL = 1.5
#: Things that stand lean over by so much (standard deviation), in parts of their height.
USUAL_LEAN = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Lifted:
    """A reading after the full step.

    Parameters
    ----------
    problem : Problem
    full : FullProblem
    minimum : Minimum of Pose
    above : bool
        Whether the camera is above the ground.
    focal_assumed : bool
        Whether the focal length is a usual one, the drawing not telling it.
    doubtful : bool
        Whether only a first look was taken, since it missed the drawing by far.
    twofold : bool
        Whether another reading fits as well.
    as_guessed : bool
        Whether edges drawn along three directions are square though nobody said so.
    drawn : Lifted or None
        What is drawn, where sizes made another shape of it: it tells how sure all this is.
    told : bool
        Whether the drawing tells it so well that no other view was looked at.
    """

    problem: Problem
    full: FullProblem
    minimum: Minimum[Pose]
    above: bool
    focal_assumed: bool = False
    doubtful: bool = False
    twofold: bool = False
    as_guessed: bool = False
    drawn: Lifted | None = None
    told: bool = False


def lift(
    graph: SketchGraph,
    structure: Structure,
    stop: Stop | None,
    *,
    doubt_rms: float = math.inf,
) -> Lifted | None:
    """Both steps; where the drawing does not tell the focal length, a usual one is assumed.

    It ends where the first view misses the drawing by more than may be doubted (RMS, parts of its
    diagonal), and says that it is doubtful.
    """
    problem = build_problem(graph, structure)
    known = problem.log_focal_prior
    best = _best(graph, problem, told_focal(problem), stop, doubt_rms=doubt_rms)
    if known is not None or (best is not None and best.doubtful):
        return best
    if best is None or (not best.told and is_unsure_of_focal(best.full, best.minimum.x)):
        usual = replace(problem, log_focal_prior=USUAL.log_focal)
        assumed = _best(graph, usual, USUAL, stop)
        if assumed is None or (best is not None and _shows_no_perspective(best)):
            return best
        # From there the drawing may well tell it.
        free = _go_on(graph, assumed, problem, None, stop)
        if _is_exact(free) and not is_unsure_of_focal(free.full, free.minimum.x):
            return free
        return replace(_as_expected(graph, assumed, USUAL, stop), focal_assumed=True)
    return _as_expected(graph, best, None, stop)


def lift_near(
    graph: SketchGraph, structure: Structure, start: Solution, stop: Stop | None
) -> Lifted | None:
    """The full step alone, from a solution that is known; None where that leads nowhere good."""
    problem = build_problem(graph, structure)
    pose = pose_from(start, graph, problem)
    if pose is None:
        return None
    full = FullProblem(problem, told_focal(problem))
    enough = NEXT_ENOUGH if problem.log_focal_prior is None else ENOUGH
    minimum = minimise(full, pose, max_iterations=MAX_ITERATIONS, enough=enough, stop=stop)
    above = camera_above_ground(graph, problem, minimum.x)
    near = Lifted(problem, full, minimum, above)
    if not above or not minimum.converged:
        return None
    return with_usual_focal(graph, near, stop)


def with_usual_focal(graph: SketchGraph, found: Lifted, stop: Stop | None) -> Lifted:
    """With what is expected of a focal length that nobody told, as far as the drawing leaves it."""
    if found.problem.log_focal_prior is not None:
        return found
    unsure = is_unsure_of_focal(found.full, found.minimum.x)
    expected = _as_expected(graph, found, USUAL if unsure else None, stop)
    return replace(expected, focal_assumed=unsure)


def _shows_no_perspective(lifted: Lifted) -> bool:
    """Whether a drawing is met from as far as can be, and far better than a hand draws."""
    at_limit = lifted.minimum.x.log_focal > LOG_FOCAL_RANGE[1] - 0.1
    return (
        lifted.above
        and at_limit
        and lifted.minimum.cost < PARALLEL_COST * len(lifted.problem.points)
    )


def told_focal(problem: Problem) -> FocalPrior | None:
    """The focal length that the photo's file tells; a known camera's is no unknown."""
    known = problem.log_focal_prior
    if known is None or problem.camera is not None:
        return None
    return FocalPrior(known, EXIF_LOG_SIGMA)


def _as_expected(
    graph: SketchGraph, lifted: Lifted, least: FocalPrior | None, stop: Stop | None
) -> Lifted:
    """With the usual focal length weighed by the misfit, which changes with it: at each step."""
    problem = replace(lifted.problem, log_focal_prior=None)
    full, last = lifted.full.with_prior(None), lifted.minimum
    spare = spare_observations(full, last.x)
    prior: FocalPrior | None = None
    iterations = last.iterations
    for _ in range(MAX_ITERATIONS):
        before, prior = prior, tighter(usual_prior(full, last.x, spare), least)
        if prior is None:
            break
        same = before is not None and abs(prior.sigma - before.sigma) < SAME_WEIGHT * before.sigma
        if same and last.converged:
            break
        full = full.with_prior(prior)
        cost, damping = last.cost, last.damping
        last = minimise(
            full,
            last.x,
            max_iterations=1,
            enough=NEXT_ENOUGH,
            near=True,
            damping=last.damping,
            gained=last.gain,
            stop=stop,
        )
        iterations += last.iterations
        # A step that was taken, not one that was refused.
        taken = last.damping <= damping
        if same and taken and abs(last.cost - cost) <= NEXT_ENOUGH * cost:
            last = replace(last, converged=True)
        if not last.iterations:
            break
    if prior is None and full.prior is None:
        return lifted
    minimum = replace(last, iterations=iterations)
    return Lifted(problem, full, minimum, camera_above_ground(graph, problem, minimum.x))


def _go_on(
    graph: SketchGraph,
    lifted: Lifted,
    problem: Problem,
    prior: FocalPrior | None,
    stop: Stop | None,
) -> Lifted:
    """From a minimum to that with another prior."""
    full = lifted.full.with_prior(prior)
    x = lifted.minimum.x
    minimum = minimise(
        full, x, max_iterations=MAX_ITERATIONS, enough=NEXT_ENOUGH, near=True, stop=stop
    )
    minimum = replace(minimum, iterations=lifted.minimum.iterations + minimum.iterations)
    return Lifted(problem, full, minimum, camera_above_ground(graph, problem, minimum.x))


def is_unsure_of_focal(full: FullProblem, pose: Pose) -> bool:
    """Whether the drawing does not tell the focal length."""
    return focal_sigma(full, pose) > UNSURE_FOCAL_SIGMA


def _best(
    graph: SketchGraph,
    problem: Problem,
    prior: FocalPrior | None,
    stop: Stop | None,
    *,
    doubt_rms: float = math.inf,
) -> Lifted | None:
    """The reading seen from above that fits the drawing best.

    All views are carried on for a few iterations, the most promising ones to the end.
    """
    full = FullProblem(problem, prior)
    known: list[Array] = []
    known_from: list[Pose] = []
    # Without a focal length it goes on with the usual one.
    enough = NEXT_ENOUGH if problem.log_focal_prior is None else ENOUGH

    def been(x: Pose) -> bool:
        shape = full.shape(x)
        return any(float(np.abs(shape - other).max()) < SAME_SHAPE for other in known)

    def begin(pose: Pose) -> Minimum[Pose]:
        some = TRIAL_ITERATIONS if full.constrained else SOME_ITERATIONS
        return minimise(full, pose, max_iterations=some, enough=TRIAL_ENOUGH, stop=stop, been=been)

    def carry_on(last: Minimum[Pose], enough: float) -> Minimum[Pose]:
        return minimise(
            full,
            last.x,
            max_iterations=SOME_ITERATIONS,
            enough=enough,
            near=True,
            damping=last.damping,
            gained=last.gain,
            stop=stop,
        )

    def seen(minimum: Minimum[Pose]) -> Lifted:
        return Lifted(problem, full, minimum, camera_above_ground(graph, problem, minimum.x))

    tried: list[Lifted] = []
    tolerated, least = np.inf, np.inf
    for view in islice(views(problem), MAX_STARTS):
        new = view.misfit <= tolerated and not _leads_to_one_of(problem, view, known_from)
        pose = initial_pose(problem, view) if new else None
        for begun in () if pose is None else _with_floats(problem, pose, stop):
            pursuit = _Pursuit(carry_on, TRIAL_ENOUGH, TRIAL_ITERATIONS, least)
            tried.append(seen(pursuit.of(begin(begun))))
            if tried[-1].minimum.converged:
                known.append(full.shape(tried[-1].minimum.x))
                known_from.append(tried[-1].minimum.x)
            if tried[-1].minimum.converged or tried[-1].minimum.cost == np.inf:
                # What begins there ends there, too.
                known_from.append(begun)
            if tried[-1].above and tried[-1].minimum.converged:
                tolerated = min(tolerated, RIVAL * view.misfit + 1e-20)
                least = min(least, tried[-1].minimum.cost)
            if _is_exact(tried[-1]):
                break
        if len(tried) == 1 and _is_told(graph, tried[0]):
            tried = [replace(tried[0], told=True)]
            break
        if doubt_rms < math.inf and tried:
            if all(first_rms(t) > doubt_rms for t in tried):
                return replace(_preferred(graph, tried)[0], doubtful=True)
            doubt_rms = math.inf
        if tried and (_is_exact(tried[-1]) or (stop is not None and stop())):
            break
        if len(tried) > AGREEING and all(t.minimum.cost == np.inf for t in tried[-AGREEING:]):
            break
    if ground_indices(graph) and not any(t.above for t in tried):
        # Of few directions the lines may agree with the view from below alone.
        for below in [t.minimum.x for t in tried if t.minimum.cost < np.inf]:
            tried.append(seen(begin(near_and_far_exchanged(full, below))))
    finished: list[Lifted] = []
    promising = _promising(graph, tried)
    goes_on = len(promising) == 1 and _goes_on(promising[0])
    for t in promising:
        least = min((f.minimum.cost for f in finished), default=np.inf)
        settled = goes_on or (t.minimum.converged and t.minimum.cost > SETTLED * least)
        pursuit = _Pursuit(carry_on, enough, MAX_ITERATIONS, least)
        finished.append(t if settled else seen(pursuit.of(_open(t.minimum))))
    for pose in _with_floats_moved(problem, finished, stop):
        least = min(f.minimum.cost for f in finished)
        finished.append(seen(_Pursuit(carry_on, enough, MAX_ITERATIONS, least).of(begin(pose))))
    return _preferred(graph, finished)[0] if finished else None


def _is_told(graph: SketchGraph, t: Lifted) -> bool:
    """Whether no other view need be looked at.

    The first reading, from above, meets the drawing better than hands draw, with enough left over
    to check it and to tell the focal length: of 1,100 such readings none was beaten by another.
    """
    x, full, problem = t.minimum.x, t.full, t.problem
    if not (t.above and t.minimum.converged and ground_indices(graph)):
        return False
    if problem.log_focal_prior is not None or not problem.structure.has_axes:
        return False
    if floats_matter(problem) or drawing_rms(t) > SMALL_LOOK_RMS:
        return False
    enough = spare_observations(full, x) >= BARELY * 2 * full.n_vertices
    return enough and not is_unsure_of_focal(full, x)


def _leads_to_one_of(problem: Problem, view: Start, found: list[Pose]) -> bool:
    """Whether a view is so near to that of a reading that was found that it leads there."""
    if not problem.structure.has_axes or floats_matter(problem):
        return False
    return any(
        abs(view.log_focal - x.log_focal) < SAME_FOCAL
        and float(np.abs(np.einsum("ik,ik->k", view.R, x.R)).min()) > SAME_AXES
        for x in found
    )


def _goes_on(only: Lifted) -> bool:
    """Whether the only reading is weighed against the usual focal length next, and ends there."""
    full, minimum = only.full, only.minimum
    weighed = full.prior is None and full.problem.log_focal_prior is None
    return weighed and minimum.converged and minimum.cost > EXACT_COST


def _with_floats(problem: Problem, pose: Pose, stop: Stop | None) -> list[Pose]:
    return [replace(pose, g=g) for g in lifts(problem, pose.R, pose.g, stop)]


def _with_floats_moved(
    problem: Problem, finished: list[Lifted], stop: Stop | None
) -> Iterator[Pose]:
    """With a good camera, other depths of parts that float may meet the annotations as well."""
    if not finished or not floats_matter(problem) or any(map(_is_exact, finished)):
        return
    best = min(finished, key=lambda t: t.minimum.cost).minimum
    x = best.x
    begun = initial_pose(problem, Start(x.R, x.log_focal, best.cost))
    if begun is None:
        return
    g = begun.g
    for other in lifts(problem, x.R, g, stop):
        if not same_lift(other, x.g):
            yield replace(x, g=other)
    along = depths_along(problem, x.R, g)
    for end in (0, -1):
        while along:
            yield replace(x, g=along.pop(end))
            if finished[-1].minimum.cost == np.inf:
                # It leads to a known reading, and so does what lies between.
                break


def _open(minimum: Minimum[Pose]) -> Minimum[Pose]:
    """Converged roughly is not converged."""
    return replace(minimum, converged=minimum.cost <= EXACT_COST)


@dataclass(frozen=True, slots=True)
class _Pursuit:
    """Going on, as long as the least cost known so far seems within reach."""

    carry_on: Callable[[Minimum[Pose], float], Minimum[Pose]]
    enough: float
    max_iterations: int
    least: float

    def of(self, last: Minimum[Pose]) -> Minimum[Pose]:
        used = last.iterations
        while used < self.max_iterations and not last.converged and last.cost < np.inf:
            before = last.cost
            last = self.carry_on(last, self.enough)
            used += last.iterations
            # A stop, and a damping beyond use, end it as well.
            stuck = last.iterations < SOME_ITERATIONS
            beyond = self.least < last.cost
            gain = before - last.cost
            if used >= self.max_iterations and 0 <= gain < INSIGNIFICANT * last.cost:
                last = replace(last, converged=True)
            if stuck or (beyond and gain < REACH * (last.cost - self.least)):
                break
        return replace(last, iterations=used)


def _promising(graph: SketchGraph, tried: list[Lifted]) -> list[Lifted]:
    """The best few, each minimum once."""
    kept: list[Lifted] = []
    for t in _preferred(graph, [t for t in tried if np.isfinite(t.minimum.cost)]):
        cost = t.minimum.cost
        if not any(abs(k.minimum.cost - cost) <= 1e-4 * cost for k in kept):
            kept.append(t)
    return kept[:MAX_FINISHED]


def _preferred(graph: SketchGraph, found: list[Lifted]) -> list[Lifted]:
    """Best first: with a ground, what is seen from above; else a close call only goes by that."""
    if len(found) < 2:
        return found
    least = min((c.minimum.cost for c in found), default=0.0)
    has_ground = bool(ground_indices(graph))

    def badness(c: Lifted) -> tuple[bool, bool, float]:
        far_off = not has_ground and c.minimum.cost > CLOSE_CALL * least + 1e-20
        return (far_off, not c.above, _surprise(graph, c))

    return sorted(found, key=badness)


def _surprise(graph: SketchGraph, c: Lifted) -> float:
    """Minus twice the log likelihood: of the drawing, its noise unknown, and of the lean."""
    spare = spare_numbers(c.full)
    leaning = min(lean(graph, c.problem, c.minimum.x) / USUAL_LEAN, 1e3)
    return spare * float(np.log(c.minimum.cost + 1e-24)) + leaning**2


def spare_numbers(full: FullProblem) -> int:
    """How many drawn numbers there are beyond those that a reading needs."""
    return max(1, 2 * full.n_vertices - full.m - 3)


def _is_exact(lifted: Lifted) -> bool:
    """Whether the drawing is met to the last digits, from above: no other reading can be better."""
    return lifted.above and lifted.minimum.converged and lifted.minimum.cost < 1e-20


def initial_pose(problem: Problem, start: Start) -> Pose | None:
    """The linear lift, with a stronger pull to equal depths where it came out of proportion."""
    for pull in PULLS:
        g = lift_linear(problem, start.R, start.log_focal, pull)
        if _is_in_proportion(problem, start, g, pull):
            return Pose(start.R, start.log_focal, g)
    return None


def _is_in_proportion(problem: Problem, start: Start, g: Array, pull: float) -> bool:
    """Whether all vertices lie before the eye, and no part has shrunk beside one that floats.

    A part of which the drawing misses its rays misses them by less where it is small: only a pull
    that weighs more than the miss keeps its depth beside that of others.
    """
    depth = g[problem.structure.coordinate] @ start.R[2]
    if not np.isfinite(g).all() or float(depth.min()) <= 1e-3 * float(np.abs(depth).mean()):
        return False
    if not floats_matter(problem):
        return True
    return pull >= OUTWEIGHS * miss_of_rays(problem, start.R, start.log_focal, g)
