"""The Modified Lipson solve ([Lau10] 4.2), in the order of the paper.

1. the annotations reduce the unknowns (structure);
2. an initial step finds an approximate shape and camera (initial);
3. the full step follows the drawing as well as the annotations allow (full);
4. the shape is put on the ground and given its size (world);
5. what is left open or disagrees is told (diagnosis).
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from .blaming import (
    MAX_COORDINATES,
    MAX_NUMBERS,
    Blame,
    Stop,
    blame_for_clash,
    find_blame,
    is_doubtful,
    needs_a_closer_look,
    reading_of,
)
from .circles import flat_circles
from .diagnosis import (
    Freedoms,
    Reading,
    focal_sigma,
    freedoms,
    size_of,
    unmet_annotations,
    without,
)
from .errors import SketchError
from .faces import find_faces
from .full import EXIF_LOG_SIGMA, FocalPrior, FullProblem, Pose
from .graph import SketchGraph
from .initial import USUAL_LOG_FOCAL, Start, lift_linear, starts
from .least_squares import ENOUGH, EXACT_COST, Minimum, minimise
from .placed import put_in_world
from .problem import Problem, build_problem
from .residuals import annotation_residuals
from .revolution import without_profiles
from .solution import Report, Solution, Status
from .structure import Structure, build_structure
from .symmetry import Geometry, mirrored
from .values import Array
from .world import (
    camera_above_ground,
    ground_indices,
)

#: Views that are carried on to the full step.
MAX_STARTS = 9
#: Iterations to tell promising views from others, views that are finished, iterations for those.
TRIAL_ITERATIONS = 14
TRIAL_ENOUGH = 1e-3
SOME_ITERATIONS = 4
#: What gained no more and still costs so much more than the best is not looked at again.
SETTLED = 1.1
MAX_FINISHED = 2
MAX_ITERATIONS = 100


#: A view that in so many more iterations gains less than this part of its distance to the best is
#: not carried on.
REACH = 0.25
#: Views whose lines fit so many times worse than those of one that was finished are not tried
#: (measured: what won never fitted 2.5 times worse).
RIVAL = 4.0
#: A log focal length less certain than this counts as not determined by the sketch.
UNSURE_FOCAL_SIGMA = 0.3
USUAL_FOCAL_SIGMA = 0.3
#: Readings whose misfits differ by less than this factor fit about equally well.
CLOSE_CALL = 1.5
#: A solve ends after so many seconds.
MAX_SOLVE_S = 3.0
#: A drawing further than this from every shape (image units, RMS) was not understood.
LOST_MISFIT = 0.25


@dataclass(frozen=True, slots=True, eq=False)
class _Lifted:
    """A candidate after the full step."""

    problem: Problem
    full: FullProblem
    minimum: Minimum[Pose]
    above: bool
    focal_assumed: bool = False
    doubtful: bool = False


def solve(graph: SketchGraph, *, stop: Stop | None = None) -> Solution:
    """Lift a sketch graph to 3D and find the camera.

    Parameters
    ----------
    graph : SketchGraph
    stop : callable, optional
        Asked now and then; True ends the solve with what there is (status ``not_converged``).

    Returns
    -------
    Solution
        Always; how it went is told by its status and message.
    """
    began = time.perf_counter()
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        try:
            solution = _solve(graph, stop)
        except np.linalg.LinAlgError:
            solution = _lost(graph)
    if not solution.is_bounded:
        solution = _lost(graph)
    elapsed = (time.perf_counter() - began) * 1e3
    return replace(solution, report=replace(solution.report, solve_ms=elapsed))


def _solve(graph: SketchGraph, stop: Stop | None) -> Solution:
    nothing = _nothing_to_lift(graph)
    if nothing is not None:
        return Solution(graph.digest, Status.UNDERDETERMINED, nothing)
    core = without_profiles(graph)
    structure = build_structure(core)
    stop = _with_deadline(stop)
    if structure.contradiction:
        return _without_culprit(graph, core, stop)
    if structure.n_coordinates > MAX_COORDINATES:
        return _too_free(graph, f"{structure.n_coordinates} coordinates are free")
    conditions = sum(len(block.items) for block in build_problem(core, structure).blocks)
    if conditions * structure.n_coordinates > MAX_NUMBERS:
        n = structure.n_coordinates
        return _too_free(graph, f"{conditions} conditions on {n} coordinates are left")
    lifted, blamed = _lift_or_blame(core, structure, stop)
    if lifted is None:
        return _lost(graph)
    return _describe(graph, core, lifted, blamed)


def _too_free(graph: SketchGraph, what: str) -> Solution:
    message = f"{what}, too many to solve for: mark right angles and parallels."
    return Solution(graph.digest, Status.UNDERDETERMINED, message)


def _lost(graph: SketchGraph) -> Solution:
    """Wild drawings end without a shape, or with one whose numbers overflow."""
    return Solution(
        graph.digest,
        Status.NOT_CONVERGED,
        "No 3D shape fits this drawing; check the annotations against it.",
    )


def _with_deadline(stop: Stop | None) -> Stop:
    """Stop when asked to, or when the solve takes too long."""
    deadline = time.perf_counter() + MAX_SOLVE_S
    return lambda: time.perf_counter() > deadline or (stop is not None and stop())


def _nothing_to_lift(graph: SketchGraph) -> str | None:
    if not graph.edges and not graph.circles:
        return "The sketch has no edges: draw the object's edges over the photo."
    if flat := flat_circles(graph):
        return f"{_and(flat)} drawn without width or height: pull the ellipse open."
    if graph.circles:
        return None
    pixels = np.array(list(graph.vertices.values()))
    spread = np.linalg.svd(pixels - pixels.mean(axis=0), compute_uv=False)
    if len(pixels) < 3 or spread[1] <= 1e-6 * max(float(spread[0]), 1e-300):
        return "All vertices lie on one line: draw edges in at least two directions."
    return None


def _without_culprit(graph: SketchGraph, core: SketchGraph, stop: Stop) -> Solution:
    """What follows from annotations that cannot all hold: the shape without the culprit."""
    kept: dict[str, _Lifted] = {}

    def attempt(id_: str) -> Reading | None:
        lifted = _lift_without(core, id_, stop)
        if lifted is None or lifted.doubtful:
            return None
        kept[id_] = lifted
        return reading_of(without(core, id_), lifted)

    blamed = blame_for_clash(core, attempt)
    first = blamed.ids[0]
    lifted = kept.get(first) or _lift_without(core, first, stop)
    if lifted is None or lifted.doubtful:
        report = Report(conflicts=blamed.ids)
        return Solution(graph.digest, Status.CONFLICTING, blamed.message, report=report)
    return _describe(graph, core, lifted, blamed)


def _lift_without(core: SketchGraph, id_: str, stop: Stop) -> _Lifted | None:
    rest = without(core, id_)
    structure = build_structure(rest)
    if structure.contradiction or structure.n_coordinates > MAX_COORDINATES:
        return None
    return _lift(rest, structure, stop, wary=True)


def _lift_or_blame(
    core: SketchGraph, structure: Structure, stop: Stop
) -> tuple[_Lifted | None, Blame | None]:
    """The shape, or where an annotation contradicts the drawing grossly the shape without it."""
    lifted = _lift(core, structure, stop, wary=True)
    if lifted is None or not (lifted.doubtful or needs_a_closer_look(core, lifted)):
        return lifted, None
    blamed = None
    for lost in (False, True)[lifted.doubtful :]:
        blamed = blamed or find_blame(core, structure, lifted, stop, lost=lost)
    other = None
    if blamed is not None and not blamed.held:
        other = _lift_without(core, blamed.ids[0], stop)
    if other is not None and not other.doubtful:
        return other, blamed
    # What was found at first sight only is finished.
    return (_lift(core, structure, stop) if lifted.doubtful else lifted), blamed


def _lift(
    graph: SketchGraph, structure: Structure, stop: Stop | None, *, wary: bool = False
) -> _Lifted | None:
    """Both steps; where the drawing does not tell the focal length, a usual one is assumed.

    A wary one ends where the first view misses the drawing by far, and says that it is doubtful.
    """
    problem = build_problem(graph, structure)
    known = problem.log_focal_prior
    is_prior = known is not None and problem.camera is None
    prior = FocalPrior(known, EXIF_LOG_SIGMA) if known is not None and is_prior else None
    best = _best(graph, problem, prior, stop, wary=wary)
    if best is not None and best.doubtful:
        return best
    if known is None and (best is None or is_unsure_of_focal(best.full, best.minimum.x)):
        usual = replace(problem, log_focal_prior=USUAL_LOG_FOCAL)
        assumed = _best(graph, usual, FocalPrior(USUAL_LOG_FOCAL, USUAL_FOCAL_SIGMA), stop)
        best = replace(assumed, focal_assumed=True) if assumed is not None else best
    return best


def is_unsure_of_focal(full: FullProblem, pose: Pose) -> bool:
    """Whether the drawing does not tell the focal length."""
    return focal_sigma(full, pose) > UNSURE_FOCAL_SIGMA


def _best(
    graph: SketchGraph,
    problem: Problem,
    prior: FocalPrior | None,
    stop: Stop | None,
    *,
    wary: bool = False,
) -> _Lifted | None:
    """The reading seen from above that fits the drawing best.

    All views are carried on for a few iterations, the most promising ones to the end.
    """
    full = FullProblem(problem, prior)

    def begin(pose: Pose) -> _Lifted:
        some = TRIAL_ITERATIONS if full.constrained else SOME_ITERATIONS
        minimum = minimise(full, pose, max_iterations=some, enough=TRIAL_ENOUGH, stop=stop)
        above = camera_above_ground(graph, problem, minimum.x)
        return _Lifted(problem, full, minimum, above)

    def carry_on(last: Minimum[Pose], enough: float) -> _Lifted:
        minimum = minimise(
            full,
            last.x,
            max_iterations=SOME_ITERATIONS,
            enough=enough,
            near=True,
            damping=last.damping,
            stop=stop,
        )
        above = camera_above_ground(graph, problem, minimum.x)
        return _Lifted(problem, full, minimum, above)

    tried: list[_Lifted] = []
    tolerated, least = np.inf, np.inf
    for view in starts(problem)[:MAX_STARTS]:
        pose = _initial_pose(problem, view) if view.misfit <= tolerated else None
        if pose is None:
            continue
        pursuit = _Pursuit(carry_on, TRIAL_ENOUGH, TRIAL_ITERATIONS, least)
        tried.append(pursuit.of(begin(pose)))
        if _is_exact(tried[-1]):
            break
        if wary and len(tried) == 1 and is_doubtful(graph, tried[0]):
            return replace(tried[0], doubtful=True)
        if tried[-1].above and tried[-1].minimum.converged:
            tolerated = min(tolerated, RIVAL * view.misfit + 1e-20)
            least = min(least, tried[-1].minimum.cost)
    finished: list[_Lifted] = []
    for t in _promising(graph, tried):
        least = min((f.minimum.cost for f in finished), default=np.inf)
        settled = t.minimum.converged and t.minimum.cost > SETTLED * least
        pursuit = _Pursuit(carry_on, ENOUGH, MAX_ITERATIONS, least)
        finished.append(t if settled else pursuit.of(replace(t, minimum=_open(t.minimum))))
    return _preferred(graph, finished)[0] if finished else None


def _open(minimum: Minimum[Pose]) -> Minimum[Pose]:
    """Converged roughly is not converged."""
    return replace(minimum, converged=minimum.cost <= EXACT_COST)


@dataclass(frozen=True, slots=True)
class _Pursuit:
    """Going on, as long as the least cost known so far seems within reach."""

    carry_on: Callable[[Minimum[Pose], float], _Lifted]
    enough: float
    max_iterations: int
    least: float

    def of(self, t: _Lifted) -> _Lifted:
        used = t.minimum.iterations
        while used < self.max_iterations and not t.minimum.converged:
            before = t.minimum.cost
            t = self.carry_on(t.minimum, self.enough)
            used += t.minimum.iterations
            # A stop, and a damping beyond use, end it as well.
            stuck = t.minimum.iterations < SOME_ITERATIONS
            beyond = self.least < t.minimum.cost
            gain = before - t.minimum.cost
            if stuck or (beyond and gain < REACH * (t.minimum.cost - self.least)):
                break
        return replace(t, minimum=replace(t.minimum, iterations=used))


def _promising(graph: SketchGraph, tried: list[_Lifted]) -> list[_Lifted]:
    """The best few, each minimum once."""
    kept: list[_Lifted] = []
    for t in _preferred(graph, [t for t in tried if np.isfinite(t.minimum.cost)]):
        cost = t.minimum.cost
        if not any(abs(k.minimum.cost - cost) <= 1e-4 * cost for k in kept):
            kept.append(t)
    return kept[:MAX_FINISHED]


def _preferred(graph: SketchGraph, found: list[_Lifted]) -> list[_Lifted]:
    """Best first: with a ground, what is seen from above; else a close call only goes by that."""
    least = min((c.minimum.cost for c in found), default=0.0)
    has_ground = bool(ground_indices(graph))

    def badness(c: _Lifted) -> tuple[bool, bool, float]:
        far_off = not has_ground and c.minimum.cost > CLOSE_CALL * least + 1e-20
        return (far_off, not c.above, c.minimum.cost)

    return sorted(found, key=badness)


def _is_exact(lifted: _Lifted) -> bool:
    """Whether the drawing is met to the last digits, from above: no other reading can be better."""
    return lifted.above and lifted.minimum.converged and lifted.minimum.cost < 1e-20


def _initial_pose(problem: Problem, start: Start) -> Pose | None:
    """The linear lift, with a stronger pull to equal depths where vertices fell behind the eye."""
    for pull in (1e-3, 1e-2, 1e-1, 1.0):
        g = lift_linear(problem, start.R, start.log_focal, pull)
        depth = g[problem.structure.coordinate] @ start.R[2]
        if bool(np.isfinite(g).all()) and float(depth.min()) > 1e-3 * float(np.abs(depth).mean()):
            return Pose(start.R, start.log_focal, g)
    return None


def _describe(
    graph: SketchGraph, core: SketchGraph, lifted: _Lifted, blamed: Blame | None = None
) -> Solution:
    pose = lifted.minimum.x
    placed = put_in_world(graph, core, lifted.problem, pose)
    vertices, circles = placed.vertices, placed.circles
    geometry, on_faces = _with_copies(graph, vertices)
    residuals = annotation_residuals(graph, vertices, geometry.faces, circles)
    open_ = freedoms(lifted.full, pose, [*core.vertices, *core.circles])
    extent = np.array([*vertices.values(), *(c.center_mm for c in circles.values())])
    conflicts = unmet_annotations(residuals, size_of(extent.reshape(-1, 3)))
    status, message = _verdict(lifted, open_, conflicts)
    if blamed is not None:
        conflicts, message = blamed.ids, blamed.message
        status = status if blamed.held else Status.CONFLICTING
    return Solution(
        graph.digest,
        status,
        message + on_faces,
        geometry.vertices,
        geometry.edges,
        geometry.faces,
        circles,
        placed.camera,
        placed.scale_assumed,
        Report(
            degrees_of_freedom=open_.count,
            loose=open_.loose,
            residuals=residuals,
            reprojection_px=placed.reprojection_px(graph),
            conflicts=conflicts,
            iterations=lifted.minimum.iterations,
        ),
    )


def _with_copies(graph: SketchGraph, vertices: Mapping[str, Array]) -> tuple[Geometry, str]:
    """The geometry with its mirrored copies and its faces, and what to say of them."""
    whole, left_out = mirrored(graph, Geometry(vertices, graph.edges, graph.faces or {}))
    if left_out:
        some = ", ".join(left_out[:4])
        return whole, f" Too many copies ({some} and so on): take some symmetry planes away."
    if graph.faces is not None:
        return whole, ""
    traced = set(graph.construction)
    drawn = whole.edges
    if traced:
        drawn = {e: ends for e, ends in drawn.items() if e.split("@")[0] not in traced}
    try:
        return replace(whole, faces=find_faces(whole.vertices, drawn)), ""
    except SketchError as error:
        return whole, f" No faces were looked for: {error}."


def _verdict(lifted: _Lifted, open_: Freedoms, conflicts: tuple[str, ...]) -> tuple[Status, str]:
    if conflicts:
        return (
            Status.CONFLICTING,
            f"{_and(conflicts[:4])} cannot hold together with the rest: check the worst first.",
        )
    if open_.count:
        s = "" if open_.count == 1 else "s"
        return (
            Status.UNDERDETERMINED,
            f"{open_.count} freedom{s} left: add a right angle, parallel or ground vertex "
            f"at {_and(open_.loose[:4])}.",
        )
    misfit = float(np.sqrt(lifted.minimum.cost / max(1, len(lifted.full.coordinate))))
    if not lifted.minimum.converged or misfit > LOST_MISFIT:
        return (
            Status.NOT_CONVERGED,
            "The drawing and the annotations are too far apart: check the annotations.",
        )
    if not lifted.above:
        return (Status.CONVERGED, "Solved, but seen from below: check the ground vertices.")
    if lifted.focal_assumed:
        return (
            Status.CONVERGED,
            "Solved, with a usual focal length assumed: the drawing does not tell it.",
        )
    return (Status.CONVERGED, "Solved.")


def _and(ids: tuple[str, ...]) -> str:
    if len(ids) < 2:
        return "".join(ids)
    return f"{', '.join(ids[:-1])} and {ids[-1]}"
