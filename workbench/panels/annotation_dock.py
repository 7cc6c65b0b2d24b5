"""The panel of annotations in FreeCAD's window: there while a sketch's tab is open."""

from __future__ import annotations

import FreeCADGui

from .. import host
from ..canvas.qt import QtCore, QtGui
from . import open_tabs
from .annotation_panel import AnnotationPanel
from .controller import SketchController

_NAME = "InContextAnnotations"
#: Part of the height, per cent.
ROOM = 45
_shown: list[AnnotationPanel] = []


def follow(controller: SketchController) -> None:
    """Show a tab's annotations whenever it is the last one at the front."""
    panel = the_panel()
    view = controller.tab.view
    controller.on_news = lambda: _refresh(controller)
    view.selection_changed.connect(lambda _: _show_selection(controller))
    panel.show_sketch(controller)
    _dock().show()


def the_panel() -> AnnotationPanel:
    """The one panel of the window, made when it is first wanted."""
    if not _shown:
        panel = AnnotationPanel()
        _shown.append(panel)
        dock = QtGui.QDockWidget(host.translate("InContext", "Annotations"))
        dock.setObjectName(_NAME)
        dock.setWidget(panel)
        window = FreeCADGui.getMainWindow()
        window.addDockWidget(QtCore.Qt.LeftDockWidgetArea, dock)
        _give_room(window, dock)
        open_tabs.mdi_area().subWindowActivated.connect(turn_to_front)
    return _shown[0]


def _give_room(window: QtGui.QMainWindow, dock: QtGui.QDockWidget) -> None:
    """Share the height with what is docked there already."""
    left = QtCore.Qt.LeftDockWidgetArea
    docks = [d for d in window.findChildren(QtGui.QDockWidget) if d.isVisible() and d is not dock]
    others = [d for d in docks if window.dockWidgetArea(d) == left and not d.isFloating()]
    sizes = [ROOM] + [(100 - ROOM) // len(others) for _ in others]
    window.resizeDocks([dock, *others], sizes, QtCore.Qt.Vertical)


def _dock() -> QtGui.QDockWidget:
    return FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, _NAME)


def turn_to_front(*_: object) -> None:
    """Another tab is at the front: show its annotations; hide where none is left."""
    panel, front = the_panel(), open_tabs.active_tab()
    if front is not None:
        panel.show_sketch(front)
        _dock().show()
    elif panel.controller not in open_tabs.open_tabs():
        panel.show_sketch(None)
        _dock().hide()


def _refresh(controller: SketchController) -> None:
    if the_panel().controller is controller:
        the_panel().refresh_soon()


def _show_selection(controller: SketchController) -> None:
    if the_panel().controller is controller:
        the_panel().show_selection()
