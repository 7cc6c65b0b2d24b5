"""The world's frame."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scenes import box, photograph

from incontext.solver import solve
from incontext.solver.annotations import Ground
from incontext.solver.full import Pose
from incontext.solver.problem import build_problem
from incontext.solver.structure import build_structure
from incontext.solver.world import _axes


@pytest.mark.parametrize("off", [0.0, 1e-12, 1e-9, 1e-6, 1e-3])
def test_axes_are_square_even_where_right_is_up(off):
    graph = replace(photograph(box(), np.random.default_rng(0)).graph, annotations={})
    problem = build_problem(graph, build_structure(graph))
    up = np.array([np.cos(off), np.sin(off), 0.0])
    W = _axes(problem, Pose(np.eye(3), 0.0, np.zeros(problem.structure.n_coordinates)), up)
    assert np.abs(W @ W.T - np.eye(3)).max() < 1e-14
    assert np.linalg.det(W) == pytest.approx(1.0)
    assert W[2] == pytest.approx(up)


def test_ground_vertices_lie_on_the_ground():
    photo = photograph(box(), np.random.default_rng(3), noise=0.01)
    solution = solve(photo.graph)
    for a in photo.graph.annotations.values():
        if isinstance(a, Ground):
            assert max(abs(solution.vertices_mm[v][2]) for v in a.vertices) < 1e-9
