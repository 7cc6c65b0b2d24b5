"""Traps of FreeCAD that cost somebody a day once, each with a test.

=============================================  =================================================
trap                                           test
=============================================  =================================================
two geometry kernels in one process            test_shelled_solid, test_mesh_reading
Debian's old pyparsing comes first             test_startup: own packages come first
a package is missing                           test_window_installing
a Proxy is refused, and saving erases it       test_lasting: without the addon, woken before saving
`dumps` and `__getstate__`, JSON, no __init__  here; test_reopening
`onChanged` while a document is read           here
old documents lack properties                  test_objects: of an older version; test_lasting
two addons with our folders                    test_startup: two other addons
no `__file__`, names unseen inside methods     test_startup: start loads nothing heavy
`PySide.QtWidgets`, `QtTest` are missing       here: only QtCore and QtGui are imported
`exec` and `exec_`                             test_window_export, on FreeCAD 1.1
0.20: a tab outlives its document              test_window_tab: closes with its document
Delete and V reach FreeCAD's own shortcuts     test_window_tab: delete does not reach
a shortcut begun elsewhere goes on in a tab    test_window_shortcuts
`GetResources` is asked once: another language test_window_languages: follow the language
`<depend>` installs what, in which Python      test_window_installing: real pip
`PropertyFileIncluded` changes its path        test_reopening, test_lasting
undo of a text property                        test_objects: undo; UndoMode 0 in the console: here
a spreadsheet's alias `H1`, a sheet called S   here
references that nobody can follow              here
`PropertyLength` clamps negatives              here
property names are ASCII identifiers           test_dimensions: names differ
unit fields of preferences keep two decimals   test_window_preferences: speaks inches
`PrintUserError`, two arguments                here: only what 0.20 has is called
EXIF orientation                               canvas/test_photo: turned upright
Qt 6 refuses 256 MB, bombs fill the machine    canvas/test_photo: fill the machine; here
WebP and HEIC cannot be read                   canvas/test_photo: told with what would be
FreeCAD 1.1 gives no label back                test_objects, by `make_photo_sketch(label=...)`
`runCommand` of an inactive command            test_window_commands
units in preferences are FreeCAD's             test_window_preferences: speaks inches
edges are numbered anew                        test_stable_names; by hand on a page:
                                               test_window_drawing
1.x renames links as soon as a shape is new    test_stable_names, on FreeCAD 1.0 and 1.1
documents from a stranger                      test_hostile_documents
`Metadata` differs between versions            test_startup: reads every field
STEP names objects, not solids                 test_exporting: an assembly of named plates
a drawing's page opens at some corner          test_window_drawing: the whole page
=============================================  =================================================
"""

from __future__ import annotations

import ast
import json
from pathlib import Path

import FreeCAD
import pytest
from PySide import QtGui

from incontext.workbench import host
from incontext.workbench.canvas.photo import load_photo
from incontext.workbench.features.dimension_names import LENGTH
from incontext.workbench.features.dimensions import DRIVING

ROOT = Path(host.ROOT)
SOURCES = sorted((ROOT / "workbench").rglob("*.py"))


def driving_name(model) -> str:
    names = [n for n in model.PropertiesList if n.startswith(LENGTH)]
    return next(n for n in names if model.getGroupOfProperty(n) == DRIVING)


def test_state_is_json_under_both_names(shelf):
    for obj in shelf:
        state = obj.Proxy.dumps()
        assert json.loads(json.dumps(state)) == state == obj.Proxy.__getstate__()
        bare = type(obj.Proxy).__new__(type(obj.Proxy))
        bare.__setstate__(state)
        assert bare.dumps() == state


def test_opening_a_document_edits_nothing(shelf, document, tmp_path):
    text, path = shelf[0].Sketch, tmp_path / "shelf.FCStd"
    document.saveCopy(str(path))
    opened = FreeCAD.openDocument(str(path))
    try:
        assert opened.getObject("PhotoSketch").Sketch == text
        assert all("Up-to-date" in obj.State for obj in opened.Objects)
        before = [obj.Shape.Volume for obj in opened.Objects if hasattr(obj, "Shape")]
        opened.recompute()
        assert before == [obj.Shape.Volume for obj in opened.Objects if hasattr(obj, "Shape")]
    finally:
        FreeCAD.closeDocument(opened.Name)


def test_without_undo_edits_work_all_the_same(shelf, document):
    _, model, _ = shelf
    document.UndoMode = 0
    with host.transaction(document, "Edit"):
        setattr(model, driving_name(model), 280)
        document.recompute()
    assert model.Status == "converged"
    assert document.UndoCount <= 1


@pytest.mark.parametrize("sheet_name", ["S", "m", "Sizes"])
def test_a_sheet_called_like_a_unit_drives_or_is_refused_aloud(shelf, document, sheet_name):
    _, model, _ = shelf
    name, before = driving_name(model), model.Shape.BoundBox.XLength
    sheet = document.addObject("Spreadsheet::Sheet", sheet_name)
    sheet.set("A1", "310 mm")
    sheet.setAlias("A1", "width")
    document.recompute()
    model.setExpression(name, f"<<{sheet.Label}>>.width")
    document.recompute()
    assert model.Status == "converged"
    assert getattr(model, name).Value == pytest.approx(310)
    assert model.Shape.BoundBox.XLength != pytest.approx(before)


@pytest.mark.parametrize("alias", ["H1", "A1"])
def test_an_alias_that_is_a_cell_is_refused_by_freecad(document, alias):
    sheet = document.addObject("Spreadsheet::Sheet", "Sizes")
    sheet.set("B2", "310 mm")
    with pytest.raises((ValueError, RuntimeError, FreeCAD.Base.FreeCADError)):
        sheet.setAlias("B2", alias)


def test_a_reference_to_nothing_leaves_the_last_shape(shelf, document):
    sketch, model, plates = shelf
    name, state = driving_name(model), (model.Shape.Area, plates.Shape.Volume, sketch.Sketch)
    sheet = document.addObject("Spreadsheet::Sheet", "Sizes")
    sheet.set("A1", "300 mm")
    sheet.setAlias("A1", "width")
    document.recompute()
    model.setExpression(name, "Sizes.width * 0 + 1 mm / 0")
    document.recompute()
    assert (model.Shape.Area, plates.Shape.Volume, sketch.Sketch) == state
    model.setExpression(name, None)
    model.touch()
    document.recompute()
    assert model.Status == "converged"


def test_a_negative_length_is_refused_not_clamped_into_the_sketch(shelf, document):
    sketch, model, _ = shelf
    text, name = sketch.Sketch, driving_name(model)
    setattr(model, name, -50)
    document.recompute()
    assert sketch.Sketch == text
    assert getattr(model, name).Value > 0


@pytest.mark.parametrize("path", SOURCES, ids=lambda p: str(p.relative_to(ROOT)))
def test_only_what_every_freecad_has_is_used(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("PySide"):
            assert node.module == "PySide"
            assert {alias.name for alias in node.names} <= {"QtCore", "QtGui", "QtSvg"}
        if isinstance(node, ast.Attribute):
            assert node.attr not in ("PrintUserError", "PrintUserWarning", "MidButton", "QRegExp")


def test_a_photo_of_more_than_256_megabytes_is_read(tmp_path):
    path = tmp_path / "large.png"
    image = QtGui.QImage(8200, 8200, QtGui.QImage.Format_Grayscale8)
    image.fill(128)
    image.save(str(path))
    assert load_photo(path, within_px=400).width() == 400
