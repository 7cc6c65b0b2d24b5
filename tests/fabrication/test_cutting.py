"""Corner relief, the effect of kerf and play, the fit test."""

import itertools

import numpy as np
import pytest
import shapely
from fabrication import shapes

from incontext.workbench.fabrication import FabricationError, PlateSettings, make_plates
from incontext.workbench.fabrication.cut_paths import cut_path
from incontext.workbench.fabrication.fits import (
    coupon,
    coupon_marks,
    coupon_plays,
    coupon_sheets,
    effects,
)
from incontext.workbench.fabrication.relief import relief_centres, relieved


@pytest.fixture(scope="module")
def plates():
    return {p.id: p for p in make_plates(shapes.bookshelf(), PlateSettings(finger_mm=20))}


@pytest.mark.parametrize("relief", ["dogbone", "tbone"])
def test_a_round_cutter_reaches_every_inner_corner(plates, relief):
    tool = 2.0
    for plate in plates.values():
        rings = relieved(plate, relief, tool)
        cut = shapely.Polygon(rings[0], rings[1:])
        assert cut.is_valid
        assert plate.polygon.buffer(1e-6).covers(cut)
        centres = list(relief_centres(plate, relief, tool))
        corners = [
            corner
            for ring in (plate.outline, *plate.holes)
            for before, corner, after in zip(
                np.roll(ring, 1, axis=0), ring, np.roll(ring, -1, axis=0), strict=True
            )
            if np.cross(np.append(corner - before, 0), np.append(after - corner, 0))[2] < 0
        ]
        assert len(centres) == len(corners)
        for centre, corner in zip(centres, corners, strict=True):
            # The cutter's rim goes through the corner, and nothing of it is left in the way.
            assert np.linalg.norm(centre - corner) == pytest.approx(tool / 2)
            assert shapely.Point(centre).buffer(tool / 2 - 1e-3).intersection(cut).area < 1e-6


def test_tbones_show_on_one_side_only(plates):
    slot = plates["left"].holes[0]
    along = int(np.argmax(np.ptp(slot, axis=0)))
    rings = relieved(plates["left"], "tbone", 1.0)
    cut = rings[1]
    assert np.ptp(cut, axis=0)[along] == pytest.approx(np.ptp(slot, axis=0)[along], abs=0.01)
    assert np.ptp(cut, axis=0)[1 - along] > np.ptp(slot, axis=0)[1 - along] + 0.9


def test_relief_changes_cut_paths_and_no_plate(plates):
    plate = plates["left"]
    plain, boned = cut_path(plate, 0.2), cut_path(plate, 0.2, "dogbone", 1.5)
    assert len(boned.outer) > len(plain.outer)
    assert len(boned.inner) == len(plain.inner)
    assert shapely.Polygon(boned.outer).area < shapely.Polygon(plain.outer).area


def test_a_cutter_thicker_than_a_slot_is_refused(plates):
    with pytest.raises(FabricationError, match="no room for a cutter of 6 mm") as caught:
        cut_path(plates["left"], 0.0, "dogbone", 6.0)
    assert caught.value.ids == ("left",)


def test_effects_name_all_sizes():
    lines = effects(PlateSettings(finger_mm=12, play_mm=0.2, kerf_mm=0.1, relief="dogbone"))
    text = "\n".join(lines)
    assert "slot: 12.2 x 3.2 mm, its cut path 12.1 x 3.1 mm" in text
    assert "finger at a corner: 11.9 mm wide, its cut path 12 mm" in text
    assert "notch at a corner: 12.1 mm wide, its cut path 12 mm" in text
    assert "0.05 mm outside of outlines" in text
    assert "dog bone for a cutter of 3 mm: cuts 0.44 mm" in text
    assert "whoever cuts has to allow for the beam" in "\n".join(effects(PlateSettings()))


def test_effects_are_what_the_plates_have():
    settings = PlateSettings(finger_mm=12, play_mm=0.2)
    left = next(p for p in make_plates(shapes.bookshelf(), settings) if p.id == "left")
    tight = next(p for p in make_plates(shapes.bookshelf()) if p.id == "left")
    for loose_hole, hole in zip(left.holes, tight.holes, strict=True):
        np.testing.assert_allclose(np.ptp(loose_hole, axis=0) - np.ptp(hole, axis=0), 0.2)


def test_the_coupon_has_a_notch_for_each_play():
    settings = PlateSettings(finger_mm=12, play_mm=0.1, thickness_mm=4.0)
    notched, tabbed = coupon(settings)
    assert coupon_plays(settings) == (0.0, 0.05, 0.1, 0.15, 0.2)
    top = notched.polygon.bounds[3]
    line = shapely.LineString([(-1, top - 2), (1000, top - 2)])
    solid = shapely.get_parts(notched.polygon.intersection(line))
    gaps = [b.bounds[0] - a.bounds[2] for a, b in itertools.pairwise(solid)]
    top = tabbed.polygon.bounds[3]
    (tab,) = shapely.get_parts(
        tabbed.polygon.intersection(shapely.LineString([(-1, top - 2), (1000, top - 2)]))
    )
    wide = max(12.0, min(gaps))
    np.testing.assert_allclose(np.array(gaps) - wide, coupon_plays(settings), atol=1e-9)
    assert tab.length == pytest.approx(wide)
    assert notched.polygon.covers(
        shapely.MultiLineString([s.tolist() for s in coupon_marks(settings)])
    )


@pytest.mark.parametrize(
    "settings",
    [
        PlateSettings(play_mm=0.1, kerf_mm=0.2, thickness_mm=4.0),
        PlateSettings(thickness_mm=18.0, finger_mm=40.0, relief="dogbone", tool_mm=6.0),
    ],
)
def test_the_coupon_has_a_slot_for_each_play(settings):
    comb, _ = coupon(settings)
    sizes = sorted(np.ptp(hole, axis=0).tolist() for hole in comb.holes)
    wanted = [settings.thickness_mm + play for play in coupon_plays(settings)]
    np.testing.assert_allclose([high for _, high in sizes], wanted, atol=1e-9)
    borders = shapely.LinearRing(comb.outline)
    gaps = [borders.distance(shapely.LinearRing(hole)) for hole in comb.holes]
    assert min(gaps) >= settings.thickness_mm - 1e-9
    (sheet,) = coupon_sheets(settings)
    if settings.relief == "none":  # its path is narrower by the kerf
        path = next(part for part in sheet.parts if part.plate_id == "notches")
        cut = sorted(np.ptp(ring, axis=0).tolist() for ring in path.inner)
        np.testing.assert_allclose(cut, np.array(sizes) - settings.kerf_mm, atol=1e-6)


def test_the_coupon_has_no_slot_that_cannot_be_cut():
    card = PlateSettings(thickness_mm=0.3, kerf_mm=0.25)
    assert len(coupon(card)[0].holes) == 2
    routed = PlateSettings(thickness_mm=3.0, relief="tbone", tool_mm=3.0)
    assert len(coupon(routed)[0].holes) == 1
    assert coupon_sheets(card)
    assert coupon_sheets(routed)


def test_the_coupon_lies_on_one_small_sheet():
    (sheet,) = coupon_sheets(PlateSettings(kerf_mm=0.2, sheet_mm=(600.0, 400.0)))
    assert len(sheet.parts) == 2
    assert sheet.width_mm < 250
    assert sheet.height_mm < 60
