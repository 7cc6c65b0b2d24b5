"""Vertices on faces that only the solve finds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scenes import box, from_loops, photograph, v

from incontext.solver import begin_drag, drag, solve
from incontext.solver.annotations import Ground, Length, OnFace, Parallel
from incontext.solver.solution import Status
from incontext.solver.synthetic.shapes import BOX_LOOPS


def box_with_a_label():
    """A box, and a rectangle on its front, which nothing but `on_face` holds there."""
    X = [[x, y, z] for z in (0, 120) for x, y in ((0, 0), (200, 0), (200, 150), (0, 150))]
    X += [[x, 0, z] for x, z in ((60, 40), (140, 40), (140, 80), (60, 80))]
    shape = from_loops("label", X, [*BOX_LOOPS, (8, 9, 10, 11)])
    edge = {pair: f"e{k}" for k, pair in enumerate(shape.edges)}
    more = {
        "ground": Ground(tuple(v(i) for i in range(4))),
        "level": Parallel((edge[0, 1], edge[8, 9])),
        "upright": Parallel((edge[0, 4], edge[9, 10])),
    }
    return replace(shape, annotations={**shape.annotations, **more})


def drawn(noise=0.0, **more):
    graph = photograph(box_with_a_label(), np.random.default_rng(3), noise=noise).graph
    return replace(graph, annotations={**graph.annotations, **more})


def front_of(solution):
    front = {v(0), v(1), v(5), v(4)}
    return next(id_ for id_, face in solution.faces.items() if set(face.loop) == front)


def test_the_face_is_found_first_and_then_holds_the_vertex():
    loose = solve(drawn(noise=0.003))
    assert loose.status is Status.UNDERDETERMINED
    front = front_of(loose)
    graph = drawn(noise=0.003, on=OnFace(v(8), front))
    solution = solve(graph)
    assert solution.status is Status.CONVERGED, solution.message
    assert solution.sketch_digest == graph.digest
    assert solution.report.residuals["on"].value < 1e-9
    assert front_of(solution) == front


def test_ids_of_faces_stay_and_new_faces_get_new_ones():
    before = solve(drawn())
    after = solve(drawn(on=OnFace(v(8), front_of(before))))
    for id_, face in before.faces.items():
        assert set(after.faces[id_].loop) == set(face.loop)
    # The label lies in the front now: a hole of it.
    assert len(after.faces[front_of(before)].holes) == 1


def test_a_face_that_is_not_found_is_told():
    solution = solve(drawn(on=OnFace(v(8), "f99")))
    assert "No face was found for on: choose another one." in solution.message
    assert solution.status is Status.UNDERDETERMINED
    assert "on" not in solution.report.residuals


def test_a_face_that_is_not_found_is_no_success():
    graph = photograph(box(), np.random.default_rng(0)).graph
    solution = solve(replace(graph, annotations={**graph.annotations, "on": OnFace("v6", "f99")}))
    assert solution.status is Status.CONFLICTING
    assert solution.report.conflicts == ("on",)
    assert solution.message == "No face was found for on: choose another one."


def test_it_holds_while_a_vertex_is_dragged():
    graph = drawn(on=OnFace(v(8), front_of(solve(drawn()))))
    at = begin_drag(graph)
    x, y = graph.vertices[v(10)]
    moved = replace(graph, vertices={**graph.vertices, v(10): (x + 6.0, y - 4.0)})
    solution = drag(at, moved).solution
    front = np.array([solution.vertices_mm[v(i)] for i in (0, 1, 4)])
    normal = np.cross(front[1] - front[0], front[2] - front[0])
    normal /= np.linalg.norm(normal)
    assert abs((solution.vertices_mm[v(8)] - front[0]) @ normal) < 1e-9


@pytest.mark.parametrize("length", [80.0, 77.0])
def test_a_length_on_the_face_is_held_too(length):
    graph = drawn(on=OnFace(v(8), front_of(solve(drawn()))))
    edge = next(e for e, ends in graph.edges.items() if set(ends) == {v(8), v(9)})
    graph = replace(graph, annotations={**graph.annotations, "wide": Length(edge, length)})
    solution = solve(graph)
    wide = np.linalg.norm(solution.vertices_mm[v(9)] - solution.vertices_mm[v(8)])
    assert wide == pytest.approx(length, abs=1e-6)
    assert solution.report.residuals["on"].value < 1e-6
