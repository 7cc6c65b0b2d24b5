"""Edits of a sketch graph: what each does, and that none ever gives an invalid graph."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from incontext.solver import SketchError, load_sketch
from incontext.solver.annotations import EqualLength, Ground, Length, OnFace, Parallel, RightAngle
from incontext.solver.editing import annotating as say
from incontext.solver.editing import elements as edit
from incontext.solver.graph import Ellipse, Face, Revolution, SketchGraph
from incontext.solver.reading.parsing import check_references, graph_from_json

SHELF = Path(__file__).parent / "data" / "shelf.sketch.json"


@pytest.fixture(scope="module")
def shelf():
    return load_sketch(SHELF)


@pytest.fixture
def square():
    vertices = {"v1": (0, 0), "v2": (10, 0), "v3": (10, 10), "v4": (0, 10)}
    edges = {"e1": ("v1", "v2"), "e2": ("v2", "v3"), "e3": ("v3", "v4"), "e4": ("v4", "v1")}
    annotations = {
        "a1": RightAngle("v2", ("e1", "e2")),
        "a2": EqualLength(("e1", "e3")),
        "a3": Length("e1", 20.0),
        "a4": Ground(("v1", "v2", "v3")),
        "a5": OnFace("v4", "f1"),
    }
    faces = {"f1": Face(("v1", "v2", "v3", "v4"))}
    return SketchGraph(vertices=vertices, edges=edges, annotations=annotations, faces=faces)


def test_from_nothing_to_an_edge_with_a_length():
    graph, v = edit.add_vertex(SketchGraph(), (1.23456, 2))
    graph, w = edit.add_vertex(graph, (3, 4))
    graph, edge = edit.add_edge(graph, v, w)
    graph = say.set_length(graph, edge, 210)
    assert (v, w, edge) == ("v1", "v2", "e1")
    assert graph.vertices["v1"] == (1.235, 2.0)
    assert dict(graph.annotations) == {"a1": Length("e1", 210.0)}
    assert edit.add_edge(graph, w, v) == (graph, edge)


def test_new_ids_are_above_all_in_use(square):
    smaller = edit.delete(square, vertices=["v2"])
    assert edit.add_vertex(smaller, (0, 0))[1] == "v5"
    circles = {"e9": Ellipse(((0, 0), (2, 0)), ((1, -1), (1, 1)))}
    round_one = SketchGraph(vertices=square.vertices, circles=circles)
    assert edit.add_edge(round_one, "v1", "v3")[1] == "e10"


def test_edges_that_cannot_be_are_refused(square):
    for v, w in (("v1", "v1"), ("v1", "nowhere")):
        with pytest.raises(SketchError):
            edit.add_edge(square, v, w)


def test_moving_leaves_the_old_graph_as_it_was(square):
    moved = edit.move_vertices(square, {"v1": (1, 1), "v2": (2, 2)})
    assert (moved.vertices["v1"], square.vertices["v1"]) == ((1.0, 1.0), (0, 0))
    with pytest.raises(SketchError):
        edit.move_vertices(square, {"nowhere": (0, 0)})


def test_a_deleted_vertex_takes_what_depends_on_it(square):
    smaller = edit.delete(square, vertices=["v2"])
    assert set(smaller.edges) == {"e3", "e4"}
    assert smaller.faces is None
    assert dict(smaller.annotations) == {"a4": Ground(("v1", "v3"))}


def test_a_deleted_edge_takes_the_vertices_that_it_leaves_alone(square):
    smaller = edit.delete(square, edges=["e1", "e2"])
    assert set(smaller.vertices) == {"v1", "v3", "v4"}
    assert edit.delete(square, edges=["nowhere"]) == square


def test_a_deleted_face_takes_what_lies_on_it(square):
    assert "a5" not in edit.delete(square, faces=["f1"]).annotations


def test_a_deleted_circle_takes_its_revolution(square):
    circle = Ellipse(((0, 0), (2, 0)), ((1, -1), (1, 1)))
    lid = SketchGraph(
        vertices=square.vertices,
        circles={"c1": circle, "c2": circle, "c3": circle},
        revolutions={"r1": Revolution("c1", "c2", "c3", ("v1", "v2", "v3"))},
        construction=("c1",),
    )
    smaller = edit.delete(lid, circles=["c1"])
    assert not smaller.revolutions
    assert smaller.construction == ()
    assert edit.delete(lid, vertices=["v2"]).revolutions["r1"].profile == ("v1", "v3")


def test_merging_neighbours_takes_their_edge(square):
    merged = edit.merge_vertices(square, "v1", "v2")
    assert dict(merged.edges) == {"e2": ("v1", "v3"), "e3": ("v3", "v4"), "e4": ("v4", "v1")}
    assert merged.faces["f1"].loop == ("v1", "v3", "v4")
    assert dict(merged.annotations) == {"a4": Ground(("v1", "v3")), "a5": OnFace("v4", "f1")}


def test_merging_corners_makes_two_edges_one(square):
    merged = edit.merge_vertices(square, "v2", "v4")
    assert dict(merged.edges) == {"e1": ("v1", "v2"), "e2": ("v2", "v3")}
    assert merged.annotations["a2"] == EqualLength(("e1", "e2"))
    assert merged.annotations["a1"] == square.annotations["a1"]
    assert merged.faces is None


def test_splitting_keeps_what_is_still_true(square):
    said = say.annotate(square, Parallel(("e1", "e3")))[0]
    said = say.annotate(said, RightAngle("v1", ("e1", "e4")))[0]
    split, middle = edit.split_edge(said, "e1", (4, 0))
    assert (split.edges["e1"], split.edges["e5"]) == (("v1", middle), (middle, "v2"))
    assert split.faces["f1"].loop == ("v1", middle, "v2", "v3", "v4")
    assert dict(split.annotations) == {
        "a1": RightAngle("v2", ("e5", "e2")),
        "a4": square.annotations["a4"],
        "a5": square.annotations["a5"],
        "a6": Parallel(("e1", "e3", "e5")),
        "a7": RightAngle("v1", ("e1", "e4")),
    }


def test_halves_of_a_split_edge_stay_straight_and_construction(square):
    split, middle = edit.split_edge(edit.toggle_construction(square, ["e2"]), "e2", (10, 5))
    assert set(split.construction) == {"e2", "e5"}
    assert Parallel(("e2", "e5")) in split.annotations.values()
    assert split.edges["e5"] == (middle, "v3")


def test_the_same_is_said_once(square):
    assert say.annotate(square, RightAngle("v2", ("e2", "e1"))) == (square, "a1")
    assert say.annotate(square, EqualLength(("e3", "e1"))) == (square, "a2")
    with pytest.raises(SketchError):
        say.annotate(square, RightAngle("v1", ("e1", "e2")))


def test_length_is_set_changed_and_taken_back(square):
    assert say.set_length(square, "e1", 30).annotations["a3"] == Length("e1", 30.0)
    assert "a3" not in say.set_length(square, "e1", None).annotations
    for wrong in (0, -1, float("nan"), float("inf")):
        with pytest.raises(SketchError):
            say.set_length(square, "e1", wrong)


def test_ground_toggles(square):
    assert say.toggle_ground(square, ["v4"]).annotations["a4"].vertices == ("v1", "v2", "v3", "v4")
    assert say.toggle_ground(square, ["v2"]).annotations["a4"].vertices == ("v1", "v3")
    assert "a4" not in say.toggle_ground(square, ["v1", "v2", "v3"]).annotations
    assert say.toggle_ground(SketchGraph(vertices=square.vertices), ["v4"]).annotations


def test_groups_grow_shrink_and_go(square):
    assert say.set_group(square, EqualLength, ["e1", "e2", "e3"], "a2").annotations["a2"].edges == (
        "e1",
        "e2",
        "e3",
    )
    assert "a2" not in say.set_group(square, EqualLength, ["e1"], "a2").annotations
    assert say.set_group(square, Parallel, ["e1"], None) == square


def test_construction_toggles(square):
    both = edit.toggle_construction(edit.toggle_construction(square, ["e1"]), ["e1", "e2"])
    assert set(both.construction) == {"e1", "e2"}
    assert edit.toggle_construction(both, ["e2", "e1"]) == square


def some_of(draw, ids):
    return draw(st.sampled_from(sorted(ids))) if ids else None


def random_edit(draw, graph):
    """A graph after one edit that a person could make; the same graph where one cannot be made."""
    v, w = some_of(draw, graph.vertices), some_of(draw, graph.vertices)
    e, f = some_of(draw, graph.edges), some_of(draw, graph.edges)
    a, face = some_of(draw, graph.annotations), some_of(draw, graph.faces or {})
    at = draw(st.tuples(st.integers(0, 800), st.integers(0, 600)))
    edits = [lambda: edit.add_vertex(graph, at)[0]]
    if v:
        edits += [
            lambda: edit.add_edge(graph, v, w)[0],
            lambda: edit.move_vertices(graph, {v: at}),
            lambda: edit.merge_vertices(graph, v, w),
            lambda: edit.delete(graph, vertices=[v]),
            lambda: say.toggle_ground(graph, [v, w]),
        ]
    if e:
        edits += [
            lambda: edit.split_edge(graph, e, at)[0],
            lambda: edit.delete(graph, edges=[e, f]),
            lambda: edit.toggle_construction(graph, [e, f]),
            lambda: say.set_length(graph, e, 1.0 + at[0]),
            lambda: say.set_group(graph, EqualLength, [e, f], None),
            lambda: say.set_group(graph, Parallel, [e, f], None),
            lambda: say.annotate(graph, RightAngle(graph.edges[e][0], (e, f)))[0],
        ]
    if a:
        edits.append(lambda: edit.delete(graph, annotations=[a]))
    if face:
        edits.append(lambda: edit.delete(graph, faces=[face]))
    try:
        return draw(st.sampled_from(edits))()
    except SketchError:
        # Only what cannot be said is refused: an edge to itself, an angle that is none.
        return graph


@settings(max_examples=60, deadline=None)
@given(data=st.data(), steps=st.integers(1, 25), empty=st.booleans())
def test_no_sequence_of_edits_gives_an_invalid_graph(data, steps, empty):
    graph = SketchGraph() if empty else load_sketch(SHELF)
    for _ in range(steps):
        before = graph.digest
        after = random_edit(data.draw, graph)
        check_references(after)
        assert graph_from_json(after.to_json()) == after
        assert graph.digest == before
        graph = after
