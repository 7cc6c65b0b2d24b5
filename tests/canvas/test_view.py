"""The view by itself: zoom, pan, drag, keys."""

from pathlib import Path

import pytest
from PySide import QtCore, QtGui

from incontext.solver import load_sketch
from incontext.solver.graph import SketchGraph
from incontext.workbench.canvas.photo import load_photo
from incontext.workbench.canvas.tools import KEYS
from incontext.workbench.canvas.view import SketchView

Qt = QtCore.Qt
DATA = Path(__file__).parent.parent / "data"


@pytest.fixture
def view():
    view = SketchView(load_sketch(DATA / "shelf.sketch.json"), load_photo(DATA / "shelf.jpg"))
    view.resize(640, 480)
    view.show()
    QtGui.QApplication.processEvents()
    yield view
    view.close()
    view.deleteLater()


def at(view, vertex):
    return view.mapFromScene(QtCore.QPointF(*view.graph.vertices[vertex]))


def mouse(view, kind, pos, button=Qt.LeftButton, buttons=Qt.LeftButton):
    screen = QtCore.QPointF(view.viewport().mapToGlobal(pos))
    event = QtGui.QMouseEvent(kind, QtCore.QPointF(pos), screen, button, buttons, Qt.NoModifier)
    QtGui.QApplication.sendEvent(view.viewport(), event)


def drag(view, start, end, button=Qt.LeftButton):
    mouse(view, QtCore.QEvent.MouseButtonPress, start, button, button)
    mouse(view, QtCore.QEvent.MouseMove, end, Qt.NoButton, button)
    mouse(view, QtCore.QEvent.MouseButtonRelease, end, button, Qt.NoButton)


def key(view, kind, code, modifiers=Qt.NoModifier):
    event = QtGui.QKeyEvent(kind, code, modifiers)
    event.ignore()
    QtGui.QApplication.sendEvent(view, event)
    return event


def edits_of(view):
    edits = []
    view.graph_edited.connect(lambda graph, words: edits.append((graph, words)))
    return edits


def test_whole_photo_is_in_view(view):
    corners = [QtCore.QPointF(x, y) for x in (0, 800) for y in (0, 600)]
    area = view.viewport().rect()
    assert all(area.contains(view.mapFromScene(corner)) for corner in corners)
    view.resize(300, 500)
    QtGui.QApplication.processEvents()
    area = view.viewport().rect()
    assert all(area.contains(view.mapFromScene(corner)) for corner in corners)


def test_dragging_edits_once_and_keeps_the_grip(view):
    edits, before = edits_of(view), view.graph
    start = at(view, "v8") + QtCore.QPoint(3, 2)
    drag(view, start, start + QtCore.QPoint(20, -10))
    ((graph, words),) = edits
    assert words == "Move vertex"
    moved = [b - a for a, b in zip(before.vertices["v8"], graph.vertices["v8"], strict=True)]
    assert moved == pytest.approx([20 / view.zoom, -10 / view.zoom], abs=0.01)
    others = {v: p for v, p in graph.vertices.items() if v != "v8"}
    assert others == {v: p for v, p in before.vertices.items() if v != "v8"}


def test_dragging_beside_a_vertex_edits_nothing(view):
    edits = edits_of(view)
    drag(view, QtCore.QPoint(30, 30), QtCore.QPoint(60, 60))
    drag(view, at(view, "v8"), at(view, "v8"))
    assert edits == []


def test_escape_gives_up_a_drag(view):
    edits, before = edits_of(view), view.graph
    start = at(view, "v8")
    mouse(view, QtCore.QEvent.MouseButtonPress, start)
    mouse(view, QtCore.QEvent.MouseMove, start + QtCore.QPoint(20, 0), Qt.NoButton)
    assert view.graph != before
    key(view, QtCore.QEvent.KeyPress, Qt.Key_Escape)
    mouse(view, QtCore.QEvent.MouseButtonRelease, start, Qt.LeftButton, Qt.NoButton)
    assert view.graph == before
    assert edits == []


def test_middle_button_pans(view):
    before = view.mapToScene(QtCore.QPoint(100, 100))
    drag(view, QtCore.QPoint(100, 100), QtCore.QPoint(140, 90), Qt.MiddleButton)
    after = view.mapToScene(QtCore.QPoint(140, 90))
    assert (after - before).manhattanLength() < 2 / view.zoom


def test_space_pans_with_the_left_button(view):
    edits = edits_of(view)
    key(view, QtCore.QEvent.KeyPress, Qt.Key_Space)
    start = at(view, "v8")
    drag(view, start, start + QtCore.QPoint(30, 0))
    key(view, QtCore.QEvent.KeyRelease, Qt.Key_Space)
    assert edits == []
    assert (at(view, "v8") - start - QtCore.QPoint(30, 0)).manhattanLength() <= 2


