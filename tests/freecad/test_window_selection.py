"""One selection for the sketch and the 3D view."""

from itertools import pairwise

import FreeCADGui
import pytest

from incontext.tests.freecad.hands import pump
from incontext.workbench.canvas.selection import Selection
from incontext.workbench.features import pipeline
from incontext.workbench.features.plate_set import plates_of


@pytest.fixture
def controller(hands, shelf):
    from incontext.workbench.panels.tabs import show_tab
    from incontext.workbench.panels.tiling import show_side_by_side

    FreeCADGui.getMainWindow().showMaximized()
    controller = show_tab(shelf[0])
    show_side_by_side(controller)
    pump(0.5)
    FreeCADGui.Selection.clearSelection()
    return controller


def overlays(document):
    """What is lit in the 3D view: ends of lines, and points."""
    from pivy import coin

    view = FreeCADGui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")[0]
    scene = view.getSceneGraph()
    children = [scene.getChild(k) for k in range(scene.getNumChildren())]
    found = [c for c in children if c.getTypeId() == coin.SoAnnotation.getClassTypeId()]
    places = [
        [c.getChild(k).point.getNum() for k in (4, 6)] for c in found if c.getNumChildren() == 8
    ]
    return places[0] if places else None


def test_what_is_selected_in_the_sketch_is_lit_in_3d(controller, document):
    view = controller.tab.view
    assert overlays(document) is None
    edge = next(iter(view.graph.edges))
    view.select(Selection(vertices=frozenset(("v8",)), edges=frozenset((edge,))))
    assert overlays(document) == [2, 1]
    view.select(Selection())
    assert overlays(document) is None


@pytest.mark.parametrize("kind", ["Vertex", "Edge", "Face"])
def test_what_is_clicked_on_the_model_is_selected_in_the_sketch(controller, shelf, kind):
    model, view = shelf[1], controller.tab.view
    solution = pipeline.solution_of(shelf[0].Sketch)
    FreeCADGui.Selection.addSelection(model.Document.Name, model.Name, f"{kind}1")
    element = model.Shape.getElement(f"{kind}1")
    chosen = view.selection
    if kind == "Vertex":
        (vertex,) = chosen.vertices
        assert tuple(element.Point) == pytest.approx(solution.vertices_mm[vertex], abs=1e-6)
    else:
        assert chosen.edges
        ends = [solution.vertices_mm[v] for e in chosen.edges for v in solution.edges[e]]
        corners = [tuple(vertex.Point) for vertex in element.Vertexes]
        assert all(any(tuple(end) == pytest.approx(c, abs=1e-6) for c in corners) for end in ends)
    FreeCADGui.Selection.clearSelection()
    assert not view.selection


@pytest.mark.parametrize("kind", ["Face", "Edge", "Vertex"])
def test_clicked_plate_selects_the_edges_of_its_face_and_they_are_lit(
    controller, shelf, document, kind
):
    plates, view = shelf[2], controller.tab.view
    chosen = set()
    for solid, plate in zip(plates.Shape.Solids, plates_of(plates), strict=True):
        FreeCADGui.Selection.clearSelection()
        part = {"Face": solid.Faces, "Edge": solid.Edges, "Vertex": solid.Vertexes}[kind][0]
        everything = getattr(plates.Shape, "Vertexes" if kind == "Vertex" else f"{kind}s")
        number = 1 + next(k for k, other in enumerate(everything) if other.isSame(part))
        FreeCADGui.Selection.addSelection(document.Name, plates.Name, f"{kind}{number}")
        loops = [view.graph.faces[face].loop for face in plate.face_ids]
        sides = {frozenset(pair) for loop in loops for pair in pairwise((*loop, loop[0]))}
        assert {frozenset(view.graph.edges[e]) for e in view.selection.edges} == sides
        assert overlays(document)[0] == 2 * len(sides)
        chosen.add(view.selection)
    assert len(chosen) == 6
