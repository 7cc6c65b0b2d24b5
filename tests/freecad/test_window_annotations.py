"""The panel of annotations, with real mouse and keys."""

import json

import FreeCADGui
import pytest
from PySide import QtCore

from incontext.solver.annotations import RightAngle
from incontext.solver.serialise import sketch_from_text
from incontext.tests.freecad.hands import pump, wait_until
from incontext.tests.scenes import GABLES, loose_house
from incontext.workbench.canvas.selection import Selection
from incontext.workbench.panels import working

SIZE, OFF = 1, 2


@pytest.fixture
def controller(hands, shelf):
    from incontext.workbench.panels.tabs import show_tab
    from incontext.workbench.panels.tiling import show_side_by_side

    FreeCADGui.getMainWindow().showMaximized()
    controller = show_tab(shelf[0])
    show_side_by_side(controller)
    pump(0.5)
    return controller


@pytest.fixture
def panel(controller):
    from incontext.workbench.panels.annotation_dock import the_panel

    panel = the_panel()
    wait_until(lambda: row(panel, "length") is not None)
    return panel


def row(panel, id_):
    rows = {r.data(0, QtCore.Qt.UserRole): r for r in panel._list.rows()}
    return rows.get(id_)


def place(panel, id_, column=0):
    """The middle of a cell on the screen."""
    item = row(panel, id_)
    panel._list.scrollToItem(item)
    pump(0.1)
    rect = panel._list.visualItemRect(item)
    header = panel._list.header()
    x = header.sectionViewportPosition(column) + header.sectionSize(column) // 2
    return panel._list.viewport().mapToGlobal(QtCore.QPoint(x, rect.center().y()))


def test_every_annotation_has_a_row(panel, controller):
    graph = controller.tab.view.graph
    rows = panel._list.rows()
    assert [r.data(0, QtCore.Qt.UserRole) for r in rows] == list(graph.annotations)
    assert not any(r.icon(0).isNull() for r in rows)
    length = graph.annotations["length"]
    assert row(panel, "length").text(SIZE) == f"{length.length_mm:g} mm"


def test_row_and_sketch_select_each_other(panel, controller, hands):
    view = controller.tab.view
    hands.click(place(panel, "length"))
    assert view.selection.annotations == {"length"}
    edge = view.graph.annotations["length"].edge
    view.select(Selection(edges=frozenset((edge,))))
    assert "length" in panel.selected_ids()
    view.select(Selection())
    assert panel.selected_ids() == frozenset()


def test_delete_takes_away_the_annotation_alone(panel, controller, hands, document):
    FreeCADGui.Selection.addSelection(controller.obj)
    hands.click(place(panel, "parallel"))
    hands.press("Delete")
    assert "parallel" not in controller.tab.view.graph.annotations
    assert document.UndoNames[0] == "Delete annotation"
    assert len(document.Objects) == 3
    document.undo()
    wait_until(lambda: row(panel, "parallel") is not None)


@pytest.mark.parametrize("soon_s", [0.3, 0.0])
def test_typed_length_drives_the_model(panel, controller, hands, shelf, monkeypatch, soon_s):
    # Where plates take long, events are handled while the row's editor is still at work.
    monkeypatch.setattr(working, "SOON_S", soon_s)
    area = shelf[1].Shape.Area
    cell = place(panel, "length", SIZE)
    hands.click(cell)
    hands.press("F2")
    pump(0.2)
    item = row(panel, "length")
    if not panel._list.isPersistentEditorOpen(item, SIZE):
        hands.double_click(cell)
    hands.press("ctrl+a")
    hands.type("60 cm")
    hands.press("Return")
    wait_until(lambda: controller.tab.view.graph.annotations["length"].length_mm == 600)
    assert shelf[1].Shape.Area > 1.1 * area
    assert shelf[0].Document.UndoNames[0] == "Set length"
    wait_until(lambda: row(panel, "length").text(SIZE) == "600 mm")


def test_what_disagrees_is_red_and_says_by_how_much(panel, controller):
    body = json.loads(controller.obj.Sketch)
    for k, edge in enumerate(body["annotations"]["equal"]["edges"]):
        wrong = {"kind": "length", "edge": edge, "length_mm": 100.0 + 300.0 * k}
        body["annotations"][f"wrong{k}"] = wrong
    controller.write(sketch_from_text(json.dumps(body)), "Wrong")
    wait_until(lambda: controller.tab.view.findings.conflicts)
    wait_until(lambda: panel._status.text() == controller.tab.outcome_with_links)
    conflicts = controller.tab.view.findings.conflicts
    bad, good = next(iter(conflicts)), next(a for a in body["annotations"] if a not in conflicts)
    colours = [row(panel, id_).foreground(0).color() for id_ in (bad, good)]
    assert colours[0].red() > colours[0].green() + 60
    assert colours[1].red() < colours[1].green() + 20


