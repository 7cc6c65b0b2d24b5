"""Sketches that the usual way does not lead to a shape: begun from somewhere else.

From what the drawing suggests, or from a shape whose annotations give way as springs do.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from ..candidates import MAX_COORDINATES, NEAR_ITERATIONS, Candidate, Near, is_settled, reading_of
from ..candidates import lift_near as near_to
from ..closer_look import CLOSER_LOOK_RMS, DOUBTFUL_RMS
from ..diagnosis import KnownShape, beginnings, pose_near
from ..full import FullProblem
from ..graph import SketchGraph
from ..initial import views
from ..least_squares import Minimum, minimise
from ..lifting import Lifted, initial_pose, lift, told_focal, with_usual_focal
from ..problem import Problem, build_problem
from ..structure import Structure, build_structure
from ..values import Stop
from ..world import camera_above_ground
from .guessing import guesses
from .turned_views import turned_views

#: So many right angles that shared coordinates do not hold make a sketch that leaves much open.
MANY_RIGHT_ANGLES = 4


def lift_as_guessed(graph: SketchGraph, structure: Structure, stop: Stop) -> Lifted | None:
    """A good shape begun where those suggested by the drawing hold too.

    Only where the annotations share so few coordinates that nothing else comes first.
    """
    problem = build_problem(graph, structure)
    rows = sum(len(b.items) for b in problem.blocks if b.energy == "right_angle")
    if rows < MANY_RIGHT_ANGLES:
        return None
    near = _first_good(graph, _near_guesses(graph, problem, stop), stop)
    return _finished(graph, near, stop)


def rescued(graph: SketchGraph, lifted: Candidate, stop: Stop) -> Lifted | None:
    """A shape that all annotations hold for, where the usual way did not lead to one."""

    def found() -> Iterator[Near | None]:
        yield from _from_turned_cameras(graph, lifted.problem, stop)
        yield from _near_guesses(graph, lifted.problem, stop)
        yield from _where_all_give_way(graph, lifted, stop)

    return _finished(graph, _first_good(graph, found(), stop), stop)


def found_otherwise(graph: SketchGraph, lifted: Candidate, stop: Stop) -> Lifted | None:
    """The same without guesses; where much is open, a search may end at what hardly fits."""
    return _finished(
        graph, _first_good(graph, _where_all_give_way(graph, lifted, stop), stop), stop
    )


def _where_all_give_way(graph: SketchGraph, lifted: Candidate, stop: Stop) -> Iterator[Near | None]:
    for near in beginnings(graph, lifted.problem, lifted.minimum.x, stop):
        yield near_to(graph, near, stop)


def _first_good(graph: SketchGraph, found: Iterator[Near | None], stop: Stop) -> Near | None:
    """The first that follows the drawing well, else the one that does best."""
    best: tuple[float, Near] | None = None
    for near in found:
        if stop():
            break
        if near is None or not is_settled(near):
            continue
        reading = reading_of(graph, near)
        if reading.plausible and (best is None or reading.rms < best[0]):
            best = (reading.rms, near)
            if reading.rms < CLOSER_LOOK_RMS:
                break
    return None if best is None or best[0] > DOUBTFUL_RMS else best[1]


def _from_turned_cameras(graph: SketchGraph, problem: Problem, stop: Stop) -> Iterator[Near]:
    """Begun from cameras that the lines allow as well."""
    full = FullProblem(problem, told_focal(problem))
    best = next(views(problem), None)
    if best is None or not problem.structure.has_axes:
        return
    for R, log_focal in turned_views(problem, best.R, best.log_focal):
        pose = initial_pose(problem, replace(best, R=R, log_focal=log_focal))
        if pose is not None:
            minimum = minimise(full, pose, max_iterations=NEAR_ITERATIONS, enough=1e-6, stop=stop)
            above = camera_above_ground(graph, problem, minimum.x)
            yield Near(problem, full, minimum, above)


def _near_guesses(graph: SketchGraph, problem: Problem, stop: Stop) -> Iterator[Near | None]:
    if problem.structure.n_coordinates > MAX_COORDINATES:
        return
    for guess in guesses(graph, problem):
        structure = build_structure(guess)
        if structure.n_coordinates > problem.structure.n_coordinates:
            continue
        lifted = lift(guess, structure, stop, doubt_rms=DOUBTFUL_RMS)
        if lifted is not None and not lifted.doubtful and is_settled(lifted):
            yield _guess_taken_back(graph, guess, lifted, stop)


def _guess_taken_back(
    graph: SketchGraph, guess: SketchGraph, lifted: Lifted, stop: Stop
) -> Near | None:
    """The best shape nearby; where no descent comes to its end, the guess itself.

    At right-angled shapes some constraints agree to first order with moves that they forbid; and
    valleys in which a shape follows each stroke of a careless hand may be endless.
    """
    start = KnownShape.at(lifted.full, lifted.minimum.x)
    near = near_to(graph, start, stop)
    if near is None or is_settled(near):
        return near
    pose = pose_near(near.problem, start)
    minimum = Minimum(pose, lifted.minimum.iterations, True, near.full.merit(pose, 0.0))
    above = camera_above_ground(graph, near.problem, pose)
    return Near(near.problem, near.full, minimum, above, as_guessed=True)


def _finished(graph: SketchGraph, near: Near | None, stop: Stop) -> Lifted | None:
    """With what is known of the focal length."""
    if near is None:
        return None
    problem, last = near.problem, near.minimum
    if not near.as_guessed:
        full = FullProblem(problem, told_focal(problem))
        minimum = minimise(full, last.x, near=True, stop=stop)
        found = with_usual_focal(graph, Lifted(problem, full, minimum, near.above), stop)
        if is_settled(found):
            return found
    return Lifted(problem, near.full, last, near.above, as_guessed=near.as_guessed)
