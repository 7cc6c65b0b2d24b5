"""How far a solve goes where nothing fits, and what it says then."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scenes import l_shape, photograph

from incontext.solver import solve
from incontext.solver.effort import Effort
from incontext.solver.solution import Status


def test_guesses_leave_something_for_what_follows():
    effort = Effort(None)
    with effort.at_most(50.0):
        while not effort():
            pass
    assert not effort()


@pytest.mark.parametrize("seed", range(4))
def test_scribbles_that_no_shape_follows_are_not_called_solved(seed):
    rng = np.random.default_rng(seed)
    graph = photograph(l_shape(), rng).graph
    places = rng.uniform(200, 1000, (len(graph.vertices), 2)).tolist()
    scribble = {v: (x, y) for v, (x, y) in zip(graph.vertices, places, strict=True)}
    solution = solve(replace(graph, vertices=scribble))
    off = np.array(list(solution.report.reprojection_px.values()))
    assert np.sqrt(np.mean(off**2)) > 100
    assert solution.status is not Status.CONVERGED
