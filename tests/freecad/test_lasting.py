"""Documents outlast versions of FreeCAD, of this addon, and its absence."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

import FreeCAD
import pytest

from incontext.workbench.features.dimension_names import LENGTH, property_name
from incontext.workbench.launch import find_program

#: One document each, saved by that FreeCAD with version 0.1.0 of this addon.
DOCUMENTS = sorted((Path(__file__).parent.parent / "data" / "documents").glob("*.FCStd"))
#: The spreadsheet's cell that the documents' shelves are as wide as, and their thickness.
WIDTH_MM, THICKNESS_MM = 260.0, 4.0


@pytest.fixture(params=DOCUMENTS, ids=lambda path: path.stem)
def saved(request, tmp_path):
    """A copy of a stored document."""
    return Path(shutil.copy(request.param, tmp_path))


@pytest.fixture
def opened(saved):
    document = FreeCAD.openDocument(str(saved))
    yield document
    FreeCAD.closeDocument(document.Name)


def objects(document):
    names = ("PhotoSketch", "LiftedModel", "PlateSet", "ShelledSolid")
    return [document.getObject(name) for name in names]


def proxies(document):
    return [type(obj.Proxy).__name__ for obj in objects(document)]


def test_there_is_a_document_of_every_freecad():
    assert [path.stem for path in DOCUMENTS] == ["0.1.0-on-0.20", "0.1.0-on-1.0", "0.1.0-on-1.1"]


def test_a_stored_document_shows_what_it_showed(opened, shelf_path):
    sketch, model, plates, shell = objects(opened)
    assert proxies(opened) == ["PhotoSketch", "LiftedModel", "PlateSet", "ShelledSolid"]
    assert Path(sketch.Photo).read_bytes() == (shelf_path.parent / "shelf.jpg").read_bytes()
    assert model.Shape.BoundBox.XLength == pytest.approx(WIDTH_MM, abs=1e-6)
    assert len(plates.Shape.Solids) == 6
    assert shell.Shape.Volume > 0


def test_a_stored_document_is_alive(opened):
    sketch, model, plates, shell = objects(opened)
    shapes = [model.Shape.Area, plates.Shape.Volume, shell.Shape.Volume]
    for obj in opened.Objects:
        obj.touch()
    opened.recompute()
    assert [sketch.Status, model.Status, plates.Status, shell.Status] == [
        "ready",
        "converged",
        "made",
        "made",
    ]
    again = [model.Shape.Area, plates.Shape.Volume, shell.Shape.Volume]
    assert again == pytest.approx(shapes, rel=1e-6)
    assert plates.Thickness.Value == THICKNESS_MM
    opened.getObject("Sizes").set("A1", "310 mm")
    opened.recompute()
    assert model.Shape.BoundBox.XLength == pytest.approx(310, abs=1e-6)
    assert plates.Shape.Volume > again[1]


def test_without_the_addon_the_shapes_are_there_and_saving_loses_nothing(saved, tmp_path):
    """Opened and saved by a FreeCAD without us, then opened with us."""
    answer = tmp_path / "answer.json"
    script = tmp_path / "without.py"
    script.write_text(WITHOUT.format(path=str(saved), answer=str(answer)))
    home = tmp_path / "home"
    home.mkdir()
    environment = {**os.environ, "FREECAD_USER_HOME": str(home), "HOME": str(home)}
    program = find_program(window=False)
    subprocess.run(
        [program, str(script)],
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        check=False,
    )
    found = json.loads(answer.read_text())
    assert found["proxies"] == ["None"] * 4
    assert found["solids"] == 6
    document = FreeCAD.openDocument(str(saved))
    assert proxies(document) == ["PhotoSketch", "LiftedModel", "PlateSet", "ShelledSolid"]
    document.getObject("Sizes").set("A1", "310 mm")
    document.recompute()
    model = document.getObject("LiftedModel")
    assert model.Shape.BoundBox.XLength == pytest.approx(310, abs=1e-6)
    document.save()
    FreeCAD.closeDocument(document.Name)


WITHOUT = """
import json, os
import FreeCAD
document = FreeCAD.openDocument({path!r})
names = ("PhotoSketch", "LiftedModel", "PlateSet", "ShelledSolid")
found = dict(
    proxies=[str(document.getObject(name).Proxy) for name in names],
    solids=len(document.getObject("PlateSet").Shape.Solids),
)
document.save()
with open({answer!r}, "w") as file:
    json.dump(found, file)
os._exit(0)
"""


def test_an_object_that_lost_its_proxy_is_woken_before_it_is_saved(shelf, document, tmp_path):
    _, model, plates = shelf
    model.Proxy = plates.Proxy = None
    document.saveAs(str(tmp_path / "shelf.FCStd"))
    assert [type(obj.Proxy).__name__ for obj in (model, plates)] == ["LiftedModel", "PlateSet"]
    setattr(model, property_name(LENGTH, "e1"), 300)
    document.recompute()
    assert model.Status == "converged"


def test_what_is_not_ours_stays_as_it_is(document):
    from incontext.workbench.features.waking import wake

    other = document.addObject("Part::FeaturePython", "Other")
    other.addProperty("App::PropertyString", "Status")
    assert wake(document) == ()
    assert other.Proxy is None


def test_original_properties_are_still_there():
    from incontext.workbench.features.lifted_model import LiftedModel
    from incontext.workbench.features.photo_sketch import PhotoSketch
    from incontext.workbench.features.plate_set import PlateSet
    from incontext.workbench.features.proxy import ORIGINAL_PROPERTIES
    from incontext.workbench.features.shelled_solid import ShelledSolid

    for cls in (PhotoSketch, LiftedModel, PlateSet, ShelledSolid):
        assert ORIGINAL_PROPERTIES[cls.TYPE] <= {prop.name for prop in cls.PROPERTIES}
