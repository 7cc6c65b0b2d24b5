"""The three laws of every energy: zero on the truth, Jacobian = central difference, gauge-free."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from incontext.solver.energies import ENERGIES

# Corners of a box of 3 x 2 x 1 and a point in its bottom: what holds there, by vertex index.
BOX = np.array(
    [[x, y, z] for z in (0.0, 1.0) for x, y in ((0, 0), (3, 0), (3, 2), (0, 2))] + [[1.0, 0.5, 0.0]]
)
TRUE_ITEMS = {
    "right_angle": [(0, 1, 0, 3), (5, 1, 5, 6)],
    "angle": [(0, 1, 0, 3), (0, 2, 0, 1), (1, 0, 1, 3)],
    "parallel": [(0, 1, 3, 2), (0, 4, 6, 2)],
    "length_ratio": [(0, 1, 7, 6), (1, 2, 1, 5)],
    "planarity": [(0, 1, 2, 8), (4, 5, 6, 7)],
    "symmetry": [(0, 1, 3, 2), (0, 1, 7, 6)],
}
SLANTED = np.arctan2(2.0, 3.0)
WANTED = {
    "length_ratio": np.array([[3.0, 3.0], [2.0, 1.0]]),
    "angle": np.array([[np.pi / 2, 0.0], [SLANTED, 0.0], [SLANTED, 0.0]]),
}


def evaluate(name, X):
    extra = (WANTED[name],) if name in WANTED else ()
    return ENERGIES[name](X, np.array(TRUE_ITEMS[name]), *extra)


def test_every_energy_is_tested():
    assert set(TRUE_ITEMS) == set(ENERGIES)


@pytest.mark.parametrize("name", ENERGIES)
def test_zero_on_the_truth(name):
    assert np.abs(evaluate(name, BOX).residual).max() < 1e-15


@pytest.mark.parametrize("name", ENERGIES)
def test_not_zero_elsewhere(name):
    moved = BOX + np.random.default_rng(1).normal(size=BOX.shape) * 0.1
    assert np.abs(evaluate(name, moved).residual).max() > 1e-3


@pytest.mark.parametrize("name", ENERGIES)
def test_jacobian_equals_the_central_difference(name):
    X = BOX + np.random.default_rng(2).normal(size=BOX.shape) * 0.2
    at = evaluate(name, X)
    dense = np.zeros((len(at.residual), X.size))
    for k in range(3):
        np.add.at(dense, (at.row, 3 * at.vertex + k), at.value[:, k])
    step = 1e-6
    for i in range(X.size):
        d = np.zeros(X.size)
        d[i] = step
        d = d.reshape(X.shape)
        difference = (evaluate(name, X + d).residual - evaluate(name, X - d).residual) / (2 * step)
        np.testing.assert_allclose(dense[:, i], difference, atol=1e-8)


@pytest.mark.parametrize("name", ENERGIES)
def test_unchanged_by_a_move_of_the_gauge(name):
    X = BOX + np.random.default_rng(3).normal(size=BOX.shape) * 0.2
    R = Rotation.from_rotvec([0.3, -1.1, 0.7]).as_matrix()
    moved = 2.5 * X @ R.T + np.array([4.0, -7.0, 1.0])
    before, after = evaluate(name, X).residual, evaluate(name, moved).residual
    # The cross product of parallel turns with the frame; its length does not.
    if name == "parallel":
        before = np.linalg.norm(before.reshape(-1, 3), axis=1)
        after = np.linalg.norm(after.reshape(-1, 3), axis=1)
    np.testing.assert_allclose(after, before, atol=1e-12)
