"""The shapes of annotation symbols."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from incontext.workbench.canvas import symbols

coordinates = st.floats(-500, 500)
points = st.tuples(coordinates, coordinates)


def test_right_angle_is_a_square_between_two_long_edges():
    assert symbols.right_angle((0, 0), (100, 0), (0, 100), 10) == ((10, 0), (10, 10), (0, 10))


def test_right_angle_follows_the_perspective_of_its_edges():
    first, far, second = symbols.right_angle((0, 0), (60, 80), (-100, 0), 10)
    assert first == pytest.approx((6, 8))
    assert second == pytest.approx((-10, 0))
    assert far == pytest.approx((-4, 8))


@given(points, points, points)
def test_right_angle_keeps_to_a_third_of_its_edges(corner, along, across):
    first, _, second = symbols.right_angle(corner, along, across, 10)
    for mark, end in ((first, along), (second, across)):
        assert math.dist(corner, mark) <= min(10, math.dist(corner, end) / 3) + 1e-6


@pytest.mark.parametrize("count", [1, 2, 3])
def test_ticks_cross_the_middle_of_the_edge(count):
    strokes = symbols.ticks((0, 0), (100, 0), count, 6, 5)
    assert len(strokes) == count
    assert sum(x for stroke in strokes for x, _ in stroke) / (2 * count) == pytest.approx(50)
    assert {abs(y) for stroke in strokes for _, y in stroke} == {3}


def test_arrows_of_parallel_edges_point_the_same_way():
    one = symbols.arrows((0, 0), (100, 0), 1, 6, 5)
    other = symbols.arrows((100, 20), (0, 20), 1, 6, 5)
    assert [[(x, y + 20) for x, y in stroke] for stroke in one] == [list(s) for s in other]


@given(points, points, points)
def test_label_stands_away_from_the_centre(start, end, centre):
    if math.dist(start, end) < 1:
        return
    middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    label = symbols.beside(start, end, centre, (40, 16), 7)
    assert math.dist(label, centre) >= math.dist(middle, centre) - 1e-6
    assert math.dist(label, middle) >= 7 + 8 - 1e-6


def test_ellipse_passes_through_its_antipodal_points():
    outline = symbols.ellipse(((0, 0), (100, 0)), ((50, -20), (50, 20)), corners=4)
    expected = [(100, 0), (50, 20), (0, 0), (50, -20), (100, 0)]
    assert [pytest.approx(point) for point in expected] == list(outline)
