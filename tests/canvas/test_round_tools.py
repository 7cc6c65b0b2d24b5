"""Circles, their grips, and surfaces of revolution, by the gestures of a hand."""

import pytest

from incontext.solver.graph import SketchGraph
from incontext.tests.canvas.test_tools import SQUARE, Hand
from incontext.workbench.canvas.questions import About
from incontext.workbench.canvas.selection import Selection
from incontext.workbench.canvas.snapping import SnapKind


def circle_at(box, graph=None):
    hand = Hand(graph or SketchGraph(), "circle")
    hand.drag(*box)
    hand.drawing.use("select")
    return hand


def test_circle_by_drag_and_by_two_clicks():
    hand = Hand(SketchGraph(), "circle")
    hand.drag((10, 10), (110, 50))
    hand.click(200, 200)
    assert hand.drawing.preview.strokes == ()
    hand.drawing.move(hand.at(300, 240))
    assert hand.drawing.preview.strokes
    hand.click(300, 240)
    hand.drag((400, 400), (402, 480))
    assert hand.graph.circles["c1"].a == ((10, 30), (110, 30))
    assert list(hand.graph.circles) == ["c1", "c2"]
    assert hand.words == ["Draw circle", "Draw circle"]


def test_the_ellipse_meets_a_vertex_near_its_axis_end():
    hand = Hand(SQUARE, "circle")
    hand.drag((20, 80), (97, 116))
    assert hand.graph.circles["c1"].a == ((20, 100), (100, 100))
    hand.drag((160, 20), (236, 97))
    assert (200, 100) in hand.graph.circles["c2"].a + hand.graph.circles["c2"].b


def test_grips_pull_and_the_outline_moves():
    hand = circle_at(((100, 100), (200, 140)))
    hand.drawing.move(hand.at(200, 121))
    assert len(hand.drawing.preview.grips) == 4
    hand.drag((200, 120), (240, 124))
    assert hand.graph.circles["c1"].a == ((100, 120), (240, 120))
    hand.drag((240, 120), (240, 160))
    assert hand.graph.circles["c1"].a == ((100, 120), (240, 160))
    hand = circle_at(((100, 100), (200, 140)))
    hand.drag((164, 101), (174, 111))
    assert hand.graph.circles["c1"].a == ((110, 130), (210, 130))
    assert hand.words == ["Draw circle", "Move"]


def test_a_grip_meets_a_vertex_and_the_two_stay_together():
    hand = Hand(SQUARE, "circle")
    hand.drag((30, 60), (80, 90))
    hand.drawing.use("select")
    hand.drag((80, 75), (97, 98))
    assert hand.graph.circles["c1"].a[1] == (100, 100)
    hand.drag((100, 100), (120, 95))
    assert hand.graph.vertices["v1"] == (120, 95)
    assert hand.graph.circles["c1"].a[1] == (120, 95)
    assert hand.words == ["Draw circle", "Change circle", "Move vertex"]


def test_circles_are_selected_deleted_and_made_construction():
    hand = circle_at(((100, 100), (200, 140)))
    hand.click(164, 101)
    assert hand.drawing.selection == Selection(circles=frozenset(("c1",)))
    hand.drawing.toggle_construction()
    assert hand.graph.construction == ("c1",)
    hand.drag((50, 50), (250, 250))
    assert hand.drawing.selection.circles == {"c1"}
    hand.drawing.select_all()
    hand.drawing.delete()
    assert not hand.graph.circles


def test_diameter_is_asked_for():
    hand = circle_at(((100, 100), (200, 140)))
    hand.drawing.use("length")
    hand.click(164, 101)
    (question,) = hand.asked
    assert (question.about, question.target, question.at_px) == (About.CIRCLE, "c1", (150, 120))
    hand.drawing.answer(question, 90.0)
    hand.click(164, 101)
    assert hand.asked[1].said_mm == 90.0
    assert hand.words[-1] == "Set diameter"


