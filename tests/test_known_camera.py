"""A camera known beforehand: it gives the frame and the size."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from asserts import assert_annotations_hold, assert_solved
from scenes import LID, bookshelf, box, photograph, photograph_turned, v

from incontext.solver import solve
from incontext.solver.annotations import Length


@pytest.mark.parametrize("make", [box, bookshelf])
@pytest.mark.parametrize("seed", range(3))
def test_the_world_is_the_cameras_and_the_size_follows(make, seed):
    shape = make()
    photo = photograph(shape.without("length"), np.random.default_rng(seed))
    solution = solve(replace(photo.graph, camera=photo.camera))
    assert_solved(solution)
    assert not solution.scale_assumed
    found = np.array([solution.vertices_mm[v(i)] for i in range(len(shape.X))])
    np.testing.assert_allclose(found, shape.X, atol=1e-6)
    assert solution.camera.to_json() == photo.camera.to_json()


def test_a_careless_sketch_keeps_camera_and_right_angles():
    shape = box().without("length")
    photo = photograph(shape, np.random.default_rng(2), noise=0.01)
    solution = solve(replace(photo.graph, camera=photo.camera))
    assert_solved(solution)
    assert_annotations_hold(solution, 200.0)
    assert solution.camera.to_json() == photo.camera.to_json()
    found = np.array([solution.vertices_mm[v(i)] for i in range(8)])
    assert np.abs(found - shape.X).max() < 15


def test_lengths_come_before_the_cameras_height():
    photo = photograph(box(), np.random.default_rng(2), noise=0.01)
    solution = solve(replace(photo.graph, camera=photo.camera))
    assert_solved(solution)
    assert_annotations_hold(solution, 200.0)
    focal = solution.camera.focal_px
    assert focal == pytest.approx(photo.camera.focal_px, rel=1e-12)


@pytest.mark.parametrize("make", [box, bookshelf])
def test_a_length_and_the_camera_hold_together_where_they_agree(make):
    photo = photograph(make(), np.random.default_rng(4))
    solution = solve(replace(photo.graph, camera=photo.camera))
    assert_solved(solution)
    assert_annotations_hold(solution, 200.0)
    assert "camera" not in solution.message
    np.testing.assert_allclose(
        solution.camera.translation_cam_from_world_mm,
        photo.camera.translation_cam_from_world_mm,
        rtol=1e-8,
    )
    found = np.array([solution.vertices_mm[v(i)] for i in range(len(photo.shape.X))])
    np.testing.assert_allclose(found, photo.shape.X, atol=1e-6)


def test_a_length_that_disagrees_with_the_camera_holds_and_says_how_far():
    shape = box()
    said = {**shape.annotations, "length": Length("e0", 220.0)}  # 10 % too long
    photo = photograph(replace(shape, annotations=said), np.random.default_rng(4))
    solution = solve(replace(photo.graph, camera=photo.camera))
    assert_solved(solution)
    X = solution.vertices_mm
    assert np.linalg.norm(X["v1"] - X["v0"]) == pytest.approx(220.0, abs=1e-6)
    off = 0.1 * photo.camera.position_mm[2]
    assert f"{off:.3g} mm (10 %)" in solution.message


def test_a_lid_under_a_known_camera():
    graph, camera = photograph_turned(LID, np.random.default_rng(1))
    solution = solve(replace(graph, annotations={}, camera=camera))
    assert_solved(solution)
    assert not solution.scale_assumed
    radii = [solution.circles[c].radius_mm for c in ("c0", "c1", "c2")]
    np.testing.assert_allclose(radii, [r for r, _ in LID.circles], rtol=1e-8)
    np.testing.assert_allclose(solution.circles["c0"].center_mm, [70, 70, 0], atol=1e-6)
