"""What a solve came to, told: the solution with its status, its message and its report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from .annotations import Angle, Diameter, EqualLength, Length
from .blaming import GROSS_RMS, Blame
from .camera import Camera
from .candidates import drawing_rms, drawn_diagonal
from .circles import flat_circles
from .diagnosis import (
    UNSURE_SIZE_SIGMA,
    Freedoms,
    busiest_vertex,
    freedoms,
    most_helpful_corner,
    pose_in,
    says_directions,
    size_of,
    standard_errors,
    unmet_annotations,
)
from .errors import SketchError
from .faces import awaited_faces
from .full import held_at_last
from .graph import SketchGraph
from .leaning import with_a_possible_lean
from .lifting import UNSURE_FOCAL_SIGMA, Lifted
from .placed import Placed, put_in_world
from .profiles import said_of_profiles
from .residuals import annotation_residuals
from .solution import Report, Solution, Status
from .starting.focal_prior import spare_observations
from .symmetry import Geometry, mirrored
from .values import Array, rows_of
from .world import ground_indices

#: Vertices whose spread to the side is so small a part of that along are on one line.
ON_A_LINE = 1e-6
#: Said where the standard errors of sizes are large.
UNSURE = " Its sizes are unsure: mark more, give a length, or trace something real in the photo."
#: Said where all that is drawn is used up, so that nothing of it checks the result.
JUST_ENOUGH = " Only just enough is said, and other shapes may fit as well: mark more."
#: Said where the drawing does not tell the focal length, and something else is said first.
UNTOLD_FOCAL = " The drawing does not tell the focal length: a usual one is assumed."
#: A camera this part of its height off is worth a word.
NEARLY_AGREE = 1e-3
#: People notice where a drawing is missed by this (RMS, parts of its diagonal).
NOTICEABLE = 0.005
#: A drawing further than this from every shape (RMS, parts of its diagonal) was not understood: the
#: worst of 2,000 careless and leaning ones is missed by 0.06.
LOST_RMS = 0.1


def describe(
    graph: SketchGraph, core: SketchGraph, lifted: Lifted, blamed: Blame | None = None
) -> Solution:
    """The solution that a lifted shape is.

    Parameters
    ----------
    graph : SketchGraph
        As it was drawn.
    core : SketchGraph
        Without the profiles of surfaces of revolution: what was lifted.
    lifted : Lifted
    blamed : Blame, optional
        What keeps annotations and drawing apart.
    """
    pose = held_at_last(lifted.full, lifted.minimum.x)
    drawn = lifted.drawn
    shown = None if drawn is None else pose_in(lifted.problem, drawn.full, drawn.minimum.x)
    placed = put_in_world(graph, core, lifted.full, pose, shown)
    vertices, circles = placed.vertices, placed.circles
    geometry, on_faces = _with_copies(graph, vertices)
    residuals = annotation_residuals(graph, geometry.vertices, geometry.faces, circles)
    # Away from the drawing its slopes tell nothing.
    seen = drawn or lifted
    told = seen.minimum.x
    open_ = freedoms(seen.full, told, [*core.vertices, *core.circles])
    extent = rows_of(vertices)
    if circles:
        extent = np.vstack([extent, *(c.center_mm for c in circles.values())])
    conflicts = unmet_annotations(residuals, size_of(extent))
    errors = None if open_.count else standard_errors(seen.full, told)
    sigmas = np.zeros(0) if errors is None else with_a_possible_lean(seen, errors.lengths)
    if errors is not None and errors.log_focal > UNSURE_FOCAL_SIGMA:
        seen = replace(seen, focal_assumed=_is_expected(seen))
    unsure = bool(np.sqrt(np.mean(sigmas**2)) > UNSURE_SIZE_SIGMA) if len(sigmas) else False
    just_enough = errors is not None and _is_just_enough(seen)
    status, message = _verdict(graph, core, seen, open_, conflicts)
    if status is Status.CONVERGED and (unsure or just_enough):
        message += JUST_ENOUGH if just_enough else UNSURE
    if status is Status.CONVERGED and core.camera is not None:
        message += _off_camera(placed.camera_off_mm, core.camera)
    if blamed is not None:
        conflicts = blamed.ids
        too_far = blamed.held and status is Status.NOT_CONVERGED
        message = message if too_far else blamed.message
        status = status if blamed.held else Status.CONFLICTING
    elif placed.wished and status is Status.CONVERGED:
        conflicts, message = placed.wished, _against_the_side(graph, placed)
    elif status is Status.NOT_CONVERGED:
        conflicts = ()
    if status is not Status.UNDERDETERMINED:
        message += _undirected(core)
    if seen.focal_assumed and "focal length" not in message:
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
            focal_assumed=seen.focal_assumed,
            size_sigma=dict(zip(core.edges, sigmas.tolist(), strict=False)),
            unsure=unsure or just_enough,
        ),
    )


def _verdict(
    graph: SketchGraph,
    core: SketchGraph,
    lifted: Lifted,
    open_: Freedoms,
    conflicts: tuple[str, ...],
) -> tuple[Status, str]:
    if conflicts and lifted.minimum.converged and _are_sizes(graph, conflicts):
        return Status.CONFLICTING, f"{_and(conflicts[:4])} cannot all hold: take one of them away."
    if conflicts and set(conflicts) <= said_of_profiles(graph, core).keys():
        return Status.CONFLICTING, (
            f"{_and(conflicts[:4])} cannot hold with what is said of the circles and the rest of "
            "the side: take one of these away."
        )
    if conflicts:
        # That directions clash would have been found by reasoning: here a search failed.
        return (
            Status.NOT_CONVERGED,
            "No shape was found in which all annotations hold: mark more right angles, "
            f"parallels or ground vertices, or check {_and(conflicts[:4])}.",
        )
    if open_.count:
        return Status.UNDERDETERMINED, _what_would_help(core, lifted, open_)
    rms = drawing_rms(lifted)
    if not lifted.minimum.converged or rms > LOST_RMS:
        return (
            Status.NOT_CONVERGED,
            "The drawing and the annotations are too far apart: check the annotations.",
        )
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
            f"it is.{_missed(lifted, rms)}",
        )
    if lifted.focal_assumed:
        return (
            Status.CONVERGED,
            "Solved, with a usual focal length assumed: the drawing does not tell it.",
        )
    return (Status.CONVERGED, "Solved.")


def _against_the_side(graph: SketchGraph, placed: Placed) -> str:
    """What is said where the side of a surface of revolution is another than was drawn."""
    off = placed.reprojection_px(graph)
    sides = {v for r in graph.revolutions.values() for v in r.profile}
    px = float(np.sqrt(np.mean([off[v] ** 2 for v in sides])))
    which = " or ".join(placed.wished)
    return f"Solved, but {which} contradicts the drawing, which is missed by {px:.0f} px."


def _missed(lifted: Lifted, rms: float) -> str:
    """How far the drawing is missed, where people would notice it."""
    px = rms * drawn_diagonal(lifted.problem) * lifted.problem.px_per_unit
    return f" The drawing is missed by {px:.0f} px." if rms > NOTICEABLE else ""


def _are_sizes(graph: SketchGraph, ids: tuple[str, ...]) -> bool:
    sizes = (Length, Diameter, EqualLength, Angle)
    return len(ids) > 1 and all(isinstance(graph.annotations[i], sizes) for i in ids)


def _what_would_help(core: SketchGraph, lifted: Lifted, open_: Freedoms) -> str:
    """How much is open, and which annotation would fix most of it."""
    left = f"{open_.count} freedom{'' if open_.count == 1 else 's'} left"
    first = busiest_vertex(core)
    if not says_directions(core) and first is not None:
        return (
            f"{left}: nothing is said to be square or parallel; begin with right angles at {first}."
        )
    sizes = {a.circle for a in core.annotations.values() if isinstance(a, Diameter)}
    # The first size only sets the scale: two sizes say what one circle is beside the other.
    unsaid = tuple(circle for circle in core.circles if circle not in sizes)
    if unsaid and all(id_ in core.circles for id_ in open_.loose):
        return (
            f"{left}: give the diameter of {_and(unsaid[:4])}, or join circles of one axis "
            "to a surface of revolution (V)."
        )
    x = lifted.minimum.x
    corner = most_helpful_corner(core, lifted.full.positions(x) @ x.R.T, open_)
    words = f"{left}: add a right angle, parallel or ground vertex at {_and(open_.loose[:4])}."
    if corner is None:
        return words
    v, e, f = corner
    return f"{words} If {e} and {f} are square at {v}, saying so would help most."


def _undirected(core: SketchGraph) -> str:
    """What is said where only sizes and the ground hold a shape: such shapes are seldom meant."""
    corner = None if core.circles or says_directions(core) else busiest_vertex(core)
    if corner is None:
        return ""
    return f" Nothing is said to be square or parallel: begin with right angles at {corner}."


def _is_expected(lifted: Lifted) -> bool:
    """Whether the usual focal length had a say, as it has unless the drawing is exact."""
    told = lifted.problem.log_focal_prior is not None and not lifted.focal_assumed
    return lifted.focal_assumed or not (told or lifted.full.prior is None)


def _is_just_enough(lifted: Lifted) -> bool:
    """Whether a shape has as many freedoms as numbers were drawn: each drawing is met, and several
    shapes may meet it, for such equations have several roots."""
    told = lifted.problem.log_focal_prior is not None and lifted.problem.camera is None
    return spare_observations(lifted.full, lifted.minimum.x) + told <= 0


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


def nothing_to_lift(graph: SketchGraph) -> str | None:
    """Why there is nothing to lift, in a sentence; None where there is something."""
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


def clashing(graph: SketchGraph, blamed: Blame) -> Solution:
    """Annotations cannot all hold, and no shape was found without those to blame."""
    return Solution(graph, Status.CONFLICTING, blamed.message, report=Report(conflicts=blamed.ids))


def too_free(graph: SketchGraph, what: str) -> Solution:
    """So much is open that solving would fill the machine."""
    message = f"{what}, too many to solve for: mark right angles and parallels."
    return Solution(graph, Status.UNDERDETERMINED, message)


def lost(graph: SketchGraph) -> Solution:
    """Wild drawings end without a shape, or with one whose numbers overflow."""
    return Solution(
        graph,
        Status.NOT_CONVERGED,
        "No 3D shape fits this drawing; check the annotations against it.",
    )


def _and(ids: tuple[str, ...]) -> str:
    if len(ids) < 2:
        return "".join(ids)
    return f"{', '.join(ids[:-1])} and {ids[-1]}"
