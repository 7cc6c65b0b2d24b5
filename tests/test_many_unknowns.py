"""Sketches with hundreds of unknowns, solved by sparse algebra: as exact as small ones."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from asserts import assert_annotations_hold, assert_solved

from incontext.solver import solve
from incontext.solver.annotations import EqualLength
from incontext.solver.least_squares import MAX_DENSE, smallest_step
from incontext.solver.structure import build_structure
from incontext.solver.synthetic import photograph, shape_error, staircase


def test_a_long_staircase_is_exact():
    shape = staircase(90)
    graph = photograph(shape, np.random.default_rng(1)).graph
    assert build_structure(graph).n_coordinates > MAX_DENSE
    solution = solve(graph)
    assert_solved(solution)
    assert shape_error(shape, solution.vertices_mm) < 1e-9


def test_equal_steps_hold_exactly_in_a_careless_drawing():
    shape = staircase(90)
    treads = [e for e, (a, b) in enumerate(shape.edges) if _is_tread(shape.X[a], shape.X[b])]
    equal = EqualLength(tuple(f"e{e}" for e in treads[:40]))
    shape = replace(shape, annotations={**shape.annotations, "equal": equal})
    solution = solve(photograph(shape, np.random.default_rng(2), noise=0.002).graph)
    assert_solved(solution)
    assert_annotations_hold(solution, 60.0 * 90)
    assert shape_error(shape, solution.vertices_mm) < 0.02


def _is_tread(p, q) -> bool:
    return abs(p - q)[0] == 60.0 and not (p - q)[1:].any()


@pytest.mark.parametrize("times", [1, 20])
def test_the_smallest_step_with_rows_that_say_the_same(times):
    """Fewer rows than unknowns, and more of them."""
    rng = np.random.default_rng(3)
    n = MAX_DENSE + 30
    H = rng.normal(size=(20, n))
    H = np.vstack([H, H[:5], 2 * H[5:7], np.tile(H, (times - 1, 1))])
    x = rng.normal(size=n)
    step = smallest_step(H @ x, H)
    np.testing.assert_allclose(H @ (x + step), 0.0, atol=1e-8)
    np.testing.assert_allclose(step, -np.linalg.lstsq(H, H @ x, rcond=1e-9)[0], atol=1e-8)
