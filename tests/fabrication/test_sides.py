"""Where the inside is."""

import numpy as np
import pytest
from fabrication import shapes

from incontext.workbench.fabrication.openings import caps
from incontext.workbench.fabrication.sides import face_sides


def sides_of(model):
    """For each face: the direction towards the inside (None for partitions)."""
    loops = {id_: (f.loop_mm, *f.holes_mm) for id_, f in model.faces.items()}
    made = [id_ for id_, face in model.faces.items() if face.included]
    result = {}
    for id_, side in face_sides(loops, made).items():
        a, b, c = loops[id_][0][:3]
        normal = np.cross(b - a, c - b)
        result[id_] = None if side == 0 else tuple(np.round(side * normal / np.linalg.norm(normal)))
    return result


INWARDS = {
    "bottom": (0, 0, 1),
    "top": (0, 0, -1),
    "front": (0, 1, 0),
    "back": (0, -1, 0),
    "left": (1, 0, 0),
    "right": (-1, 0, 0),
}


@pytest.mark.parametrize("left_out", [(), ("top",), ("front", "back")])
def test_a_box_whatever_is_left_out(left_out):
    found = sides_of(shapes.box(left_out=left_out))
    assert found == {id_: way for id_, way in INWARDS.items() if id_ not in left_out}


@pytest.mark.parametrize("height", [4.0, 40.0, 400.0])
def test_a_tray_without_a_lid(height):
    found = sides_of(shapes.tray(h=height))
    assert found == {id_: way for id_, way in INWARDS.items() if id_ != "top"}


def test_a_bookshelf_without_a_front():
    found = sides_of(shapes.bookshelf())
    assert found.pop("shelf") is None
    assert found == {id_: way for id_, way in INWARDS.items() if id_ != "front"}


def test_a_tube_is_closed_by_two_caps():
    loops = shapes.box_loops(100, 80, 60)
    del loops["front"], loops["back"]
    found = sides_of(shapes.model(loops))
    assert found == {id_: way for id_, way in INWARDS.items() if id_ not in ("front", "back")}
    arrays = [(np.array(loop, dtype=float),) for loop in loops.values()]
    assert len(caps(arrays, 150.0)) == 2


def test_an_l_box_without_its_top():
    plan = [(0, 0), (140, 0), (140, 60), (80, 60), (80, 110), (0, 110)]
    loops = shapes.prism(plan, 50)
    del loops["top"]
    found = sides_of(shapes.model(loops))
    assert found["side3"] == (0, -1, 0)
    assert found["side4"] == (-1, 0, 0)


def test_organizers():
    found = sides_of(shapes.organizer_8())
    assert all((way is None) == ("." in id_) for id_, way in found.items())


def test_a_bracket_and_a_board():
    assert sides_of(shapes.bracket()) == {"floor": (0, 0, 1), "wall": (1, 0, 0)}
    assert sides_of(shapes.board()) == {"f1": (0, 0, -1)}


def test_a_shelf_between_two_uprights():
    loops = {
        "left": shapes.rect(0, 0, (0, 50), (0, 100)),
        "right": shapes.rect(0, 80, (0, 50), (0, 100)),
        "shelf": shapes.rect(2, 40, (0, 80), (0, 50)),
    }
    assert sides_of(shapes.model(loops)) == {
        "left": (1, 0, 0),
        "right": (-1, 0, 0),
        "shelf": None,
    }


def test_a_border_aslant_is_closed_by_a_cap():
    found = sides_of(shapes.magazine_file())
    assert found == {id_: way for id_, way in INWARDS.items() if id_ != "top"}
