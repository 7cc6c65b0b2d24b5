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


def test_faces_with_mirrored_corners_are_not_lost_in_a_list():
    graph, _ = half_of_a_box()
    graph = replace(graph, faces=None)
    solved = Solved(graph, solve(graph))
    assert any("@" in v for face in solved.found.values() for v in face.loop)
    hand = hand_with(graph, solved, "leave_out")
    assert "hidden edges" in hand.drawing.tool.hint
    for face in solved.solution.faces.values():
        if all(v in graph.vertices for v in face.loop):
            click(hand, face.loop)
    assert hand.words == []
