"""Every tool by itself, without a screen: what its gestures make of a drawing."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from incontext.solver.annotations import EqualLength, Ground, Length, Parallel, RightAngle
from incontext.solver.graph import SketchGraph
from incontext.solver.reading.parsing import check_references
from incontext.workbench.canvas.drawing import Listener
from incontext.workbench.canvas.questions import About, Question
from incontext.workbench.canvas.selection import Selection
from incontext.workbench.canvas.snapping import SnapKind
from incontext.workbench.canvas.tool_at_work import ToolAtWork
from incontext.workbench.canvas.tools import KEYS, TOOLS
from incontext.workbench.canvas.tools.base import Pointer

RESOURCES = Path(__file__).parents[2] / "resources"

SQUARE = SketchGraph(
    vertices={"v1": (100, 100), "v2": (200, 100), "v3": (200, 200), "v4": (100, 200)},
    edges={"e1": ("v1", "v2"), "e2": ("v2", "v3"), "e3": ("v3", "v4"), "e4": ("v4", "v1")},
)


class Hand:
    """A drawing, a pointer over it, and all edits that came of it."""

    def __init__(self, graph=SQUARE, tool="select"):
        self.words, self.asked = [], []
        self.drawing = ToolAtWork(graph, Listener(self._edited, asked=self.asked.append))
        self.drawing.use(tool)

    def _edited(self, graph, words):
        check_references(graph)
        self.words.append(words)
        # As the document does: the graph comes back equal, but as another object.
        self.drawing.replace_graph(SketchGraph(**{n: getattr(graph, n) for n in graph.__slots__}))

    @property
    def graph(self):
        return self.drawing.graph

    def at(self, u, v, adding=False):
        return Pointer((u, v), 8.0, adding)

    def click(self, u, v, adding=False):
        for event in (self.drawing.move, self.drawing.press, self.drawing.release):
            event(self.at(u, v, adding))

    def drag(self, start, end):
        self.drawing.press(self.at(*start))
        self.drawing.move(self.at(*end))
        self.drawing.release(self.at(*end))


def test_tools_have_each_a_name_a_key_and_words():
    assert len({tool.KEY for tool in TOOLS.values()}) == len(TOOLS) == len(KEYS)
    for name, tool in TOOLS.items():
        hand = Hand(tool=name)
        assert name == hand.drawing.tool.NAME
        assert hand.drawing.tool.hint
        assert tool.TITLE


@pytest.mark.parametrize("name", TOOLS)
def test_tools_have_each_an_icon_and_a_picture_with_words(name):
    tool = TOOLS[name]
    icon = "".join(word.capitalize() for word in name.split("_"))
    assert (RESOURCES / "icons" / f"InContext_Tool{icon}.svg").exists()
    assert (RESOURCES / "docs" / "tools" / f"{name}.png").exists()
    page = (RESOURCES / "docs" / "tools.md").read_text(encoding="utf-8")
    assert f"## {tool.TITLE} ({tool.KEY})" in page
    assert f"(tools/{name}.png)" in page


def test_line_by_clicks_goes_on_until_escape():
    hand = Hand(SketchGraph(), "line")
    for place in ((10, 10), (60, 10), (60, 60)):
        hand.click(*place)
    hand.drawing.escape()
    hand.click(300, 300)
    assert list(hand.graph.edges.values()) == [("v1", "v2"), ("v2", "v3")]
    assert hand.words == ["Draw line", "Draw line"]
    assert hand.drawing.tool.NAME == "line"


def test_line_stops_where_it_meets_the_drawing_again():
    hand = Hand(tool="line")
    hand.click(300, 100)
    hand.click(201, 102)
    hand.click(400, 400)
    assert hand.graph.edges["e5"] == ("v5", "v2")
    assert len(hand.graph.edges) == 5


def test_line_by_drag_is_one_line():
    hand = Hand(SketchGraph(), "line")
    hand.drag((10, 10), (60, 10))
    hand.drag((100, 10), (160, 10))
    assert list(hand.graph.edges.values()) == [("v1", "v2"), ("v3", "v4")]


def test_two_clicks_at_one_place_draw_nothing():
    hand = Hand(SketchGraph(), "line")
    hand.click(10, 10)
    hand.click(10, 10)
    assert hand.words == []


def test_line_splits_the_edge_that_it_ends_on():
    hand = Hand(tool="line")
    hand.drag((160, 50), (170, 103))
    middle = hand.graph.vertices["v6"]
    assert middle == (170, 100)
    assert hand.graph.edges["e1"] == ("v1", "v6")
    assert hand.words == ["Draw line"]


def test_line_finds_the_middle_of_an_edge():
    hand = Hand(tool="line")
    hand.drawing.move(hand.at(147, 103))
    assert hand.drawing.preview.snap.kind is SnapKind.MIDPOINT
    assert hand.drawing.preview.snap.point_px == (150, 100)


def test_line_goes_on_after_its_own_edit_but_not_from_what_undo_took():
    hand = Hand(SketchGraph(), "line")
    hand.click(10, 10)
    before = hand.graph
    hand.click(60, 10)
    hand.drawing.replace_graph(before)
    hand.drawing.move(hand.at(90, 90))
    assert hand.drawing.preview.strokes == ()


def test_rectangle_is_four_edges_and_four_right_angles():
    hand = Hand(SketchGraph(), "rectangle")
    hand.drag((10, 10), (110, 60))
    assert len(hand.graph.edges) == 4
    assert len(hand.graph.annotations_of("right_angle")) == 4
    assert hand.words == ["Draw rectangle"]
    hand.drag((300, 300), (302, 350))
    assert len(hand.graph.edges) == 4


def test_rectangle_takes_vertices_that_are_there():
    hand = Hand(tool="rectangle")
    hand.drag((201, 101), (300, 201))
    assert len(hand.graph.vertices) == 6
    assert len(hand.graph.edges) == 7


def test_rectangle_by_two_clicks():
    hand = Hand(SketchGraph(), "rectangle")
    hand.click(10, 10)
    hand.click(110, 60)
    assert len(hand.graph.edges) == 4


def test_right_angle_at_a_corner_and_back():
    hand = Hand(tool="right_angle")
    hand.click(112, 112)
    assert list(hand.graph.annotations.values()) == [RightAngle("v1", ("e4", "e1"))]
    hand.click(112, 112)
    assert not hand.graph.annotations
    assert hand.words == ["Mark right angle", "Remove right angle"]


def test_all_four_right_angles_inside_a_quadrilateral():
    hand = Hand(tool="right_angle")
    hand.click(112, 112)
    hand.click(150, 150)
    assert len(hand.graph.annotations) == 4
    hand.click(150, 150)
    assert not hand.graph.annotations
    hand.click(400, 400)
    assert len(hand.words) == 3


def test_ground_by_click_and_by_box():
    hand = Hand(tool="ground")
    hand.click(101, 199)
    hand.drag((180, 80), (240, 240))
    assert hand.graph.annotations["a1"] == Ground(("v4", "v2", "v3"))
    hand.click(200, 100)
    assert hand.graph.annotations["a1"] == Ground(("v4", "v3"))


def test_length_is_asked_for_and_set():
    hand = Hand(tool="length")
    hand.click(130, 103)
    hand.click(300, 300)
    assert hand.asked == [Question(About.EDGE, "e1", (150, 100), None)]
    hand.drawing.answer(hand.asked[0], 210.0)
    assert hand.graph.annotations["a1"] == Length("e1", 210.0)
    hand.click(130, 103)
    assert hand.asked[1].said_mm == 210.0
    hand.drawing.answer(hand.asked[1], None)
    assert not hand.graph.annotations


@pytest.mark.parametrize(("tool", "kind"), [("parallel", Parallel), ("equal_length", EqualLength)])
def test_groups_are_picked_and_done(tool, kind):
    hand = Hand(tool=tool)
    hand.click(130, 100)
    hand.click(130, 200)
    assert hand.words == []
    hand.drawing.enter()
    assert list(hand.graph.annotations.values()) == [kind(("e1", "e3"))]
    # An edge of the group takes it up again: one more in, all but one out.
    hand.click(130, 100)
    hand.click(200, 130)
    hand.drawing.enter()
    assert list(hand.graph.annotations.values()) == [kind(("e1", "e3", "e2"))]
    for place in ((130, 100), (200, 130), (130, 200)):
        hand.click(*place)
    hand.drawing.enter()
    assert not hand.graph.annotations


@pytest.mark.parametrize(
    ("tool", "edges", "said"),
    [
        ("parallel", "e1 e3", Parallel(("e1", "e3"))),
        ("equal_length", "e1 e2 e4", EqualLength(("e1", "e2", "e4"))),
        ("right_angle", "e1 e2", RightAngle("v2", ("e1", "e2"))),
        ("ground", "e1 e2", Ground(("v1", "v2", "v3"))),
        ("right_angle", "e1 e3", None),
        ("parallel", "e1", None),
        ("ground", "e1", None),
        ("line", "e1 e3", None),
    ],
)
def test_a_tool_says_of_what_was_selected_what_it_says(tool, edges, said):
    for take in (ToolAtWork.use, ToolAtWork.say_of_selection):
        hand = Hand()
        hand.drawing.select(Selection(edges=frozenset(edges.split())))
        take(hand.drawing, tool)
        assert list(hand.graph.annotations.values()) == ([] if said is None else [said])
        assert len(hand.words) == len(hand.graph.annotations)
        hand.drawing.use("select")
        hand.drawing.select(Selection(edges=frozenset(edges.split())))
        hand.drawing.use(tool)
        # It says it once, and what another tool has picked is none of its business.
        assert len(hand.graph.annotations) == (said is not None)


def test_selected_edges_join_the_group_that_one_is_in():
    hand = Hand()
    for edges in ("e1 e3", "e2 e3"):
        hand.drawing.select(Selection(edges=frozenset(edges.split())))
        hand.drawing.use("equal_length")
        hand.drawing.use("select")
    assert list(hand.graph.annotations.values()) == [EqualLength(("e1", "e3", "e2"))]


def test_a_number_means_the_line_or_circle_drawn_last_or_what_is_selected():
    hand = Hand(tool="line")
    assert hand.drawing.tool.size_meant() is None
    hand.click(50, 50)
    hand.click(60, 90)
    (edge,) = set(hand.graph.edges) - set(SQUARE.edges)
    assert hand.drawing.tool.size_meant() == Question(About.EDGE, edge, (55, 70), None)
    hand.drawing.escape()
    hand.click(20, 20)
    assert hand.drawing.tool.size_meant() is None
    hand.drawing.use("circle")
    hand.drag((300, 300), (360, 340))
    assert hand.drawing.tool.size_meant().about is About.CIRCLE
    hand.drawing.use("length")
    hand.drawing.move(hand.at(130, 103))
    assert hand.drawing.tool.size_meant().target == "e1"
    hand.drawing.use("select")
    hand.drawing.select_all()
    assert hand.drawing.tool.size_meant() is None
    hand.click(130, 100)
    assert hand.drawing.tool.size_meant().target == "e1"


def test_a_double_click_on_an_edge_asks_for_its_length_and_so_does_the_tool_then_taken():
    hand = Hand()
    for second in (False, False, True):
        assert hand.asked == []
        pointer = Pointer((130, 100), 8.0, is_second=second)
        hand.drawing.press(pointer)
        hand.drawing.release(pointer)
    hand.drawing.use("length")
    assert hand.asked == 2 * [Question(About.EDGE, "e1", (150, 100), None)]


def test_the_right_button_selects_what_it_means_and_keeps_what_is_selected_with_it():
    hand = Hand()
    assert hand.drawing.right(hand.at(130, 100))
    assert hand.drawing.selection == Selection(edges=frozenset(("e1",)))
    hand.drawing.select_all()
    assert hand.drawing.right(hand.at(130, 100))
    assert len(hand.drawing.selection.edges) == 4
    assert hand.drawing.right(hand.at(400, 400))
    assert not hand.drawing.selection
    hand.drawing.press(hand.at(130, 100))
    assert not hand.drawing.right(hand.at(130, 100))
    hand.drawing.use("line")
    assert not hand.drawing.right(hand.at(130, 100))


def test_a_group_that_was_begun_is_kept_when_another_tool_is_taken():
    hand = Hand(tool="parallel")
    hand.click(130, 100)
    hand.click(130, 200)
    hand.drawing.use("line")
    assert hand.words == ["Mark parallel"]
    assert not hand.drawing.selection


def test_escape_drops_what_was_picked_then_goes_back_to_selecting():
    hand = Hand(tool="parallel")
    hand.click(130, 100)
    hand.drawing.escape()
    assert hand.drawing.tool.NAME == "parallel"
    hand.drawing.escape()
    assert hand.drawing.tool.NAME == "select"
    assert hand.words == []


def test_select_by_click_shift_click_box_and_all():
    hand = Hand()
    hand.click(101, 101)
    assert hand.drawing.selection == Selection(vertices=frozenset(("v1",)))
    hand.click(150, 200, adding=True)
    assert hand.drawing.selection.edges == {"e3"}
    hand.drag((50, 50), (250, 150))
    assert hand.drawing.selection == Selection(frozenset(("v1", "v2")), frozenset(("e1",)))
    hand.click(400, 400)
    assert not hand.drawing.selection
    hand.drawing.select_all()
    assert len(hand.drawing.selection.edges) == 4


def test_dragging_an_edge_moves_both_ends_and_a_selection_moves_whole():
    hand = Hand()
    hand.drag((130, 100), (130, 80))
    assert (hand.graph.vertices["v1"], hand.graph.vertices["v2"]) == ((100, 80), (200, 80))
    hand.drawing.select_all()
    hand.drag((200, 150), (210, 150))
    assert hand.graph.vertices["v4"] == (110, 200)
    assert hand.words == ["Move", "Move"]


def test_a_push_moves_what_is_selected_and_nothing_where_nothing_is():
    hand = Hand()
    hand.drawing.push((3, 0))
    hand.click(130, 100)
    hand.drawing.push((0, -2.5))
    assert (hand.graph.vertices["v1"], hand.graph.vertices["v2"]) == ((100, 97.5), (200, 97.5))
    assert hand.graph.vertices["v3"] == (200, 200)
    assert hand.words == ["Move"]


def test_a_vertex_dropped_on_another_becomes_one_with_it():
    hand = Hand()
    hand.drag((100, 100), (199, 199))
    assert set(hand.graph.vertices) == {"v2", "v3", "v4"}
    assert hand.words == ["Merge vertices"]


def test_a_trembling_click_moves_nothing():
    hand = Hand()
    hand.drag((100, 100), (101, 101))
    assert hand.words == []
    assert hand.drawing.selection.vertices == {"v1"}


def test_delete_and_construction_act_on_the_selection():
    hand = Hand()
    hand.drawing.delete()
    hand.click(130, 100)
    hand.drawing.toggle_construction()
    assert hand.graph.construction == ("e1",)
    hand.drawing.delete()
    assert "e1" not in hand.graph.edges
    assert hand.words == ["Change construction", "Delete"]


def test_deleting_what_a_group_has_picked_does_no_harm():
    hand = Hand(tool="parallel")
    hand.click(130, 100)
    hand.click(130, 200)
    hand.drawing.delete()
    hand.drawing.enter()
    assert not hand.graph.annotations


#: Few places, near together: what is random must meet what is there.
PLACES = st.tuples(st.integers(8, 22), st.integers(8, 22)).map(lambda p: (10.0 * p[0], 10.0 * p[1]))
MOUSE = st.tuples(st.sampled_from(["press", "move", "release", "click", "right"]), PLACES)
KEYS_PRESSED = st.tuples(
    st.sampled_from(
        ["enter", "escape", "delete", "select_all", "toggle_construction", "undo", *TOOLS]
    ),
    st.none(),
)


@settings(max_examples=300, deadline=None)
@given(st.lists(MOUSE | KEYS_PRESSED, max_size=60))
def test_no_sequence_of_gestures_breaks_the_drawing(gestures):
    hand = Hand()
    for name, place in gestures:
        before, edits = hand.drawing.committed, len(hand.words)
        if name == "undo":
            hand.drawing.replace_graph(SQUARE)
        elif name == "click":
            hand.click(*place)
        elif name in TOOLS:
            hand.drawing.use(name)
        elif place is None:
            getattr(hand.drawing, name)()
        else:
            getattr(hand.drawing, name)(hand.at(*place))
        check_references(hand.graph)
        assert len(hand.words) <= edits + 1
        assert name == "undo" or (len(hand.words) > edits) == (hand.drawing.committed != before)
        assert hand.drawing.preview is not None
        assert hand.drawing.selection.edges <= set(hand.graph.edges)
