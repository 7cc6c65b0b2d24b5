"""The photo in the window: replaced, pasted, in the 3D view, looked through."""

import FreeCADGui
import numpy as np
import pytest
from PySide import QtCore, QtGui

from incontext.solver.dimensions.lengths import driving_sizes_mm, set_size
from incontext.solver.serialise import sketch_to_text
from incontext.tests.freecad.hands import pump, wait_until
from incontext.workbench.features import pipeline
from incontext.workbench.features.photo_change import with_photo


@pytest.fixture
def controller(hands, shelf):
    from incontext.workbench.panels.tabs import show_tab
    from incontext.workbench.panels.tiling import show_side_by_side

    FreeCADGui.getMainWindow().showMaximized()
    FreeCADGui.activateWorkbench("InContextWorkbench")
    controller = show_tab(shelf[0])
    show_side_by_side(controller)
    pump(0.5)
    return controller


@pytest.fixture
def view(document):
    """The document's 3D view."""
    return FreeCADGui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")[0]


def pasted(colour, width, height):
    image = QtGui.QImage(width, height, QtGui.QImage.Format_RGB32)
    image.fill(QtGui.QColor(colour))
    QtGui.QApplication.clipboard().setImage(image)


def test_pasted_photo_takes_the_place_of_the_old_one(controller, hands, document):
    before = controller.tab.view.graph
    pasted("magenta", 1600, 1200)
    controller.tab.view.setFocus()
    hands.press("ctrl+v")
    wait_until(lambda: controller.tab.view.graph.photo.width_px == 1600)
    graph = controller.tab.view.graph
    # The same view, twice as large: the drawing stays on it.
    for vertex, (u, v) in before.vertices.items():
        assert graph.vertices[vertex] == pytest.approx((2 * u, 2 * v), abs=1e-3)
    assert graph.annotations == before.annotations
    corner = controller.tab.view.mapFromScene(QtCore.QPointF(30, 30))
    shown = controller.tab.view.grab().toImage().pixelColor(corner)
    assert shown == QtGui.QColor("magenta")
    assert document.UndoNames[0] == "Replace photo"
    document.undo()
    assert controller.tab.view.graph == before


def test_photo_of_another_shape_leaves_the_drawing_where_it_is(shelf):
    graph = pipeline.graph_of(shelf[0].Sketch)
    other = with_photo(graph, "other.png", (900, 900), 700.0)
    assert other.vertices == graph.vertices
    assert (other.photo.width_px, other.photo.focal_px) == (900, 700.0)
    larger = with_photo(with_photo(graph, "a.png", (800, 600), 500.0), "b.png", (1600, 1200), None)
    assert larger.photo.focal_px == 1000.0


def test_dropped_file_that_is_no_photo_is_told(controller, monkeypatch, tmp_path):
    from incontext.workbench.panels import controller as module

    told = []
    monkeypatch.setattr(module, "tell", told.append)
    path = tmp_path / "text.jpg"
    path.write_text("no photo")
    text = controller.obj.Sketch
    controller.tab.view.photo_given.emit(path)
    assert "text.jpg" in told[0]
    assert controller.obj.Sketch == text


def test_new_sketch_from_the_clipboard(hands, document):
    from incontext.workbench.panels.open_tabs import open_tabs

    pasted("cyan", 640, 480)
    FreeCADGui.activateWorkbench("InContextWorkbench")
    FreeCADGui.runCommand("InContext_PastePhoto")
    pump(0.5)
    (tab,) = open_tabs()
    assert (tab.tab.view.graph.photo.width_px, tab.tab.view.graph.photo.height_px) == (640, 480)
    wait_until(lambda: tab.tab.view.has_photo)


def test_photo_stands_where_the_camera_sees_it_in_place(controller):
    from incontext.workbench.panels.photo_plane import corners_mm, depth_behind_mm

    solution = pipeline.solution_of(controller.obj.Sketch)
    depth = depth_behind_mm(solution)
    corners = corners_mm(solution.camera, (800, 600), depth)
    seen = solution.camera.project(corners)
    assert seen == pytest.approx(np.array([(0, 600), (800, 600), (800, 0), (0, 0)]), abs=1e-6)
    forward = solution.camera.rotation_cam_from_world[2]
    depths = [(x - solution.camera.position_mm) @ forward for x in solution.vertices_mm.values()]
    assert max(depths) < depth
    root = controller.obj.ViewObject.Proxy.photo_root
    assert root.getNumChildren() == 1


def test_view_through_the_photo_and_back(controller, view, document):
    before = camera_of(view)
    FreeCADGui.runCommand("InContext_ViewThroughPhoto")
    pump(0.5)
    solution = pipeline.solution_of(controller.obj.Sketch)
    eye = view.getCameraNode().position.getValue().getValue()
    assert eye == pytest.approx(solution.camera.position_mm, rel=1e-4, abs=0.01)
    # What FreeCAD's camera sees of two vertices is as far apart, and in the same direction, as in
    # the photo.
    places = [solution.vertices_mm[v] for v in ("v0", "v10")]
    drawn = np.subtract(*(controller.tab.view.graph.vertices[v] for v in ("v0", "v10")))
    seen = np.subtract(*(on_screen(view, place) for place in places)) * (1, -1)
    assert drawn / np.linalg.norm(drawn) == pytest.approx(seen / np.linalg.norm(seen), abs=0.02)
    FreeCADGui.runCommand("InContext_ViewThroughPhoto")
    assert camera_of(view) == before


def test_view_goes_on_looking_through_the_photo_when_sizes_change(controller, view, document):
    """A larger size puts the camera farther off: what is seen stays as it was."""
    FreeCADGui.runCommand("InContext_ViewThroughPhoto")
    pump(0.5)
    before = pipeline.solution_of(controller.obj.Sketch)
    seen = [on_screen(view, before.vertices_mm[v]) for v in ("v0", "v10")]
    graph = controller.tab.view.graph
    (edge, size_mm), *_ = driving_sizes_mm(graph).items()
    controller.obj.Sketch = sketch_to_text(set_size(graph, edge, 1.5 * size_mm))
    document.recompute()
    pump(1.0)
    after = pipeline.solution_of(controller.obj.Sketch)
    eye = view.getCameraNode().position.getValue().getValue()
    assert after.camera.position_mm == pytest.approx(1.5 * before.camera.position_mm, rel=0.01)
    assert eye == pytest.approx(after.camera.position_mm, rel=1e-4, abs=0.01)
    still = [on_screen(view, after.vertices_mm[v]) for v in ("v0", "v10")]
    assert np.array(still) == pytest.approx(np.array(seen), abs=3)
    FreeCADGui.runCommand("InContext_ViewThroughPhoto")
    pump(0.2)


def camera_of(view):
    """A view's camera, but for the clipping planes, which are found anew at each painting."""
    lines = view.getCamera().splitlines()
    return [line for line in lines if "nearDistance" not in line and "farDistance" not in line]


def on_screen(view, place):
    import FreeCAD

    return np.array(view.getPointOnScreen(FreeCAD.Vector(*map(float, place))), dtype=float)
