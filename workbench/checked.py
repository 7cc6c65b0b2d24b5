"""Fit and standing of what an order makes, without any file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..solver.graph import SketchGraph
from ..solver.model import build_model
from ..solver.solution import Solution

if TYPE_CHECKING:
    from ..solver.model import Model
    from .fabrication.checking import Check
    from .fabrication.meshes import Mesh
    from .fabrication.plates import Joined
    from .making import Order


def checks(graph: SketchGraph, solution: Solution, order: Order) -> tuple[Check, ...]:
    """Check the plates, the print, or both.

    Parameters
    ----------
    graph : SketchGraph
    solution : Solution
        Converged.
    order : Order

    Returns
    -------
    tuple of Check

    Raises
    ------
    SketchError, FabricationError
        Where nothing can be made.
    """
    from .fabrication.plates import joined_plates

    thickness = order.plates.thickness_mm if order.plates else 3.0
    model = build_model(solution, thickness, graph.made_revolutions)
    found = []
    if order.plates is not None:
        joined = joined_plates(model, order.plates)
        found.append(plates_check(joined, model, graph, solution))
    if order.shell is not None:
        from .fabrication.meshes import mesh_of
        from .fabrication.shell import shell_solid

        mesh = mesh_of(shell_solid(model, order.shell), order.shell.tolerance_mm)
        found.append(print_check(mesh, model, graph, solution, order.shell.least_wall_mm))
    return tuple(found)


def plates_check(joined: Joined, model: Model, graph: SketchGraph, solution: Solution) -> Check:
    """Plates against what is traced in their sketch."""
    from .fabrication.checking import check_plates
    from .fabrication.things import existing_things

    return check_plates(joined, model, existing_things(graph, solution), solution.camera)


def print_check(
    mesh: Mesh, model: Model, graph: SketchGraph, solution: Solution, line_mm: float
) -> Check:
    """A print against what is traced in its sketch."""
    from .fabrication.checking import check_print
    from .fabrication.things import existing_things

    return check_print(mesh, model, existing_things(graph, solution), solution.camera, line_mm)
