"""How runs are divided, and who owns what."""

import itertools

import numpy as np
import pytest
from fabrication import shapes
from hypothesis import given
from hypothesis import strategies as st

from incontext.workbench.fabrication import PlateSettings
from incontext.workbench.fabrication.cells import Cells, Run, meetings
from incontext.workbench.fabrication.finger_joints import (
    divide,
    finger_borders,
    global_order,
    least_finger_mm,
    share_out,
)
from incontext.workbench.fabrication.frame import find_frame
from incontext.workbench.fabrication.walls import find_walls


def walls_of(model):
    faces = {id_: face for id_, face in model.faces.items() if face.included}
    return find_walls(model, find_frame(faces), "inside")


def runs_of(model):
    return meetings(Cells(walls_of(model)))[0]


def kinds_of(model):
    names = [run.kind for run in runs_of(model)]
    return {kind: names.count(kind) for kind in sorted(set(names))}


@given(
    st.floats(1.0, 2000.0),
    st.floats(1.0, 60.0),
    st.floats(1.0, 60.0),
)
def test_fingers_are_odd_and_never_too_narrow(length, target, least):
    count = divide(length, target, least)
    assert count % 2 == 1
    assert count == 1 or length / count >= least * (1 - 1e-9)


@pytest.mark.parametrize(
    ("length", "target", "least", "count"),
    [(120, 12, 4.5, 11), (60, 12, 4.5, 5), (40, 12, 4.5, 3), (14, 12, 4.5, 3), (13, 12, 4.5, 1)],
)
def test_divide(length, target, least, count):
    assert divide(length, target, least) == count


def test_the_narrowest_finger():
    assert least_finger_mm(3.0, 0.2) == 4.5
    assert least_finger_mm(1.0, 0.2) == 2.2


def test_borders_are_symmetric():
    run = Run(0, 1, "L", 0, 3.0, 117.0)
    borders = np.array(finger_borders(run, 3.0, 12.0, 4.5, "finger"))
    np.testing.assert_allclose(borders + borders[::-1], 120.0, atol=2e-6)
    assert len(borders) % 2 == 0


def test_a_short_t_gets_one_tab_or_none():
    one = finger_borders(Run(0, 1, "T", 0, 0.0, 11.0), 3.0, 12.0, 4.5, "finger")
    assert one == [0.0, 3.25, 7.75, 11.0]
    assert finger_borders(Run(0, 1, "T", 0, 0.0, 10.0), 3.0, 12.0, 4.5, "finger") == [0.0, 10.0]


def test_how_walls_meet():
    assert kinds_of(shapes.box()) == {"L": 12}
    assert kinds_of(shapes.tray()) == {"L": 8}
    assert kinds_of(shapes.bookshelf()) == {"L": 8, "T": 3}
    # Eight compartments: 8 corners, the walls' edges run past the partitions that end on them.
    assert kinds_of(shapes.organizer_8()) == {"L": 8, "T": 18, "X": 3}
    assert kinds_of(shapes.bracket()) == {"L": 1}


def test_a_wall_comes_after_those_on_which_it_ends():
    runs = [Run(2, 0, "T", 0, 0, 1), Run(1, 2, "T", 0, 0, 1), Run(0, 1, "L", 0, 0, 1)]
    assert global_order(3, runs) == [2, 0, 1]
    circle = [Run(0, 1, "T", 0, 0, 1), Run(1, 0, "T", 0, 0, 1)]
    assert sorted(global_order(2, circle)) == [0, 1]


def test_pieces_are_apart_from_one_another():
    pieces = share_out(walls_of(shapes.organizer_6()), PlateSettings())
    low = np.array([piece.low_mm for piece in pieces])
    high = np.array([piece.high_mm for piece in pieces])
    for a, b in itertools.combinations(range(len(pieces)), 2):
        shared = np.minimum(high[a], high[b]) - np.maximum(low[a], low[b])
        assert shared.min() < 1e-9


def test_a_slot_that_cannot_open_is_closed_and_whole():
    """A shelf that goes through a taller, wider wall passes it in one closed slot."""
    loops = {
        "wall": shapes.rect(0, 50, (0, 100), (0, 100)),
        "shelf": shapes.rect(2, 50, (0, 100), (20, 80)),
    }
    pieces = share_out(walls_of(shapes.model(loops)), PlateSettings())
    assert [(piece.owner, piece.low_mm[1], piece.high_mm[1]) for piece in pieces] == [(1, 20, 80)]
