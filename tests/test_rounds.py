"""Edits of circles and surfaces of revolution."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from incontext.solver import SketchError
from incontext.solver.annotations import Diameter
from incontext.solver.editing import rounds as edit
from incontext.solver.editing.elements import add_edge, add_vertex, delete, split_edge
from incontext.solver.graph import Ellipse, SketchGraph
from incontext.solver.reading.parsing import check_references

NUMBERS = st.floats(-500, 500)
POINTS = st.tuples(NUMBERS, NUMBERS)


@pytest.fixture
def circle():
    """A wide ellipse, and a line that begins at its right end."""
    graph, _ = edit.add_circle(SketchGraph(), edit.ellipse_in_box((0, 0), (100, 40)))
    graph, v = add_vertex(graph, (100, 20))
    graph, w = add_vertex(graph, (160, 20))
    return add_edge(graph, v, w)[0]


def test_ellipse_fills_its_box_with_the_long_axis_first():
    wide, high = edit.ellipse_in_box((100, 40), (0, 0)), edit.ellipse_in_box((0, 0), (40, 100))
    assert wide == Ellipse(((0, 20), (100, 20)), ((50, 0), (50, 40)))
    assert high == Ellipse(((20, 0), (20, 100)), ((0, 50), (40, 50)))


def test_circles_and_edges_share_no_id(circle):
    graph, second = edit.add_circle(circle, edit.ellipse_in_box((0, 0), (9, 5)))
    assert second == "c2"
    check_references(graph)


@given(POINTS, POINTS, st.sampled_from("ab"), st.sampled_from([0, 1]), POINTS)
def test_a_pulled_ellipse_keeps_its_opposite_end_and_its_other_width(p, q, axis, end, to):
    drawn = edit.ellipse_in_box(p, q)
    other = "b" if axis == "a" else "a"
    pulled = edit.pulled(drawn, axis, end, to)
    stays = getattr(drawn, axis)[1 - end]
    if math.dist(stays, to) == 0:
        assert pulled == drawn
        return
    assert getattr(pulled, axis)[end] == to
    assert getattr(pulled, axis)[1 - end] == stays
    was, is_ = (math.dist(*getattr(e, other)) for e in (drawn, pulled))
    assert is_ == pytest.approx(was, abs=1e-6)
    (a, b), (c, d) = pulled.a, pulled.b
    dot = (b[0] - a[0]) * (d[0] - c[0]) + (b[1] - a[1]) * (d[1] - c[1])
    assert abs(dot) <= 1e-6 * (1 + math.dist(a, b) * math.dist(c, d))


def test_pulling_along_the_axis_leaves_the_ends_of_the_other_on_their_sides():
    pulled = edit.pulled(edit.ellipse_in_box((0, 0), (100, 40)), "a", 1, (140, 20))
    assert pulled == Ellipse(((0, 20), (140, 20)), ((70, 0), (70, 40)))


def test_a_shared_place_stays_shared(circle):
    moved = edit.move(circle, {"v1": (120, 20)})
    assert moved.circles["c1"].a == ((0, 20), (120, 20))
    back = edit.move(moved, {}, {"c1": edit.shifted(moved.circles["c1"], (5, 7))})
    assert back.vertices["v1"] == (125, 27)
    assert back.vertices["v2"] == (160, 20)
    both = edit.move(circle, {"v1": (110, 20)}, {"c1": edit.shifted(circle.circles["c1"], (10, 0))})
    assert both.circles["c1"].a == ((10, 20), (110, 20))


def test_diameter_is_said_once_and_taken_back(circle):
    graph = edit.set_diameter(edit.set_diameter(circle, "c1", 80), "c1", 90)
    assert list(graph.annotations.values()) == [Diameter("c1", 90.0)]
    assert not edit.set_diameter(graph, "c1", None).annotations
    for bad in (0, -1, float("nan")):
        with pytest.raises(SketchError, match="diameter"):
            edit.set_diameter(circle, "c1", bad)
    with pytest.raises(SketchError):
        edit.set_diameter(circle, "c9", 5)


def turned():
    graph = SketchGraph()
    for box in (((0, 80), (100, 120)), ((20, 60), (80, 80)), ((40, 0), (60, 8))):
        graph, _ = edit.add_circle(graph, edit.ellipse_in_box(*box))
    for place in ((80, 70), (70, 40), (60, 4)):
        graph, _ = add_vertex(graph, place)
    graph, _ = add_edge(graph, "v1", "v2")
    return add_edge(graph, "v2", "v3")[0]


def test_a_revolution_is_changed_where_there_is_one_on_the_same_circles():
    graph, first = edit.set_revolution(turned(), ("c1", "c2", "c3"), ("v1", "v2"))
    graph, again = edit.set_revolution(graph, ("c1", "c2", "c3"), ("v1", "v2", "v3"))
    assert (first, again) == ("r1", "r1")
    assert graph.revolutions["r1"].profile == ("v1", "v2", "v3")
    with pytest.raises(SketchError):
        edit.set_revolution(graph, ("c1", "c2", "c3"), ("v1",))
    with pytest.raises(SketchError):
        edit.set_revolution(graph, ("c1", "c2", "c9"), ("v1", "v2"))


def test_a_split_side_is_passed_by_the_profile_and_a_lost_circle_takes_it_along():
    graph, _ = edit.set_revolution(turned(), ("c1", "c2", "c3"), ("v1", "v2", "v3"))
    split, middle = split_edge(graph, "e1", (75, 55))
    assert split.revolutions["r1"].profile == ("v1", middle, "v2", "v3")
    assert not delete(graph, circles=["c3"]).revolutions