def test_status_has_links_that_go_there(panel, controller):
    assert panel._status.textFormat() == QtCore.Qt.RichText
    body = json.loads(controller.obj.Sketch)
    body["annotations"] = {"ground": body["annotations"]["ground"]}
    controller.write(sketch_from_text(json.dumps(body)), "Less")
    wait_until(lambda: controller.tab.view.findings.loose)
    wait_until(lambda: "href" in panel._status.text())
    vertices = controller.tab.view.graph.vertices
    vertex = next(v for v in vertices if f">{v}<" in panel._status.text())
    panel._status.linkActivated.emit(vertex)
    assert controller.tab.view.selection.vertices == {vertex}


def test_suggestions_are_ghosts_until_a_click_or_a_key_takes_them(panel, controller, hands):
    view = controller.tab.view
    body = json.loads(controller.obj.Sketch)
    less = dict(list(body["annotations"].items())[:6])
    less["length"] = body["annotations"]["length"]
    body["annotations"] = less
    controller.write(sketch_from_text(json.dumps(body)), "Less")
    wait_until(lambda: view.suggestions)
    pump(0.3)
    offered, said = view.suggestions, set(view.graph.annotations)
    assert said == set(less)
    assert panel._suggested.isVisible()
    ghost = next(g for g in view.painting.ghosts._painted if isinstance(g.suggestion, RightAngle))
    hands.move(view.viewport().mapToGlobal(QtCore.QPoint(*map(round, ghost.handles[0]))))
    assert view.painting.ghosts.lit == ghost.suggestion
    hands._do("click", "1")
    assert len(view.graph.annotations) == len(said) + 1
    controller.undo()
    wait_until(lambda: set(view.graph.annotations) == said)
    view.setFocus()
    wait_until(lambda: view.suggestions == offered)
    hands.press("y")
    assert len(view.graph.annotations) > len(said)
    assert controller.obj.Document.UndoNames[0] == "Take suggestions"


def test_a_loop_that_is_nearly_flat_becomes_a_face_by_a_click(controller, hands):
    """Gables whose peaks nothing holds: no plate would be made of them."""
    view = controller.tab.view
    controller.write(loose_house(0.004, slope_told=False), "House")
    wait_until(lambda: len(view.painting.ghosts._painted) == len(GABLES))
    assert controller.models[0].Status == "underdetermined"
    view.fit()
    # The tab may still be finding its size; places are those of the last painting.
    pump(0.5)
    (place, *_) = view.painting.ghosts._painted[0].handles
    hands.click(view.viewport().mapToGlobal(QtCore.QPoint(*map(round, place))))
    wait_until(lambda: controller.models[0].Status == "converged" and view.suggestions)
    hands.press("y")
    listed = {frozenset(face.loop) for face in view.graph.faces.values()}
    assert set(GABLES) < listed
    wait_until(lambda: controller.models[0].Status == "converged")
    assert len(listed) == 7
    assert view.suggestions == ()


def test_panel_goes_with_the_last_tab(panel, document):
    import FreeCAD

    dock = panel.parentWidget()
    assert dock.isVisible()
    other = FreeCAD.newDocument("Other")
    document.removeObject("PlateSet")
    document.removeObject("LiftedModel")
    document.removeObject("PhotoSketch")
    wait_until(lambda: not dock.isVisible())
    FreeCAD.closeDocument(other.Name)


def symbol_place(controller, id_):
    """Where the symbol of an annotation is on the screen."""
    from incontext.workbench.canvas import said
    from incontext.workbench.canvas.marks import marks_of

    view = controller.tab.view
    places = said.on_photo(view.graph, marks_of(view.graph), 1 / view.zoom)
    symbol = said.symbol_of(places, id_)
    place = symbol.areas[0][2] if id_ == "a1" else said.middle((*symbol.areas, *symbol.lines)[0])
    return view.viewport().mapToGlobal(view.mapFromScene(QtCore.QPointF(*place)))


def test_symbols_are_clicked_and_deleted_in_the_sketch(panel, controller, hands, document):
    view = controller.tab.view
    for id_ in ("a1", "equal", "length"):
        hands.move(symbol_place(controller, id_))
        assert view._drawing.preview.lit.annotations == {id_}
        hands._do("click", "1")
        assert view.selection == Selection(annotations=frozenset((id_,)))
        assert panel.selected_ids() == {id_}
    hands._do("click", "1")
    hands.type("30 cm")
    hands.press("Return")
    assert view.graph.annotations["length"].length_mm == 300
    hands.click(symbol_place(controller, "a1"))
    hands.press("Delete")
    assert "a1" not in view.graph.annotations
    assert document.UndoNames[0] == "Delete"
    assert len(document.Objects) == 3


def test_every_kind_has_an_icon():
    from pathlib import Path

    from incontext.solver.annotations import ANNOTATIONS
    from incontext.workbench.panels.annotation_texts import kind_icon

    assert all(Path(kind_icon(kind)).is_file() for kind in ANNOTATIONS)
