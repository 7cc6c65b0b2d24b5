"""The synthetic scenes themselves: what the figures stand on."""

from __future__ import annotations

import numpy as np
import pytest
from scenes import (
    FAMILIES,
    HEIGHT,
    WIDTH,
    Hand,
    Views,
    box,
    photograph,
    shape_error_floor,
    with_noise,
    with_traced_box,
)

from incontext.solver import solve


@pytest.mark.parametrize("name", FAMILIES)
def test_random_shapes_are_seen_whole_and_stand_on_the_ground(name):
    for seed in range(5):
        rng = np.random.default_rng(seed)
        shape = FAMILIES[name](rng)
        assert shape.X[:, 2].min() == 0.0
        drawn = np.array(list(photograph(shape, rng).graph.vertices.values()))
        assert (drawn > 0).all()
        assert (drawn < [WIDTH, HEIGHT]).all()


def test_the_floor_is_what_an_efficient_solver_reaches():
    """Over many drawings of one box, the mean squared error equals the floor's square."""
    noise = 0.002
    rng = np.random.default_rng(3)
    photo = photograph(box(), rng)
    errors = []
    for seed in range(60):
        drawn = with_noise(photo.graph, noise, np.random.default_rng(seed))
        errors.append(photo.error(solve(drawn).vertices_mm))
    found = np.sqrt(np.mean(np.square(errors)))
    assert found == pytest.approx(shape_error_floor(photo, noise), rel=0.2)


def test_a_known_focal_length_lowers_the_floor():
    photo = photograph(box(), np.random.default_rng(0))
    known = shape_error_floor(photo, 0.01, focal_known=True)
    assert known < shape_error_floor(photo, 0.01)
    assert shape_error_floor(photo, 0.02) == pytest.approx(2 * shape_error_floor(photo, 0.01))


def test_a_leaning_hand_keeps_small_angles_and_lengths():
    hand = Hand(tilt_deg=(3, 10), length_off=0.05)
    X = box(100, 100, 100).X
    leaned = hand.imagined(X, np.random.default_rng(1))
    for a, b in ((0, 1), (1, 2), (0, 4)):
        was, now = X[b] - X[a], leaned[b] - leaned[a]
        angle = np.degrees(np.arccos(was @ now / np.linalg.norm(was) / np.linalg.norm(now)))
        assert 3 <= angle <= 10
        assert 0.95 <= np.linalg.norm(now) / np.linalg.norm(was) <= 1.05


def test_a_rolled_camera_looks_past_the_middle():
    shape = box()
    rolled = photograph(shape, np.random.default_rng(0), views=Views(roll_deg=20, off_centre=0.4))
    level = photograph(shape, np.random.default_rng(0))
    assert abs(level.camera.rotation_cam_from_world[0, 2]) < 1e-12
    assert abs(rolled.camera.rotation_cam_from_world[0, 2]) > 1e-3
    np.testing.assert_allclose(rolled.camera.position_mm, level.camera.position_mm, atol=1e-9)


@pytest.mark.parametrize("aligned", [True, False])
def test_a_traced_box_is_construction_and_exact_without_noise(aligned):
    rng = np.random.default_rng(4)
    photo = with_traced_box(photograph(box(), rng), rng, trace_px=0.0, aligned=aligned)
    solution = solve(photo.graph)
    assert len(photo.graph.construction) == 12
    assert photo.error(solution.vertices_mm) < 1e-9
