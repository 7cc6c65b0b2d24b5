"""The camera from a rectangle in FreeCAD's window, with real mouse and keys."""

from __future__ import annotations

import numpy as np
import pytest
from PySide import QtCore, QtGui

from incontext.tests.freecad.hands import pump, wait_until
from incontext.tests.rectangles import SMALL, camera_at, corners_mm, seen
from incontext.workbench.features import pipeline
from incontext.workbench.features.known_rectangle import rectangle_of
from incontext.workbench.panels.rectangle_dialog import RectangleDialog

CAMERA = camera_at(38, -65, 480, 900, photo=SMALL)
SQUARE = (100.0, 100.0)


@pytest.fixture(scope="module")
def photo_path(tmp_path_factory):
    """The printed marker on a table."""
    path = tmp_path_factory.mktemp("photo") / "table.png"
    grey = seen(CAMERA, SMALL, np.random.default_rng(2)).astype(np.uint8)
    image = QtGui.QImage(grey.tobytes(), 800, 600, 800, QtGui.QImage.Format_Grayscale8)
    assert image.save(str(path))
    return path


@pytest.fixture
def corners():
    return CAMERA.project(corners_mm(SQUARE))


def dialog():
    """The window that asks, once it is there."""
    found = [w for w in QtGui.QApplication.topLevelWidgets() if isinstance(w, RectangleDialog)]
    return next((w for w in found if w.isVisible()), None)


def answer(ask):
    """Have something done once the window is there: it waits, and this must not."""
    told = []

    def look():
        window = dialog()
        if window is None:
            QtCore.QTimer.singleShot(50, look)
            return
        # Only now the window's own loop runs: hands would wait for themselves.
        told.append(window.words)
        ask(window)

    QtCore.QTimer.singleShot(50, look)
    return told


def click_corners(person, corners, off):
    for (u, v), (across, down) in zip(corners, off, strict=True):
        person.click_at(u + across, v + down)


OFF = ((3, -2), (-3, 2), (2, 3), (-2, -3))


def test_four_clicks_and_a_size_give_the_camera(person, document, corners):
    sketch = document.getObject("PhotoSketch")
    person.press("w")
    assert person.view.tool_name == "camera"
    told = answer(lambda window: window.accept())
    click_corners(person, corners, OFF)
    wait_until(lambda: pipeline.graph_of(sketch.Sketch).camera is not None)
    camera = pipeline.graph_of(sketch.Sketch).camera
    assert camera.focal_px == pytest.approx(900, rel=0.02)
    assert camera.position_mm[2] == pytest.approx(CAMERA.position_mm[2], rel=0.01)
    assert "above the ground" in told[0]
    assert person.view.attraction.grid_shown
    found, size_mm = rectangle_of(sketch.Marker)
    assert size_mm == SQUARE
    ways = [np.abs(np.roll(found, k, axis=0) - corners).max() for k in range(4)]
    assert min(ways) < 0.3, "the clicks were 3 px off, the photo put them right"

    # One step to undo, and the tool's corners go with it.
    person.press("ctrl+z")
    assert pipeline.graph_of(sketch.Sketch).camera is None
    assert sketch.Marker == ""
    person.press("ctrl+shift+z")
    assert pipeline.graph_of(sketch.Sketch).camera is not None

    # A corner that is dragged is put right again, often to the last digit.
    dragged = []
    person.view.rectangle_told.connect(dragged.append)
    u, v = found[0]
    person.hands.move(person.at_px(u, v))
    while person.view.zoom < 1:
        # From far away so small a way is a click.
        person.hands.wheel_up()
    person.drag(person.at_px(u, v), person.at_px(u + 5, v + 4))
    wait_until(lambda: bool(dragged))
    pump(0.5)
    assert np.abs(np.array(dragged[-1].corners_px) - np.array(found)).max() > 3
    assert np.abs(rectangle_of(sketch.Marker)[0] - np.array(found)).max() < 0.3
    person.press("Delete")
    wait_until(lambda: pipeline.graph_of(sketch.Sketch).camera is None)
    assert sketch.Marker == ""


def test_giving_up_leaves_everything(person, document, corners):
    sketch = document.getObject("PhotoSketch")
    before = sketch.Sketch
    person.press("w")
    person.click_at(*corners[0])
    person.press("Escape")
    assert person.view.tool_name == "camera"

    def other_size_then_cancel(window):
        window.kind.setCurrentIndex(window.kind.count() - 1)
        window.width_field.setText("nonsense")
        window.width_field.textEdited.emit("nonsense")
        assert window.found is None
        window.width_field.setText("20 cm")
        window.height_field.setText("20 cm")
        window.height_field.textEdited.emit("20 cm")
        assert window.found is not None
        assert person.view.graph.camera is not None
        window.reject()

    told = answer(other_size_then_cancel)
    click_corners(person, corners, OFF)
    wait_until(lambda: bool(told) and dialog() is None)
    assert sketch.Sketch == before
    assert person.view.graph.camera is None
    assert not person.view.attraction.grid_shown


def test_the_marker_is_found_by_the_key_alone(person, document):
    pytest.importorskip("cv2")
    sketch = document.getObject("PhotoSketch")
    person.press("w")
    told = answer(lambda window: window.accept())
    person.press("w")
    wait_until(lambda: pipeline.graph_of(sketch.Sketch).camera is not None)
    assert told
    camera = pipeline.graph_of(sketch.Sketch).camera
    assert camera.position_mm[2] == pytest.approx(CAMERA.position_mm[2], rel=0.01)


def test_the_marker_is_printed(person, tmp_path, monkeypatch):
    from incontext.workbench.panels import asking

    shown = []
    monkeypatch.setattr(asking, "ask_for_new_file", lambda *_: tmp_path / "marker.pdf")
    monkeypatch.setattr(asking, "ask_for_length", lambda *_: 80.0)
    monkeypatch.setattr(asking, "show_file", shown.append)
    person.push("InContext_PrintMarker")
    assert shown == [tmp_path / "marker.pdf"]
    assert shown[0].read_bytes().startswith(b"%PDF")


def test_a_sketch_over_a_marker_needs_no_length(person, document, corners):
    """A rectangle of 50 x 40 mm on the table beside the marker."""
    sketch = document.getObject("PhotoSketch")
    answer(lambda window: window.accept())
    person.press("w")
    click_corners(person, corners, OFF)
    wait_until(lambda: pipeline.graph_of(sketch.Sketch).camera is not None)
    person.press("k")
    person.press("l")
    places = CAMERA.project([[60, -20, 0], [110, -20, 0], [110, 20, 0], [60, 20, 0]])
    for place in (*places, places[0]):
        person.click_at(*place)
    person.press("Escape")
    person.press("a")
    person.click_at(*places.mean(axis=0))
    person.press("g")
    person.click_at(*places.mean(axis=0))
    person.push("InContext_Lift")
    wait_until(lambda: getattr(document.getObject("LiftedModel"), "Status", "") == "converged")
    solution = pipeline.known_solution_of(sketch.Sketch)
    X = np.array(list(solution.vertices_mm.values()))
    assert not solution.scale_assumed
    assert np.ptp(X[:, 0]) == pytest.approx(50, rel=0.04)
    assert np.ptp(X[:, 1]) == pytest.approx(40, rel=0.04)
