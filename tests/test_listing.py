"""Faces that a sketch lists: made of those found, left out, added to as the drawing grows."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scenes import box, photograph

from incontext.solver import SketchError, solve
from incontext.solver.annotations import OnFace, Parallel, RightAngle
from incontext.solver.editing.annotating import annotate
from incontext.solver.editing.elements import add_edge, add_vertex, delete, split_edge
from incontext.solver.editing.listing import (
    Choice,
    choices,
    found_faces,
    set_included,
    set_thickness,
    with_new_faces,
)

FRONT = ("v0", "v1", "v5", "v4")


@pytest.fixture(scope="module")
def photo():
    """A box photographed, its hidden edges drawn, no faces listed."""
    return photograph(box(200, 150, 120), np.random.default_rng(1))


@pytest.fixture(scope="module")
def empty(photo):
    return replace(photo.graph, faces=None)


def face_of(faces, *vertices):
    """The id of the face on some vertices."""
    (id_,) = [id_ for id_, face in faces.items() if set(face.loop) == set(vertices)]
    return id_


def said(graph, id_, **changes):
    solution = solve(graph)
    choice = Choice(id_, found_faces(graph, solution), solution.vertices_mm)
    for name, value in changes.items():
        graph = {"included": set_included, "thickness_mm": set_thickness}[name](
            graph, choice, value
        )
    return graph


def with_a_shelf(photo, graph):
    """Half way up, its corners on the uprights, as a hand draws it."""
    loop = []
    for low, high in (("v0", "v4"), ("v1", "v5"), ("v2", "v6"), ("v3", "v7")):
        ends = [photo.shape.X[int(v[1:])] for v in (low, high)]
        (place,) = photo.camera.project(np.mean(ends, axis=0))
        graph, middle = split_edge(graph, graph.edge_between(low, high), tuple(place))
        loop.append(middle)
    edges = []
    for v, w in zip(loop, loop[1:] + loop[:1], strict=True):
        graph, edge = add_edge(graph, v, w)
        edges.append(edge)
    for k, v in enumerate(loop):
        graph, _ = annotate(graph, RightAngle(v, (edges[k - 1], edges[k])))
        upright = graph.edge_between(v, f"v{k}")
        graph, _ = annotate(graph, RightAngle(v, (upright, edges[k])))
    return graph, loop


def grown(before, after):
    return with_new_faces((before, solve(before)), (after, solve(after)))


def test_leaving_one_out_lists_all(empty):
    faces = solve(empty).faces
    front = face_of(faces, *FRONT)
    listed = said(empty, front, included=False)
    assert {id_: f.loop for id_, f in listed.faces.items()} == {
        id_: f.loop for id_, f in faces.items()
    }
    assert [id_ for id_, face in listed.faces.items() if not face.included] == [front]
    thick = said(listed, front, thickness_mm=6.0)
    assert (thick.faces[front].thickness_mm, thick.faces[front].included) == (6.0, False)
    assert said(thick, front, thickness_mm=None).faces == listed.faces


def test_what_is_no_face_and_no_thickness_is_refused(empty):
    with pytest.raises(SketchError, match="no such"):
        said(empty, "f99", included=False)
    for bad in (0.0, -3.0, float("inf"), float("nan")):
        with pytest.raises(SketchError, match="thickness"):
            said(empty, "f1", thickness_mm=bad)


def test_a_shelf_drawn_later_becomes_a_face_and_the_open_front_stays_open(photo, empty):
    before = said(empty, face_of(solve(empty).faces, *FRONT), included=False)
    drawn, shelf = with_a_shelf(photo, before)
    after = grown(before, drawn)
    new = face_of(after.faces, *shelf)
    assert set(after.faces) == {*before.faces, new}
    assert after.faces[new].included
    assert grown(after, after) == after


def test_a_part_of_a_face_can_be_closed_again(photo, empty):
    before = said(empty, face_of(solve(empty).faces, *FRONT), included=False)
    drawn, shelf = with_a_shelf(photo, before)
    after = grown(before, drawn)
    front = next(id_ for id_, face in after.faces.items() if not face.included)
    lower = {"v0", "v1", shelf[0], shelf[1]}
    solution = solve(after)
    part = face_of(choices(after, found_faces(after, solution)), *lower)
    closed = said(after, part, included=True)
    assert len(closed.faces) == len(after.faces) + 1
    assert not closed.faces[front].included
    assert set(closed.faces[front].loop) == {"v4", "v5", shelf[0], shelf[1]}
    assert closed.faces[face_of(closed.faces, *lower)].included


def test_a_shelf_that_is_taken_away_leaves_whole_walls_and_the_front_open(photo, empty):
    drawn, shelf = with_a_shelf(photo, empty)
    lower, upper = {"v0", "v1", *shelf[:2]}, {"v4", "v5", *shelf[:2]}
    before = drawn
    for part in (lower, upper):
        before = said(before, face_of(solve(before).faces, *part), included=False)
    wall = {"v2", "v3", *shelf[2:]}
    before = said(before, face_of(before.faces, *wall), thickness_mm=6.0)
    board = [before.edge_between(*pair) for pair in pairwise((*shelf, shelf[0]))]
    after = grown(before, delete(before, edges=board))
    assert len(after.faces) == 6
    assert set(after.faces) & set(before.faces)
    (front,) = [face for face in after.faces.values() if not face.included]
    assert set(front.loop) == lower | upper
    (thick,) = [face for face in after.faces.values() if face.thickness_mm]
    assert set(thick.loop) == {"v2", "v3", "v6", "v7", *shelf[2:]}


def test_a_window_in_a_wall_can_be_left_out(photo, empty):
    before = said(empty, face_of(solve(empty).faces, *FRONT), thickness_mm=5.0)
    graph, loop, edges = before, [], []
    low, high = photo.shape.X[0], photo.shape.X[5]
    for s, t in ((0.3, 0.3), (0.7, 0.3), (0.7, 0.7), (0.3, 0.7)):
        place = low + (high - low) * np.array([s, 0, t])
        graph, v = add_vertex(graph, tuple(photo.camera.project(place)[0]))
        loop.append(v)
    for v, w in zip(loop, loop[1:] + loop[:1], strict=True):
        graph, edge = add_edge(graph, v, w)
        edges.append(edge)
    front = face_of(before.faces, *FRONT)
    for v in loop:
        graph, _ = annotate(graph, OnFace(v, front))
    bottom, upright = graph.edge_between("v0", "v1"), graph.edge_between("v0", "v4")
    graph, _ = annotate(graph, Parallel((bottom, edges[0], edges[2])))
    graph, _ = annotate(graph, Parallel((upright, edges[1], edges[3])))
    graph = grown(before, graph)
    assert set(graph.faces) == set(before.faces)
    solution = solve(graph)
    assert solution.status.value == "converged", solution.message
    window = face_of(choices(graph, found_faces(graph, solution)), *loop)
    open_ = said(graph, window, included=False)
    assert [set(hole) for hole in open_.faces[front].holes] == [set(loop)]
    assert open_.faces[front].thickness_mm == 5.0
    assert not open_.faces[window].included


def test_a_face_is_new_where_nothing_was_solved_before(photo, empty):
    before = said(empty, face_of(solve(empty).faces, *FRONT), included=False)
    drawn, shelf = with_a_shelf(photo, before)
    after = with_new_faces((before, None), (drawn, solve(drawn)))
    assert set(after.faces) - set(before.faces) == {face_of(after.faces, *shelf)}


def test_nothing_is_listed_where_nothing_was(photo, empty):
    drawn, _ = with_a_shelf(photo, empty)
    assert grown(empty, drawn).faces is None


def test_faces_that_a_file_does_not_list_stay_unlisted(photo, empty):
    listed = said(empty, "f1", included=True)
    fewer = replace(listed, faces={id_: listed.faces[id_] for id_ in list(listed.faces)[:3]})
    moved = replace(fewer, vertices={**fewer.vertices, "v0": fewer.vertices["v0"]})
    assert grown(fewer, moved).faces == fewer.faces
