"""The kerf: a simulated beam along the path leaves the finished size."""

import numpy as np
import pytest
import shapely
from fabrication import shapes

from incontext.workbench.fabrication import (
    FabricationError,
    Plate,
    PlateSettings,
    joined_plates,
    make_plates,
)
from incontext.workbench.fabrication.cut_paths import cut_path
from incontext.workbench.fabrication.narrow_places import TooNarrowError
from incontext.workbench.fabrication.sheets import lay_out


def path_lines(path):
    return [shapely.LinearRing(ring) for ring in (path.outer, *path.inner)]


@pytest.mark.parametrize("kerf", [0.08, 0.2, 0.5])
@pytest.mark.parametrize("name", ["organizer_6", "magazine_file"])
def test_the_beam_leaves_the_part(name, kerf):
    for plate in make_plates(shapes.TRUTHS[name].make()):
        path = cut_path(plate, kerf)
        beam = shapely.union_all([line.buffer(kerf / 2) for line in path_lines(path)])
        # Path positions are multiples of 1e-6 mm.
        assert beam.intersection(plate.polygon).area < 1e-7 * plate.polygon.length
        stock = shapely.box(*plate.polygon.buffer(20).bounds)
        left = [
            part
            for part in shapely.get_parts(stock.difference(beam))
            if part.contains(plate.polygon.representative_point())
        ]
        assert len(left) == 1
        # The round beam leaves a fillet in each inner corner: (1 - pi / 4) (k / 2)^2.
        rings = [plate.outline, *plate.holes]
        fillets = sum(len(ring) for ring in rings) * (1 - np.pi / 4) * (kerf / 2) ** 2
        assert left[0].area - plate.polygon.area == pytest.approx(fillets / 2, abs=fillets)
        assert left[0].covers(plate.polygon.buffer(-1e-5))


def test_no_kerf_is_the_finished_outline():
    plate = make_plates(shapes.tray())[0]
    assert cut_path(plate, 0.0).outer is plate.outline


def test_outlines_grow_and_holes_shrink():
    plate = make_plates(shapes.bookshelf())[3]
    path = cut_path(plate, 0.2)
    np.testing.assert_allclose(np.ptp(path.outer, axis=0), np.ptp(plate.outline, axis=0) + 0.2)
    assert len(path.inner) == len(plate.holes) > 0
    for cut, hole in zip(path.inner, plate.holes, strict=True):
        np.testing.assert_allclose(np.ptp(cut, axis=0), np.ptp(hole, axis=0) - 0.2, atol=1e-5)


def square_with_hole(width: float) -> Plate:
    hole = np.array([(10, 10), (10, 20), (10 + width, 20), (10 + width, 10)], dtype=float)
    outline = np.array([(0, 0), (40, 0), (40, 40), (0, 40)], dtype=float)
    return Plate("p1", ("p1",), 3.0, outline, (hole,), np.eye(4))


def test_a_hole_narrower_than_the_kerf_is_named():
    with pytest.raises(FabricationError, match="narrower than the kerf") as caught:
        cut_path(square_with_hole(0.15), 0.2)
    assert caught.value.ids == ("p1",)
    assert len(cut_path(square_with_hole(0.4), 0.2).inner) == 1


def test_a_notch_narrower_than_the_kerf_is_named():
    outline = [(0, 0), (40, 0), (40, 40), (20.1, 40), (20.1, 20), (20, 20), (20, 40), (0, 40)]
    plate = Plate("p2", ("p2",), 3.0, np.array(outline, dtype=float), (), np.eye(4))
    with pytest.raises(TooNarrowError, match=r"a beam of 0\.1 mm just gets into") as caught:
        cut_path(plate, 0.3)
    assert shapely.box(20, 20, 20.1, 40).covers(shapely.Point(caught.value.place))


def test_a_notch_that_is_too_narrow_is_told_by_its_joint():
    loops = {
        "one": shapes.rect(0, 40, (0, 90), (0, 60)),
        "two": shapes.rect(1, 30, (0, 60), (0, 80)),
        "far": shapes.rect(1, 70, (0, 100), (0, 80)),
    }
    settings = PlateSettings(kerf_mm=2.6)
    joined = joined_plates(
        shapes.model(loops, thickness={"one": 3.0, "two": 3.0, "far": 2.5}), settings
    )
    with pytest.raises(
        FabricationError, match=r"of 2\.5 mm just gets into .* of 2\.6 mm"
    ) as caught:
        lay_out(joined.plates, settings, None, joined.joints)
    assert caught.value.ids == ("one", "far")


def wedge(degrees: float) -> Plate:
    """A triangle with one sharp corner."""
    outline = np.array([(0, 0), (100, 0), (0, 100 * np.tan(np.radians(degrees)))], dtype=float)
    return Plate("w", ("w",), 3.0, outline, (), np.eye(4))


@pytest.mark.parametrize("kerf", [0.05, 0.2, 1.0])
@pytest.mark.parametrize("degrees", [4.0, 12.0, 22.0, 40.0])
def test_sharp_corners_are_left_whole(degrees, kerf):
    """Where the mitre is too long it is cut off, and no side leans into the part by that."""
    plate = wedge(degrees)
    path = cut_path(plate, kerf)
    beam = shapely.LinearRing(path.outer).buffer(kerf / 2 - 1e-6, quad_segs=32)
    assert beam.intersection(plate.polygon).area < 1e-9
    steps = np.linalg.norm(np.roll(path.outer, -1, axis=0) - path.outer, axis=1)
    assert steps.min() >= 0.05
    assert shapely.Polygon(path.outer).hausdorff_distance(plate.polygon) < max(8 * kerf, 1.0)


def test_short_steps_leave_no_short_sides_and_take_nothing_away():
    outline = [(0, 0), (40, 0), (40, 20), (20, 20), (20, 20.03), (0, 20.03)]
    plate = Plate("s", ("s",), 3.0, np.array(outline, dtype=float), (), np.eye(4))
    for kerf in (0.0, 0.2):
        path = cut_path(plate, kerf)
        part = shapely.Polygon(path.outer).buffer(1e-9 - kerf / 2, join_style="mitre")
        assert part.covers(plate.polygon.buffer(-1e-6, join_style="mitre"))
        assert np.linalg.norm(np.diff(path.outer, axis=0), axis=1).min() >= 0.05


def test_a_wide_notch_with_a_sharp_end_is_cut_as_far_as_the_beam_gets():
    outline = [(0, 0), (60, 0), (60, 30), (40, 30), (30, 5), (26, 30), (0, 30)]
    plate = Plate("n", ("n",), 3.0, np.array(outline, dtype=float), (), np.eye(4))
    path = cut_path(plate, 0.3)
    assert len(path.outer) == len(outline)
