"""Stories of a person at work in FreeCAD's window, with real mouse and keys."""

import FreeCADGui
import numpy as np
import pytest
from PySide import QtCore, QtGui

from incontext.solver.camera import Camera
from incontext.solver.editing.annotating import set_length
from incontext.solver.editing.elements import add_edge, add_vertex
from incontext.tests.freecad.hands import wait_until
from incontext.workbench.canvas.scene import Findings
from incontext.workbench.features import pipeline

#: A box of 200 x 130 x 160 mm: four corners on the ground, counted around, and those above them.
SIZE = (200.0, 130.0, 160.0)
GROUND = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]


@pytest.fixture(scope="module")
def places():
    """Where the box's corners are in the photo: g0 to g3 on the ground, t0 to t3 above them."""
    eye, target = np.array([390.0, -620.0, 520.0]), np.array([100.0, 65.0, 70.0])
    forward = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(forward, (0.0, 0.0, 1.0))
    right /= np.linalg.norm(right)
    turn = np.array([right, np.cross(forward, right), forward])
    camera = Camera(900.0, np.array([400.0, 300.0]), turn, -turn @ eye)
    corners = {f"g{k}": np.array(g) * SIZE for k, g in enumerate(GROUND)}
    corners |= {f"t{k}": np.add(g, (0, 0, 1)) * SIZE for k, g in enumerate(GROUND)}
    return {name: tuple(camera.project(corner)[0]) for name, corner in corners.items()}


@pytest.fixture
def person(person, places):
    person.places = places
    return person


def on_screen(view, *vertices):
    """The middle of some vertices, on the screen."""
    u, v = np.mean([view.graph.vertices[vertex] for vertex in vertices], axis=0)
    return view.viewport().mapToGlobal(view.mapFromScene(QtCore.QPointF(u, v)))


def draw_box(person):
    """A rectangle for the front, its corners put right, and lines for the rest."""
    person.press("r")
    person.drag(person.at("t0"), person.at("g1"))
    person.press("s")
    for vertex, name in (("v2", "t1"), ("v4", "g0")):
        person.drag(on_screen(person.view, vertex), person.at(name))
    person.press("l")
    for name in ("t0", "t3", "t2", "t1", "g0", "g3", "g2", "g1"):
        person.click(name)
    for k in (2, 3):
        person.drag(person.at(f"t{k}"), person.at(f"g{k}"))


def annotate_box(person):
    """Right angles by a click in each face, what stands on the ground, a length."""
    person.press("a")
    sides = [(f"g{k}", f"g{(k + 1) % 4}", f"t{k}", f"t{(k + 1) % 4}") for k in (1, 2, 3)]
    for face in (*sides, ("g0", "g2"), ("t0", "t2")):
        person.click(*face)
    person.press("g")
    for k in range(4):
        person.click(f"g{k}")
    person.press("d")
    person.click("t0", "t1")
    person.type("20 cm")
    person.press("Return")


def test_box_from_an_empty_sketch_to_plates(person, document):
    draw_box(person)
    graph = person.view.graph
    assert (len(graph.vertices), len(graph.edges)) == (8, 12)
    annotate_box(person)
    sketch = document.getObject("PhotoSketch")
    solution = pipeline.solution_of(sketch.Sketch)
    assert solution.status.value == "converged", solution.message
    found = np.ptp(np.array(list(solution.vertices_mm.values())), axis=0)
    assert sorted(found) == pytest.approx(sorted(SIZE), rel=0.03)
    FreeCADGui.runCommand("InContext_Lift")
    FreeCADGui.runCommand("InContext_MakePlates")
    assert document.getObject("PlateSet").Status == "made"
    assert document.getObject("PlateSet").PlateCount == 6
    assert person.gestures <= 40
    assert person.complaints() == []


def test_every_gesture_is_one_step_to_undo(person, document):
    draw_box(person)
    # One rectangle, two corners moved, six lines in two chains, two lines dragged.
    assert document.UndoCount - 1 == 1 + 2 + 6 + 2
    while document.UndoCount > 1:
        person.hands.press("ctrl+z")
    assert not person.view.graph.vertices
    assert document.UndoNames == ["New sketch from a photo"]


def test_keys_take_tools_and_the_buttons_show_it(person):
    def down():
        names = [f"InContext_Tool{name}" for name in ("Select", "Line", "Rectangle", "Length")]
        return [n for n in names if FreeCADGui.Command.get(n).getAction()[0].isChecked()]

    assert down() == ["InContext_ToolSelect"]
    person.press("l")
    assert (person.view.tool_name, down()) == ("line", ["InContext_ToolLine"])
    FreeCADGui.runCommand("InContext_ToolRectangle")
    assert (person.view.tool_name, down()) == ("rectangle", ["InContext_ToolRectangle"])
    FreeCADGui.runCommand("InContext_ToolRectangle")
    assert down() == ["InContext_ToolRectangle"]
    person.press("Escape")
    assert down() == ["InContext_ToolSelect"]


