"""DXF read back by ezdxf, SVG read back as XML: the geometry of the cut paths and nothing else."""

import io
import re
import subprocess
import sys
from collections import Counter
from xml.etree import ElementTree

import ezdxf
import numpy as np
import pytest
import shapely
from fabrication import shapes

from incontext.workbench.fabrication import PlateSettings, make_plates
from incontext.workbench.fabrication.dxf import dxf_bytes
from incontext.workbench.fabrication.presets import PURPOSES
from incontext.workbench.fabrication.sheets import lay_out
from incontext.workbench.fabrication.strokes import text_strokes, text_width_mm
from incontext.workbench.fabrication.svg import svg_bytes


@pytest.fixture(scope="module")
def sheets():
    plates = make_plates(shapes.organizer_8())
    return lay_out(plates, PlateSettings(kerf_mm=0.15, sheet_mm=(300.0, 260.0)))


@pytest.fixture(scope="module")
def document(sheets):
    return ezdxf.read(io.StringIO(dxf_bytes(sheets).decode("cp1252")))


def test_head_of_the_dxf(document):
    assert document.dxfversion == "AC1015"
    assert document.header["$INSUNITS"] == 4
    assert document.header["$MEASUREMENT"] == 1
    assert not document.audit().errors


def test_only_polylines_and_closed_ones_to_cut(document):
    for entity in document.modelspace():
        assert entity.dxftype() == "LWPOLYLINE"
        assert entity.dxf.layer in PURPOSES
        if entity.dxf.layer.startswith("CUT"):
            assert entity.closed


def test_rings_and_lengths_survive(document, sheets):
    parts = [part for sheet in sheets for part in sheet.parts]
    rings = {
        "CUT_OUTER": [part.outer for part in parts],
        "CUT_INNER": [ring for part in parts for ring in part.inner],
    }
    for layer, expected in rings.items():
        read = [
            np.array([p[:2] for p in e.get_points()])
            for e in document.modelspace().query(f'LWPOLYLINE[layer=="{layer}"]')
        ]
        assert len(read) == len(expected) > 0
        length = sum(shapely.LinearRing(ring).length for ring in read)
        assert length == pytest.approx(sum(shapely.LinearRing(r).length for r in expected))
        for ring in read:
            assert shapely.LinearRing(ring).is_simple
            assert np.linalg.norm(ring - np.roll(ring, 1, axis=0), axis=1).min() >= 0.05


def test_no_segment_twice(document):
    seen: Counter[tuple] = Counter()
    for entity in document.modelspace():
        if entity.dxf.layer.startswith("CUT"):
            points = [tuple(np.round(p[:2], 4)) for p in entity.get_points()]
            seen.update(
                tuple(sorted(ends)) for ends in zip(points, [*points[1:], points[0]], strict=True)
            )
    assert max(seen.values()) == 1


def test_holes_stand_before_outlines(document):
    order = [e.dxf.layer for e in document.modelspace() if e.dxf.layer.startswith("CUT")]
    assert order == sorted(order)


def test_extents_are_those_of_the_geometry(document):
    points = np.array([p[:2] for e in document.modelspace() for p in e.get_points()])
    np.testing.assert_allclose(document.header["$EXTMIN"][:2], points.min(axis=0))
    np.testing.assert_allclose(document.header["$EXTMAX"][:2], points.max(axis=0))


def test_the_scale_bar_is_100_mm(document):
    bars = document.modelspace().query('LWPOLYLINE[layer=="SCALE"]')
    widths = [np.ptp([p[0] for p in bar.get_points()]) for bar in bars]
    assert max(widths) == pytest.approx(100.0)


def test_the_same_sheets_give_the_same_bytes(sheets):
    assert dxf_bytes(sheets) == dxf_bytes(sheets)
    assert svg_bytes(sheets) == svg_bytes(sheets)
    assert ezdxf.options.write_fixed_meta_data_for_testing is False


def test_the_svg_shows_the_same_in_millimetres(sheets, document):
    root = ElementTree.fromstring(svg_bytes(sheets))
    assert root.get("width").endswith("mm")
    view = [float(x) for x in root.get("viewBox").split()]
    assert float(root.get("width")[:-2]) == view[2]
    space = document.modelspace()
    for group in root:
        paths = [path.get("d") for path in group]
        assert len(paths) == len(space.query(f'LWPOLYLINE[layer=="{group.get("id")}"]'))
        if group.get("id").startswith("CUT"):
            assert all(path.endswith(" Z") for path in paths)
        for path in paths:
            numbers = np.array([float(x) for x in re.findall(r"-?[\d.]+", path)])
            assert numbers.min() >= 0
            assert numbers.max() <= max(view)


def test_every_letter_is_single_strokes_in_its_box():
    text = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 .,:-_+/#@()?é"
    points = np.vstack(text_strokes(text, (2.0, 3.0), 6.0))
    assert points[:, 0].min() >= 2.0
    assert points[:, 0].max() <= 2.0 + text_width_mm(text, 6.0) + 1e-9
    assert points[:, 1].min() >= 3.0
    assert points[:, 1].max() <= 9.0
    assert text_width_mm("", 6.0) == 0.0


def test_plates_to_dxf_need_no_cad_kernel():
    code = (
        "import sys; from incontext.workbench.fabrication import make_plates, PlateSettings;"
        "from incontext.workbench.fabrication import dxf, sheets, svg, plates_json;"
        "assert not {'cadquery', 'OCP', 'FreeCAD', 'PySide'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)
