"""Fit and standing of plates and prints, without any file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..solver.graph import SketchGraph
from ..solver.solution import Solution

if TYPE_CHECKING:
    from ..solver.model import Model
    from .fabrication.checking import Check
    from .fabrication.meshes import Mesh
    from .fabrication.plates import Joined


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
