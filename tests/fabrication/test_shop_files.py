"""Presets, the PDF, the parts list, edge marks, grain: what a shop gets besides the drawing."""

import csv
import io
import json
import math
import re
import zlib
from collections import Counter
from itertools import pairwise

import ezdxf
import numpy as np
import pytest
import shapely
from fabrication import shapes, slanted

from incontext.workbench.fabrication import FabricationError, PlateSettings, joined_plates
from incontext.workbench.fabrication.drawing import draw
from incontext.workbench.fabrication.dxf import dxf_bytes
from incontext.workbench.fabrication.marks import edge_marks
from incontext.workbench.fabrication.packing import pack
from incontext.workbench.fabrication.parts import parts_csv_bytes, parts_list
from incontext.workbench.fabrication.pdf import POINTS_PER_MM, pdf_bytes
from incontext.workbench.fabrication.presets import PLAIN, PURPOSES, load_preset, preset_names
from incontext.workbench.fabrication.settings import PAGES_MM, ShopSettings
from incontext.workbench.fabrication.sheets import lay_out
from incontext.workbench.fabrication.svg import svg_bytes


@pytest.fixture(scope="module")
def joined():
    return joined_plates(shapes.organizer_6())


@pytest.fixture(scope="module")
def sheets(joined):
    settings = PlateSettings(kerf_mm=0.1, sheet_mm=(300.0, 200.0))
    return lay_out(joined.plates, settings, edge_marks(joined.plates, joined.joints))


def test_presets_are_whole():
    assert "plain" in preset_names()
    for name in preset_names():
        preset = load_preset(name)
        assert set(preset.layers) == set(PURPOSES)
        assert preset.layers["CUT_OUTER"].shown
        assert preset.name


@pytest.mark.parametrize("name", preset_names())
def test_files_have_the_layers_of_the_preset(name, sheets):
    preset = load_preset(name)
    document = ezdxf.read(io.StringIO(dxf_bytes(sheets, preset).decode("cp1252")))
    drawn = Counter(e.dxf.layer for e in document.modelspace())
    paths: Counter[str] = Counter()
    for path in draw(sheets, preset).paths:
        lines = len(path.points) - (0 if path.closed else 1)
        paths[preset.layers[path.purpose].name] += lines if preset.lines else 1
    assert drawn == paths
    for purpose, layer in preset.layers.items():
        if layer.shown and layer.name != "0":
            assert document.layers.get(layer.name).dxf.color == layer.aci
        shown = f'id="{purpose}"'.encode() in svg_bytes(sheets, preset)
        assert shown == layer.shown


@pytest.mark.parametrize("lines", [False, True])
def test_r12_for_old_programs(tmp_path, sheets, lines):
    path = tmp_path / "old.json"
    path.write_text(json.dumps({"dxf": "R12", "lines": lines, "layers": {}}))
    drawing = draw(sheets, load_preset(str(path)))
    text = dxf_bytes(sheets, load_preset(str(path))).decode("cp1252")
    document = ezdxf.read(io.StringIO(text))
    assert document.dxfversion == "AC1009"
    assert "LWPOLYLINE" not in text
    kinds = {entity.dxftype() for entity in document.modelspace()}
    assert kinds == ({"LINE"} if lines else {"POLYLINE"})
    segments = [
        (e.dxf.layer, a, b)
        for e in document.modelspace()
        for a, b in (
            [(e.dxf.start, e.dxf.end)]
            if lines
            else pairwise([*e.points(), *([next(iter(e.points()))] if e.is_closed else [])])
        )
    ]
    for layer in ("CUT_OUTER", "CUT_INNER", "ENGRAVE"):
        drawn = sum(
            shapely.LineString([*p.points, *(p.points[:1] if p.closed else [])]).length
            for p in drawing.paths
            if p.purpose == layer
        )
        read = sum(a.distance(b) for name, a, b in segments if name == layer)
        assert read == pytest.approx(drawn, rel=1e-9)


