"""Radial distortion: there and back, and what it makes of straight edges."""

from __future__ import annotations

import numpy as np
import pytest

from incontext.workbench.radial import Radial

RADIAL = Radial.of(np.zeros((600, 800)))


def test_its_middle_is_the_photos_by_default():
    np.testing.assert_allclose(RADIAL.principal_px, [400, 300])
    assert RADIAL.half_diagonal_px == 500
    np.testing.assert_allclose(Radial.of(np.zeros((600, 800)), [1, 2]).principal_px, [1, 2])


@pytest.mark.parametrize("k", [-0.1, 0.0, 0.15, 0.3])
def test_bent_and_straightened_are_inverse(k):
    points = np.random.default_rng(1).uniform([0, 0], [800, 600], (50, 2))
    np.testing.assert_allclose(RADIAL.straightened(RADIAL.bent(points, k), k), points, atol=1e-8)


def test_the_bow_is_how_far_a_straight_edge_is_beside_its_chord():
    p, q, k = np.array([60.0, 40.0]), np.array([700.0, 90.0]), 0.05
    ends = RADIAL.straightened(np.array([p, q]), k)
    t = np.linspace(0, 1, 9)
    seen = RADIAL.bent(ends[0] + np.outer(t, ends[1] - ends[0]), k)
    along = (q - p) / np.linalg.norm(q - p)
    beside = (seen - p) @ [-along[1], along[0]]
    np.testing.assert_allclose(k * RADIAL.bow(p, q, t), beside, atol=0.4)
    assert np.abs(beside).max() > 4


def test_an_edge_through_the_middle_does_not_bend():
    bow = RADIAL.bow(np.array([0.0, 300.0]), np.array([800.0, 300.0]), np.linspace(0, 1, 5))
    np.testing.assert_allclose(bow, 0, atol=1e-9)
