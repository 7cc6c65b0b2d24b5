"""A TechDraw page of the plates, in the real window: views are worked out on the side there."""

from __future__ import annotations

import warnings

import FreeCADGui
import pytest
from PySide import QtCore, QtGui

from incontext.tests.freecad.hands import pump, wait_until
from incontext.workbench.commands.draw_plates import SETTLING_MS, drawing_for
from incontext.workbench.features.flat_plate import is_flat_plate
from incontext.workbench.features.plate_drawing import PAGE_MM, views_are_ready
from incontext.workbench.features.plate_set import plates_of
from incontext.workbench.panels.waiting import wait_for


@pytest.fixture
def drawn(window, shelf, document):
    page = drawing_for(shelf[2])
    return page, [obj for obj in document.Objects if is_flat_plate(obj)]


def sizes_on(page):
    """The measured sizes, rounded."""
    found = [o for o in page.Document.Objects if o.TypeId == "TechDraw::DrawViewDimExtent"]
    return sorted(round(size.getRawValue(), 3) for size in found)


def sizes_of(plates):
    return sorted(round(size, 3) for plate in plates_of(plates) for size in plate.size_mm)


def test_each_plate_has_its_outline_and_its_two_sizes(drawn, shelf):
    page, flat = drawn
    assert [obj.PlateId for obj in flat] == [plate.id for plate in plates_of(shelf[2])]
    assert views_are_ready(page)
    assert sizes_on(page) == sizes_of(shelf[2])


def test_everything_follows_the_plates(drawn, shelf, document):
    page, flat = drawn
    sheet = document.getObject("PartsList")
    assert [sheet.get(f"A{row}") for row in range(2, 8)] == [obj.PlateId for obj in flat]
    before = sizes_on(page)
    driving = [n for n in shelf[1].PropertiesList if shelf[1].getGroupOfProperty(n) == "Dimensions"]
    setattr(shelf[1], driving[0], 1.1 * getattr(shelf[1], driving[0]).Value)
    document.recompute()
    wait_for(lambda: views_are_ready(page) and sizes_on(page) == sizes_of(shelf[2]))
    assert sizes_on(page) != before
    assert sizes_on(page) == sizes_of(shelf[2])
    widths = [sheet.get(f"B{row}").Value for row in range(2, 8)]
    assert widths == [plate.size_mm[0] for plate in plates_of(shelf[2])]


def test_the_command_shows_the_whole_page(window, shelf):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(shelf[2])
    with warnings.catch_warnings():
        # FreeCAD opens its own workbench, which in 1.1 is older than its Python.
        warnings.simplefilter("ignore")
        FreeCADGui.runCommand("InContext_DrawPlates")
    tab = window.findChild(QtGui.QMdiArea).activeSubWindow()
    (view,) = tab.findChildren(QtGui.QGraphicsView)
    # In tenths of a millimetre, upwards from the lower left corner.
    page = QtCore.QRectF(0, -10 * PAGE_MM[1], 10 * PAGE_MM[0], 10 * PAGE_MM[1])

    def shown():
        return view.mapToScene(view.viewport().rect()).boundingRect()

    pump(1.5 * SETTLING_MS / 1000)
    wait_until(lambda: shown().adjusted(-20, -20, 20, 20).contains(page))
    assert min(shown().width() / page.width(), shown().height() / page.height()) < 1.2


def edges_of(view):
    """Ends of the view's edges, mm on the plate."""
    return [[v.Point / view.Scale for v in edge.Vertexes] for edge in view.getVisibleEdges()]


def is_measured(view, size):
    """Whether a size is the longest edge's, which is worked out on the side."""
    longest = max((b - a).Length for a, b in edges_of(view))
    return abs(size.getRawValue() - longest) < 1e-3


def test_a_size_drawn_by_hand_stays_on_its_border(drawn, shelf, document):
    """Where another size means another number of fingers."""
    page, flat = drawn
    views = {v.Source[0]: v for v in page.Views if v.TypeId == "TechDraw::DrawViewPart"}
    drawn_by_hand = []
    for obj in flat:
        lengths = [(b - a).Length for a, b in edges_of(views[obj])]
        longest = max(range(len(lengths)), key=lengths.__getitem__)
        if lengths[longest] < 100:
            continue
        size = document.addObject("TechDraw::DrawViewDimension", "Size")
        size.Type, size.References2D = "Distance", [(views[obj], f"Edge{longest}")]
        page.addView(size)
        drawn_by_hand.append((obj, size, len(lengths), longest))
    document.recompute()
    assert len(drawn_by_hand) >= 3
    before = [size.getRawValue() for _, size, *_ in drawn_by_hand]
    driving = [n for n in shelf[1].PropertiesList if shelf[1].getGroupOfProperty(n) == "Dimensions"]
    setattr(shelf[1], driving[0], 1.6 * getattr(shelf[1], driving[0]).Value)
    document.recompute()
    wait_for(lambda: views_are_ready(page))
    document.recompute()
    wait_for(lambda: all(is_measured(views[obj], size) for obj, size, *_ in drawn_by_hand))
    for (obj, size, count, _), value in zip(drawn_by_hand, before, strict=True):
        edges = edges_of(views[obj])
        assert len(edges) > count
        longest = max((b - a).Length for a, b in edges)
        assert size.getRawValue() == pytest.approx(longest, abs=1e-3), obj.PlateId
        assert size.getRawValue() > 1.3 * value


def test_the_drawing_is_one_step_to_undo(drawn, document):
    document.undo()
    assert [obj.Name for obj in document.Objects] == ["PhotoSketch", "LiftedModel", "PlateSet"]


def test_a_plate_that_is_gone_says_so(drawn, document):
    _, flat = drawn
    area = flat[0].Shape.Area
    flat[0].PlateId = "f99"
    document.recompute()
    assert (flat[0].Status, flat[0].Shape.Area) == ("not_made", area)
    assert "f99" in flat[0].Message
