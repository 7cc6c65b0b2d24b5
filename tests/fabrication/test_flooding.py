"""Flooding right-angled objects finds what lines of view find."""

import numpy as np
import pytest
from fabrication import shapes, slanted

from incontext.workbench.fabrication.flooding import flooded
from incontext.workbench.fabrication.openings import caps
from incontext.workbench.fabrication.sides import _seen, _side


def placed(model):
    return {id_: (face.loop_mm, *face.holes_mm) for id_, face in model.faces.items()}


@pytest.mark.parametrize("seed", range(6))
def test_the_same_as_lines_of_view(seed):
    faces = placed(shapes.polycube(seed))
    every = np.vstack([loops[0] for loops in faces.values()])
    size = float(np.linalg.norm(np.ptp(every, axis=0)))
    closing = [(cap,) for cap in caps(list(faces.values()), size)]
    quick, exact = flooded(faces, closing, list(faces)), _seen(faces, closing, list(faces), size)
    assert quick is not None
    for id_, loops in faces.items():
        sides = [_side(np.array(s[id_]), loops[0], every, 1e-3 * size) for s in (quick, exact)]
        assert sides[0] == sides[1]


def test_an_open_box_leaks_unless_it_is_closed():
    faces = placed(shapes.tray())
    assert flooded(faces, [], ["bottom"]) == {"bottom": (0.0, 0.0)}
    lid = (np.array(shapes.rect(2, 40, (0, 150), (0, 90))),)
    assert flooded(faces, [lid], ["bottom"]) == {"bottom": (0.0, 1.0)}


def test_a_partition_has_inside_on_both_sides_and_half_a_one_a_share():
    faces = placed(shapes.bookshelf())
    front = (np.array(shapes.rect(1, 0, (0, 160), (0, 200))),)
    assert flooded(faces, [front], ["shelf"]) == {"shelf": (1.0, 1.0)}
    loops = shapes.box_loops(100, 50, 50)
    loops["floor"] = shapes.rect(2, 0, (0, 200), (0, 50))
    faces = {id_: (np.array(loop, float),) for id_, loop in loops.items()}
    assert flooded(faces, [], ["floor"]) == {"floor": (0.0, 0.5)}


def test_slanted_ones_are_left_to_lines_of_view():
    assert flooded(placed(slanted.leaning()), [], ["bottom"]) is None
    assert flooded(placed(shapes.magazine_file()), [], ["bottom"]) is None
