"""File > Export on our own objects, and the kinds of files that FreeCAD knows of."""

from __future__ import annotations

import FreeCAD
import Import
import Part
import pytest

from incontext.workbench.features import exporting
from incontext.workbench.features.exports import (
    PLATE_FORMATS,
    PRINT_FORMATS,
    export_plates,
    export_print,
)
from incontext.workbench.features.shelled_solid import make_shelled_solid

MODULE = "incontext.workbench.features.exporting"


@pytest.mark.parametrize("ending", ["dxf", "svg", "pdf", "step", "stl", "3mf"])
def test_freecad_knows_our_kinds_of_files(ending):
    assert MODULE in FreeCAD.getExportType(ending)


@pytest.mark.parametrize("ending", PLATE_FORMATS)
def test_plates_are_written_as_the_command_writes_them(shelf, tmp_path, ending):
    _, _, plates = shelf
    path = tmp_path / f"one{ending}"
    exporting.export([plates], str(path))
    export_plates(plates, tmp_path, "two", [ending])
    two = (tmp_path / f"two{ending}").read_bytes()
    assert path.stat().st_size > 100
    assert path.read_bytes() == two


@pytest.mark.parametrize("by", ["us", "FreeCAD"])
def test_step_has_the_plates_as_solids(shelf, document, tmp_path, by):
    """Each by its name where we write it; FreeCAD has one name for one object."""
    _, _, plates = shelf
    path, open_before = tmp_path / "plates.step", set(FreeCAD.listDocuments())
    if by == "us":
        exporting.export([plates], str(path))
    else:
        Import.export([plates], str(path))
    assert set(FreeCAD.listDocuments()) == open_before
    assert FreeCAD.ActiveDocument == document
    solids = Part.read(str(path)).Solids
    for solid, plate in zip(solids, plates.Shape.Solids, strict=True):
        assert solid.Volume == pytest.approx(plate.Volume)
        assert solid.BoundBox.Center.isEqual(plate.BoundBox.Center, 1e-6)


@pytest.mark.skipif(
    FreeCAD.Version()[0] == "0", reason="0.20 crashes at assemblies, its window makes them one"
)
def test_freecad_reads_our_step_as_an_assembly_of_named_plates(shelf, tmp_path):
    _, _, plates = shelf
    path = tmp_path / "plates.step"
    exporting.export([plates], str(path))
    document = FreeCAD.newDocument("Read")
    Import.insert(str(path), document.Name)
    parts = [obj for obj in document.Objects if obj.TypeId == "Part::Feature"]
    (whole,) = [obj for obj in document.Objects if obj.TypeId == "App::Part"]
    assert [part.Label for part in parts] == list(plates.PlateIds)
    assert whole.Label == plates.Label
    for part, solid in zip(parts, plates.Shape.Solids, strict=True):
        assert part.Shape.Volume == pytest.approx(solid.Volume)
        assert part.Shape.BoundBox.Center.isEqual(solid.BoundBox.Center, 1e-6)
    FreeCAD.closeDocument(document.Name)


def test_freecads_step_of_a_print_is_the_solid(shelf, document, tmp_path):
    solid = make_shelled_solid(document, shelf[1])
    document.recompute()
    path = tmp_path / "print.step"
    Import.export([solid], str(path))
    shape = Part.read(str(path))
    assert len(shape.Solids) == 1
    assert shape.Volume == pytest.approx(solid.Shape.Volume, rel=1e-6)


def test_the_print_is_written_too(shelf, document, tmp_path):
    solid = make_shelled_solid(document, shelf[1])
    document.recompute()
    for ending in PRINT_FORMATS:
        path = tmp_path / f"print{ending}"
        exporting.export([solid], str(path))
        assert path.stat().st_size > 100
    export_print(solid, tmp_path, "print", (".stl",))


def test_what_cannot_be_written_is_told(shelf, tmp_path):
    sketch, model, plates = shelf
    with pytest.raises(RuntimeError, match="select one"):
        exporting.export([sketch, model], str(tmp_path / "a.dxf"))
    with pytest.raises(RuntimeError, match=r"\.3mf"):
        exporting.export([plates], str(tmp_path / "a.3mf"))
    assert list(tmp_path.iterdir()) == []


def test_only_the_chosen_formats_are_written(shelf, tmp_path):
    paths = export_plates(shelf[2], tmp_path, "shelf", [".svg", ".parts.csv"])
    assert sorted(p.name for p in paths) == ["shelf.parts.csv", "shelf.svg"]
    assert {p.name for p in tmp_path.iterdir()} == {p.name for p in paths}
