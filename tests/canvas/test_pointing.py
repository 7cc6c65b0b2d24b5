"""Hit testing, snapping, quadrilaterals, typed lengths: pure functions."""

import math
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import pytest

from incontext.solver import load_sketch, solve
from incontext.solver.annotations import Parallel
from incontext.solver.graph import SketchGraph
from incontext.workbench.canvas.hit_testing import corner_at, edge_at, inside_box
from incontext.workbench.canvas.lengths import exact_text, parse_length
from incontext.workbench.canvas.loops import Quad, quad_around, quads
from incontext.workbench.canvas.plane import foot, is_inside, line_crossing
from incontext.workbench.canvas.selection import Selection
from incontext.workbench.canvas.snapping import Lead, Snap, SnapKind, always, place, snap
from incontext.workbench.canvas.solved import Solved

SHELF = Path(__file__).parent.parent / "data" / "shelf.sketch.json"


@pytest.fixture
def cross():
    """Four edges from a middle, to the right, down, left and up."""
    vertices = {"m": (0, 0), "r": (50, 0), "d": (0, 50), "l": (-50, 0), "u": (0, -50)}
    return SketchGraph(vertices=vertices, edges={f"e{v}": ("m", v) for v in "rdlu"})


@pytest.mark.parametrize(
    ("place", "ends"), [((5, 5), "rd"), ((-5, 5), "ld"), ((-5, -5), "lu"), ((5, -5), "ru")]
)
def test_corner_is_between_the_edges_around_the_pointer(cross, place, ends):
    at, along, across = corner_at(cross, place, 20)
    assert (at, {along, across}) == ("m", set(ends))


def test_no_corner_at_a_loose_end_or_far_off(cross):
    assert corner_at(cross, (50, 3), 20) is None
    assert corner_at(cross, (25, 25), 20) is None


def test_edge_is_hit_beside_its_inside_only(cross):
    assert edge_at(cross, (30, 3), 5) == "er"
    assert edge_at(cross, (60, 0), 5) is None
    assert edge_at(cross, (30, 3), 5, frozenset(("er",))) is None
    assert edge_at(SketchGraph(), (0, 0), 5) is None


def test_box_takes_whole_edges(cross):
    assert inside_box(cross, (60, 10), (-10, -10)) == Selection(frozenset("mr"), frozenset(("er",)))


def test_snapping_prefers_vertices_then_midpoints_then_edges(cross):
    found = {at: snap(cross, at, 8).kind.name for at in ((48, 2), (24, 2), (36, 2), (30, 30))}
    assert list(found.values()) == ["VERTEX", "MIDPOINT", "EDGE", "FREE"]
    assert snap(cross, (36, 2), 8).point_px == (36, 0)


def test_placing_splits_only_what_is_there(cross):
    graph, vertex = place(cross, snap(cross, (36, 2), 8))
    assert graph.edges["er"] == ("m", vertex)
    for kind in (SnapKind.EDGE, SnapKind.VERTEX):
        graph, vertex = place(cross, Snap(kind, (1, 1), "gone"))
        assert graph.vertices[vertex] == (1, 1)
        assert dict(graph.edges) == dict(cross.edges)


def test_quadrilaterals_of_the_shelf_are_its_faces():
    shelf = load_sketch(SHELF)
    loops = {frozenset(quad.outline) for quad in quads(shelf)}
    drawn = {frozenset(face.loop) for face in shelf.faces.values()}
    assert drawn <= loops
    assert len(loops) == len(list(quads(shelf)))


def test_the_quadrilateral_with_the_nearest_middle_is_meant():
    shelf = load_sketch(SHELF)
    for face in shelf.faces.values():
        us, vs = zip(*(shelf.vertices[v] for v in face.loop), strict=True)
        middle = (sum(us) / 4, sum(vs) / 4)
        assert set(quad_around(shelf, middle).corners) == set(face.loop)
    assert quad_around(shelf, (0, 0)) is None


def test_angles_of_a_quadrilateral_name_its_edges():
    quad = Quad((("a", "b"), ("b", "c"), ("c", "m", "d"), ("d", "a")))
    assert quad.angles == (("a", "d", "b"), ("b", "a", "c"), ("c", "b", "m"), ("d", "m", "a"))
    assert quad.outline == ("a", "b", "c", "m", "d")


def test_a_side_may_have_vertices_in_it():
    vertices = {"a": (0, 0), "b": (100, 0), "c": (100, 100), "d": (0, 100), "m": (100, 50)}
    loop = "abmcda"
    edges = {f"e{k}": pair for k, pair in enumerate(pairwise(loop))}
    plain = SketchGraph(vertices=vertices, edges=edges)
    assert quad_around(plain, (50, 50)) is None
    said = replace(plain, annotations={"a1": Parallel(("e1", "e2"))})
    quad = quad_around(said, (50, 50))
    assert set(quad.corners) == set("abcd")
    assert set(quad.outline) == set("abcdm")


