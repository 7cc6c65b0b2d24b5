"""Where the keyboard's cursor goes: each tool stops where it can be pointed at."""

import pytest

from incontext.solver.annotations import RightAngle
from incontext.solver.graph import SketchGraph
from incontext.tests.canvas.test_said import EVERYTHING
from incontext.tests.canvas.test_tools import SQUARE, Hand
from incontext.workbench.canvas import stops
from incontext.workbench.canvas.key_cursor import KeyCursor
from incontext.workbench.canvas.selection import Selection
from incontext.workbench.canvas.tools import TOOLS

#: Tools that draw need nothing below the cursor; those of faces need a solution.
POINTING = ("right_angle", "parallel", "equal_length", "ground", "symmetry_plane", "length")


@pytest.mark.parametrize("name", TOOLS)
def test_every_tool_has_stops_in_a_full_sketch(name):
    hand = Hand(EVERYTHING, name)
    places = hand.drawing.tool.stops(8.0)
    assert places
    assert Hand(SketchGraph(), name).drawing.tool.stops(8.0) == []


@pytest.mark.parametrize("name", POINTING)
def test_a_stop_is_where_a_press_would_take_something(name):
    for place in Hand(SQUARE, name).drawing.tool.stops(8.0):
        hand = Hand(SQUARE, name)
        hand.drawing.move(hand.at(*place))
        preview = hand.drawing.preview
        assert preview.lit or preview.corners, place


def test_corners_lie_inside_the_angles():
    assert sorted(stops.corners(SQUARE, 2**0.5 * 5)) == [
        pytest.approx(place) for place in ((105, 105), (105, 195), (195, 105), (195, 195))
    ]


def test_tab_goes_around_and_back():
    hand = Hand(SQUARE, "ground")
    cursor, pointer = KeyCursor(hand.drawing), hand.at(0, 0)
    seen = [cursor.go_on(1, pointer) for _ in range(6)]
    assert seen[0] == seen[5] == (150, 150)
    assert set(seen[1:5]) == set(SQUARE.vertices.values())
    assert cursor.go_on(-1, pointer) == seen[4]
    cursor.tool_changed()
    assert cursor.go_on(-1, pointer) == seen[4]


def test_tab_selects_one_after_the_other_when_selecting():
    hand = Hand(EVERYTHING)
    cursor, seen = KeyCursor(hand.drawing), []
    count = len(stops.everything(EVERYTHING))
    assert count == 4 + 4 + 1 + 8
    for _ in range(count):
        cursor.go_on(1, hand.at(0, 0))
        seen.append(hand.drawing.selection)
    assert len(set(seen)) == count
    assert seen[-1] == Selection(annotations=frozenset(("ground",)))
    cursor.go_on(-1, hand.at(0, 0))
    assert hand.drawing.selection == seen[-2]
    assert cursor.place_px is None


def test_steps_and_space_draw_a_line():
    hand = Hand(SketchGraph(), "line")
    cursor = KeyCursor(hand.drawing)
    for by_px in ((0, 0), (40, 8)):
        u, v = cursor.step(by_px, (20.0, 30.0), hand.at(0, 0))
        cursor.click(hand.at(u, v))
    assert set(hand.graph.vertices.values()) == {(20, 30), (60, 38)}
    assert cursor.hide()
    assert not cursor.hide()


def test_corner_stops_mark_right_angles():
    hand = Hand(SQUARE, "right_angle")
    cursor = KeyCursor(hand.drawing)
    for _ in range(2):
        place = cursor.go_on(1, hand.at(0, 0))
    cursor.click(hand.at(*place))
    assert [type(a) for a in hand.graph.annotations.values()] == [RightAngle]
