"""Long edges anywhere in a photo."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

from incontext.workbench.long_edges import long_edges


def slab(shape, rng, noise=3.0):
    """A bright slab, turned a little, on a dark table: its four corners, and the photo."""
    height, width = shape
    u, v = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    turn = np.array([[0.96, 0.28], [-0.28, 0.96]])
    x, y = np.einsum("ij,jvu->ivu", turn, [u - width / 2, v - height / 2])
    half = np.array([0.3 * width, 0.2 * height])
    is_slab = (np.abs(x) < half[0]) & (np.abs(y) < half[1])
    grey = gaussian_filter(np.where(is_slab, 190.0, 90.0), 0.8) + rng.normal(0, noise, shape)
    ring = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half
    return ring @ turn + [width / 2, height / 2], grey


@pytest.mark.parametrize("shape", [(600, 800), (2400, 3200)])
def test_the_sides_of_a_slab_are_found_at_any_size(shape):
    corners, grey = slab(shape, np.random.default_rng(1))
    found = long_edges(grey)
    near = 0.02 * shape[1]
    for p, q in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        off = [
            min(np.linalg.norm([a - p, b - q]), np.linalg.norm([b - p, a - q])) for a, b in found
        ]
        assert min(off) < near


def test_photos_of_bytes_are_read_alike():
    _, grey = slab((600, 800), np.random.default_rng(1))
    whole = np.clip(np.rint(grey), 0, 255)
    assert len(long_edges(whole.astype(np.uint8))) == len(long_edges(whole)) >= 4


def test_noise_has_no_long_edges():
    assert long_edges(120 + np.random.default_rng(4).normal(0, 8, (600, 800))) == []
