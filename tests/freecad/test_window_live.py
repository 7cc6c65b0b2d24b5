"""The shape follows the hand: in the photo and in the 3D view, before anything is stored."""

import threading
import time
from pathlib import Path

import FreeCADGui
import numpy as np
import pytest
from PySide import QtCore

from incontext.solver import solve
from incontext.tests.freecad.hands import pump, wait_until
from incontext.workbench.features import pipeline
from incontext.workbench.panels.lifting import Lifting

EXAMPLES = Path(__file__).parents[2] / "resources" / "examples"


@pytest.fixture
def controller(hands, shelf):
    from incontext.workbench.panels.tabs import show_tab
    from incontext.workbench.panels.tiling import show_side_by_side

    FreeCADGui.getMainWindow().showMaximized()
    controller = show_tab(shelf[0])
    show_side_by_side(controller)
    pump(0.5)
    return controller


def on_screen(view, vertex):
    point = QtCore.QPointF(*view.graph.vertices[vertex])
    return view.viewport().mapToGlobal(view.mapFromScene(point))


@pytest.fixture
def dragged(controller, hands, shelf):
    """In the middle of a drag; let go afterwards."""
    before = (shelf[0].Sketch, controller.tab.view.lifted)
    start = on_screen(controller.tab.view, "v8")
    hands.move(start)
    hands._do("mousedown", "1")
    for k in range(4):
        hands.move(start + QtCore.QPoint(3 * k, -5 * k))
    wait_until(lambda: controller.tab.view.lifted != before[1])
    wait_until(lambda: not controller.lifting.is_busy)
    yield before
    hands._do("mouseup", "1")


def test_shape_follows_before_the_document_knows(controller, shelf, dragged):
    text, lifted = dragged
    view = controller.tab.view
    assert shelf[0].Sketch == text
    # A drag's few iterations end within a px or two of the true shape.
    solution = solve(view.graph)
    shown = np.array([view.lifted.edges[e] for e in view.graph.edges])
    ends = [[solution.vertices_mm[v] for v in view.graph.edges[e]] for e in view.graph.edges]
    assert shown.reshape(-1, 2) == pytest.approx(
        solution.camera.project(np.array(ends).reshape(-1, 3)), abs=2.0
    )
    assert shown != pytest.approx(np.array([lifted.edges[e] for e in view.graph.edges]), abs=0.5)


def test_preview_stands_in_for_the_plates_until_the_hand_lets_go(controller, hands, shelf, dragged):
    plates = shelf[2].ViewObject
    assert controller.preview.is_shown
    assert plates.SwitchNode.whichChild.getValue() == -1
    assert plates.Visibility
    hands._do("mouseup", "1")
    assert not controller.preview.is_shown
    assert plates.SwitchNode.whichChild.getValue() >= 0
    assert shelf[0].Sketch != dragged[0]
    assert shelf[0].Document.UndoNames[0] == "Move vertex"


def test_escape_brings_the_old_shape_back(controller, hands, dragged):
    text, lifted = dragged
    hands.press("Escape")
    wait_until(lambda: not controller.lifting.is_busy)
    assert controller.obj.Sketch == text
    assert controller.tab.view.lifted == lifted
    assert not controller.preview.is_shown


def test_without_a_model_the_preview_shows_the_shape(document, shelf_path):
    from incontext.workbench.commands.import_sketch import imported
    from incontext.workbench.panels.tabs import show_tab

    controller = show_tab(imported(document, shelf_path))
    wait_until(lambda: controller.preview.is_shown)
    document.removeObject(controller.obj.Name)
    wait_until(lambda: not controller.preview.is_shown)


