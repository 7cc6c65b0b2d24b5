"""The camera tool: what it asks for, and what it leaves alone."""

from __future__ import annotations

import pytest

from incontext.solver.camera import Camera
from incontext.solver.graph import SketchGraph
from incontext.workbench.canvas.attraction import Attraction
from incontext.workbench.canvas.drawing import Listener
from incontext.workbench.canvas.questions import KnownRectangle
from incontext.workbench.canvas.solved import Solved
from incontext.workbench.canvas.tool_at_work import ToolAtWork
from incontext.workbench.canvas.tools.base import Pointer

CORNERS = ((100.0, 300.0), (300.0, 310.0), (260.0, 200.0), (120.0, 195.0))
REACH = 8.0


class Hand:
    """A drawing with the camera tool, and what was told of rectangles."""

    def __init__(self, rectangle=None):
        self.told, self.edits = [], []
        listener = Listener(
            edited=lambda *edit: self.edits.append(edit), rectangle_told=self.told.append
        )
        self.drawing = ToolAtWork(SketchGraph(vertices={"v1": (5.0, 5.0)}), listener)
        self.drawing.set_rectangle(rectangle)
        self.drawing.use("camera")

    def click(self, u, v):
        pointer = Pointer((u, v), REACH)
        self.drawing.press(pointer)
        self.drawing.release(pointer)

    def drag(self, start, end):
        self.drawing.press(Pointer(start, REACH))
        self.drawing.move(Pointer(end, REACH))
        self.drawing.release(Pointer(end, REACH))


def test_four_clicks_tell_a_rectangle_once_the_button_is_up():
    hand = Hand()
    hints = [hand.drawing.tool.hint]
    for corner in CORNERS[:3]:
        hand.click(*corner)
        hints.append(hand.drawing.tool.hint)
    assert len(set(hints)) == 4
    assert len(hand.drawing.preview.grips) == 3
    hand.drawing.press(Pointer(CORNERS[3], REACH))
    assert hand.told == []
    hand.drawing.release(Pointer(CORNERS[3], REACH))
    assert hand.told == [KnownRectangle(CORNERS)]
    assert hand.drawing.preview.grips == ()
    assert not hand.edits


def test_a_second_click_at_one_place_is_none():
    hand = Hand()
    hand.click(*CORNERS[0])
    hand.click(CORNERS[0][0] + 1, CORNERS[0][1])
    assert len(hand.drawing.preview.grips) == 1


def test_escape_gives_up_the_corners_and_then_the_tool():
    hand = Hand()
    hand.click(*CORNERS[0])
    hand.drawing.escape()
    assert hand.drawing.tool.NAME == "camera"
    assert hand.drawing.preview.grips == ()
    hand.drawing.escape()
    assert hand.drawing.tool.NAME == "select"


def test_the_key_again_looks_for_the_printed_marker():
    hand = Hand()
    hand.click(*CORNERS[0])
    hand.drawing.use("camera")
    assert hand.told == [None]
    assert hand.drawing.preview.grips == ()


def test_a_known_corner_is_dragged_and_keeps_the_size():
    hand = Hand(KnownRectangle(CORNERS, (100.0, 80.0)))
    assert hand.drawing.preview.grips == CORNERS
    hand.drag((302.0, 309.0), (330.0, 320.0))
    moved = (CORNERS[0], (330.0, 320.0), *CORNERS[2:])
    assert hand.told == [KnownRectangle(moved, (100.0, 80.0))]


def test_a_trembling_hand_moves_no_corner():
    hand = Hand(KnownRectangle(CORNERS, (100.0, 80.0)))
    hand.drag(CORNERS[1], (CORNERS[1][0] + 1, CORNERS[1][1]))
    assert hand.told == []


def test_delete_forgets_the_camera_and_nothing_drawn():
    hand = Hand(KnownRectangle(CORNERS, (100.0, 80.0)))
    hand.drawing.delete()
    assert hand.told == [KnownRectangle(())]
    assert not hand.edits
    without = Hand()
    without.drawing.delete()
    assert without.told == []


def camera(height_mm):
    turn = [[1.0, 0.0, 0.0], [0.0, -0.6, -0.8], [0.0, 0.8, -0.6]]
    shift = [0.0, 0.8 * height_mm, 0.6 * height_mm]
    return Camera(800.0, [400.0, 300.0], turn, shift)


@pytest.mark.parametrize("known", [None, camera(500.0)])
def test_the_grid_is_that_of_the_camera_known_now(known):
    """The last solution may be of another one."""
    from incontext.solver.solution import Solution, Status

    attraction = Attraction()
    attraction.grid_shown = True
    graph = SketchGraph(camera=known)
    old = camera(300.0)
    solved = Solved(SketchGraph(), Solution("", Status.CONVERGED, "", camera=old))
    grid = attraction.grid(graph, solved)
    assert grid.camera is (old if known is None else known)
