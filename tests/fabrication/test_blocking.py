"""Who blocks whom along which way: what is seen at once is what a sweep finds."""

import numpy as np
import pytest
from fabrication import shapes, slanted

from incontext.workbench.fabrication import Plate, PlateSettings, make_plates
from incontext.workbench.fabrication.blocking import TOUCH_MM3, Blocking
from incontext.workbench.fabrication.facing import facings
from incontext.workbench.fabrication.sweeps import swept, together


def board(size, place=None) -> Plate:
    w, d, t = size
    outline = np.array([(0, 0), (w, 0), (w, d), (0, d)], dtype=float)
    world = np.eye(4)
    if place is not None:
        world[:3] = place
    return Plate("b", ("b",), t, outline, (), world)


def test_a_board_on_another_cannot_go_down():
    below = board((100, 60, 4))
    above = board((30, 20, 3), [[1, 0, 0, 20], [0, 1, 0, 20], [0, 0, 1, 4]])
    ways = np.array(
        [[0, 0, 1.0], [0, 0, -1], [0.6, 0, -0.8], [-0.6, 0, 0.8], [1, 0, 0], [-1, 0, 0]]
    )
    surely = facings((below, above)).blocked(ways, 2)
    assert surely[:, 1, 0].tolist() == [False, True, True, False, False, False]
    assert surely[:, 0, 1].tolist() == [True, False, False, True, False, False]


def test_over_a_gap_a_board_passes_where_it_slides_by():
    below = board((100, 60, 4))
    above = board((30, 20, 3), [[1, 0, 0, 50], [0, 1, 0, 20], [0, 0, 1, 6]])
    flat, steep = (
        np.array([[x, 0, -z], [-x, 0, z]]) for x, z in ((0.999, 0.0447), (0.0447, 0.999))
    )
    found = facings((below, above))
    assert not found.blocked(flat, 2).any()
    assert found.blocked(steep, 2)[0, 1, 0]


@pytest.mark.parametrize("play", [0.0, 0.2])
@pytest.mark.parametrize(
    "model", [shapes.organizer_6, slanted.crossed, slanted.hexagon_with_shelf, slanted.leaning]
)
def test_what_is_surely_blocked_is_blocked(model, play):
    plates = make_plates(model(turned=2), PlateSettings(play_mm=play))
    ways = Blocking(plates).ways
    assert np.array_equal(ways[::2], -ways[1::2])
    surely = facings(plates).blocked(ways, len(plates))
    bodies = [together(swept(plate, np.zeros(3))) for plate in plates]
    for way, one, other in np.random.default_rng(1).permutation(np.argwhere(surely))[:40]:
        passed = swept(plates[one], 1000.0 * ways[way])
        shared = sum((part ^ bodies[other]).volume() for part in passed)
        assert shared > TOUCH_MM3