def test_a_persons_own_preset(tmp_path, sheets):
    path = tmp_path / "makerspace.json"
    body = {"name": "Makerspace", "layers": {"CUT_OUTER": {"name": "Schnitt 2", "rgb": "#00ff00"}}}
    path.write_text(json.dumps(body), encoding="utf-8")
    preset = load_preset(str(path))
    assert preset.layers["CUT_OUTER"].name == "Schnitt 2"
    assert preset.layers["ENGRAVE"] == PLAIN["ENGRAVE"]
    assert b"#00ff00" in svg_bytes(sheets, preset)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("{", "cannot be read"),
        ("[]", "has no layers"),
        ('{"layers": {"CUT": {}}}', "unknown layers .CUT"),
        ('{"layers": {"CUT_OUTER": {"colour": 3}}}', "something unknown of a layer .CUT_OUTER"),
        ('{"layers": {"CUT_OUTER": {"rgb": "red"}}}', "wrong name or colour .CUT_OUTER"),
        ('{"layers": {"CUT_OUTER": {"aci": 0}}}', "wrong name or colour .CUT_OUTER"),
        ('{"layers": {}, "dxf": "R13"}', "a DXF that we do not write"),
        ('{"layers": {}, "lines": 1}', "a DXF that we do not write"),
    ],
)
def test_a_preset_that_cannot_be(tmp_path, text, words):
    path = tmp_path / "mine.json"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(FabricationError, match=words):
        load_preset(str(path))


def test_a_preset_that_is_not_there():
    with pytest.raises(FabricationError, match=r"no preset 'fast'.*plain"):
        load_preset("fast")


def contents_of(pdf: bytes) -> list[str]:
    streams = re.findall(rb"stream\n(.*?)\nendstream", pdf, re.DOTALL)
    return [zlib.decompress(stream).decode() for stream in streams]


