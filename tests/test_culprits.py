"""False annotations that hide behind true ones: the beginning of the search decides."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scenes import box, from_loops, photograph, prism

from incontext.solver import solve
from incontext.solver.annotations import Ground, Parallel
from incontext.solver.synthetic.planting import PLANTED, planted


def pergola():
    """Four posts and a frame of beams, one of them across: its ends have no post."""
    low = [(0, 0), (230, 0), (230, 180), (0, 180)]
    X = [(x, y, z) for z in (0, 170) for x, y in low] + [(95, 0, 170), (95, 180, 170)]
    loops = [
        (4, 8, 9, 7),
        (8, 5, 6, 9),
        (0, 1, 5, 8, 4),
        (1, 2, 6, 5),
        (2, 3, 7, 9, 6),
        (3, 0, 4, 7),
    ]
    return from_loops("pergola", X, loops)


def two_boxes(turned_deg=35.0):
    """Two boxes on one ground, the second one turned."""
    first, second = box(150, 110, 90), box(90, 130, 70)
    angle = np.radians(turned_deg)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    X = second.X.copy()
    X[:, :2] = X[:, :2] @ turn
    X[:, 0] += 180.0 - X[:, 0].min()
    loops = [*first.loops, *(tuple(i + 8 for i in loop) for loop in second.loops)]
    return from_loops("two boxes", np.vstack([first.X, X]), loops)


def with_planted(photo, false):
    said = {PLANTED: false, **photo.graph.annotations}
    return replace(photo.graph, annotations=said)


@pytest.mark.parametrize("seed", range(4))
def test_a_vertex_wrongly_on_the_ground_is_named_before_what_it_clashes_with(seed):
    photo = photograph(pergola(), np.random.default_rng(seed))
    said = {**photo.graph.annotations, PLANTED: Ground(("v8",))}
    solution = solve(replace(photo.graph, annotations=said))
    assert solution.report.conflicts[0] == PLANTED


@pytest.mark.parametrize("seed", range(4))
def test_boxes_wrongly_said_to_be_parallel_are_told(seed):
    photo = photograph(two_boxes(), np.random.default_rng(seed), noise=0.003)
    solution = solve(with_planted(photo, Parallel(("e0", "e12"))))
    assert PLANTED in solution.report.conflicts[:3]


def test_an_exact_drawing_of_something_else_is_no_leaning_hand():
    steps = prism(
        "steps",
        [(0, 0), (230, 0), (230, 40), (150, 40), (150, 95), (60, 95), (60, 160), (0, 160)],
        120,
    )
    named = 0
    for seed in range(6):
        graph = planted(
            photograph(steps, np.random.default_rng(seed)),
            np.random.default_rng(seed),
            "equal_length",
        )
        named += solve(graph).report.conflicts[:1] == (PLANTED,)
    assert named >= 5
