"""Edges that a lens bends, followed as one curve and beyond what is drawn."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

from incontext.workbench.plumb_lines import followed
from incontext.workbench.radial import Radial

SHAPE = (600, 800)
RADIAL = Radial.of(np.zeros(SHAPE))


def through(k, brightness, rng):
    """A photo of what is so bright at heights v of the straight photo."""
    u, v = np.meshgrid(np.arange(800) + 0.5, np.arange(600) + 0.5)
    straight = RADIAL.straightened(np.stack([u, v], axis=-1), k)
    return gaussian_filter(brightness(straight), 0.8) + rng.normal(0, 2, SHAPE)


def joint(places):
    """A dark joint, 6 px wide, between bright tiles."""
    return np.where(np.abs(places[..., 1] - 90) < 3, 90.0, 180.0)


@pytest.mark.parametrize("k", [-0.15, 0.0, 0.12])
def test_one_border_of_a_joint_is_followed_to_the_ends(k):
    rng = np.random.default_rng(1)
    drawn = RADIAL.bent(np.array([[250.0, 92], [480, 91]]), k) + np.array([[0, 2], [0, -2]])
    points = followed(through(k, joint, rng), *drawn, 9.0, RADIAL)
    back = RADIAL.straightened(points, k)
    border = 90 + 3 * np.sign(back[:, 1].mean() - 90)
    assert np.median(np.abs(back[:, 1] - border)) < 0.15
    assert np.ptp(points[:, 0]) > 640


def test_an_edge_ends_where_it_is_covered():
    rng = np.random.default_rng(2)
    grey = through(0.0, joint, rng)
    grey[:, 600:] = 120 + rng.normal(0, 2, (600, 200))
    points = followed(grey, np.array([250.0, 93.0]), np.array([480.0, 93.0]), 6.0, RADIAL)
    assert 570 < points[:, 0].max() < 615
    assert points[:, 0].min() < 80


def test_nothing_is_followed_where_nothing_is():
    flat = np.full(SHAPE, 120.0)
    p, q = np.array([250.0, 93.0]), np.array([480.0, 93.0])
    assert followed(flat, p, q, 6.0, RADIAL).shape == (0, 2)
    assert followed(flat, p, p + 5, 6.0, RADIAL).shape == (0, 2)
