"""Which photo sketches have a tab in FreeCAD's window, and which one is at the front."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import FreeCADGui

from ..canvas.qt import QtGui

if TYPE_CHECKING:
    from .controller import SketchController

#: A document and an object in it, by their names.
Key = tuple[str, str]

_open: dict[Key, SketchController] = {}


def key_of(obj: Any) -> Key:
    """What stands for an object here, even when it is gone."""
    return (obj.Document.Name, obj.Name)


def tab_of(key: Key) -> SketchController | None:
    """The tab of a photo sketch, if it is open."""
    return _open.get(key)


def keys_in(document_name: str) -> tuple[Key, ...]:
    """Of the open tabs, those of one document."""
    return tuple(key for key in _open if key[0] == document_name)


def open_tabs() -> tuple[SketchController, ...]:
    """All open tabs."""
    return tuple(_open.values())


def add(key: Key, controller: SketchController) -> None:
    """A tab opens."""
    _open[key] = controller


def remove(key: Key) -> SketchController | None:
    """A tab closes; it is returned, if it was there."""
    return _open.pop(key, None)


def active_tab() -> SketchController | None:
    """The tab at the front, if it is one of ours."""
    front = mdi_area().activeSubWindow()
    for controller in open_tabs():
        if front is not None and subwindow_of(controller.tab) is front:
            return controller
    return None


def mdi_area() -> QtGui.QMdiArea:
    """The part of FreeCAD's window that holds the tabs."""
    return FreeCADGui.getMainWindow().findChild(QtGui.QMdiArea)


def subwindow_of(widget: QtGui.QWidget) -> QtGui.QMdiSubWindow | None:
    """The tab's window that a widget lies in."""
    while widget is not None and not isinstance(widget, QtGui.QMdiSubWindow):
        widget = widget.parentWidget()
    return widget
