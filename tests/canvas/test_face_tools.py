"""Leaving faces out and making them thick, by clicks in their middles."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from incontext.solver import load_sketch, solve
from incontext.solver.graph import Face
from incontext.tests.canvas.test_tools import Hand
from incontext.tests.test_symmetry import half_of_a_box
from incontext.workbench.canvas.questions import About
from incontext.workbench.canvas.solved import Solved

SHELF = Path(__file__).parent.parent / "data" / "shelf.sketch.json"


@pytest.fixture(scope="module")
def shelf():
    return replace(load_sketch(SHELF), faces=None)


@pytest.fixture(scope="module")
def solved(shelf):
    return Solved(shelf, solve(shelf))


def hand_with(graph, solved, tool):
    hand = Hand(graph, tool)
    hand.drawing.set_solved(solved)
    return hand


def click(hand, loop):
    hand.click(*np.mean([hand.graph.vertices[v] for v in loop], axis=0))


FRONT = ("v0", "v1", "v5", "v4")


def test_faces_wait_for_a_solution(shelf):
    hand = hand_with(shelf, None, "leave_out")
    assert "solved" in hand.drawing.tool.hint
    click(hand, FRONT)
    assert hand.words == []


def test_a_click_in_a_face_leaves_it_out_and_another_takes_it_back(shelf, solved):
    hand = hand_with(shelf, solved, "leave_out")
    click(hand, FRONT)
    (front,) = [f for f in hand.graph.faces.values() if not f.included]
    assert set(front.loop) == set(FRONT)
    assert len(hand.graph.faces) == len(solved.solution.faces)
    assert hand.drawing.preview.areas
    click(hand, FRONT)
    assert all(f.included for f in hand.graph.faces.values())
    assert hand.words == ["Leave face out", "Include face"]


def test_a_loop_that_is_not_listed_is_listed_by_a_click(shelf, solved):
    fewer = replace(shelf, faces={"f1": Face(FRONT)})
    hand = hand_with(fewer, solved, "leave_out")
    click(hand, ("v2", "v3", "v7", "v6"))
    assert {frozenset(f.loop) for f in hand.graph.faces.values()} == {
        frozenset(FRONT),
        frozenset(("v2", "v3", "v7", "v6")),
    }
    assert hand.words == ["Include face"]


def test_thickness_is_asked_for_in_the_middle_of_a_face(shelf, solved):
    hand = hand_with(shelf, solved, "thickness")
    click(hand, FRONT)
    (question,) = hand.asked
    assert (question.about, question.said_mm) == (About.FACE, None)
    hand.drawing.answer(question, 6.0)
    assert hand.graph.faces[question.target].thickness_mm == 6.0
    hand.drawing.move(hand.at(*np.mean([shelf.vertices[v] for v in FRONT], axis=0)))
    click(hand, FRONT)
    assert hand.asked[1].said_mm == 6.0
    hand.drawing.answer(hand.asked[1], None)
    assert hand.graph.faces[question.target].thickness_mm is None
    assert hand.words == ["Set thickness", "Set thickness"]


def test_faces_stay_to_be_clicked_while_the_drawing_goes_on(shelf, solved):
    hand = hand_with(shelf, solved, "select")
    hand.click(*shelf.vertices["v9"])
    hand.drawing.delete()
    hand.drawing.use("leave_out")
    click(hand, FRONT)
    assert "v9" not in {v for f in hand.graph.faces.values() for v in f.loop}


@pytest.fixture(scope="module")
def half():
    graph = replace(half_of_a_box()[0], faces=None)
    return graph, Solved(graph, solve(graph))


def click_mirrored(hand, solved, loop):
    hand.click(*np.mean([solved.seen[v] for v in loop], axis=0))


def test_a_half_drawn_face_is_clicked_where_it_is_seen(half):
    graph, solved = half
    (back,) = [f.loop for f in solved.found.values() if any("@" in v for v in f.loop)]
    hand = hand_with(graph, solved, "leave_out")
    click_mirrored(hand, solved, back)
    assert hand.words == ["Leave face out"]
    assert [set(f.loop) for f in hand.graph.faces.values() if not f.included] == [set(back)]
    assert len(hand.graph.faces) == 4
    assert hand.drawing.preview.areas
    click_mirrored(hand, solved, back)
    assert all(f.included for f in hand.graph.faces.values())
    hand.drawing.use("thickness")
    click_mirrored(hand, solved, back)
    hand.drawing.answer(hand.asked[0], 6.0)
    assert [set(f.loop) for f in hand.graph.faces.values() if f.thickness_mm] == [set(back)]


def test_the_mirror_image_of_a_listed_face_is_a_face_of_its_own(half):
    graph, solved = half
    listed = replace(graph, faces={"f2": Face(("v0", "v1", "v5", "v4"))})
    solved = Solved(listed, solve(listed))
    (copy,) = [f for id_, f in solved.found.items() if id_ == "f2@mirror"]
    hand = hand_with(listed, solved, "leave_out")
    click_mirrored(hand, solved, copy.loop)
    assert hand.words == ["Leave face out"]
    assert {id_: f.included for id_, f in hand.graph.faces.items()} == {
        "f2": True,
        "f2@mirror": False,
    }


def test_vertices_touch_drawn_faces_only(half):
    graph, solved = half
    hand = hand_with(graph, solved, "on_face")
    hand.click(*graph.vertices["v5"])
    (back,) = [f.loop for f in solved.found.values() if any("@" in v for v in f.loop)]
    assert set(back) not in [set(f.loop) for f in hand.drawing.tool._faces().values()]


def test_what_is_said_of_a_half_drawn_face_is_painted_where_it_is_seen(half):
    from incontext.workbench.canvas.lifted import lifted_view
    from incontext.workbench.canvas.scene import Scene

    graph, solved = half
    view = lifted_view(solved.solution)
    assert view.mirrored.keys() == {"v5@mirror"}
    scene = Scene(graph, None, dict(graph.vertices), mirrored=view.mirrored)
    assert scene.outline(("v2", "v5@mirror"))[1] == pytest.approx(solved.seen["v5@mirror"])
    assert scene.outline(("v2", "v7@mirror")) == ()
