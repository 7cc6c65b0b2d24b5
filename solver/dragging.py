"""Lifting while a vertex is dragged: a few iterations from the last shape, at each mouse move.

The annotations stay as they are, so that the structure, the unknowns, the faces and what the report
says of the annotations stay too. When the mouse is let go, `solve` looks at everything afresh.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from .blas_threads import one_blas_thread
from .designing import designed_sizes, stretched
from .diagnosis import without
from .full import FocalPrior, FullProblem, Pose
from .graph import SketchGraph
from .leaning import LeaningHand, can_lean, leaning_problem, shown_hand
from .least_squares import Minimum, minimise
from .lifting import Lifted, is_unsure_of_focal, told_focal
from .on_found_faces import listing_named_faces
from .placed import put_in_world
from .problem import build_problem
from .revolution import without_profiles
from .solution import Solution
from .starting.focal_prior import USUAL, spare_observations, tighter, usual_prior
from .starting.warm_start import pose_from
from .structure import Structure, build_structure
from .symmetry import Geometry, mirrored
from .topology import Topology, topology_of
from .two_step import solve

#: Iterations at each move: the shape follows within a fraction of a pixel.
ITERATIONS = 2


@dataclass(frozen=True, slots=True, eq=False)
class Drag:
    """A sketch on its way, and its shape.

    Parameters
    ----------
    graph : SketchGraph
    solution : Solution
    """

    graph: SketchGraph
    solution: Solution
    _topology: Topology
    _structure: Structure | None = None
    _pose: Pose | None = None
    _prior: FocalPrior | None = None
    _expected: FocalPrior | None = None
    _spare: int | None = None
    _hand: LeaningHand | None = None
    _sizes: tuple[str, ...] = ()


def begin_drag(graph: SketchGraph, solution: Solution | None = None) -> Drag:
    """Get ready to drag.

    Parameters
    ----------
    graph : SketchGraph
        As it is before the first move.
    solution : Solution, optional
        Its solution, where it is known.
    """
    solution = solve(graph) if solution is None else solution
    with one_blas_thread:
        return _begun(graph, solution)


def _begun(graph: SketchGraph, solution: Solution) -> Drag:
    idle = Drag(graph, solution, topology_of(graph))
    core = without_profiles(listing_named_faces(graph, solution.faces))
    # Sizes of the new object stretch what is drawn without them.
    sizes = designed_sizes(core)
    core, idle = without(core, *sizes), replace(idle, _sizes=sizes)
    structure = build_structure(core)
    if structure.contradiction:
        return idle
    problem = build_problem(core, structure)
    pose = pose_from(solve(without(graph, *sizes)) if sizes else solution, core, problem)
    if pose is None:
        return idle
    prior = told_focal(problem)
    full = FullProblem(problem, prior)
    hand = shown_hand(full, prior, pose) if can_lean(problem) else None
    if hand is not None:
        return replace(idle, _structure=structure, _pose=pose, _prior=prior, _hand=hand)
    if problem.camera is None and prior is None:
        expected = USUAL if is_unsure_of_focal(full, pose) else None
        spare = spare_observations(full, pose)
        rated = tighter(usual_prior(full, pose, spare), expected)
        return replace(
            idle, _structure=structure, _pose=pose, _prior=rated, _expected=expected, _spare=spare
        )
    return replace(idle, _structure=structure, _pose=pose, _prior=prior)


def drag(last: Drag, graph: SketchGraph) -> Drag:
    """The next move.

    Parameters
    ----------
    last : Drag
    graph : SketchGraph
        The sketch with vertices or circles moved. Where anything else is different too, it is
        solved from nothing.
    """
    if last._pose is None or last._structure is None or topology_of(graph) is not last._topology:
        return begin_drag(graph)
    with one_blas_thread:
        return _moved(last, last._structure, last._pose, graph)


def _moved(last: Drag, structure: Structure, pose: Pose, graph: SketchGraph) -> Drag:
    whole = without_profiles(listing_named_faces(graph, last.solution.faces))
    core = without(whole, *last._sizes)
    problem = build_problem(core, structure)
    full = FullProblem(problem, last._prior)
    if last._hand is not None:
        full = leaning_problem(problem, last._prior, last._hand)
    weighed = last._spare is not None
    x = minimise(full, pose, max_iterations=ITERATIONS - weighed, near=True).x
    prior = last._prior
    if last._spare is not None:
        # The misfit has changed, and with it how far the drawing is trusted.
        prior = tighter(usual_prior(full, x, last._spare), last._expected)
        full = full.with_prior(prior)
        x = minimise(full, x, max_iterations=1, near=True).x
    shown = _stretched(whole, full, x) if last._sizes else (full, x)
    solution = _describe(graph, whole, *shown, last.solution)
    return replace(last, graph=graph, solution=solution, _pose=x, _prior=prior)


def _stretched(core: SketchGraph, full: FullProblem, x: Pose) -> tuple[FullProblem, Pose]:
    """With the sizes of the new object; as it is drawn where they cannot be had."""
    near = Minimum(x, 0, True, 0.0)
    drawn = Lifted(full.problem, full, near, True)
    found = stretched(core, build_structure(core), drawn, lambda: False)
    return (full, x) if found is None else (found.full, found.minimum.x)


def _describe(
    graph: SketchGraph, core: SketchGraph, full: FullProblem, pose: Pose, last: Solution
) -> Solution:
    """The new shape; what does not depend on positions is as it was."""
    placed = put_in_world(graph, core, full, pose)
    whole, _ = mirrored(graph, Geometry(placed.vertices, graph.edges, graph.drawn_faces or {}))
    return replace(
        last,
        sketch=graph,
        vertices_mm=whole.vertices,
        circles=placed.circles,
        camera=placed.camera,
        report=replace(last.report, reprojection_px=placed.reprojection_px(graph)),
    )
