"""Keys that begin a shortcut elsewhere in FreeCAD, and go on in the sketch."""

from __future__ import annotations

import pytest
from PySide import QtGui

from incontext.tests.freecad.hands import pump, wait_until


@pytest.fixture
def tree(window):
    """The tree of the document's objects."""
    trees = window.findChildren(QtGui.QTreeWidget)
    return next(
        t for t in trees if t.isVisible() and t.metaObject().className().startswith("Gui::")
    )


def test_a_shortcut_begun_in_the_tree_is_forgotten_in_the_sketch(person, hands, document, tree):
    view, before = person.view, len(document.Objects)
    hands.click(tree.viewport().mapToGlobal(tree.viewport().rect().bottomLeft()))
    wait_until(tree.hasFocus)
    hands.press("i")
    hands.click(person.at_px(400, 300))
    wait_until(view.hasFocus)
    hands.press("l")
    wait_until(lambda: view.tool_name == "line")
    pump(0.3)
    assert len(document.Objects) == before
    hands.press("r")
    assert view.tool_name == "rectangle"


def test_the_same_keys_lift_where_they_begin_and_end_in_the_tree(person, hands, document, tree):
    before = len(document.Objects)
    hands.click(tree.viewport().mapToGlobal(tree.viewport().rect().bottomLeft()))
    wait_until(tree.hasFocus)
    # And after a visit to the sketch.
    hands.click(person.at_px(400, 300))
    wait_until(person.view.hasFocus)
    hands.click(tree.viewport().mapToGlobal(tree.viewport().rect().bottomLeft()))
    wait_until(tree.hasFocus)
    hands.press("i")
    hands.press("l")
    wait_until(lambda: len(document.Objects) == before + 1)
