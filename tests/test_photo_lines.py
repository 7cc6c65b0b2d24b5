"""Straight edges in photos, to a fraction of a pixel."""

from __future__ import annotations

import numpy as np
import pytest
from rectangles import SMALL, camera_at, corners_mm, seen

from incontext.workbench.photo_lines import found_line, refined_corners

SQUARE = (100.0, 100.0)


def ramp_edge(angle_deg: float, offset_px: float, noise: float, rng) -> np.ndarray:
    """Dark on one side of a straight line, bright on the other; blurred as a lens does."""
    u, v = np.meshgrid(np.arange(200) + 0.5, np.arange(150) + 0.5)
    a = np.radians(angle_deg)
    across = (u - 100) * -np.sin(a) + (v - 75) * np.cos(a) - offset_px
    return 60 + 120 / (1 + np.exp(-across / 0.6)) + rng.normal(0, noise, u.shape)


@pytest.mark.parametrize("angle_deg", [0.0, 17.0, 45.0, 80.0])
@pytest.mark.parametrize("offset_px", [0.0, 0.37, -4.2])
def test_a_line_is_found_where_it_is(angle_deg, offset_px):
    rng = np.random.default_rng(1)
    grey = ramp_edge(angle_deg, offset_px, 2.0, rng)
    along = np.array([np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))])
    across = np.array([-along[1], along[0]])
    middle = np.array([100.0, 75.0])
    p, q = middle - 50 * along + 1.5 * across, middle + 50 * along - 2.0 * across
    line = found_line(grey, p, q, 8.0)
    off = (line.ends_px - middle) @ across - offset_px
    assert np.abs(off).max() < 0.1
    assert line.sigma_px < 0.1
    assert np.abs((line.points_px - middle) @ across - offset_px).max() < 0.8


def test_nothing_is_found_where_nothing_is():
    rng = np.random.default_rng(2)
    flat = rng.normal(100, 3, (150, 200))
    found = found_line(flat, np.array([50.0, 75.0]), np.array([150.0, 75.0]), 8.0)
    # Noise has steps of its own, but they make no line that is sure.
    assert found is None or found.sigma_px > 0.3


def test_of_two_edges_the_nearer_one_is_meant():
    grey = np.full((150, 200), 200.0)
    grey[70:80] = 40.0
    for v, edge in ((68.0, 70.0), (82.0, 80.0)):
        line = found_line(grey, np.array([40.0, v]), np.array([160.0, v]), 9.0)
        np.testing.assert_allclose(line.ends_px[:, 1], edge, atol=0.1)


@pytest.mark.parametrize("seed", range(2))
def test_clicked_corners_come_to_a_tenth_of_a_pixel(seed):
    rng = np.random.default_rng(seed)
    camera = camera_at(rng.uniform(30, 60), rng.uniform(-180, 180), 420, 900, photo=SMALL)
    grey = seen(camera, SMALL, rng)
    true = camera.project(corners_mm(SQUARE))
    found = refined_corners(grey, true + rng.uniform(-4, 4, (4, 2)), 10.0)
    off = np.linalg.norm(found.corners_px - true, axis=1)
    assert off.max() < 0.15
    assert found.sigma_px < 0.15
    assert len(found.sides) == 4


def test_corners_beside_nothing_are_left_to_the_person():
    rng = np.random.default_rng(3)
    grey = rng.normal(100, 1, (600, 800))
    corners = np.array([[300.0, 400.0], [500.0, 400.0], [480.0, 250.0], [320.0, 250.0]])
    found = refined_corners(grey, corners, 10.0)
    assert found is None or found.sigma_px > 0.3
