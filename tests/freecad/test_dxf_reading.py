"""FreeCAD's own importer reads from the DXF what the plates are."""

from __future__ import annotations

import json
from itertools import pairwise
from math import dist

import ezdxf
import FreeCAD
import Import
import pytest

from incontext.tests.fabrication.catalogue import CATALOGUE
from incontext.workbench.fabrication import PlateSettings, make_plates
from incontext.workbench.fabrication.drawing import draw
from incontext.workbench.fabrication.dxf import dxf_bytes
from incontext.workbench.fabrication.presets import load_preset
from incontext.workbench.fabrication.sheets import lay_out
from incontext.workbench.features.exports import export_plates

CUT = ("CUT_OUTER", "CUT_INNER")


@pytest.fixture
def imported(tmp_path):
    """Reads a DXF into a document of its own and returns the shapes."""
    document = FreeCAD.newDocument("Imported")

    def read(path):
        Import.readDXF(str(path), document.Name)
        document.recompute()
        return [o.Shape for o in document.Objects if hasattr(o, "Shape")]

    yield read
    FreeCAD.closeDocument(document.Name)


def perimeter(ring) -> float:
    return sum(dist(a, b) for a, b in pairwise([*ring, ring[0]]))


def test_the_cut_length_is_the_plates_perimeter(shelf, imported, tmp_path):
    export_plates(shelf[2], tmp_path, "shelf")
    plates = json.loads((tmp_path / "shelf.plates.json").read_text())["plates"]
    wanted = sum(perimeter(ring) for p in plates for ring in (p["outline"], *p["holes"]))
    drawing = ezdxf.readfile(tmp_path / "shelf.dxf")
    others = [e for e in drawing.modelspace() if e.dxf.layer not in CUT]
    for entity in others:
        drawing.modelspace().delete_entity(entity)
    drawing.saveas(tmp_path / "cuts.dxf")
    shapes = imported(tmp_path / "cuts.dxf")
    assert sum(shape.Length for shape in shapes) == pytest.approx(wanted, rel=1e-6)
    # Every end of a segment is the end of exactly one other: the paths are closed.
    ends: dict[tuple[float, float], int] = {}
    for shape in shapes:
        for vertex in (v for edge in shape.Edges for v in edge.Vertexes):
            key = (round(vertex.X, 4), round(vertex.Y, 4))
            ends[key] = ends.get(key, 0) + 1
    assert set(ends.values()) == {2}


def test_everything_in_the_file_is_read(shelf, imported, tmp_path):
    export_plates(shelf[2], tmp_path, "shelf")
    drawing = ezdxf.readfile(tmp_path / "shelf.dxf")
    wanted = 0.0
    for entity in drawing.modelspace():
        points = [(x, y) for x, y in entity.get_points("xy")]
        closing = points[:1] if entity.closed else []
        wanted += sum(dist(a, b) for a, b in pairwise([*points, *closing]))
    total = sum(shape.Length for shape in imported(tmp_path / "shelf.dxf"))
    assert total == pytest.approx(wanted, rel=1e-6)


@pytest.mark.parametrize(
    ("name", "preset"), [*((name, "plain") for name in CATALOGUE), ("crossed", "simple")]
)
def test_every_shape_has_its_length_and_size(name, preset, imported, tmp_path):
    settings = PlateSettings(kerf_mm=0.15, sheet_mm=(320.0, 300.0))
    drawing = draw(sheets := lay_out(make_plates(CATALOGUE[name].make()), settings))
    path = tmp_path / "plates.dxf"
    path.write_bytes(dxf_bytes(sheets, load_preset(preset)))
    wanted = 0.0
    for line in drawing.paths:
        points = line.points.tolist()
        wanted += sum(dist(a, b) for a, b in pairwise([*points, *points[: int(line.closed)]]))
    read = imported(path)
    assert sum(shape.Length for shape in read) == pytest.approx(wanted, rel=1e-4)
    low = [min(getattr(shape.BoundBox, name) for shape in read) for name in ("XMin", "YMin")]
    high = [max(getattr(shape.BoundBox, name) for shape in read) for name in ("XMax", "YMax")]
    assert low == pytest.approx(drawing.low_mm, abs=1e-4)
    assert high == pytest.approx(drawing.high_mm, abs=1e-4)
