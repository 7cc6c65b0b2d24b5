"""Sizes are fixed and freed by the edges and vertices that are selected in 3D."""

from __future__ import annotations

import FreeCADGui
import pytest

from incontext.solver.dimensions.lengths import driving_sizes_mm, tied_edges
from incontext.workbench.features import pipeline
from incontext.workbench.features.dimension_names import HEIGHT, LENGTH, property_name
from incontext.workbench.features.dimensions import DRIVING
from incontext.workbench.features.picking import dimension_at


def said(sketch):
    return driving_sizes_mm(pipeline.graph_of(sketch.Sketch))


@pytest.fixture
def free(shelf):
    """An edge of the shape that is not tied to the driving one, and its id."""
    sketch, model, _ = shelf
    (driving,) = said(sketch)
    tied = tied_edges(pipeline.graph_of(sketch.Sketch), driving)
    names = [f"Edge{k + 1}" for k in range(len(model.Shape.Edges))]
    found = [(name, dimension_at(model, name).ids[0]) for name in names]
    return next((name, edge) for name, edge in found if edge not in tied)


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
    assert document.UndoNames[0] == "Fix size"
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


def test_a_click_on_a_vertex_fixes_its_height(shelf, document):
    sketch, model, _ = shelf
    top = max(range(len(model.Shape.Vertexes)), key=lambda k: model.Shape.Vertexes[k].Point.z)
    element, height = f"Vertex{top + 1}", model.Shape.BoundBox.ZMax
    name = dimension_at(model, element).name
    assert name.startswith(HEIGHT)
    FreeCADGui.activateWorkbench("InContextWorkbench")
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(model, element)
    FreeCADGui.runCommand("InContext_FixLength")
    assert model.getGroupOfProperty(name) == DRIVING
    assert len(said(sketch)) == 2
    setattr(model, name, 1.25 * height)
    document.recompute()
    assert model.Shape.BoundBox.ZMax == pytest.approx(1.25 * height, abs=1e-6)
