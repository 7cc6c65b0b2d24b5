"""A person at work with keys alone: no mouse from the new sketch to the plates."""

import FreeCADGui
import pytest
from PySide import QtCore, QtGui

from incontext.tests.freecad import test_window_bookshelf as story
from incontext.tests.freecad.hands import pump, wait_until
from incontext.workbench.canvas.key_cursor import FAST_PX, FINE_PX, STEP_PX
from incontext.workbench.features import pipeline

#: The seven corners of a box that are seen, in the order of the tool, photo px.
BOX = ((230, 392), (360, 480), (560, 400), (557, 190), (357, 230), (227, 170), (420, 135))
WAYS = {(0, 1): "Right", (0, -1): "Left", (1, 1): "Down", (1, -1): "Up"}


class Keys:
    """Ten fingers over one view."""

    def __init__(self, hands, view):
        self.hands, self.view = hands, view

    def press(self, *keys):
        self.hands._do("key", "--delay", "4", *keys)

    def go_to(self, place):
        """Move the cursor to a photo position, by the arrow keys."""
        view = self.view
        wanted = view.mapFromScene(QtCore.QPointF(*place))
        here = view.mapFromScene(QtCore.QPointF(*(view._cursor.place_px or view._hand_px())))
        keys = []
        for axis, off in enumerate((wanted.x() - here.x(), wanted.y() - here.y())):
            arrow, off = WAYS[axis, 1 if off >= 0 else -1], abs(off)
            for held, step in (("shift+", FAST_PX), ("", STEP_PX), ("ctrl+", FINE_PX)):
                keys += (off // step) * [held + arrow]
                off %= step
        if keys:
            self.press(*keys)

    def click(self, *places):
        """Move the cursor to the middle of some photo positions, and press there."""
        self.go_to(tuple(sum(axis) / len(places) for axis in zip(*places, strict=True)))
        self.press("space")

    def choose(self, command, window):
        """Take a command from the workbench's menu."""
        self.press("alt+c")
        self.until(lambda: highlighted(window) == command, "Down")
        self.press("Return")

    def until(self, is_there, key="Tab"):
        """Go on until something is so."""
        for _ in range(80):
            self.press(key)
            if is_there():
                return
        raise AssertionError("never came there")


@pytest.fixture
def keys(window, hands, document, photo_path, monkeypatch):
    """A new sketch over a photo, by the menu."""
    from incontext.workbench.panels import asking
    from incontext.workbench.panels.open_tabs import open_tabs

    monkeypatch.setattr(asking, "ask_for_file", lambda title, kinds: photo_path)
    # The mouse lies in a corner and stays there.
    hands.move(QtCore.QPoint(1, 1))
    window.activateWindow()
    pump(0.3)
    hands.press("alt+c")
    hands.press("Return")
    wait_until(open_tabs)
    pump(0.5)
    return Keys(hands, open_tabs()[0].tab.view)


def test_box_from_a_new_sketch_to_plates_without_a_mouse(keys, document, window):
    view = keys.view
    keys.press("b")
    for place in BOX:
        keys.click(place)
    assert len(view.graph.edges) == 12
    drawn = sorted(view.graph.vertices.values())
    for place in BOX:
        assert min(abs(place[0] - u) + abs(place[1] - v) for u, v in drawn) < 4 / view.zoom
    keys.press("d")
    keys.until(lambda: view._drawing.preview.lit.edges)
    keys.press("space")
    keys.hands.type("20 cm")
    keys.press("Return")
    assert [a.length_mm for a in view.graph.annotations_of("length").values()] == [200]
    solution = pipeline.solution_of(document.getObject("PhotoSketch").Sketch)
    assert solution.status.value == "converged", solution.message
    # A right angle less, by the list of all there is, and back.
    keys.press("s")
    count = len(view.graph.annotations)
    keys.until(lambda: view.selection.annotations, "shift+Tab")
    keys.press("Delete")
    assert len(view.graph.annotations) == count - 1
    keys.press("ctrl+z")
    assert len(view.graph.annotations) == count
    keys.choose("InContext_MakePlates", window)
    wait_until(lambda: document.getObject("PlateSet") is not None)
    assert document.getObject("PlateSet").PlateCount == 6


def highlighted(window):
    """The command that is lit in the open menu."""
    menu = QtGui.QApplication.activePopupWidget()
    action = None if menu is None else menu.activeAction()
    return "" if action is None else action.objectName()


class TestBookshelf:
    """The whole of the bookshelf's story, without a mouse."""

    @pytest.fixture
    def photo_path(self):
        return story.EXAMPLE / "desk.jpg"

    @pytest.fixture
    def places(self):
        return story.corners()

    def test_it_comes_to_its_plates(self, keys, document, window, places):
        keys.press("l")
        for line in (story.BOTTOM, story.TOP, *story.UPRIGHTS, story.SHELF):
            for corner in line:
                keys.click(places[corner])
            # An upright ends where another line is; a line that came round has ended.
            keys.press("Return")
        assert (len(keys.view.graph.vertices), len(keys.view.graph.edges)) == (12, 20)
        for tool, loops in (("a", story.SQUARE), ("g", story.SQUARE[:1]), ("d", [("v1", "v2")])):
            keys.press(tool)
            for loop in loops:
                keys.click(*(places[corner] for corner in loop))
        keys.hands.type("210")
        keys.press("Return", "o")
        wait_until(lambda: "click again" in keys.view.hint)
        for loop in story.OPEN:
            keys.click(*(places[corner] for corner in loop))
        keys.choose("InContext_MakePlates", window)
        wait_until(lambda: document.getObject("PlateSet") is not None)
        plates = document.getObject("PlateSet")
        assert (plates.Status, plates.PlateCount) == ("made", 6), plates.Message


def test_cursor_moves_pushes_zooms_and_goes_when_the_mouse_comes(keys, hands):
    view = keys.view
    keys.press("l", "Right", "Right", "shift+Down")
    before = view._cursor.place_px
    keys.press("ctrl+Left")
    assert before[0] - view._cursor.place_px[0] == pytest.approx(FINE_PX / view.zoom)
    keys.press("space", "shift+Right", "shift+Right", "space", "Return")
    (edge,) = view.graph.edges
    keys.press("s", "Tab", "Tab", "Tab")
    assert view.selection.edges == {edge}
    places = dict(view.graph.vertices)
    keys.press("Up")
    moved = {v: places[v][1] - view.graph.vertices[v][1] for v in places}
    assert list(moved.values()) == pytest.approx(2 * [1 / view.zoom], abs=0.01)
    zoom = view.zoom
    keys.press("plus")
    assert view.zoom > zoom
    keys.press("minus")
    assert view.zoom == pytest.approx(zoom)
    keys.press("Escape", "Right")
    assert not view.selection
    assert view._cursor.place_px is not None
    hands.move(view.viewport().mapToGlobal(QtCore.QPoint(30, 30)))
    assert view._cursor.place_px is None
    view.setFocus()
    keys.press("k")
    assert FreeCADGui.Command.get("InContext_Grid").getAction()[0].isChecked()
    keys.press("k", "i")
    assert not FreeCADGui.Command.get("InContext_Grid").getAction()[0].isChecked()
    assert FreeCADGui.Command.get("InContext_PhotoEdges").getAction()[0].isChecked()
