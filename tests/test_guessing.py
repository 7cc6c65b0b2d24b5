"""Sparse sketches: begun from what the drawing suggests, and nothing of that stays."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from asserts import assert_annotations_hold
from scenes import SHAPES, box, l_shape, photograph

from incontext.solver import solve
from incontext.solver.annotations import RightAngle
from incontext.solver.effort import Effort
from incontext.solver.lifting import lift
from incontext.solver.problem import build_problem
from incontext.solver.solution import Status
from incontext.solver.starting.guessing import guesses
from incontext.solver.structure import build_structure
from incontext.solver.synthetic import organizer, staircase, table
from incontext.solver.telling import describe


def sparse(make, seed: int, part: float, noise: float = 0.0):
    """A photograph with only a part of its right angles said, and nothing else."""
    rng = np.random.default_rng(seed)
    photo = photograph(make(), rng, noise=noise)
    said = {
        id_: a
        for id_, a in photo.graph.annotations.items()
        if isinstance(a, RightAngle) and rng.random() < part
    }
    return photo, replace(photo.graph, annotations=said)


@pytest.mark.parametrize("make", [organizer, staircase])
@pytest.mark.parametrize("seed", range(3))
def test_an_exact_sparse_sketch_is_met_exactly(make, seed):
    photo, graph = sparse(make, seed, 0.5)
    assert not build_structure(graph).contradiction
    solution = solve(graph)
    assert solution.status is Status.CONVERGED
    assert photo.error(solution.vertices_mm) < 1e-8
    assert_annotations_hold(solution, 300.0)


def largest_cosine_unsaid(photo, graph, solution) -> float:
    """Among the corners that are right angles in truth and were not said to be."""
    X, ends = solution.vertices_mm, graph.edges
    said = {frozenset(a.between) for a in graph.annotations.values()}
    cosines = []
    for a in photo.shape.annotations.values():
        if isinstance(a, RightAngle) and frozenset(a.between) not in said:
            u, w = (X[ends[e][1]] - X[ends[e][0]] for e in a.between)
            cosines.append(abs(u @ w) / np.linalg.norm(u) / np.linalg.norm(w))
    return float(max(cosines))


def test_what_was_guessed_is_taken_back():
    photo, graph = sparse(l_shape, 3, 0.6, noise=0.005)
    solution = solve(graph)
    assert set(solution.report.residuals) == set(graph.annotations)
    assert "taken to be square" not in solution.message
    assert largest_cosine_unsaid(photo, graph, solution) > 1e-4


def test_where_a_guess_stays_this_is_said():
    photo, graph = sparse(organizer, 1, 0.5, noise=0.005)
    solution = solve(graph)
    assert largest_cosine_unsaid(photo, graph, solution) < 1e-9
    assert "taken to be square" in solution.message
    assert photo.error(solution.vertices_mm) < 0.03


def test_the_lines_along_three_directions_are_found_whatever_is_said():
    photo, graph = sparse(table, 0, 0.3, noise=0.005)
    guess = next(guesses(graph, build_problem(graph, build_structure(graph))))
    axis = build_structure(guess).edge_axis
    ends = np.array(photo.shape.edges)
    true = np.argmax(np.abs(photo.shape.X[ends[:, 1]] - photo.shape.X[ends[:, 0]]), axis=1)
    for k in range(3):
        assert len(set(true[axis == k])) == 1
    assert np.mean(axis >= 0) > 0.6


def test_nothing_is_guessed_of_nothing():
    graph = replace(photograph(box(), np.random.default_rng(0)).graph, edges={}, annotations={})
    assert list(guesses(graph, build_problem(graph, build_structure(graph)))) == []


def test_a_solve_counts_its_work_and_not_the_time(monkeypatch):
    graph = sparse(SHAPES[6], 2, 0.4, noise=0.01)[1]
    first = solve(graph)
    ticks = iter(range(0, 10**9, 1000))
    monkeypatch.setattr("time.perf_counter", lambda: float(next(ticks)))
    again = solve(graph)
    assert again.status is first.status
    assert all((again.vertices_mm[v] == x).all() for v, x in first.vertices_mm.items())


def test_the_work_of_a_solve_is_limited():
    effort = Effort(None)
    effort.weigh(500, 0)
    calls = 0
    while not effort():
        calls += 1
    assert 10 < calls < 200


@pytest.mark.parametrize(("noise", "told"), [(0.02, True), (0.001, False)])
def test_how_far_a_guess_misses_the_drawing_is_told(noise, told):
    graph = photograph(box(), np.random.default_rng(1), noise=noise).graph
    lifted = lift(graph, build_structure(graph), None)
    solution = describe(graph, graph, replace(lifted, as_guessed=True))
    assert "nearly square taken to be square" in solution.message
    assert ("The drawing is missed by" in solution.message) == told


@pytest.mark.parametrize(("make", "seed"), [(organizer, 2), (staircase, 0)])
def test_singular_right_angles_hold_to_the_last_digits(make, seed):
    _, graph = sparse(make, seed, 0.6, noise=0.005)
    solution = solve(graph)
    assert solution.status is Status.CONVERGED
    assert max(r.value for r in solution.report.residuals.values()) < 1e-11
