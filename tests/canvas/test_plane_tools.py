"""Rectangles in perspective, squares, symmetry planes, faces that are touched: by gestures."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from incontext.solver import load_sketch, solve
from incontext.solver.annotations import EqualLength, Ground, OnFace, SymmetryPlane
from incontext.solver.camera import Camera
from incontext.solver.graph import Photo, SketchGraph
from incontext.solver.synthetic import box
from incontext.tests.canvas.test_tools import SQUARE, Hand
from incontext.workbench.canvas.perspective import on_plane
from incontext.workbench.canvas.plane import middle
from incontext.workbench.canvas.solved import Solved
from incontext.workbench.canvas.symmetry import outline_of
from incontext.workbench.canvas.tools.base import Pointer
from incontext.workbench.canvas.tools.box import hidden_corner

SHELF = Path(__file__).parent.parent / "data" / "shelf.sketch.json"


@pytest.fixture(scope="module")
def shelf():
    return load_sketch(SHELF)


@pytest.fixture(scope="module")
def solved(shelf):
    return Solved(shelf, solve(shelf))


def hand_with(graph, solved, tool):
    hand = Hand(graph, tool)
    hand.drawing.set_solved(solved)
    return hand


def on_photo(solved, *point_mm):
    return solved.on_photo([np.array(point_mm)])[0]


def in_space(solved, hand, vertices):
    """The vertices of a rectangle on the ground, from where they are drawn."""
    camera, up = solved.solution.camera, np.array([0, 0, 1.0])
    places = [hand.graph.vertices[v] for v in vertices]
    return np.array([on_plane(camera, place, np.zeros(3), up) for place in places])


def test_a_square_has_equal_sides_in_the_photo_and_says_so():
    hand = Hand(SketchGraph(), "square")
    hand.drag((10, 10), (110, 60))
    assert set(hand.graph.vertices.values()) == {(10, 10), (110, 10), (110, 110), (10, 110)}
    assert [type(a) for a in hand.graph.annotations.values()].count(EqualLength) == 1
    assert hand.words == ["Draw square"]


def test_a_rectangle_on_the_ground_follows_the_perspective(shelf, solved):
    hand = hand_with(shelf, solved, "rectangle")
    assert "level" in hand.drawing.tool.hint
    hand.drag(on_photo(solved, -200, -200, 0), on_photo(solved, -80, -150, 0))
    new = [v for v in hand.graph.vertices if v not in shelf.vertices]
    X = in_space(solved, hand, new)
    assert sorted(np.ptp(X, axis=0)) == pytest.approx([0, 50, 120], abs=0.5)
    (ground,) = [a for a in hand.graph.annotations.values() if isinstance(a, Ground)]
    assert set(new) <= set(ground.vertices)
    assert len(hand.graph.annotations_of("right_angle")) == 4 + len(
        shelf.annotations_of("right_angle")
    )


def test_a_square_on_the_ground_is_one_in_space(shelf, solved):
    hand = hand_with(shelf, solved, "square")
    hand.drag(on_photo(solved, -200, -200, 0), on_photo(solved, -80, -150, 0))
    X = in_space(solved, hand, [v for v in hand.graph.vertices if v not in shelf.vertices])
    assert np.ptp(X, axis=0) == pytest.approx([120, 120, 0], abs=0.5)


def test_the_key_turns_the_rectangle_upright_and_back_to_the_photo(shelf, solved):
    hand = hand_with(shelf, solved, "rectangle")
    corner = solved.solution.vertices_mm["v0"]
    hints = []
    for axes in ((0, 2), (1, 2)):
        hand.drawing.use("rectangle")
        hints.append(hand.drawing.tool.hint)
        there = corner.copy()
        there[list(axes)] += (-40, 60)
        hand.drawing.press(hand.at(*shelf.vertices["v0"]))
        hand.drawing.move(Pointer(on_photo(solved, *there), 8.0, is_free=True))
        (outline,) = hand.drawing.preview.strokes
        beside = corner.copy()
        beside[axes[0]] -= 40
        assert outline[1] == pytest.approx(on_photo(solved, *beside), abs=0.1)
        hand.drawing.escape()
    hand.drawing.use("rectangle")
    hand.drag((10, 10), (110, 60))
    assert (110, 10) in hand.graph.vertices.values()
    assert len(set(hints)) == 2


def test_above_the_horizon_a_rectangle_lies_on_the_photo(shelf, solved):
    hand = hand_with(shelf, solved, "rectangle")
    hand.drag((100, -2000), (200, -1900))
    assert (200, -2000) in hand.graph.vertices.values()
    assert not [v for v in hand.graph.vertices.values() if not np.isfinite(v).all()]


def test_ground_by_an_edge_and_by_the_middle_of_a_face():
    hand = Hand(SQUARE, "ground")
    hand.click(150, 150)
    assert set(hand.graph.annotations["a1"].vertices) == set(SQUARE.vertices)
    hand.click(130, 100)
    assert set(hand.graph.annotations["a1"].vertices) == {"v3", "v4"}
    assert hand.words == ["Mark ground", "Mark ground"]


def test_symmetry_is_suggested_by_similar_slopes_and_taken_with_one_click():
    hand = Hand(SQUARE, "symmetry_plane")
    hand.drawing.move(hand.at(152, 103))
    assert hand.drawing.preview.lit.edges == {"e1", "e3"}
    assert hand.drawing.preview.guides
    hand.click(152, 103)
    assert hand.graph.annotations["a1"] == SymmetryPlane(("e1", "e3"))
    hand.click(152, 203)
    assert not hand.graph.annotations
    hand.click(130, 130)
    assert hand.words == ["Mark symmetry plane", "Remove symmetry plane"]


def test_symmetry_is_picked_middle_by_middle():
    hand = Hand(SQUARE, "symmetry_plane")
    for place in ((150, 100), (100, 150), (150, 200)):
        hand.click(*place, adding=True)
    hand.click(100, 150)
    assert hand.words == []
    hand.drawing.enter()
    assert hand.graph.annotations["a1"] == SymmetryPlane(("e1", "e3"))
    hand.click(150, 100, adding=True)
    hand.drawing.escape()
    assert hand.drawing.tool.NAME == "symmetry_plane"
    hand.drawing.enter()
    assert len(hand.words) == 1


def test_once_solved_the_plane_takes_the_edges_that_it_halves(shelf, solved):
    hand = hand_with(shelf, solved, "symmetry_plane")
    edge = shelf.edge_between("v0", "v1")
    hand.drawing.move(hand.at(*middle([shelf.vertices[v] for v in ("v0", "v1")])))
    at, ends = solved.solution.vertices_mm, shelf.edges
    across = at["v1"] - at["v0"]
    parallel = {
        e
        for e, (v, w) in ends.items()
        if np.linalg.norm(np.cross(at[w] - at[v], across)) < 1e-6 * np.linalg.norm(across) ** 2
    }
    assert hand.drawing.preview.lit.edges == parallel
    assert edge in parallel
    assert len(parallel) == 6


def test_the_outline_of_a_plane_goes_around_its_points():
    corners = [(0, 0), (10, 0), (10, 10), (0, 10)]
    around = outline_of([*corners, (5, 5), (5, 0)])
    assert set(around) == set(corners)
    assert around[0] == around[-1]
    assert outline_of([(3, 3), (1, 1)]) == ((1, 1), (3, 3))


def test_a_vertex_touches_a_face_by_two_clicks(shelf, solved):
    graph = replace(shelf, faces=None)
    hand = hand_with(graph, Solved(graph, solve(graph)), "on_face")
    front = ("v0", "v1", "v5", "v4")
    hand.click(*graph.vertices["v10"])
    assert "middle of the face" in hand.drawing.tool.hint
    hand.drawing.move(hand.at(*middle([graph.vertices[v] for v in front])))
    assert hand.drawing.preview.areas
    hand.click(*middle([graph.vertices[v] for v in front]))
    ((id_, said),) = hand.graph.annotations_of("on_face").items()
    assert said == OnFace("v10", said.face)
    assert set(hand.graph.faces[said.face].loop) == set(front)
    hand.click(*graph.vertices["v10"])
    hand.click(*middle([graph.vertices[v] for v in front]))
    assert id_ not in hand.graph.annotations
    hand.click(*graph.vertices["v10"])
    hand.drawing.escape()
    assert hand.drawing.tool.NAME == "on_face"
    assert hand.words == ["Mark on face", "Remove on face"]


def test_a_vertex_touches_no_face_of_its_own(shelf, solved):
    hand = hand_with(shelf, solved, "on_face")
    front = ("v0", "v1", "v5", "v4")
    hand.click(*shelf.vertices["v0"])
    hand.drawing.move(hand.at(*middle([shelf.vertices[v] for v in front])))
    areas = hand.drawing.preview.areas
    assert not any(shelf.vertices["v0"] in area for area in areas)


#: Left, front and right on the ground, above them from right to left, the back above; hidden.
BOX_CORNERS = ("v3", "v0", "v1", "v5", "v4", "v7", "v6", "v2")


def test_a_box_by_its_seven_corners_is_solved_to_its_true_proportions():
    camera = looking_at_a_corner()
    X = box(200, 150, 120).X
    places = {f"v{k}": tuple(place) for k, place in enumerate(camera.project(X))}
    hand = Hand(SketchGraph(photo=Photo(None, 1600, 1200)), "box")
    for name in BOX_CORNERS[:7]:
        hand.drawing.move(hand.at(*places[name]))
        assert hand.drawing.preview is not None
        hand.click(*places[name])
    assert hand.words == ["Draw box"]
    assert hand.graph.vertices["v8"] == pytest.approx(places["v2"], abs=0.1)
    assert len(hand.drawing.selection.edges) == 12
    hand.drawing.toggle_construction()
    assert len(hand.graph.construction) == 12
    solution = solve(hand.graph)
    assert solution.status.value == "converged", solution.message
    size = np.ptp(np.array(list(solution.vertices_mm.values())), axis=0)
    assert sorted(size / size.max()) == pytest.approx([120 / 200, 150 / 200, 1], rel=1e-3)


def looking_at_a_corner():
    eye, target = np.array([-250.0, -500.0, 400.0]), np.array([100.0, 75.0, 40.0])
    forward = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(forward, (0.0, 0.0, 1.0))
    right /= np.linalg.norm(right)
    turn = np.array([right, np.cross(forward, right), forward])
    return Camera(1500.0, np.array([800.0, 600.0]), turn, -turn @ eye)


def test_a_box_is_given_up_by_escape_and_slips_do_not_count():
    hand = Hand(SketchGraph(), "box")
    hand.click(10, 100)
    hand.click(11, 101)
    hand.click(60, 130)
    assert "right corner" in hand.drawing.tool.hint
    hand.drawing.escape()
    assert "left corner" in hand.drawing.tool.hint
    assert hand.words == []


def test_the_hidden_corner_of_a_box_without_perspective():
    seen = [(0, 50), (40, 70), (90, 50), (90, 10), (40, 30), (0, 10), (50, -10)]
    assert hidden_corner(seen) == pytest.approx((50, 30))