def test_zoom_has_bounds(view):
    view.zoom_by(1e9)
    assert view.zoom == pytest.approx(60)
    view.zoom_by(1e-9)
    assert view.zoom == pytest.approx(0.02)


def test_pixels_blend_below_four_times_and_are_squares_above(view):
    chequers = QtGui.QImage(800, 600, QtGui.QImage.Format_RGB32)
    for x in range(800):
        for y in range(600):
            chequers.setPixelColor(x, y, QtGui.QColor("black" if (x + y) % 2 else "white"))
    view.set_graph(SketchGraph())
    view.set_photo(chequers, (800.0, 600.0))
    for times, squares in ((3.0, False), (5.0, True)):
        view.zoom_by(times / view.zoom)
        # It zooms at the pointer, wherever that lies.
        view.centerOn(400, 300)
        image = view.grab().toImage()
        row = {image.pixelColor(x, 200).name() for x in range(200, 300)}
        assert (row <= {"#000000", "#ffffff"}) is squares


def test_fit_key_shows_everything_again(view):
    zoom = view.zoom
    view.zoom_by(5)
    key(view, QtCore.QEvent.KeyPress, Qt.Key_F)
    assert view.zoom == pytest.approx(zoom)


@pytest.mark.parametrize("code", [Qt.Key_Delete, Qt.Key_Space, Qt.Key_F, Qt.Key_Escape])
def test_our_keys_are_claimed_before_shortcuts(view, code):
    assert key(view, QtCore.QEvent.ShortcutOverride, code).isAccepted()


def test_other_keys_are_left_to_freecad(view):
    assert not key(view, QtCore.QEvent.ShortcutOverride, Qt.Key_S, Qt.ControlModifier).isAccepted()


@pytest.mark.parametrize(
    ("code", "modifiers", "signal"),
    [
        (Qt.Key_Z, Qt.ControlModifier, "undo_asked"),
        (Qt.Key_Y, Qt.ControlModifier, "redo_asked"),
        (Qt.Key_Z, Qt.ControlModifier | Qt.ShiftModifier, "redo_asked"),
    ],
)
def test_undo_and_redo_are_asked_for(view, code, modifiers, signal):
    asked = []
    getattr(view, signal).connect(lambda: asked.append(True))
    assert key(view, QtCore.QEvent.ShortcutOverride, code, modifiers).isAccepted()
    key(view, QtCore.QEvent.KeyPress, code, modifiers)
    assert asked == [True]


def test_photo_of_another_size_is_stretched_to_the_sketch(view):
    view.set_photo(QtGui.QImage(400, 300, QtGui.QImage.Format_RGB32), (800.0, 600.0))
    assert view._photo.sceneBoundingRect() == QtCore.QRectF(0, 0, 800, 600)


def test_photo_fades_but_not_the_sketch(view):
    view.set_photo_strength(0)
    view._photo.setVisible(False)
    image = view.grab().toImage()
    colours = {image.pixelColor(x, y).name() for x in range(0, 640, 2) for y in range(0, 480, 2)}
    assert "#1769c9" in colours


def press_key(view, code, modifiers=Qt.NoModifier):
    assert key(view, QtCore.QEvent.ShortcutOverride, code, modifiers).isAccepted()
    key(view, QtCore.QEvent.KeyPress, code, modifiers)


def click(view, pos, button=Qt.LeftButton):
    mouse(view, QtCore.QEvent.MouseMove, pos, Qt.NoButton, Qt.NoButton)
    mouse(view, QtCore.QEvent.MouseButtonPress, pos, button, button)
    mouse(view, QtCore.QEvent.MouseButtonRelease, pos, button, Qt.NoButton)


@pytest.mark.parametrize(("letter", "name"), KEYS.items())
def test_each_tool_has_a_key_and_tells_of_itself(view, letter, name):
    view.use_tool("ground" if name != "ground" else "line")
    told, hints = [], []
    view.tool_changed.connect(told.append)
    view.hint_changed.connect(hints.append)
    press_key(view, getattr(Qt, f"Key_{letter}"))
    assert (view.tool_name, told, hints) == (name, [name], [view.hint])


def test_right_button_ends_a_chain_of_lines(view):
    edits = edits_of(view)
    view.use_tool("line")
    for pos in (QtCore.QPoint(30, 60), QtCore.QPoint(60, 60)):
        click(view, pos)
    click(view, QtCore.QPoint(90, 90), Qt.RightButton)
    click(view, QtCore.QPoint(30, 300))
    assert [words for _, words in edits] == ["Draw line"]


