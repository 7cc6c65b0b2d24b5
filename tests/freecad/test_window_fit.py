"""Checking the fit in FreeCAD's window."""

import FreeCADGui
import pytest
from PySide import QtGui

from incontext.solver.serialise import sketch_from_text, sketch_to_text
from incontext.tests.freecad.hands import pump
from incontext.tests.tracing import with_block
from incontext.workbench.features.fit_check import is_fit_check
from incontext.workbench.features.fit_test import is_fit_test


@pytest.fixture(autouse=True)
def workbench():
    FreeCADGui.activateWorkbench("InContextWorkbench")
    yield
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()


@pytest.fixture
def plates(shelf, document):
    sketch, _, plates = shelf
    graph = with_block(sketch_from_text(sketch.Sketch), (150, 20), (60, 120, 200), "b")
    sketch.Sketch = sketch_to_text(with_block(graph, (-40, 60), (60, 80, 120), "d"))
    document.recompute()
    return plates


def the(document, is_kind):
    (found,) = [obj for obj in document.Objects if is_kind(obj)]
    return found


def said():
    """All labels of the task panel."""
    labels = FreeCADGui.getMainWindow().findChildren(QtGui.QLabel)
    return " ".join(label.text() for label in labels if label.isVisible())


def test_the_numbers_are_shown_and_the_overlap_is_red(plates, document):
    from incontext.workbench.features.fit_view import RED

    FreeCADGui.runCommand("InContext_CheckFit")
    pump(0.3)
    check = the(document, is_fit_check)
    assert FreeCADGui.Control.activeDialog()
    assert "20.0 mm into f4" in said()
    assert "it stands" in said()
    assert document.UndoNames[0] == "Check fit"
    marks = check.ViewObject.Proxy._marks
    assert marks.getNumChildren() == 3
    red = marks.getChild(0)
    assert tuple(red.getChild(0).diffuseColor.getValues()[0].getValue()) == pytest.approx(RED)
    assert red.getChild(2).coordIndex.getNum() >= 4 * 12
    # Once more shows the same check again, and makes no second one.
    FreeCADGui.runCommand("InContext_CheckFit")
    the(document, is_fit_check)


def test_marks_go_with_the_object_and_come_back_from_a_file(plates, document, tmp_path):
    import FreeCAD

    FreeCADGui.runCommand("InContext_CheckFit")
    check = the(document, is_fit_check)
    check.ViewObject.Visibility = False
    assert check.ViewObject.Proxy._switch.whichChild.getValue() == -1
    check.ViewObject.Visibility = True
    FreeCADGui.Control.closeDialog()
    path = tmp_path / "shelf.FCStd"
    document.saveCopy(str(path))
    copy = FreeCAD.openDocument(str(path))
    try:
        proxy = the(copy, is_fit_check).ViewObject.Proxy
        assert proxy._marks.getNumChildren() == 3
    finally:
        FreeCAD.closeDocument(copy.Name)


def test_a_double_click_shows_the_numbers_again(plates, document):
    FreeCADGui.runCommand("InContext_CheckFit")
    check = the(document, is_fit_check)
    FreeCADGui.Control.closeDialog()
    assert check.ViewObject.Proxy.doubleClicked(check.ViewObject)
    assert FreeCADGui.Control.activeDialog()


def test_the_fit_test_is_made_undone_and_written(plates, document, tmp_path, monkeypatch):
    from incontext.workbench.panels import asking

    FreeCADGui.runCommand("InContext_MakeFitTest")
    assert document.UndoNames[0] == "Make fit test"
    document.undo()
    assert not [obj for obj in document.Objects if is_fit_test(obj)]
    document.redo()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(the(document, is_fit_test))
    monkeypatch.setattr(asking, "ask_for_folder", lambda title: tmp_path)
    FreeCADGui.runCommand("InContext_ExportPlates")
    assert {p.name for p in tmp_path.iterdir()} == {"Test.coupon.dxf", "Test.coupon.svg"}
    FreeCADGui.Selection.clearSelection()
