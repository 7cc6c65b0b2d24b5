"""Drawings whose directions lean, and those whose errors only look so."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from random_objects import drawn
from scenes import FAMILIES, Hand, Views, photograph

from incontext.solver import begin_drag, drag, solve
from incontext.solver.diagnosis import standard_errors
from incontext.solver.leaning import (
    LeaningHand,
    LeaningProblem,
    as_leaning,
    by_lean,
    with_a_possible_lean,
)
from incontext.solver.lifting import lift
from incontext.solver.problem import build_problem
from incontext.solver.structure import build_structure

LEANING = Hand(0.003, (3.0, 10.0), 0.05)


def drawing(family, run, hand, **told):
    rng = np.random.default_rng([run, list(FAMILIES).index(family)])
    return photograph(FAMILIES[family](rng), rng, hand=hand, **told)


def lifted(graph):
    return lift(graph, build_structure(graph), None)


def never():
    return False


@pytest.mark.parametrize(
    ("family", "run"),
    [("bookshelf", 24), ("house", 21), ("table", 8), ("staircase", 30), ("hexagonal box", 22)],
)
def test_what_leans_as_a_whole_is_not_taken_for_another_shape(family, run):
    # Without a lean: 11 to 44 % off, or a true annotation was blamed.
    photo = drawing(family, run, LEANING, focal_known=True)
    solution = solve(photo.graph)
    assert photo.error(solution.vertices_mm) < 0.03
    assert not solution.report.conflicts


def test_a_rolled_camera_is_found_all_the_same():
    views = Views(roll_deg=20.0, off_centre=0.5)
    errors = []
    for family in ("box", "L", "bookshelf", "organizer 6", "staircase"):
        photo = drawing(family, 1, LEANING, views=views, focal_known=True)
        errors.append(photo.error(solve(photo.graph).vertices_mm))
    assert max(errors) < 0.05


@pytest.mark.parametrize("family", ["cube", "L", "table", "house"])
@pytest.mark.parametrize("noise", [0.0, 0.005, 0.02])
def test_independent_errors_are_no_lean(family, noise):
    for run in range(3):
        graph = drawing(family, run, Hand(noise), focal_known=True).graph
        assert as_leaning(graph, lifted(graph), never) is None


def test_annotations_hold_with_a_lean():
    for family in ("hexagonal box", "tapered tray", "organizer 24"):
        solution = solve(drawing(family, 3, LEANING, focal_known=True).graph)
        for residual in solution.report.residuals.values():
            assert abs(residual.value) < {"deg": 1e-9, "mm": 1e-6}[residual.unit]


def test_the_marginal_misfit_is_that_with_the_best_lean():
    graph = drawing("L", 0, LEANING).graph
    problem, x = build_problem(graph, build_structure(graph)), lifted(graph).minimum.x
    full = LeaningProblem(problem, None, LeaningHand(0.002))
    D, r = by_lean(full, x), full.rows_of_vertices(x)[0]
    P = np.diag(full._precision)
    stacked = np.vstack([D.T, np.diag(np.sqrt(P))])
    wanted = np.append(r, np.zeros(9))
    e = np.linalg.lstsq(stacked, wanted, rcond=None)[0]
    assert full.misfit(x) == pytest.approx(float(np.sum((wanted - stacked @ e) ** 2)), rel=1e-9)


def test_a_lean_moves_the_vertices_as_it_says():
    graph = drawing("box", 0, LEANING).graph
    problem, x = build_problem(graph, build_structure(graph)), lifted(graph).minimum.x
    full = LeaningProblem(problem, None, LeaningHand(0.002))
    D = by_lean(full, x)
    c = full.positions(x)
    E = 1e-6 * np.random.default_rng(0).normal(size=(3, 3))
    leaned = c + (c - c.mean(axis=0)) @ E.T
    seen = [np.exp(x.log_focal) * (y @ x.R.T)[:, :2] / (y @ x.R.T)[:, 2:] for y in (c, leaned)]
    assert np.allclose(D.T @ E.ravel(), (seen[1] - seen[0]).T.ravel(), atol=1e-11)


def test_what_is_traced_does_not_lean():
    graph = drawing("box", 0, LEANING).graph
    problem, x = build_problem(graph, build_structure(graph)), lifted(graph).minimum.x
    weights = problem.weights.copy()
    weights[:4] = 7.0
    full = LeaningProblem(replace(problem, weights=weights), None, LeaningHand(0.002))
    D = by_lean(full, x).reshape(9, 2, -1)
    assert not D[..., :4].any()
    assert D[..., 4:].any()


def test_a_dragged_vertex_is_followed_with_the_lean():
    graph = drawing("table", 3, LEANING, focal_known=True).graph
    drags = begin_drag(graph)
    for _ in range(8):
        u, v = drags.graph.vertices["v0"]
        drags = drag(drags, replace(drags.graph, vertices={**graph.vertices, "v0": (u + 1, v)}))
    near = solve(drags.graph, start=drags.solution)
    afresh = solve(drags.graph)
    size = np.ptp(afresh.vertices_mm["v0"] - np.array(list(afresh.vertices_mm.values())))
    for id_, place in afresh.vertices_mm.items():
        assert np.allclose(near.vertices_mm[id_], place, atol=1e-3 * size)
        assert np.allclose(drags.solution.vertices_mm[id_], place, atol=5e-3 * size)


@pytest.mark.parametrize("run", [80006, 80016])
def test_where_a_lean_can_neither_be_seen_nor_excluded_the_sizes_are_unsure(run):
    # 24 and 13 % off: a frustum follows a leaning hand as another frustum does.
    photo = drawn("frustum", run, hand=LEANING, focal_known=True)
    solution = solve(photo.graph)
    assert photo.error(solution.vertices_mm) < 0.06 or solution.report.unsure


def test_a_lean_that_the_drawing_excludes_adds_nothing():
    for hand in (Hand(), Hand(0.005)):
        found = lifted(drawing("organizer 24", 5, hand).graph)
        sigmas = standard_errors(found.full, found.minimum.x).lengths
        assert with_a_possible_lean(found, sigmas) is sigmas


def test_a_lean_that_is_shown_is_not_counted_twice():
    graph = drawing("bookshelf", 24, LEANING, focal_known=True).graph
    found = as_leaning(graph, lifted(graph), never)
    sigmas = standard_errors(found.full, found.minimum.x).lengths
    assert with_a_possible_lean(found, sigmas) is sigmas
