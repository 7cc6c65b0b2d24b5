"""Right-angled polygons less boxes: what shapely says, or nothing."""

import numpy as np
import pytest
import shapely

from incontext.workbench.fabrication.rectilinear import rastered, wide_all_over


def test_the_same_as_shapely():
    region = shapely.box(0, 0, 60, 40).difference(shapely.box(20, 15, 27, 22))
    found = 0
    for seed in range(60):
        rng = np.random.default_rng(seed)
        low = rng.integers(-3, 55, (int(rng.integers(1, 14)), 2))
        boxes = np.hstack([low, low + rng.integers(1, 9, low.shape)]).astype(float)
        wanted = region.difference(shapely.union_all(shapely.box(*boxes.T)))
        raster = rastered(region, boxes)
        left = raster.less(range(len(boxes)))
        largest = max((part.area for part in shapely.get_parts(wanted)), default=0.0)
        assert raster.largest_mm2(range(len(boxes))) == pytest.approx(largest, rel=1e-12)
        # None: several parts, or parts that touch in a corner only.
        if left is not None:
            found += 1
            assert left.is_valid
            assert left.equals(wanted)
    assert found > 30


def test_other_angles_are_left_to_shapely():
    slanted = shapely.Polygon([(0, 0), (50, 0), (40, 30), (0, 30)])
    boxes = np.array([[10.0, 0.0, 20.0, 5.0]])
    assert rastered(slanted, boxes) is None
    assert not wide_all_over(slanted, 1.0)


def test_nothing_left_and_several_parts_are_no_polygon():
    boxes = np.array(
        [[0.0, 0.0, 10.0, 10.0], [4.0, 0.0, 7.0, 10.0], [0.0, 0.0, 5.0, 5.0], [5.0, 5.0, 10, 10.0]]
    )
    raster = rastered(shapely.box(0, 0, 10, 10), boxes)
    for some, largest in (([0], 0.0), ([1], 40.0), ([2, 3], 25.0)):
        assert raster.less(some) is None
        assert raster.largest_mm2(some) == largest
    assert raster.less([2]).area == 75.0


def test_narrow_places_are_seen():
    comb = shapely.box(0, 0, 30, 10).difference(shapely.box(10, 0.05, 20, 10))
    assert not wide_all_over(comb, 0.1)
    assert wide_all_over(comb, 0.01)
