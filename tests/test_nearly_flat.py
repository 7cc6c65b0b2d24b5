"""Loops that look like faces and are none."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scenes import GABLES, SHAPES, loose_house, photograph, v

from incontext.solver import solve
from incontext.solver.editing.listing import with_flat_face
from incontext.solver.editing.nearly_flat import message_with_wanting_faces, nearly_flat
from incontext.solver.solution import Status


def is_gable(face):
    return frozenset(face.loop) in GABLES


def with_gables(graph, solution):
    for one in nearly_flat(graph, solution):
        graph = with_flat_face(graph, one.loop, solution.faces)
    return graph


def test_gables_that_nothing_holds_flat_are_no_faces_and_are_told():
    graph = loose_house(0.004, slope_told=True)
    solution = solve(graph)
    assert solution.status is Status.CONVERGED
    assert not any(map(is_gable, solution.faces.values()))
    near = nearly_flat(graph, solution)
    assert {frozenset(one.loop) for one in near} == set(GABLES)
    assert all(1e-3 < one.off_mm < 10 for one in near)
    message = message_with_wanting_faces(graph, solution)
    assert message.startswith(f"{solution.message} Not flat enough for a face: ")
    assert all(" ".join(one.loop) in message for one in near)


def test_exact_gables_are_faces():
    graph = loose_house(0.0, slope_told=True)
    solution = solve(graph)
    assert nearly_flat(graph, solution) == ()
    assert message_with_wanting_faces(graph, solution) == solution.message
    assert sum(map(is_gable, solution.faces.values())) == 2


@pytest.mark.parametrize("slope_told", [True, False])
def test_a_loop_that_is_listed_is_made_flat(slope_told):
    graph = loose_house(0.004, slope_told=slope_told)
    listed = with_gables(graph, solve(graph))
    assert sum(map(is_gable, listed.faces.values())) == 2
    after = solve(listed)
    assert after.status is Status.CONVERGED
    assert len(after.faces) == 7
    for face in after.faces.values():
        X = np.array([after.vertices_mm[vertex] for vertex in face.loop])
        assert np.linalg.svd(X - X.mean(axis=0))[1][-1] < 1e-9 * np.ptp(X)
    assert nearly_flat(listed, after) == ()
    assert with_gables(listed, after) is listed


def test_loops_of_loose_vertices_are_told_where_all_others_are_flat():
    graph = loose_house(0.004, slope_told=False)
    solution = solve(graph)
    assert (solution.status, solution.report.loose) == (Status.UNDERDETERMINED, (v(3), v(8)))
    near = nearly_flat(graph, solution)
    assert {frozenset(one.loop) for one in near} == set(GABLES)
    assert " ".join(near[0].loop) in message_with_wanting_faces(graph, solution)


@pytest.mark.parametrize("make", SHAPES)
@pytest.mark.parametrize("noise", [0.0, 0.01])
def test_nothing_looks_like_a_face_where_all_are_there(make, noise):
    shape = make()
    graph = photograph(shape, np.random.default_rng(7), noise=noise).graph
    assert nearly_flat(graph, solve(graph)) == ()


def test_left_out_faces_and_traced_loops_are_nothing_to_tell():
    graph = loose_house(0.004, slope_told=True)
    solution = solve(graph)
    assert nearly_flat(replace(graph, construction=tuple(graph.edges)), solution) == ()
    listed = with_gables(graph, solution)
    out = {id_: replace(face, included=False) for id_, face in listed.faces.items()}
    left_out = replace(listed, faces=out)
    assert nearly_flat(left_out, solve(left_out)) == ()
