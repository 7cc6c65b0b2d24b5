"""Numbers left at each vertex, annotations that follow from others, standard errors."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scenes import LID, SHAPES, bookshelf, box, l_shape, photograph, photograph_turned

from incontext.solver import parameter_counts, redundant_annotations, solve
from incontext.solver.annotations import Length
from incontext.solver.solution import Status
from incontext.solver.structure import build_structure
from incontext.solver.synthetic import Hand

NAMES = [make().name for make in SHAPES]


def sketch(shape, seed=0, **how):
    return photograph(shape, np.random.default_rng(seed), **how).graph


def test_the_l_needs_8_numbers_where_the_paper_needs_18():
    # Three widths, three heights and two depths tell all of it.
    counts = parameter_counts(sketch(l_shape()))
    assert (counts.before, counts.after) == (36, 8)
    assert set(counts.of_vertex.values()) <= {0, 1, 2, 3}


@pytest.mark.parametrize("make", SHAPES, ids=NAMES)
def test_counts_add_up_to_the_shared_coordinates(make):
    graph = sketch(make())
    counts = parameter_counts(graph)
    assert sum(counts.of_vertex.values()) == counts.after
    assert counts.after == build_structure(graph).n_coordinates


def test_without_annotations_every_vertex_has_three():
    counts = parameter_counts(replace(sketch(box()), annotations={}))
    assert set(counts.of_vertex.values()) == {3}
    assert counts.before == counts.after == 24


def test_circles_count_their_radius_and_profiles_nothing():
    graph, _ = photograph_turned(LID, np.random.default_rng(0))
    counts = parameter_counts(graph)
    # One axis: x and y once, three heights, three radii.
    assert counts.after == 8
    assert set(counts.of_vertex.values()) == {0}


def test_annotations_that_follow_from_others_leave_the_shape_as_it_is():
    graph = sketch(bookshelf())
    redundant = redundant_annotations(graph, solve(graph))
    assert len(redundant) > 10
    assert "length" not in redundant
    for id_ in redundant[:3]:
        rest = {k: a for k, a in graph.annotations.items() if k != id_}
        without = build_structure(replace(graph, annotations=rest))
        assert without.n_coordinates == build_structure(graph).n_coordinates


def test_what_alone_says_something_is_not_redundant():
    shape = box()
    said = {**shape.annotations, "deep": Length("e1", 150.0), "again": Length("e3", 150.0)}
    graph = sketch(replace(shape, annotations=said))
    redundant = redundant_annotations(graph, solve(graph))
    assert {"deep", "again"} <= set(redundant)
    only = replace(graph, annotations={k: a for k, a in said.items() if k != "again"})
    assert "deep" not in redundant_annotations(only, solve(only))


def test_standard_errors_are_about_the_errors():
    ratios = []
    for seed, make in enumerate([*SHAPES[:3], *SHAPES[4:8]] * 4):
        photo = photograph(make(), np.random.default_rng(seed), noise=0.01)
        solution = solve(photo.graph)
        ends = np.array(photo.shape.edges)
        true = np.linalg.norm(photo.shape.X[ends[:, 1]] - photo.shape.X[ends[:, 0]], axis=1)
        at = solution.vertices_mm
        found = [float(np.linalg.norm(at[w] - at[v])) for v, w in photo.graph.edges.values()]
        off = np.log(np.array(found) / true)
        sigma = np.array([solution.report.size_sigma[e] for e in photo.graph.edges])
        ratios.append(np.sqrt(np.mean((off - off.mean()) ** 2) / np.mean(sigma**2)))
    assert 0.6 < np.sqrt(np.mean(np.square(ratios))) < 1.6


def test_shapes_that_are_far_off_are_marked_as_unsure():
    unsure = 0
    for seed in range(40):
        hand = Hand(0.03, (3.0, 10.0), 0.05)
        photo = photograph(SHAPES[seed % 6](), np.random.default_rng(seed), hand=hand)
        solution = solve(photo.graph)
        unsure += solution.report.unsure
        if solution.status is Status.CONVERGED and not solution.report.unsure:
            assert photo.error(solution.vertices_mm) < 0.25
        if solution.report.unsure and solution.report.conflicts == ():
            assert "unsure" in solution.message or solution.status is not Status.CONVERGED
    assert 0 < unsure < 40


def test_a_plain_drawing_is_not_marked_as_unsure():
    solution = solve(sketch(bookshelf(), noise=0.005))
    assert not solution.report.unsure
    assert solution.message == "Solved."
