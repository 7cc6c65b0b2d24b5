"""Planes of symmetry square to an axis are held by one projection, whatever the steps do."""

import numpy as np
import pytest
from scenes import photograph, tapered_tray

from incontext.solver.balances import balances_of
from incontext.solver.full import FullProblem, Pose
from incontext.solver.initial import views
from incontext.solver.lifting import initial_pose
from incontext.solver.problem import build_problem
from incontext.solver.structure import build_structure


@pytest.fixture(name="tray")
def _tray():
    graph = photograph(tapered_tray(), np.random.default_rng(4), noise=0.01).graph
    return graph, build_structure(graph)


def test_nothing_curved_is_left_of_a_tray(tray):
    graph, structure = tray
    assert not build_problem(graph, structure).blocks
    assert len(balances_of(structure)) == len(structure.balance_owners) > 0


def test_the_nearest_coordinates_in_balance_are_found(tray):
    balances = balances_of(tray[1])
    g = np.random.default_rng(0).uniform(1, 2, tray[1].n_coordinates)
    held = balances.hold(g)
    assert np.abs(balances.rows @ held).max() < 1e-14 < np.abs(balances.rows @ g).max()
    # What was taken away is square to all that is in balance.
    inside = balances.held @ np.eye(len(g))
    assert np.abs(inside.T @ (g - held)).max() < 1e-12
    assert balances.hold(held) is held


def test_steps_stay_in_balance(tray):
    graph, structure = tray
    problem = build_problem(graph, structure)
    full = FullProblem(problem, None)
    assert full.constrained
    assert not full.curved
    view = next(views(problem))
    x = full.restore(initial_pose(problem, view))
    step = np.random.default_rng(1).normal(scale=0.01, size=4 + full.m)
    moved = full.retract(x, step)
    assert isinstance(moved, Pose)
    h, H = full.constraints(moved)
    assert np.abs(h).max() < 1e-14
    assert H.shape == (len(structure.balances), 4 + full.m)
