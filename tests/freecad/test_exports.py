"""The files of a plate set."""

import json

import Part
import pytest

from incontext.workbench.features.exports import export_plates


def test_all_four_files_are_written(shelf, tmp_path):
    _, _, plates = shelf
    paths = export_plates(plates, tmp_path / "new", "shelf")
    names = {path.name for path in paths}
    assert names == {"shelf.dxf", "shelf.svg", "shelf.step", "shelf.plates.json"}
    assert {path.name for path in (tmp_path / "new").iterdir()} == names


def test_step_and_json_say_the_same(shelf, tmp_path):
    _, _, plates = shelf
    export_plates(plates, tmp_path, "shelf")
    shape = Part.read(str(tmp_path / "shelf.step"))
    body = json.loads((tmp_path / "shelf.plates.json").read_text())
    assert len(shape.Solids) == len(body["plates"]) == 6
    assert shape.Volume == pytest.approx(plates.Shape.Volume, rel=1e-9)


def test_kerf_is_in_the_cut_paths_only(shelf, document, tmp_path):
    _, _, plates = shelf
    export_plates(plates, tmp_path, "plain")
    plates.Kerf = 0.2
    document.recompute()
    export_plates(plates, tmp_path, "kerf")
    files = {p.name: p.read_bytes() for p in tmp_path.iterdir()}
    assert files["plain.plates.json"] == files["kerf.plates.json"]
    assert files["plain.svg"] != files["kerf.svg"]


def test_folder_that_cannot_be_written_is_told(shelf, tmp_path):
    from incontext.solver import SketchError

    _, _, plates = shelf
    (tmp_path / "file").write_text("")
    with pytest.raises(SketchError, match="cannot write"):
        export_plates(plates, tmp_path / "file", "shelf")
