"""Slivers go, slits become as wide as a beam, and all else stays as it is."""

import shapely

from incontext.workbench.fabrication.slivers import without_slivers

PLATE = shapely.box(0, 0, 80, 50)


def test_a_plate_with_fingers_stays_to_the_last_digit():
    comb = PLATE.difference(shapely.box(10, 47, 20, 50)).difference(shapely.box(30, 20, 42, 23))
    assert without_slivers(comb, 3.0, 0.15, 3.0).equals_exact(comb)


def test_a_sharp_corner_stays():
    wedge = shapely.Polygon([(0, 0), (100, 0), (0, 15)])  # 8.5 degrees
    assert without_slivers(wedge, 3.0, 0.15, 3.0).equals(wedge)


def test_a_sliver_goes():
    sliver = shapely.box(20, 50, 20.6, 58)
    left = without_slivers(PLATE.union(sliver), 3.0, 0.15, 3.0)
    assert left.symmetric_difference(PLATE).area < 0.02


def test_a_slit_is_made_as_wide_as_the_beam_up_to_its_mouth():
    slit = shapely.Polygon([(40, 50), (40.05, 50), (48.05, 42), (48, 42)])
    for kerf in (0.1, 0.4):
        cut = PLATE.difference(slit)
        left = without_slivers(cut, 3.0, kerf, 3.0)
        assert left.geom_type == "Polygon"
        assert cut.buffer(1e-9).covers(left)
        # A beam gets in and out again: closing the gaps narrower than it fills no more of them.
        closed = left.buffer(kerf / 2, join_style="mitre").buffer(-kerf / 2, join_style="mitre")
        assert closed.difference(left).area < kerf**2 / 2


def test_the_slot_for_a_thin_plate_is_no_slit():
    card = PLATE.difference(shapely.box(20, 20, 40, 20.4))
    assert without_slivers(card, 0.4, 0.5, 0.4).equals_exact(card)
