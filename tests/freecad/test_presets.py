"""Materials and machines in drop-downs: they set values, which stay editable."""

from __future__ import annotations

import json

import FreeCAD
import pytest

from incontext.workbench import host
from incontext.workbench.features import presets
from incontext.workbench.features.exports import sheets_of
from incontext.workbench.features.plate_set import make_plate_set
from incontext.workbench.features.shelled_solid import make_shelled_solid


@pytest.fixture
def own(tmp_path, monkeypatch):
    """A person's own folder of presets."""
    monkeypatch.setattr(presets, "own_folder", lambda: tmp_path)
    for folder in presets.KINDS.values():
        (tmp_path / folder).mkdir()
    return tmp_path


@pytest.mark.parametrize(
    "path", list(presets._files("materials")) + list(presets._files("machines"))
)
def test_our_own_presets_are_sound(path):
    preset = presets.read_preset(path)
    assert preset.values


def test_choosing_a_material_sets_its_values_and_they_stay_editable(shelf, document):
    _, _, plates = shelf
    volume = plates.Shape.Volume
    plates.Material = "Birch plywood 6 mm"
    assert (plates.Thickness.Value, plates.Play.Value) == (6.0, 0.1)
    document.recompute()
    assert plates.Status == "made"
    assert plates.Shape.Volume > 1.5 * volume
    plates.Thickness = 5
    document.recompute()
    assert (plates.Thickness.Value, plates.Material) == (5.0, "Birch plywood 6 mm")


def test_a_machine_makes_no_plate_again(shelf, document):
    _, _, plates = shelf
    shape = plates.Shape.Volume
    plates.Machine = "CO2 laser 600 x 400 mm"
    document.recompute()
    assert (plates.Kerf.Value, plates.SheetWidth.Value, plates.Shape.Volume) == (0.15, 600, shape)


@pytest.mark.parametrize(
    ("machine", "relief", "tool"),
    [("3.175 mm cutter, T-bones", "tbone", 3.175), ("2 mm cutter, dog bones", "dogbone", 2.0)],
)
def test_a_router_gets_room_for_its_round_cutter(shelf, document, machine, relief, tool):
    _, _, plates = shelf
    plates.Material = "Birch plywood 6 mm"
    document.recompute()
    plain = sum(len(part.outer) for sheet in sheets_of(plates) for part in sheet.parts)
    volume = plates.Shape.Volume
    plates.Machine = f"Router, {machine} (kerf left to CAM)"
    assert (plates.CornerRelief, plates.ToolDiameter.Value) == (relief, tool)
    document.recompute()
    assert plates.Status == "made"
    relieved = sum(len(part.outer) for sheet in sheets_of(plates) for part in sheet.parts)
    assert relieved > plain + 100, "each inner corner has an arc"
    assert plates.Shape.Volume == pytest.approx(volume), "the relief is for the cut alone"


def test_plates_fit_every_machine(shelf, document):
    _, _, plates = shelf
    plates.Material = "Birch plywood 6 mm"
    for name in presets.presets_of("Machine", "plates"):
        plates.Machine = name
        assert sheets_of(plates), name


def test_prints_have_presets_of_their_own(shelf, document):
    solid = make_shelled_solid(document, shelf[1])
    assert "PLA" in solid.getEnumerationsOfProperty("Material")
    assert "MDF 3 mm" not in solid.getEnumerationsOfProperty("Material")
    solid.Machine = "Printer 220 x 220 x 250 mm, 0.4 mm nozzle"
    assert solid.Bed == FreeCAD.Vector(220, 220, 250)


def test_a_persons_own_presets_come_beside_ours(shelf, document, own):
    body = {"name": "Walnut 5 mm", "makes": "plates", "thickness_mm": 5}
    (own / "materials" / "walnut.json").write_text(json.dumps(body))
    plates = make_plate_set(document, shelf[1])
    assert "MDF 3 mm" in plates.getEnumerationsOfProperty("Material")
    plates.Material = "Walnut 5 mm"
    assert plates.Thickness.Value == 5


def test_undo_brings_the_values_back(shelf, document):
    _, _, plates = shelf
    document.openTransaction("Material")
    plates.Material = "Birch plywood 6 mm"
    document.commitTransaction()
    document.undo()
    assert (plates.Material, plates.Thickness.Value) == ("-", 3.0)
    document.redo()
    assert (plates.Material, plates.Thickness.Value) == ("Birch plywood 6 mm", 6.0)


def test_what_was_taken_stays_though_its_file_is_gone(shelf, document, own, tmp_path):
    body = {"name": "Walnut 5 mm", "makes": "plates", "thickness_mm": 5}
    (own / "materials" / "walnut.json").write_text(json.dumps(body))
    plates = make_plate_set(document, shelf[1])
    plates.Material = "Walnut 5 mm"
    plates.Thickness = 4.5
    document.recompute()
    path = tmp_path / "walnut.FCStd"
    document.saveCopy(str(path))
    (own / "materials" / "walnut.json").unlink()
    again = FreeCAD.openDocument(str(path))
    try:
        opened = again.getObject(plates.Name)
        assert (opened.Material, opened.Thickness.Value) == ("Walnut 5 mm", 4.5)
        assert "Up-to-date" in opened.State
    finally:
        FreeCAD.closeDocument(again.Name)


@pytest.mark.parametrize(
    "text",
    [
        "[]",
        "{",
        '{"name": "A", "makes": "soup"}',
        '{"name": "", "makes": "plates"}',
        '{"name": "A", "makes": "plates", "kerf_mm": -1}',
        '{"name": "A", "makes": "plates", "kerf_mm": 1e999}',
        '{"name": "A", "makes": "plates", "kerf_mm": true}',
        '{"name": "A", "makes": "plates", "colour": "red"}',
        '{"name": "A", "makes": "print", "bed_mm": [1, 2]}',
        "[" * 20000,
        '{"name": "' + 30000 * "a" + '"}',
    ],
)
def test_what_is_no_preset_is_told_and_left_out(own, text, monkeypatch):
    told = []
    monkeypatch.setattr(host, "warn", told.append)
    path = own / "machines" / "wild.json"
    path.write_text(text)
    names = presets.presets_of("Machine", "plates")
    assert "A" not in names
    assert len(names) >= 3
    assert len(told) == 1
    assert str(path) in told[0]


def test_new_objects_begin_with_the_preferred_preset(shelf, document):
    chosen = host.preferences()
    chosen.SetString("MaterialForPlates", "Acrylic 3 mm")
    try:
        plates = make_plate_set(document, shelf[1])
        assert (plates.Material, plates.FingerWidth.Value) == ("Acrylic 3 mm", 15.0)
        assert make_shelled_solid(document, shelf[1]).Material == "-"
    finally:
        chosen.RemString("MaterialForPlates")