def test_parameter_numbers_are_shown_by_a_key_and_by_a_button(person):
    person.press("r")
    person.drag(person.at("t0"), person.at("g1"))
    assert person.view.painting.numbers.of(person.view.graph) == {}
    person.press("n")
    # The fourth corner follows from the others.
    assert sorted(person.view.painting.numbers.of(person.view.graph).values())[0] == 0
    person.push("InContext_Numbers")
    assert person.view.painting.numbers.of(person.view.graph) == {}


def test_the_button_makes_construction_of_what_is_selected(person, document):
    person.press("r")
    person.drag(person.at("t0"), person.at("g1"))
    person.press("ctrl+a")
    person.push("InContext_Construction")
    assert len(person.view.graph.construction) == 4
    assert document.UndoNames[0] == "Change construction"


def test_delete_removes_what_is_selected_and_nothing_else(person, document):
    person.press("r")
    person.drag(person.at("t0"), person.at("g1"))
    person.press("s")
    person.hands.click(on_screen(person.view, "v1", "v2"))
    person.press("Delete")
    assert len(person.view.graph.edges) == 3
    assert document.UndoNames[0] == "Delete"
    person.press("ctrl+a")
    person.press("Delete")
    assert not person.view.graph.vertices
    assert document.getObject("PhotoSketch") is not None


def test_what_is_typed_stays_in_the_field_for_a_length(person, document):
    person.press("r")
    person.drag(person.at("t0"), person.at("g1"))
    person.press("d")
    person.hands.click(on_screen(person.view, "v1", "v2"))
    person.type("lost")
    person.press("Return")
    assert person.view.tool_name == "length"
    assert not person.view.graph.annotations_of("length")
    person.press("ctrl+a")
    person.type("21cm")
    person.press("Return")
    (length,) = person.view.graph.annotations_of("length").values()
    assert length.length_mm == 210
    person.press("l")
    assert person.view.tool_name == "line"


def test_a_length_is_typed_after_a_line_and_over_what_is_selected(person, document):
    person.press("l")
    person.click("g0")
    person.click("g1")
    person.type("2*10 cm + 5 mm")
    person.press("Return")
    lengths = person.view.graph.annotations_of("length")
    assert [a.length_mm for a in lengths.values()] == [205]
    # The chain goes on; then the same by the right button's menu.
    person.click("g2")
    person.press("s")
    person.hands.move(person.at("g1", "g2"))
    person.hands.rightclick()
    menu = QtGui.QApplication.activePopupWidget()
    assert [a.text().split("\t")[1] for a in menu.actions() if a.text()][:3] == ["D", "X", "Del"]
    person.press("Down")
    person.press("Return")
    person.type("13 cm")
    person.press("Return")
    lengths = person.view.graph.annotations_of("length")
    assert [a.length_mm for a in lengths.values()] == [205, 130]
    assert document.UndoNames[:2] == ["Set length", "Draw line"]
    # Where nothing has a size, a digit is FreeCAD's.
    person.press("Escape")
    person.press("1")
    assert not person.view.findChild(QtGui.QLineEdit).isVisible()


def test_empty_sketch_says_what_to_do_and_each_tool_what_comes_next(person):
    from incontext.workbench.panels.open_tabs import open_tabs

    tab = open_tabs()[0].tab
    assert "press L" in person.view.painting.invitation
    person.press("l")
    assert any("start of the line" in label.text() for label in tab.findChildren(QtGui.QLabel))
    person.click("t0")
    assert any("end of the line" in label.text() for label in tab.findChildren(QtGui.QLabel))


def test_tab_says_without_a_model_what_is_missing_and_what_disagrees(window, shelf_path, document):
    from incontext.solver import load_sketch
    from incontext.workbench.commands.import_sketch import imported
    from incontext.workbench.panels.tabs import show_tab

    controller = show_tab(imported(document, shelf_path))
    shelf = load_sketch(shelf_path)
    view = controller.tab.view
    assert "converged" not in controller.tab.outcome
    assert view.findings == Findings()
    (length,) = shelf.annotations_of("length").values()
    other = next(e for e in shelf.edges if is_opposite(shelf, e, length.edge))
    controller.write(set_length(shelf, other, 3 * length.length_mm), "Set length")
    wait_until(lambda: not controller.lifting.is_busy)
    assert view.findings.conflicts
    assert controller.tab.outcome == solution_of(controller).message
    hanging, vertex = add_vertex(shelf, (600, 100))
    controller.write(add_edge(hanging, vertex, "v8")[0], "Draw line")
    wait_until(lambda: not controller.lifting.is_busy)
    assert view.findings.loose == {vertex}
    assert controller.tab.outcome == solution_of(controller).message


def is_opposite(graph, edge, other):
    """Whether two edges are said to be parallel, or are opposite sides of a face."""
    return edge != other and any(
        not set(graph.edges[edge]) & set(graph.edges[other])
        and {*graph.edges[edge], *graph.edges[other]} == set(face.loop)
        for face in graph.faces.values()
    )


def solution_of(controller):
    return pipeline.solution_of(controller.obj.Sketch)
