"""What a model says beside its sketch holds in the tab too, during a drag and after it."""

import math

import FreeCADGui
import numpy as np
import pytest
from PySide import QtCore

from incontext.solver.serialise import sketch_to_text
from incontext.solver.synthetic import Views, photograph_exactly, random_camera
from incontext.solver.synthetic.shapes import house
from incontext.tests.freecad.hands import pump, wait_until
from incontext.workbench.features.dimension_names import ANGLE, LENGTH, dimension_named
from incontext.workbench.features.dimensions import drive
from incontext.workbench.features.lifted_model import make_lifted_model, solution_of
from incontext.workbench.features.photo_sketch import make_photo_sketch

ANGLE_DEG, LENGTH_MM = 131.0, 87.5


@pytest.fixture
def gable(window, document, hands):
    """A house whose eaves' angle is said of its model, and one length by a spreadsheet."""
    from incontext.workbench.panels.tabs import show_tab
    from incontext.workbench.panels.tiling import show_side_by_side

    shape = house()
    graph = photograph_exactly(shape, random_camera(shape, np.random.default_rng(3), Views()))
    sketch = make_photo_sketch(document, sketch_to_text(graph))
    model = make_lifted_model(document, sketch)
    document.recompute()
    slanted = [
        name
        for name in model.PropertiesList
        if name.startswith(ANGLE) and abs(getattr(model, name).Value - 90) > 1
    ]
    angle = dimension_named(max(slanted, key=lambda name: getattr(model, name).Value))
    drive(model, angle, ANGLE_DEG)
    edge = next(name for name in model.PropertiesList if name.startswith(LENGTH))
    sheet = document.addObject("Spreadsheet::Sheet", "Sizes")
    sheet.set("A1", f"{LENGTH_MM} mm")
    sheet.setAlias("A1", "width")
    document.recompute()
    model.setExpression(edge, "Sizes.width")
    document.recompute()
    assert model.Status == "converged", model.Message
    FreeCADGui.getMainWindow().showMaximized()
    controller = show_tab(sketch)
    show_side_by_side(controller)
    pump(0.5)
    return controller, model, angle.ids, dimension_named(edge).ids[0]


def holds(graph, solution, corner, edge):
    along = [
        np.subtract(*(solution.vertices_mm[v] for v in ends))
        for ends in (graph.edges[e] for e in (*corner, edge))
    ]
    cosine = along[0] @ along[1] / math.dist((0, 0, 0), along[0]) / math.dist((0, 0, 0), along[1])
    between = math.degrees(math.acos(cosine))
    # Which way an edge is listed says nothing.
    assert min(abs(between - a) for a in (ANGLE_DEG, 180 - ANGLE_DEG)) < 1e-6
    assert math.dist((0, 0, 0), along[2]) == pytest.approx(LENGTH_MM, abs=1e-6)


def test_the_shape_in_the_hand_keeps_what_the_model_says(gable, hands):
    controller, model, corner, edge = gable
    view, text = controller.tab.view, controller.obj.Sketch
    holds(view.graph, controller.lift[1], corner, edge)
    vertex = next(iter(view.graph.vertices))
    point = QtCore.QPointF(*view.graph.vertices[vertex])
    start = view.viewport().mapToGlobal(view.mapFromScene(point))
    hands.move(start)
    hands._do("mousedown", "1")
    for k in range(4):
        hands.move(start + QtCore.QPoint(3 * k, -4 * k))
    wait_until(lambda: controller.lift[0] is view.graph and not controller.lifting.is_busy)
    assert controller.obj.Sketch == text
    holds(view.graph, controller.lift[1], corner, edge)
    assert set(controller.lift[1].sketch.annotations) == set(view.graph.annotations)
    hands._do("mouseup", "1")
    wait_until(lambda: controller.obj.Sketch != text and not controller.lifting.is_busy)
    holds(view.graph, controller.lift[1], corner, edge)
    # The tab and the model show one and the same solution.
    assert controller.lift[1] is solution_of(model)


def test_a_model_that_says_what_cannot_be_leaves_the_sketch_shown_as_it_is(gable, document):
    controller, _, _, edge = gable
    document.Sizes.set("A1", "-3 mm")
    document.recompute()
    wait_until(lambda: not controller.lifting.is_busy)
    graph, solution = controller.lift
    ends = [solution.vertices_mm[v] for v in graph.edges[edge]]
    assert solution.status.value == "converged"
    assert math.dist(*ends) > 1
