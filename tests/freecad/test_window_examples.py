"""Every example as a person meets it: opened from the menu, a size changed, cut or printed."""

from __future__ import annotations

from dataclasses import replace

import ezdxf
import FreeCAD
import FreeCADGui
import numpy as np
import pytest
import trimesh

from incontext.tests.freecad.hands import pump
from incontext.workbench.commands.fix_length import fix_or_free
from incontext.workbench.commands.open_example import EXAMPLE_COMMANDS
from incontext.workbench.features.dimension_names import dimension_named
from incontext.workbench.features.dimensions import DRIVING, SHOWN
from incontext.workbench.features.plate_set import is_plate_set, plates_of
from incontext.workbench.panels import export_dialog
from incontext.workbench.panels.open_tabs import open_tabs

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


def enlarge(model):
    """Type a size 10 % larger; where none drives, fix the largest that is shown first.

    There a marker tells the scale: a size that is typed changes nothing but itself.
    """
    names = driving(model)
    if not names:
        shown = [n for n in model.PropertiesList if model.getGroupOfProperty(n) == SHOWN]
        largest = max(shown, key=lambda name: getattr(model, name).Value)
        fix_or_free(model, [dimension_named(largest)])
        names = driving(model)
    setattr(model, names[0], LARGER * getattr(model, names[0]).Value)
    model.Document.recompute()


@pytest.mark.parametrize("command", EXAMPLE_COMMANDS, ids=lambda c: c.EXAMPLE)
def test_opened_resized_and_made(window, no_document_left, command, tmp_path, monkeypatch):
    FreeCADGui.runCommand(command.NAME)
    pump(0.5)
    document = FreeCAD.ActiveDocument
    sketch, model, product = document.Objects[:3]
    assert document.Label == command.MENU_TEXT
    assert [tab.obj for tab in open_tabs()] == [sketch]
    assert (model.Status, product.Status) == ("converged", "made")
    size = product.Shape.BoundBox.DiagonalLength
    enlarge(model)
    assert (model.Status, product.Status) == ("converged", "made"), product.Message
    assert 1.01 * size < product.Shape.BoundBox.DiagonalLength < 1.12 * size

    agree = lambda dialog: replace(dialog.choice, folder=tmp_path)  # noqa: E731
    monkeypatch.setattr(export_dialog, "ask_what_to_export", agree)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(product)
    is_cut = is_plate_set(product)
    FreeCADGui.runCommand("InContext_ExportPlates" if is_cut else "InContext_ExportPrint")
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