def test_a_surface_of_revolution_is_shown_before_anything_is_made_of_it(window, document):
    from incontext.workbench.commands.import_sketch import imported
    from incontext.workbench.panels.tabs import show_tab

    (lid,) = (EXAMPLES / "teapot_lid").glob("*.sketch.json")
    controller = show_tab(imported(document, lid))
    wait_until(lambda: controller.preview.is_shown)
    solution = pipeline.known_solution_of(controller.obj.Sketch)
    (turned,) = controller.tab.view.graph.revolutions.values()
    points = np.array(controller.preview._points.point.getValues())
    top = solution.circles[turned.top]
    off = np.hypot(*(points - top.center_mm)[:, :2].T) - top.radius_mm
    on_top = (abs(off) < 1e-3) & (abs(points[:, 2] - top.center_mm[2]) < 1e-3)
    # The circle itself, and the last ring of the surface, which has faces down to the bottom.
    assert on_top.sum() >= 2 * 48
    corners = np.array(controller.preview._faces.coordIndex.getValues())
    used = points[corners[corners >= 0]]
    assert used[:, 2].max() == pytest.approx(top.center_mm[2], abs=1e-3)
    bottom = solution.circles[turned.bottom].center_mm[2]
    assert used[:, 2].min() == pytest.approx(bottom, abs=1e-3)


@pytest.fixture
def slow(monkeypatch, shelf_path):
    """A lifting of solves that take long, and what comes of it."""
    solved_in = []

    def lift(graph, stop=None, start=None):
        solved_in.append(threading.current_thread())
        began = time.thread_time()
        while time.thread_time() - began < 0.15 and not stop():
            sum(range(1000))
        return solve(graph)

    monkeypatch.setattr(pipeline, "lift", lift)
    lifting = Lifting()
    came = []
    lifting.lifted.connect(lambda graph, solution: came.append((graph, solution)))
    yield lifting, came, solved_in
    lifting.deleteLater()


def test_slow_solves_go_on_in_a_thread(slow, shelf_path):
    from incontext.solver import load_sketch

    lifting, came, solved_in = slow
    graph = load_sketch(shelf_path)
    lifting.want(graph)
    wait_until(lambda: came)
    assert came[0][0] is graph
    assert solved_in[0] is threading.main_thread()
    assert solved_in[1] is not threading.main_thread()
    lifting.want(load_sketch(shelf_path))
    wait_until(lambda: len(came) == 2)
    # It has learnt that these are slow.
    assert len(solved_in) == 3
    assert solved_in[2] is not threading.main_thread()


def test_only_what_is_still_wanted_comes(slow, shelf_path):
    from incontext.solver import load_sketch
    from incontext.solver.editing.elements import delete

    lifting, came, _ = slow
    graph = load_sketch(shelf_path)
    other = delete(graph, annotations=graph.annotations_of("length"))
    lifting.want(graph)
    pump(0.1)
    lifting.want(other)
    wait_until(lambda: not lifting.is_busy)
    assert [g for g, _ in came] == [other]
    lifting.want(graph)
    lifting.forget()
    pump(0.4)
    assert len(came) == 1


def test_letting_go_waits_for_no_slow_solve(controller, shelf, monkeypatch):
    from incontext.solver.editing.elements import move_vertices

    lift, started = pipeline.lift, []

    def slow_from_nothing(graph, stop=None, start=None):
        started.append(start)
        if start is None:
            assert stop is not None, "a recompute solved by itself"
            while not stop():
                sum(range(1000))
        return lift(graph, start=start)

    monkeypatch.setattr(pipeline, "lift", slow_from_nothing)
    graph, area = controller.tab.view.graph, shelf[1].Shape.Area
    u, v = graph.vertices["v8"]
    moved = move_vertices(graph, {"v8": (u + 4, v - 9)})
    controller.write(moved, "Move vertex")
    assert [start is None for start in started] == [True, False]
    assert shelf[1].Shape.Area != area
    found, expected = pipeline.known_solution_of(shelf[0].Sketch), solve(moved)
    for vertex, place in expected.vertices_mm.items():
        # Of a drawing that is not exact either is settled to a thousandth of a pixel or so.
        assert found.vertices_mm[vertex] == pytest.approx(place, abs=1e-3)