def boxes_of(pdf: bytes) -> list[tuple[float, float]]:
    found = re.findall(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", pdf)
    return [(float(w) / POINTS_PER_MM, float(h) / POINTS_PER_MM) for w, h in found]


def test_the_pdf_is_in_true_size(sheets):
    pdf = pdf_bytes(sheets)
    assert pdf == pdf_bytes(sheets)
    assert len(boxes_of(pdf)) == len(sheets) > 1
    for (width, height), text, sheet in zip(boxes_of(pdf), contents_of(pdf), sheets, strict=True):
        drawing = draw([sheet])
        size = np.subtract(drawing.high_mm, drawing.low_mm) + 10.0
        np.testing.assert_allclose((width, height), size, atol=1e-3)
        scale = float(text.split()[0])
        assert scale == pytest.approx(72 / 25.4, abs=1e-5)
        lengths = sum(
            shapely.LineString([*p.points, *(p.points[:1] if p.closed else [])]).length
            for p in drawing.paths
        )
        found = 0.0
        for line in text.splitlines():
            if line.endswith((" s", " S")):
                points = np.array(
                    [
                        [float(n) for n in pair]
                        for pair in re.findall(r"(-?[\d.]+) (-?[\d.]+) [ml]", line)
                    ]
                )
                found += shapely.LineString(
                    [*points, *(points[:1] if line.endswith(" s") else [])]
                ).length
        assert found == pytest.approx(lengths, rel=1e-6)


def test_offsets_of_the_pdf_are_right(sheets):
    pdf = pdf_bytes(sheets)
    start = int(re.search(rb"startxref\n(\d+)", pdf)[1])
    assert pdf[start : start + 4] == b"xref"
    for number, offset in enumerate(re.findall(rb"(\d{10}) 00000 n", pdf), start=1):
        assert pdf[int(offset) :].startswith(f"{number} 0 obj".encode())


@pytest.mark.parametrize("page", PAGES_MM)
def test_tiles_cover_the_sheet(page, sheets):
    pdf = pdf_bytes(sheets[:1], page=page)
    sizes = {tuple(sorted(round(x, 1) for x in box)) for box in boxes_of(pdf)}
    assert sizes == {tuple(sorted(round(x, 1) for x in PAGES_MM[page]))}
    drawing = draw(sheets[:1])
    room = np.array(sorted(PAGES_MM[page])) - 20.0
    area = float(np.prod(np.subtract(drawing.high_mm, drawing.low_mm)))
    assert len(boxes_of(pdf)) >= area / float(np.prod(room))
    assert len(boxes_of(pdf)) <= 4 * math.ceil(area / float(np.prod(room)))
    clips = [re.search(r"([\d.]+) ([\d.]+) \S+ \S+ re W n", text) for text in contents_of(pdf)]
    # Lines on the drawing's very border, as the scale bar is, are not cut in half.
    assert {clip.groups() for clip in clips} == {("9.9", "9.9")}


def test_the_parts_list_adds_up(joined, sheets):
    rows = parts_list(joined.plates, sheets, ShopSettings(cut_mm_s=20.0, sheet_price=4.5))
    kinds = [row.kind for row in rows]
    assert kinds == ["plate"] * 8 + ["sheet"] * len(sheets) + ["total"]
    plates, stock, total = rows[:8], rows[8:-1], rows[-1]
    for plate, row in zip(joined.plates, plates, strict=True):
        assert (row.id, row.face_ids) == (plate.id, plate.face_ids)
        assert row.area_mm2 == pytest.approx(plate.polygon.area)
        # The path runs half a kerf outside: longer by the kerf's share of the corners only.
        assert row.cut_mm == pytest.approx(plate.polygon.length, rel=0.01)
        assert row.time_s > row.cut_mm / 20.0
    assert total.cut_mm == pytest.approx(sum(row.cut_mm for row in plates))
    assert sum(row.cut_mm for row in stock) == pytest.approx(total.cut_mm)
    assert sum(row.used_share * row.area_mm2 for row in stock) == pytest.approx(total.area_mm2)
    assert total.price == pytest.approx(4.5 * len(sheets))
    read = list(csv.DictReader(io.StringIO(parts_csv_bytes(rows).decode())))
    assert [line["id"] for line in read[:8]] == [plate.id for plate in joined.plates]
    assert float(read[-1]["area_mm2"]) == pytest.approx(total.area_mm2, abs=1e-3)


def test_a_price_that_is_not_known_stays_empty(joined, sheets):
    rows = parts_list(joined.plates, sheets, ShopSettings())
    assert {row.price for row in rows} == {None}
    with pytest.raises(FabricationError, match="cutting speed is 0 mm/s"):
        ShopSettings(cut_mm_s=0.0)


@pytest.mark.parametrize("make", [shapes.organizer_6, slanted.crossed, shapes.bookshelf])
def test_both_sides_of_a_joint_have_the_same_mark(make):
    joined = joined_plates(make())
    marks = edge_marks(joined.plates, joined.joints)
    counts = {id_: len(strokes) for id_, strokes in marks.items()}
    assert all(counts.values())
    for plate in joined.plates:
        inner = plate.polygon.buffer(-0.9)
        for stroke in marks[plate.id]:
            assert inner.covers(shapely.MultiPoint(stroke))
    (sheet,) = lay_out(joined.plates, PlateSettings(), marks)
    for part in sheet.parts:
        inside = shapely.Polygon(part.outer, part.inner)
        assert all(inside.covers(shapely.MultiPoint(stroke)) for stroke in part.name)


@pytest.mark.parametrize("grain", ["x", "y"])
def test_the_grain_runs_as_it_is_said(joined, grain):
    sheets = lay_out(joined.plates, PlateSettings(grain=grain))
    sizes = {plate.id: plate.size_mm for plate in joined.plates}
    for part in (part for sheet in sheets for part in sheet.parts):
        width, height = np.ptp(part.outer, axis=0).tolist()
        expected = sizes[part.plate_id][:: -1 if grain == "x" else 1]
        assert (width, height) == pytest.approx(expected, abs=1e-6)


def test_a_plate_that_fits_only_across_the_grain_is_named():
    plates = joined_plates(shapes.tray(500, 100, 40)).plates
    lay_out(plates, PlateSettings(sheet_mm=(300.0, 600.0)))
    with pytest.raises(FabricationError, match="grain along y") as caught:
        lay_out(plates, PlateSettings(sheet_mm=(300.0, 600.0), grain="y"))
    assert "bottom" in caught.value.ids


@pytest.mark.parametrize("seed", range(6))
def test_fifty_plates_need_one_sheet_more_than_their_area_at_most(seed):
    rng = np.random.default_rng(seed)
    high = 300 if seed % 2 else 200
    sizes = [tuple(row) for row in rng.uniform(40, high, (50, 2)).tolist()]
    room = (593.0, 393.0)
    bound = math.ceil(sum(w * h for w, h in sizes) / (room[0] * room[1]))
    assert max(place.sheet for place in pack(sizes, room)) + 1 <= bound + 1


def test_marks_that_are_other_numbers_upside_down_have_a_bar():
    """A 6 has one as soon as there is a 9."""
    joined = joined_plates(shapes.box(120, 80, 60))
    joints = joined.joints[:9]
    assert len(joints) == 9
    with_nine, without = (edge_marks(joined.plates, some) for some in (joints, joints[:8]))
    more = {id_: len(with_nine[id_]) - len(without[id_]) for id_ in without}
    six, nine = joints[5].meeting, joints[8].meeting
    expected = dict.fromkeys(more, 0)
    for id_ in (*six.one[:1], *six.two[:1]):
        expected[id_] += 1  # the bar
    for id_ in (*nine.one[:1], *nine.two[:1]):
        expected[id_] += 2  # the digit and its bar
    assert more == expected