def test_lines_stick_to_axis_ends():
    hand = circle_at(((100, 100), (200, 140)))
    hand.drawing.use("line")
    hand.drawing.move(hand.at(203, 122))
    assert hand.drawing.preview.snap.kind is SnapKind.AXIS_END
    hand.drag((203, 122), (300, 122))
    assert hand.graph.vertices["v1"] == (200, 120)


GROUND, BOTTOM, TOP = ((0, 160), (200, 240)), ((40, 110), (160, 150)), ((80, 20), (120, 32))


@pytest.fixture
def lid():
    """The three circles of a lid, drawn."""
    hand = Hand(SketchGraph(), "revolution")
    for box in (GROUND, BOTTOM, TOP):
        hand.drag(*box)
    return hand


def test_the_axis_comes_with_the_third_circle():
    hand = Hand(SketchGraph(), "revolution")
    assert "ground" in hand.drawing.tool.hint
    hand.drag(*GROUND)
    assert "bottom" in hand.drawing.tool.hint
    hand.drag(*BOTTOM)
    hand.drawing.press(hand.at(*TOP[0]))
    hand.drawing.move(hand.at(*TOP[1]))
    assert len(hand.drawing.preview.guides) == 2
    hand.drawing.release(hand.at(*TOP[1]))
    assert "side begins" in hand.drawing.tool.hint
    assert hand.words == ["Draw circle"] * 3


def test_the_side_runs_from_the_bottom_to_the_top(lid):
    for place in ((158, 131), (150, 90), (122, 60)):
        lid.click(*place)
    lid.drawing.move(lid.at(130, 40))
    # The axis, and the ring that the pointer stands for.
    assert len(lid.drawing.preview.guides) == 2
    lid.click(121, 27)
    (turned,) = lid.graph.revolutions.values()
    assert (turned.ground, turned.bottom, turned.top) == ("c1", "c2", "c3")
    assert [lid.graph.vertices[v] for v in turned.profile] == [
        (160, 130),
        (150, 90),
        (122, 60),
        (120, 26),
    ]
    assert len(lid.graph.edges) == 3
    assert lid.words[3:] == ["Draw side"] * 3
    # It begins anew.
    assert "ground" in lid.drawing.tool.hint


def test_the_surface_is_there_before_the_side_is_whole(lid):
    lid.click(160, 130)
    lid.click(150, 90)
    assert lid.graph.revolutions["r1"].profile == ("v1", "v2")
    lid.drawing.enter()
    assert "ground" in lid.drawing.tool.hint


def test_undo_goes_back_along_the_side_and_through_the_circles(lid):
    graphs = [lid.graph]
    for place in ((160, 130), (150, 90), (122, 60)):
        lid.click(*place)
        graphs.append(lid.graph)
    lid.drawing.replace_graph(graphs[2])
    lid.click(140, 60)
    assert lid.graph.revolutions["r1"].profile == ("v1", "v2", "v3")
    lid.drawing.replace_graph(graphs[0])
    assert "side begins" in lid.drawing.tool.hint
    circles = {c: drawn for c, drawn in graphs[0].circles.items() if c != "c3"}
    lid.drawing.replace_graph(SketchGraph(circles=circles))
    assert "top" in lid.drawing.tool.hint
    lid.drag(*TOP)
    assert list(lid.graph.circles) == ["c1", "c2", "c3"]


def test_circles_that_are_there_are_taken_by_a_click():
    hand = Hand(SketchGraph(), "circle")
    for box in (GROUND, BOTTOM, TOP):
        hand.drag(*box)
    hand.drawing.use("revolution")
    for place in ((100, 240), (100, 150), (100, 20)):
        hand.click(*place)
    assert "side begins" in hand.drawing.tool.hint
    assert len(hand.graph.circles) == 3


def test_escape_forgets_the_side_but_not_what_is_drawn(lid):
    lid.click(160, 130)
    lid.click(150, 90)
    lid.drawing.escape()
    assert lid.drawing.tool.NAME == "revolution"
    assert lid.graph.revolutions
    assert "ground" in lid.drawing.tool.hint
