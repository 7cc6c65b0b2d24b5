"""Every example as a person meets it: opened from the menu, a size changed, cut or printed."""

from __future__ import annotations

import ezdxf
import FreeCAD
import FreeCADGui
import numpy as np
import pytest
import trimesh
from PySide import QtCore, QtGui

from incontext.tests.freecad.hands import pump, wait_until
from incontext.tests.freecad.test_window_dimensions import type_value
from incontext.workbench.commands.export_plates import ExportPlates
from incontext.workbench.commands.export_print import ExportPrint
from incontext.workbench.commands.fix_length import FixLength
from incontext.workbench.commands.open_example import EXAMPLE_COMMANDS
from incontext.workbench.features.dimension_names import dimension_named
from incontext.workbench.features.dimensions import DRIVING, SHOWN
from incontext.workbench.features.picking import dimension_at
from incontext.workbench.features.plate_set import is_plate_set, plates_of
from incontext.workbench.panels.export_dialog import ExportDialog
from incontext.workbench.panels.open_tabs import open_tabs

#: The workbench's own menu.
OURS = "Modeling in Context"
#: How much larger a person wants it.
LARGER = 1.1


@pytest.fixture
def no_document_left():
    yield
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    pump()


def driving(model):
    """The sizes that can be typed."""
    return [n for n in model.PropertiesList if model.getGroupOfProperty(n) == DRIVING]


def enlarge(window, hands, model):
    """Type a size 10 % larger in the property editor; where none drives, fix the largest first.

    There a marker tells the scale: a size that is typed changes nothing but itself.
    """
    names = driving(model)
    if not names:
        shown = [n for n in model.PropertiesList if model.getGroupOfProperty(n) == SHOWN]
        largest = max(shown, key=lambda name: getattr(model, name).Value)
        edges = (f"Edge{k + 1}" for k in range(len(model.Shape.Edges)))
        edge = next(e for e in edges if dimension_at(model, e) == dimension_named(largest))
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(model, edge)
        choose(window, hands, OURS, FixLength.MENU_TEXT)
        names = driving(model)
    larger = f"{LARGER * getattr(model, names[0]).Value:.2f}"
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(model)
    type_value(window, hands, names[0], larger)
    wait_until(lambda: getattr(model, names[0]).Value == pytest.approx(float(larger)))
    model.Document.recompute()


def choose(window, hands, *titles):
    """Click through FreeCAD's menus, down to a command."""
    menu = window.menuBar()
    for title in titles:
        (action,) = [a for a in menu.actions() if a.text().replace("&", "") == title]
        hands.click(menu.mapToGlobal(menu.actionGeometry(action).center()))
        menu = QtGui.QApplication.activePopupWidget()


def export_into(folder):
    """Say the folder, once the window asks, and push its button."""

    def look():
        windows = QtGui.QApplication.topLevelWidgets()
        found = [w for w in windows if isinstance(w, ExportDialog) and w.isVisible()]
        if not found:
            QtCore.QTimer.singleShot(50, look)
            return
        found[0].findChildren(QtGui.QLineEdit)[1].setText(str(folder))
        found[0].export_button.click()

    QtCore.QTimer.singleShot(50, look)


@pytest.mark.parametrize("command", EXAMPLE_COMMANDS, ids=lambda c: c.EXAMPLE)
def test_opened_resized_and_made(window, hands, no_document_left, command, tmp_path):
    choose(window, hands, OURS, "Examples", command.MENU_TEXT)
    wait_until(open_tabs)
    document = FreeCAD.ActiveDocument
    sketch, model, product = document.Objects[:3]
    assert document.Label == command.MENU_TEXT
    assert [tab.obj for tab in open_tabs()] == [sketch]
    assert (model.Status, product.Status) == ("converged", "made")
    size = product.Shape.BoundBox.DiagonalLength
    enlarge(window, hands, model)
    assert (model.Status, product.Status) == ("converged", "made"), product.Message
    assert 1.01 * size < product.Shape.BoundBox.DiagonalLength < 1.12 * size

    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(product)
    is_cut = is_plate_set(product)
    export_into(tmp_path)
    choose(window, hands, OURS, (ExportPlates if is_cut else ExportPrint).MENU_TEXT)
    wait_until(lambda: any(tmp_path.glob("*.dxf" if is_cut else "*.stl")))
    (drawing if is_cut else printed)(product, tmp_path)


def drawing(plates, folder):
    """The outlines in the DXF file are those of the plates."""
    (path,) = folder.glob("*.dxf")
    outer = ezdxf.readfile(path).modelspace().query("LWPOLYLINE[layer=='CUT_OUTER']")
    assert len(outer) == plates.PlateCount
    widths = [np.ptp(np.array(list(line.vertices())), axis=0) for line in outer]
    found = sorted(tuple(sorted(np.round(w, 2))) for w in widths)
    true = sorted(tuple(sorted(np.round(plate.size_mm, 2))) for plate in plates_of(plates))
    np.testing.assert_allclose(found, true, atol=0.02)


def printed(solid, folder):
    """The mesh in the STL file is closed and as large as the solid."""
    (path,) = folder.glob("*.stl")
    mesh = trimesh.load(path)
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(solid.Shape.Volume, rel=0.01)