def test_crossing_sides_and_diagonals_make_no_quadrilateral():
    vertices = {"a": (0, 0), "b": (10, 10), "c": (10, 0), "d": (0, 10)}
    edges = {"1": ("a", "b"), "2": ("b", "c"), "3": ("c", "d"), "4": ("d", "a")}
    assert list(quads(SketchGraph(vertices=vertices, edges=edges))) == []
    plain = {**vertices, "b": (10, 0), "c": (10, 10)}
    assert len(list(quads(SketchGraph(vertices=plain, edges=edges)))) == 1
    across = {**edges, "5": ("a", "c")}
    assert list(quads(SketchGraph(vertices=plain, edges=across))) == []


def test_plane_geometry_at_its_edges():
    assert foot((5, 5), (1, 1), (1, 1)) == (1, 1)
    assert foot((-5, 3), (0, 0), (10, 0)) == (0, 0)
    assert is_inside((1, 1), [(0, 0), (4, 0), (0, 4)])
    assert not is_inside((3, 3), [(0, 0), (4, 0), (0, 4)])


@pytest.mark.parametrize(
    ("text", "length_mm"),
    [
        ("210", 210),
        (" 21 cm ", 210),
        ("2,5cm", 25),
        (".5 m", 500),
        ("3/4 in", 19.05),
        ("1 1/2 in", 38.1),
        ("1 1/2", 1.5),
        ("11/2", 5.5),
        ('3"', 76.2),
        ("2 FT", 609.6),
        ("2*18 mm + 5 mm", 41),
        ("=210 - 2*3", 204),
        ("(21 cm - 3 mm)/2", 103.5),
        ("1 cm + 3/4 in", 29.05),
        ("18 mm * 3/4", 13.5),
        ("300/4/3", 25),
        ("2 × 1,5cm", 30),
        ("5' 6 1/2\"", 1689.1),
    ],
)
def test_lengths_are_read_as_people_write_them(text, length_mm):
    assert parse_length(text) == pytest.approx(length_mm)


@pytest.mark.parametrize("length_mm", [19.05, 123.4567, 1e-5, 33.333333333333])
def test_a_length_that_is_opened_and_left_stays_as_it_was(length_mm):
    assert parse_length(exact_text(length_mm)) == pytest.approx(length_mm, abs=1e-6)


@pytest.mark.parametrize(
    "text",
    [
        *("", "0", "-3", "abc", "3 parsec", "1/0 in", "1.5 1/2 in", "1e9", "9999999 m", "1 2"),
        *("3 mm +", "2 mm * 3 mm", "1/(2 mm)", "(3", "3)", "()", "5 - 2 cm", "+3", "3 + * 4", "3!"),
        *("1 mm + 2 mm * 3 mm", "(" * 300 + "1", "9" * 150 + "*" + "9" * 40),
    ],
)
def test_what_is_no_length_is_refused_with_an_example(text):
    with pytest.raises(ValueError, match="21 cm"):
        parse_length(text)


def test_crossing_edges_are_joined_only_where_they_meet(cross):
    crossed = replace(
        cross,
        vertices={**cross.vertices, "a": (38, -30), "b": (42, 60)},
        edges={**cross.edges, "ab": ("a", "b")},
    )
    assert snap(crossed, (38, 1), 6).kind is SnapKind.EDGE
    at = snap(crossed, (38, 1), 6, meet=always)
    assert (at.kind, {at.target, at.other}) == (SnapKind.CROSSING, {"er", "ab"})
    graph, vertex = place(crossed, at)
    assert sum(vertex in ends for ends in graph.edges.values()) == 4
    assert len(graph.vertices) == len(crossed.vertices) + 1


def test_edges_that_meet_in_space_are_known_once_solved():
    shelf = load_sketch(SHELF)
    solved = Solved(shelf, solve(shelf))
    assert solved.meet(shelf.edge_between("v0", "v1"), shelf.edge_between("v1", "v2"))
    assert not solved.meet(shelf.edge_between("v0", "v1"), shelf.edge_between("v6", "v10"))
    assert not solved.meet("e1", "nowhere")


def test_lines_are_led_by_edges_and_by_the_perspective(cross):
    start = (100, 100)
    along = snap(cross, (103, 160), 8, lead=Lead(start))
    assert (along.kind, along.point_px) == (SnapKind.PARALLEL, (100, 160))
    assert snap(cross, (103, 110), 8, lead=Lead(start)).kind is SnapKind.FREE
    far = snap(cross, (203, 200), 8, lead=Lead(start, ((600, 600),)))
    assert far.kind is SnapKind.VANISHING
    assert far.point_px == pytest.approx((201.5, 201.5))


def test_an_edge_is_met_where_the_guide_crosses_it(cross):
    at = snap(cross, (38, 4), 6, lead=Lead((40, 100)))
    assert (at.kind, at.point_px) == (SnapKind.EDGE, (40, 0))
    assert at.guide == ((40, 100), (40, 0))


def test_the_three_directions_of_a_box_vanish_where_its_edges_meet():
    shelf = load_sketch(SHELF)
    solved = Solved(shelf, solve(shelf))
    found = [
        line_crossing(*ends(shelf, a), *ends(shelf, b)) for a, b in (("e0", "e2"), ("e1", "e3"))
    ]
    for place_px in found:
        assert min(math.dist(place_px, v) / math.hypot(*v) for v in solved.vanishing_px) < 0.05


def ends(graph, edge):
    return tuple(graph.vertices[v] for v in graph.edges[edge])