def test_enter_ends_a_group_and_control_a_selects_all(view):
    edits = edits_of(view)
    view.use_tool("parallel")
    for edge in ("e12", "e19"):
        v, w = view.graph.edges[edge]
        click(view, (at(view, v) + at(view, w)) / 2)
    press_key(view, Qt.Key_Return)
    assert [words for _, words in edits] == ["Mark parallel"]
    press_key(view, Qt.Key_A, Qt.ControlModifier)
    assert view.tool_name == "select"
    press_key(view, Qt.Key_Delete)
    assert not view.graph.vertices


def test_the_pointer_shows_what_a_press_does(view):
    assert view.cursor_shape() == Qt.ArrowCursor
    mouse(view, QtCore.QEvent.MouseMove, at(view, "v8"), Qt.NoButton, Qt.NoButton)
    assert view.cursor_shape() == Qt.SizeAllCursor
    view.use_tool("line")
    assert view.cursor_shape() == Qt.CrossCursor


def test_length_is_typed_over_its_edge(view):
    edits = edits_of(view)
    view.use_tool("length")
    field = view.findChild(QtGui.QLineEdit)
    middle = (at(view, "v0") + at(view, "v4")) / 2
    for text, words in (("nonsense", []), ("3/4 in", ["Set length"])):
        click(view, middle)
        assert field.isVisible()
        field.setText(text)
        key(field, QtCore.QEvent.KeyPress, Qt.Key_Return)
        assert [w for _, w in edits] == words
    assert not field.isVisible()
    assert 19.05 in [a.length_mm for a in view.graph.annotations_of("length").values()]
    click(view, middle)
    assert field.text() == "19.05 mm"
    assert key(field, QtCore.QEvent.ShortcutOverride, Qt.Key_L).isAccepted()
    key(field, QtCore.QEvent.KeyPress, Qt.Key_Escape)
    assert not field.isVisible()


def test_empty_sketch_says_what_to_do_until_something_is_begun(view):
    view.set_graph(SketchGraph())
    view.painting.invitation = ""
    bare = view.grab().toImage()
    view.painting.invitation = "Draw something"
    assert view.grab().toImage() != bare
    view.use_tool("line")
    click(view, QtCore.QPoint(30, 30))
    invited = view.grab().toImage()
    view.painting.invitation = ""
    assert view.grab().toImage() == invited


def test_arrow_keys_push_what_is_selected(view):
    edits, before = edits_of(view), view.graph.vertices["v8"]
    key(view, QtCore.QEvent.KeyPress, Qt.Key_Left)
    assert edits == []
    click(view, at(view, "v8"))
    assert key(view, QtCore.QEvent.ShortcutOverride, Qt.Key_Left).isAccepted()
    key(view, QtCore.QEvent.KeyPress, Qt.Key_Left)
    key(view, QtCore.QEvent.KeyPress, Qt.Key_Down, Qt.ShiftModifier)
    moved = [b - a for a, b in zip(before, view.graph.vertices["v8"], strict=True)]
    assert moved == pytest.approx([-1 / view.zoom, 10 / view.zoom], abs=0.01)
    assert [words for _, words in edits] == ["Move", "Move"]


@pytest.fixture
def in_hand(view):
    """In the middle of dragging a vertex; what is grabbed with and without the still picture."""
    mouse(view, QtCore.QEvent.MouseButtonPress, at(view, "v8"))
    place = at(view, "v8")

    def difference(offset):
        mouse(view, QtCore.QEvent.MouseMove, place + offset, Qt.NoButton)
        assert view.is_in_hand
        fast = view.grab().toImage()
        layer, view.painting._still_lines = view.painting._still_lines, lambda *_: None
        slow = view.grab().toImage()
        view.painting._still_lines = layer
        places = [(x, y) for x in range(fast.width()) for y in range(fast.height())]
        lights = ([image.pixelColor(*p).lightness() for p in places] for image in (fast, slow))
        # Where lines cross, another one may lie above.
        return sum(abs(a - b) > 40 for a, b in zip(*lights, strict=True)) / len(places)

    yield difference
    key(view, QtCore.QEvent.KeyPress, Qt.Key_Escape)


def test_what_stands_still_is_painted_as_ever_while_something_is_dragged(view, in_hand):
    assert in_hand(QtCore.QPoint(15, -10)) < 0.001
    picture = view.painting._still._picture
    assert in_hand(QtCore.QPoint(17, -12)) < 0.001
    assert view.painting._still._picture is picture
    view.zoom_by(1.3)
    assert in_hand(QtCore.QPoint(19, -14)) < 0.001
    assert view.painting._still._picture is not picture
