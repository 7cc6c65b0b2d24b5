"""Shapes that the benchmark does not have."""

from __future__ import annotations

import numpy as np
import pytest
from random_objects import RANDOM, drawn, upright
from scenes import Hand, Views, photograph, prism

from incontext.solver import solve
from incontext.solver.closer_look import DOUBTFUL_RMS
from incontext.solver.lifting import lift
from incontext.solver.solution import Status
from incontext.solver.structure import build_structure


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


LEANING = Hand(0.003, (3.0, 10.0), 0.05)


@pytest.mark.parametrize("name", RANDOM)
def test_exact_drawings_of_random_shapes_give_the_exact_shape(name):
    for run in range(3):
        for views in (Views(), Views(roll_deg=20.0, off_centre=0.5)):
            photo = drawn(name, run, views=views)
            solution = solve(photo.graph)
            assert solution.status is Status.CONVERGED
            assert photo.error(solution.vertices_mm) < 1e-8
            angles = [r.value for r in solution.report.residuals.values() if r.unit == "deg"]
            assert max(angles, default=0.0) < 1e-9


@pytest.mark.parametrize("name", RANDOM)
def test_leaning_drawings_of_random_shapes_are_not_taken_for_others(name):
    for run in range(4):
        photo = drawn(name, run, hand=LEANING, focal_known=True)
        assert photo.error(solve(photo.graph).vertices_mm) < 0.12


@pytest.mark.parametrize("run", [4, 12, 45])
def test_what_lines_tell_from_below_only_is_seen_from_above(run):
    # Two directions alone: the lines of these drawings agree with the Necker twin only.
    photo = drawn("three_sided", run, noise=0.02, focal_known=True)
    solution = solve(photo.graph)
    assert "below" not in solution.message
    assert photo.error(solution.vertices_mm) < 0.1


@pytest.mark.parametrize("run", [3, 4, 9, 13, 23])
def test_a_hand_that_leans_is_believed_before_a_false_annotation(run):
    photo = drawn("frustum", run, hand=LEANING, focal_known=True)
    solution = solve(photo.graph)
    assert not solution.report.conflicts
    assert photo.error(solution.vertices_mm) < 0.05


def test_a_part_that_floats_is_looked_at_in_all_its_places_before_a_sketch_is_doubted():
    # The first place often shrinks the box to a point.
    for run in range(4):
        photo = drawn("box_with_pyramid", run, hand=LEANING, focal_known=True)
        lifted = lift(photo.graph, build_structure(photo.graph), None, doubt_rms=DOUBTFUL_RMS)
        assert lifted is not None
        assert not lifted.doubtful
