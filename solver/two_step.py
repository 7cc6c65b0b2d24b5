"""The Modified Lipson solve ([Lau10] 4.2), in the order of the paper.

1. the annotations reduce the unknowns (structure);
2. an initial step finds an approximate shape and camera (initial);
3. the full step follows the drawing as well as the annotations allow (full);
4. the shape is put on the ground and given its size (world);
5. what is left open or disagrees is told (diagnosis).
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from functools import partial

import numpy as np

from .blaming import Blame
from .blas_threads import one_blas_thread
from .candidates import MAX_COORDINATES, MAX_NUMBERS
from .closer_look import needs_a_closer_look
from .culprits import lift_or_blame, lift_without_culprit
from .designing import as_designed
from .diagnosis import disagree
from .effort import Effort
from .graph import SketchGraph
from .leaning import as_leaning_near
from .lifting import Lifted, lift_near
from .necker import fits_as_well, twin_of
from .on_found_faces import solve_on_found_faces
from .problem import conditions_of
from .revolution import without_profiles
from .said_angles import Corner, with_angles
from .solution import Solution, Status
from .structure import Structure, build_structure
from .telling import clashing, describe, lost, nothing_to_lift, too_free
from .values import Progress, Stop
from .world import ground_indices

#: Said where somebody stopped it.
STOPPED = "Stopped before the end: this is as far as it came."


def solve(
    graph: SketchGraph,
    *,
    start: Solution | None = None,
    stop: Stop | None = None,
    progress: Progress | None = None,
    twin: bool = False,
    angles_deg: Mapping[Corner, float] | None = None,
) -> Solution:
    """Lift a sketch graph to 3D and find the camera.

    Parameters
    ----------
    graph : SketchGraph
    start : Solution, optional
        Of this sketch before some small change (a vertex moved, a length edited): where it leads
        to a good shape, that one is taken and no other view is looked for.
    stop : callable, optional
        Asked now and then; True ends the solve with what there is (status ``not_converged``).
    progress : callable, optional
        Told how far the solve is (0 to 1) and what is being done.
    twin : bool
        Give the other reading of the drawing, near and far exchanged, if there is one.
    angles_deg : mapping of (edge id, edge id) to float, optional
        Angles between edges that meet, said beside the sketch, degrees. What is told of them names
        them ``angle e1 e2``.

    Returns
    -------
    Solution
        Always; how it went is told by its status and message.

    Raises
    ------
    SketchError
        Where `angles_deg` names edges that do not meet, or an angle that cannot be.
    """
    began = time.perf_counter()
    sketch, graph = graph, with_angles(graph, angles_deg)
    with one_blas_thread, np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        try:
            effort = Effort(stop, progress)
            once = partial(_solve, start=start, effort=effort, twin=twin)
            solution = solve_on_found_faces(graph, once)
            effort.doing("done", 1.0)
            if effort.stopped:
                solution = replace(solution, status=Status.NOT_CONVERGED, message=STOPPED)
        except np.linalg.LinAlgError:
            solution = lost(graph)
    if not solution.is_bounded:
        solution = lost(graph)
    elapsed = (time.perf_counter() - began) * 1e3
    report = replace(solution.report, solve_ms=elapsed)
    return replace(solution, sketch=sketch, report=report)


def _solve(graph: SketchGraph, start: Solution | None, effort: Effort, *, twin: bool) -> Solution:
    effort.doing("reasoning about the annotations")
    nothing = nothing_to_lift(graph)
    if nothing is not None:
        return Solution(graph, Status.UNDERDETERMINED, nothing)
    core = without_profiles(graph)
    structure = build_structure(core)
    if disagree(core):
        shape, clash = lift_without_culprit(core, effort)
        return clashing(graph, clash) if shape is None else describe(graph, core, shape, clash)
    if structure.n_coordinates > MAX_COORDINATES:
        return too_free(graph, f"{structure.n_coordinates} coordinates are free")
    conditions = conditions_of(core, structure)
    if conditions * structure.n_coordinates > MAX_NUMBERS:
        n = structure.n_coordinates
        return too_free(graph, f"{conditions} conditions on {n} coordinates are left")
    effort.weigh(structure.n_coordinates, conditions)
    effort.doing("looking for the camera and the shape", 0.1)
    lift = partial(_lift_or_blame, start, effort, twin=twin)
    designed = as_designed(core, structure, lift, effort)
    if designed is not None:
        return describe(graph, core, *designed)
    lifted, blamed = lift(core, structure)
    if lifted is None:
        return lost(graph)
    return describe(graph, core, lifted, blamed)


def _lift_or_blame(
    start: Solution | None,
    effort: Effort,
    core: SketchGraph,
    structure: Structure,
    *,
    twin: bool,
) -> tuple[Lifted | None, Blame | None]:
    """The reading asked for, from a solution that is known where that leads to a good one."""
    blamed, lifted = None, None if start is None else _lift_near(core, structure, start, effort)
    if lifted is None or needs_a_closer_look(core, lifted, dragging=True):
        lifted, blamed = lift_or_blame(core, structure, effort)
    if lifted is None:
        return None, None
    return _reading_asked_for(core, lifted, effort, twin=twin), blamed


def _lift_near(
    core: SketchGraph, structure: Structure, start: Solution, stop: Stop
) -> Lifted | None:
    """From a solution that is known, with a lean where the drawing shows one there."""
    leaning = as_leaning_near(core, structure, start, stop)
    return leaning or lift_near(core, structure, start, stop)


def _reading_asked_for(core: SketchGraph, lifted: Lifted, effort: Effort, *, twin: bool) -> Lifted:
    """The first or the second of two readings, and whether nothing decides between them."""
    decided = bool(ground_indices(core)) or lifted.as_guessed
    if lifted.doubtful or effort.stopped or (decided and not twin):
        return lifted
    effort.doing("exchanging near and far")
    other = twin_of(core, lifted, effort)
    if other is None:
        return lifted
    twofold = fits_as_well(core, other, lifted, effort)
    return replace(other if twin else lifted, twofold=twofold)
