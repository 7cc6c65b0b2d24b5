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

from .annotations import Diameter, EqualLength, Length
from .blaming import (
    GROSS_RMS,
    MAX_COORDINATES,
    MAX_NUMBERS,
    Blame,
    blame_for_clash,
    blame_for_wishes,
    drawing_rms,
    drawn_diagonal,
    find_blame,
    is_settled,
    needs_a_closer_look,
    reading_of,
    suspicion,
)
from .blas_threads import one_blas_thread
from .camera import Camera
from .circles import flat_circles
from .diagnosis import (
    UNSURE_SIZE_SIGMA,
    Freedoms,
    Reading,
    busiest_vertex,
    disagree,
    find_clash,
    freedoms,
    most_helpful_corner,
    says_directions,
    size_of,
    standard_errors,
    unmet_annotations,
    without,
)
from .effort import Effort
from .errors import SketchError
from .faces import awaited_faces
from .graph import SketchGraph
from .leaning import as_leaning, as_leaning_near, leaning_reading
from .lifting import UNSURE_FOCAL_SIGMA, Lifted, lift, lift_near
from .necker import fits_as_well, twin_of
from .on_found_faces import solve_on_found_faces
from .placed import put_in_world
from .problem import build_problem
from .residuals import annotation_residuals
from .revolution import without_profiles
from .solution import Report, Solution, Status
from .starting.rescuing import lift_as_guessed, rescued
from .structure import Structure, build_structure
from .symmetry import Geometry, mirrored
from .values import Array, Progress, Stop, rows_of
from .wishes import drawn_shape, fulfilled, wishes_of
from .world import ground_indices

#: So many annotations are left out, at most, to show a shape where they clash.
MAX_CULPRITS = 4
#: Of more edges and annotations than these nobody draws, one is left out.
MANY_SAID = 1500
#: Vertices whose spread to the side is so small a part of that along are on one line.
ON_A_LINE = 1e-6
#: Said where somebody stopped it.
STOPPED = "Stopped before the end: this is as far as it came."
#: Said where the standard errors of sizes are large.
UNSURE = " Its sizes are unsure: mark more, give a length, or trace something real in the photo."
#: Said where the drawing does not tell the focal length, and something else is said first.
UNTOLD_FOCAL = " The drawing does not tell the focal length: a usual one is assumed."
#: A camera this part of its height off is worth a word.
NEARLY_AGREE = 1e-3
#: A drawing further than this from every shape (image units, RMS) was not understood.
LOST_MISFIT = 0.25


