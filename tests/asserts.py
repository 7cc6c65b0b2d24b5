"""Assertions with field meaning, shared by the tests."""

from __future__ import annotations

import numpy as np

from incontext.solver.solution import Solution, Status


def assert_solved(solution: Solution) -> None:
    assert solution.status is Status.CONVERGED, solution.message
    assert solution.report.degrees_of_freedom == 0
    assert solution.report.conflicts == ()


def assert_annotations_hold(solution: Solution, size_mm: float) -> None:
    """Annotated geometry holds exactly: 1e-9 of the size, 1e-9 degrees, lengths to 1e-6 mm."""
    for id_, residual in solution.report.residuals.items():
        limit = 1e-9 if residual.unit == "deg" else min(1e-6, 1e-9 * size_mm)
        assert residual.value <= limit, (id_, residual)


def assert_camera_sees(solution: Solution, graph, px: float) -> None:
    """The solved camera projects the solved vertices onto the drawing."""
    names = list(graph.vertices)
    seen = solution.camera.project(np.array([solution.vertices_mm[n] for n in names]))
    drawn = np.array([graph.vertices[n] for n in names])
    assert np.abs(seen - drawn).max() <= px
