"""Prisms keep every digit."""

import numpy as np
import pytest
import shapely

from incontext.workbench.fabrication.prisms import prism


def test_volume_and_place_to_the_last_digit():
    third = 1 / 3
    area = shapely.box(third, 0, 200, 100 + third).difference(shapely.box(20, 20, 60.1, 70.7))
    body = prism(area, -third, 2.05)
    assert body.volume() == pytest.approx(area.area * (2.05 + third), rel=1e-13)
    assert body.bounding_box() == (third, 0, -third, 200, 100 + third, 2.05)
    assert body.genus() == 1


def test_parts_and_nothing():
    two = shapely.MultiPolygon([shapely.box(0, 0, 1, 1), shapely.box(2, 0, 3, 1)])
    assert prism(two, 0, 2).volume() == pytest.approx(4)
    assert len(prism(two, 0, 2).decompose()) == 2
    assert prism(shapely.Polygon(), 0, 2).is_empty()


def test_the_way_a_ring_turns_does_not_matter():
    ring = np.array([(0, 0), (0, 2), (3, 2), (3, 0)])
    assert prism(shapely.Polygon(ring), 0, 1).volume() == pytest.approx(6)