def solve(
    graph: SketchGraph,
    *,
    start: Solution | None = None,
    stop: Stop | None = None,
    progress: Progress | None = None,
    twin: bool = False,
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

    Returns
    -------
    Solution
        Always; how it went is told by its status and message.
    """
    began = time.perf_counter()
    with one_blas_thread, np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        try:
            effort = Effort(stop, progress)
            once = partial(_solve, start=start, effort=effort, twin=twin)
            solution = solve_on_found_faces(graph, once)
            effort.doing("done", 1.0)
            if effort.stopped:
                solution = replace(solution, status=Status.NOT_CONVERGED, message=STOPPED)
        except np.linalg.LinAlgError:
            solution = _lost(graph)
    if not solution.is_bounded:
        solution = _lost(graph)
    elapsed = (time.perf_counter() - began) * 1e3
    return replace(solution, report=replace(solution.report, solve_ms=elapsed))


def _solve(graph: SketchGraph, start: Solution | None, effort: Effort, *, twin: bool) -> Solution:
    effort.doing("reasoning about the annotations")
    nothing = _nothing_to_lift(graph)
    if nothing is not None:
        return Solution(graph, Status.UNDERDETERMINED, nothing)
    core = without_profiles(graph)
    structure = build_structure(core)
    if disagree(core):
        return _without_culprit(graph, core, effort)
    if structure.n_coordinates > MAX_COORDINATES:
        return _too_free(graph, f"{structure.n_coordinates} coordinates are free")
    conditions = _conditions(core, structure)
    if conditions * structure.n_coordinates > MAX_NUMBERS:
        n = structure.n_coordinates
        return _too_free(graph, f"{conditions} conditions on {n} coordinates are left")
    effort.weigh(structure.n_coordinates + conditions)
    effort.doing("looking for the camera and the shape", 0.1)
    near = None if start is None else _lift_near(core, structure, start, effort)
    if near is not None and not needs_a_closer_look(core, near, dragging=True):
        return _describe(graph, core, _reading_asked_for(core, near, effort, twin=twin))
    lifted, blamed = _lift_or_blame(core, structure, effort)
    if lifted is None:
        return _lost(graph)
    return _describe(graph, core, _reading_asked_for(core, lifted, effort, twin=twin), blamed)


def _lift_near(
    core: SketchGraph, structure: Structure, start: Solution, stop: Stop
) -> Lifted | None:
    """From a solution that is known, with a lean where the drawing shows one there."""
    leaning = as_leaning_near(core, structure, start, stop)
    return leaning or lift_near(core, structure, start, stop)


def _conditions(core: SketchGraph, structure: Structure) -> int:
    return sum(len(block.items) for block in build_problem(core, structure).blocks)


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


def _too_free(graph: SketchGraph, what: str) -> Solution:
    message = f"{what}, too many to solve for: mark right angles and parallels."
    return Solution(graph, Status.UNDERDETERMINED, message)


def _lost(graph: SketchGraph) -> Solution:
    """Wild drawings end without a shape, or with one whose numbers overflow."""
    return Solution(
        graph,
        Status.NOT_CONVERGED,
        "No 3D shape fits this drawing; check the annotations against it.",
    )


def _nothing_to_lift(graph: SketchGraph) -> str | None:
    if not graph.edges and not graph.circles:
        return "The sketch has no edges: draw the object's edges over the photo."
    if flat := flat_circles(graph):
        return f"{_and(flat)} drawn without width or height: pull the ellipse open."
    if graph.circles:
        return None
    pixels = graph.positions_px
    off = pixels - pixels.sum(axis=0) / max(1, len(pixels))
    spread = np.linalg.eigvalsh(off.T @ off)
    if len(pixels) < 3 or float(spread[0]) <= ON_A_LINE**2 * max(float(spread[1]), 1e-300):
        return "All vertices lie on one line: draw edges in at least two directions."
    return None


def _without_culprit(graph: SketchGraph, core: SketchGraph, effort: Effort) -> Solution:
    """What follows from annotations that cannot all hold: the shape without the culprit."""
    effort.doing("looking for annotations that disagree")
    kept: dict[str, Lifted] = {}

    def attempt(id_: str) -> Reading | None:
        lifted = None if effort.stopped else _lift_without(core, id_, effort=effort)
        if lifted is None or lifted.doubtful:
            return None
        kept[id_] = lifted
        return reading_of(without(core, id_), lifted)

    blamed = blame_for_clash(core, attempt, effort)
    first = blamed.ids[0]
    lifted = kept.get(first) or _lift_without(core, first, effort=effort)
    if lifted is None and not effort.stopped:
        lifted = _lift_without(core, *_several_culprits(core, first, effort), effort=effort)
    if lifted is None or lifted.doubtful:
        report = Report(conflicts=blamed.ids)
        return Solution(graph, Status.CONFLICTING, blamed.message, report=report)
    return _describe(graph, core, lifted, blamed)


def _several_culprits(core: SketchGraph, first: str, effort: Effort) -> list[str]:
    """More and more annotations taken away, until the rest agrees."""
    ids = [first]
    if len(core.edges) + len(core.annotations) > MANY_SAID:
        return ids
    while len(ids) < MAX_CULPRITS and disagree(without(core, *ids)) and not effort():
        ids.append(find_clash(without(core, *ids), effort).ids[0])
    return ids


def _lift_without(core: SketchGraph, *ids: str, effort: Effort) -> Lifted | None:
    rest = without(core, *ids)
    structure = build_structure(rest)
    if disagree(rest) or structure.n_coordinates > MAX_COORDINATES:
        return None
    conditions = _conditions(rest, structure)
    if conditions * structure.n_coordinates > MAX_NUMBERS:
        return None
    effort.weigh(structure.n_coordinates + conditions)
    return lift(rest, structure, effort, wary=True)


def _lift_or_blame(
    core: SketchGraph, structure: Structure, effort: Effort
) -> tuple[Lifted | None, Blame | None]:
    """The shape, or where an annotation contradicts the drawing grossly the shape without it."""
    lifted = lift_as_guessed(core, structure, effort) or lift(core, structure, effort, wary=True)
    if lifted is None or effort.stopped:
        return lifted, None
    lifted, leaning = _with_lean(core, structure, lifted, effort)
    if effort.stopped or _is_fine(core, lifted):
        return leaning or lifted, None
    effort.doing("looking for annotations that disagree")
    blamed = None
    for lost in (False, True)[lifted.doubtful :]:
        blamed = blamed or find_blame(core, lifted, effort, lost=lost)
    if blamed is None and drawing_rms(lifted) > GROSS_RMS:
        afresh = partial(_lift_without, core, effort=effort)
        blamed = find_blame(core, lifted, effort, lost=True, afresh=afresh)
    if effort.stopped:
        return lifted, None
    if leaning is not None and _explains(core, leaning, lifted, blamed):
        return leaning, None
    wished = _as_wished(core, structure, lifted, blamed, effort)
    if wished is not None:
        return wished
    other = None
    if effort.stopped:
        return lifted, None
    if blamed is not None and not blamed.held:
        other = _lift_without(core, blamed.ids[0], effort=effort)
    if other is not None and not other.doubtful:
        return other, blamed
    # What was found at first sight only is finished.
    lifted = lift(core, structure, effort) if lifted.doubtful else lifted
    if lifted is not None and not is_settled(lifted):
        effort.doing("beginning from other shapes")
        lifted = rescued(core, lifted, effort) or lifted
    if lifted is not None and blamed is None and is_settled(lifted):
        blamed = suspicion(core, lifted, effort)
    return lifted, blamed


def _with_lean(
    core: SketchGraph, structure: Structure, lifted: Lifted, effort: Effort
) -> tuple[Lifted, Lifted | None]:
    """A reading, and the same with a lean where the drawing shows one."""
    leaning = as_leaning(core, lifted, effort)
    if leaning is None or not lifted.doubtful:
        return lifted, leaning
    # Only a first look was taken: the exact drawing of something else looks like a lean, too.
    whole = lift(core, structure, effort)
    if whole is None or not _is_fine(core, whole):
        return lifted, leaning
    return whole, as_leaning(core, whole, effort)


def _explains(core: SketchGraph, leaning: Lifted, lifted: Lifted, blamed: Blame | None) -> bool:
    """Whether a hand that leans explains the drawing better than a false annotation."""
    found = leaning_reading(core, leaning, lifted)
    return found.plausible and (blamed is None or found.information < blamed.information)


def _as_wished(
    core: SketchGraph, structure: Structure, lifted: Lifted, blamed: Blame | None, stop: Stop
) -> tuple[Lifted, Blame] | None:
    """The shape with the sizes that keep the drawing from being met, where there are such."""
    if blamed is None and is_settled(lifted):
        return None
    several, first = wishes_of(core), blamed.ids[:1] if blamed is not None else ()
    tries = (
        [first] if all(isinstance(core.annotations[i], Length | Diameter) for i in first) else []
    )
    # One alone would have been blamed; several may hide behind each other.
    tries += [several] if len(several) > 1 else []
    for wishes in tries:
        drawn = drawn_shape(core, wishes, stop) if wishes else None
        found = None if drawn is None else fulfilled(core, structure, drawn, stop)
        if found is not None:
            ids = blamed.ids if blamed is not None and wishes == first else wishes
            return found, blame_for_wishes(core, ids, found)
    return None


def _is_fine(core: SketchGraph, lifted: Lifted) -> bool:
    return not lifted.doubtful and is_settled(lifted) and not needs_a_closer_look(core, lifted)


def _describe(
    graph: SketchGraph, core: SketchGraph, lifted: Lifted, blamed: Blame | None = None
) -> Solution:
    pose = lifted.minimum.x
    placed = put_in_world(graph, core, lifted.problem, pose)
    vertices, circles = placed.vertices, placed.circles
    geometry, on_faces = _with_copies(graph, vertices)
    residuals = annotation_residuals(graph, geometry.vertices, geometry.faces, circles)
    wished = blamed is not None and blamed.wished
    # Away from the drawing its slopes tell nothing; before the wish nothing was left open.
    found = freedoms(lifted.full, pose, [*core.vertices, *core.circles])
    open_ = Freedoms.none() if wished else found
    extent = rows_of(vertices)
    if circles:
        extent = np.vstack([extent, *(c.center_mm for c in circles.values())])
    conflicts = unmet_annotations(residuals, size_of(extent))
    errors = None if open_.count else standard_errors(lifted.full, pose)
    sigmas = np.zeros(0) if errors is None else errors.lengths
    if errors is not None and errors.log_focal > UNSURE_FOCAL_SIGMA:
        lifted = replace(lifted, focal_assumed=_is_expected(lifted))
    unsure = bool(np.sqrt(np.mean(sigmas**2)) > UNSURE_SIZE_SIGMA) if len(sigmas) else False
    status, message = _verdict(core, lifted, open_, conflicts, wished=wished)
    if status is Status.CONVERGED and unsure:
        message += UNSURE
    if status is Status.CONVERGED and core.camera is not None:
        message += _off_camera(placed.camera_off_mm, core.camera)
    if blamed is not None:
        conflicts, message = blamed.ids, blamed.message
        status = status if blamed.held else Status.CONFLICTING
    elif status is Status.NOT_CONVERGED:
        conflicts = ()
    if status is not Status.UNDERDETERMINED:
        message += _undirected(core)
    if lifted.focal_assumed and "focal length" not in message:
        message += UNTOLD_FOCAL
    return Solution(
        graph,
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
            focal_assumed=lifted.focal_assumed,
            size_sigma=dict(zip(core.edges, sigmas.tolist(), strict=False)),
            unsure=unsure,
        ),
    )


def _undirected(core: SketchGraph) -> str:
    """What is said where only sizes and the ground hold a shape: such shapes are seldom meant."""
    corner = busiest_vertex(core)
    if corner is None or core.circles or says_directions(core):
        return ""
    return f" Nothing is said to be square or parallel: begin with right angles at {corner}."


def _is_expected(lifted: Lifted) -> bool:
    """Whether the usual focal length had a say, as it has unless the drawing is exact."""
    told = lifted.problem.log_focal_prior is not None and not lifted.focal_assumed
    return lifted.focal_assumed or not (told or lifted.full.prior is None)


def _off_camera(off_mm: float, camera: Camera) -> str:
    """What is said where the given lengths and a known camera disagree."""
    part = off_mm / max(abs(float(camera.position_mm[2])), 1e-300)
    if part < NEARLY_AGREE:
        return ""
    return (
        f" The given lengths put the camera {off_mm:.3g} mm ({100 * part:.2g} %) off its known "
        "height: check the length, the camera, and what stands on the ground."
    )


def _with_copies(graph: SketchGraph, vertices: Mapping[str, Array]) -> tuple[Geometry, str]:
    """The geometry with its mirrored copies and its faces, and what to say of them."""
    whole, left_out = mirrored(graph, Geometry(vertices, graph.edges, graph.drawn_faces or {}))
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
        return replace(whole, faces=awaited_faces(whole.vertices, drawn)), ""
    except SketchError as error:
        return whole, f" No faces were looked for: {error}."


def _verdict(
    core: SketchGraph,
    lifted: Lifted,
    open_: Freedoms,
    conflicts: tuple[str, ...],
    *,
    wished: bool,
) -> tuple[Status, str]:
    if conflicts and lifted.minimum.converged and _are_sizes(core, conflicts):
        return Status.CONFLICTING, f"{_and(conflicts[:4])} cannot all hold: take one of them away."
    if conflicts:
        # That directions clash would have been found by reasoning: here a search failed.
        return (
            Status.NOT_CONVERGED,
            "No shape was found in which all annotations hold: mark more right angles, "
            f"parallels or ground vertices, or check {_and(conflicts[:4])}.",
        )
    if open_.count:
        return Status.UNDERDETERMINED, _what_would_help(core, lifted, open_)
    misfit = float(np.sqrt(lifted.minimum.cost / max(1, len(lifted.full.coordinate))))
    if not lifted.minimum.converged or (misfit > LOST_MISFIT and not wished):
        return (
            Status.NOT_CONVERGED,
            "The drawing and the annotations are too far apart: check the annotations.",
        )
    rms = drawing_rms(lifted)
    if rms > GROSS_RMS:
        px = rms * drawn_diagonal(lifted.problem) * lifted.problem.px_per_unit
        return (
            Status.CONVERGED,
            f"Solved, but the drawing is missed by {px:.0f} px: check the annotations against it.",
        )
    if lifted.twofold:
        return (
            Status.CONVERGED,
            "Solved, but a second shape, with near and far exchanged, fits as well: mark what "
            "stands on the ground, or ask for the twin.",
        )
    if not lifted.above and ground_indices(core):
        return (Status.CONVERGED, "Solved, but seen from below: check the ground vertices.")
    if not lifted.above:
        return (Status.CONVERGED, "Solved, but seen from below: mark what stands on the ground.")
    if lifted.as_guessed:
        return (
            Status.CONVERGED,
            "Solved, with what is drawn nearly square taken to be square: mark right angles where "
            "it is.",
        )
    if lifted.focal_assumed:
        return (
            Status.CONVERGED,
            "Solved, with a usual focal length assumed: the drawing does not tell it.",
        )
    return (Status.CONVERGED, "Solved.")


def _are_sizes(core: SketchGraph, ids: tuple[str, ...]) -> bool:
    sizes = (Length, Diameter, EqualLength)
    return len(ids) > 1 and all(isinstance(core.annotations[i], sizes) for i in ids)


def _what_would_help(core: SketchGraph, lifted: Lifted, open_: Freedoms) -> str:
    """How much is open, and which annotation would fix most of it."""
    left = f"{open_.count} freedom{'' if open_.count == 1 else 's'} left"
    first = busiest_vertex(core)
    if not says_directions(core) and first is not None:
        return (
            f"{left}: nothing is said to be square or parallel; begin with right angles at {first}."
        )
    x = lifted.minimum.x
    corner = most_helpful_corner(core, lifted.full.positions(x) @ x.R.T, open_)
    words = f"{left}: add a right angle, parallel or ground vertex at {_and(open_.loose[:4])}."
    if corner is None:
        return words
    v, e, f = corner
    return f"{words} If {e} and {f} are square at {v}, saying so would help most."


def _and(ids: tuple[str, ...]) -> str:
    if len(ids) < 2:
        return "".join(ids)
    return f"{', '.join(ids[:-1])} and {ids[-1]}"
