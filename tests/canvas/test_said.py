"""Symbols of annotations: pointed at, selected, deleted; sizes opened by them."""

from pathlib import Path

import pytest

from incontext.solver import load_sketch
from incontext.solver.annotations import (
    Diameter,
    EqualLength,
    Ground,
    Length,
    OnFace,
    Parallel,
    RightAngle,
    SymmetryPlane,
)
from incontext.solver.graph import Ellipse, Face, SketchGraph
from incontext.tests.canvas.test_tools import Hand
from incontext.workbench.canvas import said
from incontext.workbench.canvas.marks import marks_of
from incontext.workbench.canvas.questions import About
from incontext.workbench.canvas.selection import Selection

SHELF = Path(__file__).parent.parent / "data" / "shelf.sketch.json"
EVERYTHING = SketchGraph(
    vertices={"v1": (100, 100), "v2": (200, 100), "v3": (200, 200), "v4": (100, 200)},
    edges={"e1": ("v1", "v2"), "e2": ("v2", "v3"), "e3": ("v3", "v4"), "e4": ("v4", "v1")},
    circles={"c1": Ellipse(((300, 300), (400, 300)), ((350, 270), (350, 330)))},
    faces={"f1": Face(("v1", "v2", "v3", "v4"))},
    annotations={
        "right": RightAngle("v1", ("e4", "e1")),
        "equal": EqualLength(("e1", "e3")),
        "along": Parallel(("e1", "e3")),
        "plane": SymmetryPlane(("e2", "e4")),
        "wide": Diameter("c1", 50.0),
        "long": Length("e4", 120.0),
        "touch": OnFace("v3", "f1"),
        "ground": Ground(("v3", "v4")),
    },
)


def places(graph=EVERYTHING, size=1.0):
    return said.on_photo(graph, marks_of(graph), size)


def chosen(*ids):
    return Selection(annotations=frozenset(ids))


@pytest.mark.parametrize("size", [0.2, 1.0, 1.6])
@pytest.mark.parametrize("id_", [i for i in EVERYTHING.annotations if i != "ground"])
def test_each_symbol_is_found_where_it_is_drawn(id_, size):
    symbol = said.symbol_of(places(size=size), id_)
    strokes = (*symbol.areas, *symbol.lines)
    place = said.middle(strokes[0]) if symbol.areas else strokes[0][0]
    assert said.annotation_at(places(size=size), place) == id_


@pytest.mark.parametrize("size", [0.2, 1.0, 1.6])
def test_the_ground_is_found_where_nothing_else_is(size):
    starts = [stroke[0] for stroke in said.symbol_of(places(size=size), "ground").lines]
    assert len(starts) == 8
    assert "ground" in {said.annotation_at(places(size=size), start) for start in starts}


def test_nothing_is_said_beside_the_symbols():
    assert said.annotation_at(places(), (170, 100)) is None
    assert said.annotation_at(places(SketchGraph()), (0, 0)) is None


def test_ticks_and_arrows_of_one_edge_stand_side_by_side():
    ticks, arrows = (f(places(), "e1") for f in (said.ticks_on, said.arrows_on))
    right = max(x for stroke in ticks for x, _ in stroke)
    assert right < min(x for stroke in arrows for x, _ in stroke)


def test_symbols_of_a_whole_sketch_are_told_apart():
    shelf = load_sketch(SHELF)
    found = [
        said.annotation_at(places(shelf), said.middle(symbol.areas[0]))
        for symbol in (said.symbol_of(places(shelf), id_) for id_ in shelf.annotations)
        if symbol.areas
    ]
    assert len(set(found)) > 0.9 * len(found) > 20


def test_click_selects_what_is_said_and_delete_takes_it_back():
    hand = Hand(EVERYTHING)
    hand.drawing.move(hand.at(109, 109))
    assert hand.drawing.preview.lit == chosen("right")
    assert not hand.drawing.tool.can_move
    hand.click(109, 109)
    assert hand.drawing.selection == chosen("right")
    hand.drawing.delete()
    assert set(EVERYTHING.annotations) - set(hand.graph.annotations) == {"right"}
    assert hand.words == ["Delete"]
    assert hand.graph.edges == EVERYTHING.edges


def test_symbol_on_an_edge_does_not_keep_it_from_being_dragged():
    hand = Hand(EVERYTHING)
    hand.drag((150, 203), (150, 243))
    assert hand.graph.vertices["v3"] == (200, 240)
    assert hand.drawing.selection == Selection(edges=frozenset(("e3",)))
    hand.drag((109, 109), (40, 40))
    assert hand.graph.vertices["v1"] == (100, 100)
    assert hand.drawing.selection == Selection(vertices=frozenset(("v1",)))


def test_second_click_on_a_vertex_means_what_is_said_of_it():
    hand = Hand(EVERYTHING)
    for expected in (Selection(vertices=frozenset(("v4",))), chosen("ground")):
        hand.click(100, 200)
        assert hand.drawing.selection == expected


def test_second_click_on_a_size_asks_for_it_and_enter_does_too():
    hand = Hand(EVERYTHING)
    where = said.middle(said.symbol_of(places(), "long").areas[0])
    hand.click(*where)
    assert (hand.drawing.selection, hand.asked) == (chosen("long"), [])
    hand.click(*where)
    hand.drawing.enter()
    assert [(q.about, q.target, q.said_mm) for q in hand.asked] == 2 * [(About.EDGE, "e4", 120.0)]
    hand.drawing.select(chosen("wide"))
    hand.drawing.enter()
    assert hand.asked[-1].about is About.CIRCLE
