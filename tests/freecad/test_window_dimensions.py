"""Sizes are fixed and freed by the edges and vertices that are selected in 3D."""

from __future__ import annotations

import FreeCADGui
import numpy as np
import pytest

from incontext.solver.dimensions.lengths import driving_sizes_mm, tied_edges
from incontext.solver.serialise import sketch_to_text
from incontext.solver.synthetic import Views, photograph_exactly, random_camera
from incontext.solver.synthetic.shapes import house
from incontext.tests.freecad.hands import pump, wait_until
from incontext.workbench.canvas.qt import QtGui
from incontext.workbench.commands.fix_angle import FixAngle
from incontext.workbench.features import pipeline
from incontext.workbench.features.dimension_names import HEIGHT, LENGTH, property_name
from incontext.workbench.features.dimensions import DRIVING
from incontext.workbench.features.lifted_model import make_lifted_model
from incontext.workbench.features.photo_sketch import make_photo_sketch
from incontext.workbench.features.picking import corner_at, dimension_at


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


@pytest.fixture
def gable(document):
    """A lifted house with a gable, and two edges of its shape that meet at no right angle."""
    shape = house()
    graph = photograph_exactly(shape, random_camera(shape, np.random.default_rng(3), Views()))
    sketch = make_photo_sketch(document, sketch_to_text(graph))
    model = make_lifted_model(document, sketch)
    document.recompute()
    names = [f"Edge{k + 1}" for k in range(len(model.Shape.Edges))]
    corners = {(a, b): corner_at(model, (a, b)) for k, a in enumerate(names) for b in names[:k]}
    slanted = (
        (pair, corner.name)
        for pair, corner in corners.items()
        if corner is not None and abs(getattr(model, corner.name).Value - 90) > 1
    )
    return model, *next(slanted)


def click_angle(model, pair):
    FreeCADGui.Selection.clearSelection()
    for element in pair:
        FreeCADGui.Selection.addSelection(model, element)
    assert FixAngle().IsActive()
    FreeCADGui.runCommand(FixAngle.NAME)


def test_one_click_fixes_an_angle_and_the_next_frees_it(gable, document):
    model, pair, name = gable
    area, angle = model.Shape.Area, getattr(model, name).Value
    FreeCADGui.activateWorkbench("InContextWorkbench")
    click_angle(model, pair)
    assert (model.getGroupOfProperty(name), model.getEditorMode(name)) == (DRIVING, [])
    assert model.Shape.Area == pytest.approx(area, rel=1e-6)
    assert document.UndoNames[0] == "Fix size"
    setattr(model, name, angle - 10)
    document.recompute()
    assert model.Status == "converged"
    assert model.Shape.Area != pytest.approx(area, rel=1e-3)
    click_angle(model, pair)
    assert model.getEditorMode(name) == ["ReadOnly"]
    assert model.Shape.Area == pytest.approx(area, rel=1e-6)


def test_edges_that_do_not_meet_have_no_angle_to_fix(gable, monkeypatch):
    from incontext.workbench.panels import messages

    model, pair, _ = gable
    told = []
    monkeypatch.setattr(messages, "tell", told.append)
    names = [f"Edge{k + 1}" for k in range(len(model.Shape.Edges))]
    apart = next(b for b in names if b != pair[0] and corner_at(model, (pair[0], b)) is None)
    click_angle(model, (pair[0], apart))
    assert len(told) == 1
    assert model.SaidAngles == ""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(model, pair[0])
    assert not FixAngle().IsActive()


def value_cell(window, name):
    """The cell of a property's value in the property editor, and the editor."""
    for tree in window.findChildren(QtGui.QTreeView):
        if tree.metaObject().className() != "Gui::PropertyEditor::PropertyEditor":
            continue
        rows = tree.model()
        for group in (rows.index(k, 0) for k in range(rows.rowCount())):
            for row in range(rows.rowCount(group)):
                shown = str(rows.index(row, 0, group).data()).replace(" ", "")
                if shown.lower() == name.lower():
                    return tree, rows.index(row, 1, group)
    return None


def type_value(window, hands, name, text):
    """Type a property of what is selected in the property editor."""
    wait_until(lambda: value_cell(window, name))
    tree, cell = value_cell(window, name)
    tree.scrollTo(cell)
    pump(0.3)
    hands.click(tree.viewport().mapToGlobal(tree.visualRect(cell).center()))
    hands.double_click(tree.viewport().mapToGlobal(tree.visualRect(cell).center()))
    pump(0.3)
    hands.press("ctrl+a")
    hands.type(text)
    hands.press("Return")


def test_a_fixed_angle_is_typed_in_the_property_editor(gable, document, window, hands):
    model, pair, name = gable
    click_angle(model, pair)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(model)
    type_value(window, hands, name, "117")
    wait_until(lambda: model.SaidAngles.endswith("117.0]]"))
    document.recompute()
    assert model.Status == "converged", model.Message
    assert getattr(model, name).Value == 117
