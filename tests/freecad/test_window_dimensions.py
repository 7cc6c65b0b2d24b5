"""Lengths are fixed and freed by the edges that are selected in 3D."""

from __future__ import annotations

import FreeCADGui
import pytest

from incontext.solver.dimensions import driving_sizes_mm, tied_edges
from incontext.workbench.features import pipeline
from incontext.workbench.features.dimensions import DRIVING, LENGTH, edge_at, property_name


def said(sketch):
    return driving_sizes_mm(pipeline.graph_of(sketch.Sketch))


@pytest.fixture
def free(shelf):
    """An edge of the shape that is not tied to the driving one, and its id."""
    sketch, model, _ = shelf
    (driving,) = said(sketch)
    tied = tied_edges(pipeline.graph_of(sketch.Sketch), driving)
    names = [f"Edge{k + 1}" for k in range(len(model.Shape.Edges))]
    return next((n, edge_at(model, n)) for n in names if edge_at(model, n) not in tied)


def test_one_click_fixes_a_length_and_the_next_frees_it(shelf, document, free):
    sketch, model, _ = shelf
    (element, edge), before = free, sketch.Sketch
    area = model.Shape.Area
    FreeCADGui.activateWorkbench("InContextWorkbench")
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(model, element)
    FreeCADGui.runCommand("InContext_FixLength")
    assert edge in said(sketch)
    assert model.getGroupOfProperty(property_name(LENGTH, edge)) == DRIVING
    assert model.Shape.Area == pytest.approx(area, rel=1e-6)
    assert document.UndoNames[0] == "Fix length"
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(model, element)
    FreeCADGui.runCommand("InContext_FixLength")
    assert edge not in said(sketch)
    document.undo()
    document.undo()
    assert sketch.Sketch == before


def test_without_a_selected_edge_there_is_nothing_to_fix(shelf):
    from incontext.workbench.commands.fix_length import FixLength

    FreeCADGui.Selection.clearSelection()
    assert not FixLength().IsActive()
    FreeCADGui.Selection.addSelection(shelf[1])
    assert not FixLength().IsActive()
