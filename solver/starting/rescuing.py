"""Sketches that the usual way does not lead to a shape: begun from somewhere else.

From what the drawing suggests, or from a shape whose annotations give way as springs do.
"""

from __future__ import annotations

from collections.abc import Iterator

from ..blaming import CLOSER_LOOK_RMS, DOUBTFUL_RMS
from ..candidates import MAX_COORDINATES, Candidate, Near, is_settled, reading_of
from ..candidates import lift_near as near_to
from ..diagnosis import KnownShape, beginnings, pose_near
from ..full import EXIF_LOG_SIGMA, FocalPrior, FullProblem
from ..graph import SketchGraph
from ..least_squares import Minimum, minimise
from ..lifting import Lifted, is_unsure_of_focal, lift
from ..problem import Problem, build_problem
from ..structure import Structure, build_structure
from ..values import Stop
from ..world import camera_above_ground
from .focal_prior import USUAL
from .guessing import guesses

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


def _near_guesses(graph: SketchGraph, problem: Problem, stop: Stop) -> Iterator[Near | None]:
    if problem.structure.n_coordinates > MAX_COORDINATES:
        return
    for guess in guesses(graph, problem):
        structure = build_structure(guess)
        if structure.n_coordinates > problem.structure.n_coordinates:
            continue
        lifted = lift(guess, structure, stop, wary=True)
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
    full, x, assumed = near.full, near.minimum.x, False
    known = near.problem.log_focal_prior
    if known is None and is_unsure_of_focal(full, x):
        assumed = True
        full = FullProblem(near.problem, USUAL)
    elif known is not None and near.problem.camera is None:
        full = FullProblem(near.problem, FocalPrior(known, EXIF_LOG_SIGMA))
    if not near.as_guessed:
        minimum = minimise(full, x, near=True, stop=stop)
        found = Lifted(near.problem, full, minimum, near.above, assumed)
        if is_settled(found):
            return found
    return Lifted(near.problem, near.full, near.minimum, near.above, as_guessed=near.as_guessed)
