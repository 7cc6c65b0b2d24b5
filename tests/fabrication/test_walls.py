"""Polygons are made tidy without losing corners."""

import shapely

from incontext.workbench.fabrication.walls import tidy, without_specks


def test_a_corner_of_a_very_short_side_stays():
    # Both ends of the short side look straight beside the long ones.
    for short in (2e-8, 5e-8, 9e-8):
        notched = shapely.Polygon([(0, 0), (40, 0), (40, 10), (20 + short, 10), (20, 10.005)])
        clean = tidy(notched)
        assert clean.symmetric_difference(notched).area < 1e-5
        chamfered = shapely.Polygon([(0, 0), (40, 0), (40, 10), (short, 10), (0, 10 - short)])
        assert tidy(chamfered).symmetric_difference(chamfered).area < 1e-5


def test_vertices_in_straight_lines_go():
    ring = [(0, 0), (1, 0), (2, 0), (3, 0), (40, 0), (40, 10), (20, 10), (0, 10), (0, 5)]
    assert len(tidy(shapely.Polygon(ring)).exterior.coords) == 5


def test_the_ground_of_a_notch_as_narrow_as_rounding_becomes_a_point():
    notch = [(20, 10), (20.1, 5), (20.100001, 5), (20.2, 10)]
    plate = shapely.Polygon([(0, 0), (40, 0), (40, 10), *notch[::-1], (0, 10)])
    clean = without_specks(plate)
    assert len(clean.exterior.coords) == len(plate.exterior.coords) - 1
    assert clean.difference(plate).area < 1e-12
    assert plate.difference(clean).area < 1e-10
