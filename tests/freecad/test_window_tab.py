"""The tab of a photo sketch in FreeCAD's window, used with real mouse and keys."""

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui

from incontext.tests.freecad.hands import pump


@pytest.fixture
def window(hands):
    window = FreeCADGui.getMainWindow()
    if not window.isMaximized():
        window.showMaximized()
        pump(1)
    return window


@pytest.fixture
def controller(window, shelf):
    from incontext.workbench.panels.tabs import show_tab
    from incontext.workbench.panels.tiling import show_side_by_side

    controller = show_tab(shelf[0])
    show_side_by_side(controller)
    pump(0.5)
    return controller


def subwindows():
    area = FreeCADGui.getMainWindow().findChild(QtGui.QMdiArea)
    return {w.windowTitle(): w for w in area.subWindowList()}


def on_screen(view, vertex):
    """Where a vertex is on the screen."""
    point = QtCore.QPointF(*view.graph.vertices[vertex])
    return view.viewport().mapToGlobal(view.mapFromScene(point))


def test_photo_left_and_3d_right_share_the_area(controller, window):
    from incontext.workbench.panels.open_tabs import mdi_area, subwindow_of

    left = subwindow_of(controller.tab)
    (right,) = (w for title, w in subwindows().items() if title.startswith("Test"))
    dock = next(d for d in window.findChildren(QtGui.QDockWidget) if d.isVisible())
    for visible in (True, False, True):
        # The area's size changes with what is docked beside it.
        dock.setVisible(visible)
        pump()
        area = mdi_area().viewport().rect()
        assert left.geometry().united(right.geometry()) == area
        assert not left.geometry().intersects(right.geometry())
        assert left.geometry().left() < right.geometry().left()
        assert abs(left.width() - right.width()) <= 1


def test_dragging_a_vertex_changes_the_model_and_undo_brings_it_back(controller, hands, shelf):
    sketch, model, plates = shelf
    text, area, volume = sketch.Sketch, model.Shape.Area, plates.Shape.Volume
    view = controller.tab.view
    start = on_screen(view, "v8")
    hands.drag(start, start + QtCore.QPoint(4, -12))
    assert sketch.Sketch != text
    assert model.Shape.Area != area
    assert plates.Shape.Volume != volume
    assert sketch.Document.UndoNames[0] == "Move vertex"
    moved = sketch.Sketch
    hands.press("ctrl+z")
    assert (sketch.Sketch, model.Shape.Area, plates.Shape.Volume) == (text, area, volume)
    assert on_screen(view, "v8") == start
    hands.press("ctrl+y")
    assert sketch.Sketch == moved


def test_click_on_a_vertex_is_no_edit(controller, hands, shelf):
    undoable = shelf[0].Document.UndoCount
    hands.click(on_screen(controller.tab.view, "v8"))
    assert shelf[0].Document.UndoCount == undoable


def test_delete_does_not_reach_the_selected_object(controller, hands, shelf, document):
    FreeCADGui.Selection.addSelection(shelf[2])
    hands.click(controller.tab.view.viewport().mapToGlobal(QtCore.QPoint(20, 20)))
    hands.press("Delete")
    assert len(document.Objects) == 3


def test_undo_in_the_3d_view_reaches_the_tab(controller, hands, shelf, document):
    view = controller.tab.view
    before = view.graph
    start = on_screen(view, "v8")
    hands.drag(start, start + QtCore.QPoint(4, -12))
    assert view.graph != before
    document.undo()
    pump()
    assert view.graph == before


def test_bar_says_how_the_solve_went(controller, shelf, document):
    import json

    assert "6 plates" in controller.tab.outcome
    body = json.loads(shelf[0].Sketch)
    body["annotations"] = {"ground": body["annotations"]["ground"]}
    shelf[0].Sketch = json.dumps(body)
    document.recompute()
    assert controller.tab.outcome == shelf[1].Message


def test_tab_is_opened_once_and_closes_with_its_document(window, shelf_path):
    from incontext.workbench.commands.import_sketch import imported
    from incontext.workbench.panels.open_tabs import open_tabs
    from incontext.workbench.panels.tabs import show_tab

    document = FreeCAD.newDocument("Other")
    sketch = imported(document, shelf_path)
    assert show_tab(sketch) is show_tab(sketch)
    pump()
    assert len(open_tabs()) == 1
    assert sketch.Label in subwindows()
    title = sketch.Label
    FreeCAD.closeDocument(document.Name)
    pump()
    assert open_tabs() == ()
    assert title not in subwindows()


def test_closed_tab_can_be_opened_again(controller, shelf):
    from incontext.workbench.panels.open_tabs import open_tabs, subwindow_of
    from incontext.workbench.panels.tabs import show_tab

    subwindow_of(controller.tab).close()
    pump()
    assert open_tabs() == ()
    show_tab(shelf[0])
    pump()
    assert len(open_tabs()) == 1


def test_double_click_in_the_tree_opens_the_tab(window, shelf):
    from incontext.workbench.panels.open_tabs import open_tabs

    assert shelf[0].ViewObject.Proxy.doubleClicked(shelf[0].ViewObject)
    pump()
    assert [tab.obj for tab in open_tabs()] == [shelf[0]]
