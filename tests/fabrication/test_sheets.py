"""Sheets: everything once, nothing on anything else, nothing over the border."""

import itertools

import numpy as np
import pytest
import shapely
from fabrication import shapes
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import Polygon

from incontext.workbench.fabrication import FabricationError, PlateSettings, make_plates, packing
from incontext.workbench.fabrication.packing import pack
from incontext.workbench.fabrication.sheets import lay_out


def check_layout(sheets, plates, kerf=0.0, margin=5.0, spacing=3.0):
    parts = [part for sheet in sheets for part in sheet.parts]
    assert sorted(part.plate_id for part in parts) == sorted(plate.id for plate in plates)
    for sheet in sheets:
        room = shapely.box(
            margin, margin, sheet.width_mm - margin, sheet.height_mm - margin
        ).buffer(1e-6)
        polygons = [Polygon(part.outer, part.inner) for part in sheet.parts]
        assert all(room.covers(polygon) for polygon in polygons)
        for one, two in itertools.combinations(polygons, 2):
            assert one.distance(two) >= spacing - 1e-6
        for part, polygon in zip(sheet.parts, polygons, strict=True):
            for stroke in part.name:
                assert polygon.covers(shapely.MultiPoint(stroke))


@pytest.mark.parametrize("sheet", [None, (600.0, 400.0), (250.0, 300.0), (260.0, 165.0)])
def test_layouts(sheet):
    plates = make_plates(shapes.organizer_8())
    sheets = lay_out(plates, PlateSettings(sheet_mm=sheet, kerf_mm=0.1))
    check_layout(sheets, plates)
    assert all(part.name for sheet in sheets for part in sheet.parts)


def test_parts_keep_their_size_and_are_not_mirrored():
    plates = {plate.id: plate for plate in make_plates(shapes.organizer_8())}
    for sheet in lay_out(list(plates.values()), PlateSettings()):
        for part in sheet.parts:
            outline = plates[part.plate_id].outline
            assert Polygon(part.outer).area == pytest.approx(Polygon(outline).area)
            assert shapely.LinearRing(part.outer).is_ccw
            edges = [
                np.linalg.norm(r - np.roll(r, 1, axis=0), axis=1) for r in (part.outer, outline)
            ]
            np.testing.assert_allclose(edges[0], edges[1], atol=2e-6)


def test_thicknesses_do_not_share_a_sheet():
    thickness = {"bottom": 6.0, "top": 3.0, "front": 3.0, "back": 3.0, "left": 6.0, "right": 3.0}
    sheets = lay_out(make_plates(shapes.box(thickness=thickness)), PlateSettings())
    assert [(s.thickness_mm, len(s.parts)) for s in sheets] == [(3.0, 4), (6.0, 2)]


def test_a_plate_larger_than_the_sheet_is_named_with_sizes():
    plates = make_plates(shapes.tray())
    with pytest.raises(FabricationError, match=r"150\.0 x 90\.0 mm .* 100 x 80 mm") as caught:
        lay_out(plates, PlateSettings(sheet_mm=(100.0, 80.0)))
    assert "bottom" in caught.value.ids


def test_the_usual_sheet_grows_with_the_plates():
    large = make_plates(shapes.box(800, 300, 300))
    assert lay_out(large, PlateSettings())[0].width_mm == 900.0
    with pytest.raises(FabricationError, match="2500 x 1250"):
        lay_out(make_plates(shapes.box(2600, 300, 300)), PlateSettings())


@settings(max_examples=25, deadline=None)
@given(st.lists(st.tuples(st.floats(5, 90), st.floats(5, 60)), min_size=1, max_size=14))
def test_packing_overlaps_nowhere(sizes):
    places = pack(sizes, (100.0, 70.0))
    boxes = []
    for (w, h), place in zip(sizes, places, strict=True):
        w, h = (h, w) if place.turned else (w, h)
        assert place.x >= -1e-6
        assert place.y >= -1e-6
        assert place.x + w <= 100.0 + 1e-6
        assert place.y + h <= 70.0 + 1e-6
        boxes.append((place.sheet, shapely.box(place.x, place.y, place.x + w, place.y + h)))
    for (s, one), (t, two) in itertools.combinations(boxes, 2):
        assert s != t or one.intersection(two).area < 1e-6


def test_bins_packed_anew_save_one(monkeypatch):
    sides = np.random.default_rng(60022).uniform(33, 393, (50, 2))
    sizes, room = [(w, h) for w, h in sides.tolist()], (593.0, 393.0)
    places = pack(sizes, room)
    monkeypatch.setattr(packing, "_TRIES", 0)
    assert max(p.sheet for p in places) < max(p.sheet for p in pack(sizes, room))
    laid = [
        (place.sheet, shapely.box(place.x, place.y, place.x + w, place.y + h))
        for place, size in zip(places, sizes, strict=True)
        for w, h in [size[::-1] if place.turned else size]
    ]
    assert {n for n, _ in laid} == set(range(max(n for n, _ in laid) + 1))
    assert all(shapely.box(0, 0, *room).buffer(1e-6).covers(area) for _, area in laid)
    for (m, a), (n, b) in itertools.combinations(laid, 2):
        assert m != n or a.intersection(b).area < 1e-6
