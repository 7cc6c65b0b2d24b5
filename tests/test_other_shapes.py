"""Shapes that the benchmark does not have."""

from __future__ import annotations

import numpy as np
import pytest
from scenes import Hand, Views, from_loops, photograph, prism

from incontext.solver import solve
from incontext.solver.solution import Status


def upright(name, outline, height):
    """A floor plan, and the same at a height."""
    n = len(outline)
    X = [(x, y, z) for z in (0, height) for x, y in outline]
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    return from_loops(name, X, [range(n), range(n, 2 * n), *sides])


def octagonal_box():
    a, d = 70.0, 70.0 / np.sqrt(2)
    xs = [d, d + a, 2 * d + a, 2 * d + a, d + a, d, 0, 0]
    return upright("octagonal box", [(xs[k], xs[(k - 2) % 8]) for k in range(8)], 90.0)


def cross():
    xs = [1, 2, 2, 3, 3, 2, 2, 1, 1, 0, 0, 1]
    return upright("cross", [(55 * xs[k], 55 * xs[(k - 3) % 12]) for k in range(12)], 60.0)


SHAPES = {
    "podium": prism(
        "podium",
        [(0, 0), (240, 0), (240, 40), (160, 40), (160, 90), (80, 90), (80, 60), (0, 60)],
        100,
    ),
    "slanted bin": prism("bin", [(0, 0), (120, 0), (150, 70), (120, 110), (0, 110)], 90),
    "octagonal box": octagonal_box(),
    "L desk": upright("L", [(0, 0), (180, 0), (180, 50), (60, 50), (60, 150), (0, 150)], 80),
    "cross": cross(),
}


@pytest.mark.parametrize("name", SHAPES)
def test_exact_drawings_give_the_exact_shape(name):
    photo = photograph(SHAPES[name], np.random.default_rng(4))
    solution = solve(photo.graph)
    assert solution.status is Status.CONVERGED
    assert photo.error(solution.vertices_mm) < 1e-8


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("fov_deg", [2.0, 0.1])
def test_exact_drawings_from_afar_give_the_exact_shape(name, fov_deg):
    photo = photograph(
        SHAPES[name], np.random.default_rng(4), views=Views(fov_deg=(fov_deg, fov_deg))
    )
    solution = solve(photo.graph)
    assert solution.status is Status.CONVERGED
    assert photo.error(solution.vertices_mm) < 1e-8


def test_a_drawing_without_any_perspective_is_not_bent_to_a_usual_camera():
    photo = photograph(SHAPES["cross"], np.random.default_rng(4), views=Views(fov_deg=(1e-6, 1e-6)))
    assert photo.error(solve(photo.graph).vertices_mm) < 1e-5


@pytest.mark.parametrize("name", SHAPES)
def test_careless_and_leaning_drawings_end_near_the_truth(name):
    for hand in (Hand(0.01), Hand(0.003, (3.0, 10.0), 0.05)):
        photo = photograph(SHAPES[name], np.random.default_rng(4), hand=hand, focal_known=True)
        assert photo.error(solve(photo.graph).vertices_mm) < 0.12
