"""Marks and hit testing: what the canvas reads off a graph."""

from pathlib import Path

import pytest

from incontext.solver import load_sketch
from incontext.solver.editing.elements import move_vertices
from incontext.workbench.canvas.hit_testing import vertex_at
from incontext.workbench.canvas.marks import length_text, marks_of

SHELF = Path(__file__).parent.parent / "data" / "shelf.sketch.json"


@pytest.fixture(scope="module")
def shelf():
    return load_sketch(SHELF)


def test_every_annotation_of_the_shelf_has_its_mark(shelf):
    marks = marks_of(shelf)
    assert len(marks.right_angles) == len(shelf.annotations_of("right_angle"))
    assert marks.ground == {"v0", "v1", "v2", "v3"}
    assert list(marks.lengths.values()) == ["220 mm"]
    assert set(marks.parallels.values()) == set(marks.equal_lengths.values()) == {1}


def test_right_angle_names_its_corner_and_the_other_ends(shelf):
    for corner, along, across in marks_of(shelf).right_angles.values():
        assert shelf.edge_between(corner, along)
        assert shelf.edge_between(corner, across)


@pytest.mark.parametrize(
    ("length_mm", "text"),
    [(240.0, "240 mm"), (12.5, "12.5 mm"), (0.25, "0.25 mm"), (12345.6, "12346 mm")],
)
def test_lengths_read_as_people_write_them(length_mm, text):
    assert length_text(length_mm) == text


def test_nearest_vertex_within_reach(shelf):
    u, v = shelf.vertices["v8"]
    assert vertex_at(shelf, (u + 3, v), 9) == "v8"
    assert vertex_at(shelf, (u - 300, v - 100), 9) is None
    assert vertex_at(move_vertices(shelf, {"v8": (0, 0)}), (u, v), 1) is None
