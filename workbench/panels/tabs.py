"""Tabs of photo sketches open and close, at most one for each, as their documents live."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from ..canvas.qt import QtCore, QtGui
from ..features.photo_sketch import is_photo_sketch
from . import annotation_dock, open_tabs, recovery, shared_selection, view_through
from .controller import SketchController
from .shortcut_rest import ShortcutRest
from .tool_buttons import show_active_tool


def show_tab(obj: Any) -> SketchController:
    """Open the tab of a photo sketch, or bring it to the front.

    Raises
    ------
    SketchError
        Where the object's text is no sketch.
    """
    key = open_tabs.key_of(obj)
    controller = open_tabs.tab_of(key)
    if controller is None:
        controller = SketchController(obj)
        open_tabs.add(key, controller)
        _add_to_window(controller)
        _OBSERVER.start()
    subwindow = open_tabs.subwindow_of(controller.tab)
    if subwindow is not None:
        open_tabs.mdi_area().setActiveSubWindow(subwindow)
    controller.tab.view.setFocus()
    show_active_tool()
    return controller


def _add_to_window(controller: SketchController) -> None:
    window = FreeCADGui.getMainWindow()
    if hasattr(window, "addWindow"):
        window.addWindow(_MdiView(controller))
        # FreeCAD 1.1 gives the keys to its own frame whenever a click activates the tab.
        controller.tab.parentWidget().setFocusProxy(controller.tab.view)
    else:
        # FreeCAD 0.20 has no views written in Python, only Qt's own subwindows.
        subwindow = open_tabs.mdi_area().addSubWindow(controller.tab)
        subwindow.setWindowIcon(controller.tab.windowIcon())
        subwindow.show()
    key = open_tabs.key_of(controller.obj)
    controller.tab.destroyed.connect(lambda *_: _forget(key, controller))
    ShortcutRest(controller.tab.view)
    _keep_buttons_right(controller)
    annotation_dock.follow(controller)
    _share_selection(controller)


def _keep_buttons_right(controller: SketchController) -> None:
    """Have the toolbar show the tool at work, whichever tab is at the front."""
    controller.tab.view.tool_changed.connect(show_active_tool)
    controller.tab.view.helpers_changed.connect(show_active_tool)
    if not _OBSERVER.started:
        open_tabs.mdi_area().subWindowActivated.connect(show_active_tool)


def _share_selection(controller: SketchController) -> None:
    shared_selection.start_listening()
    overlay = shared_selection.SelectionOverlay(controller.document_name)
    view = controller.tab.view

    def show(*_: object) -> None:
        solution = None if controller.lift is None else controller.lift[1]
        overlay.show(view.selection.with_targets(view.graph), solution)

    view.selection_changed.connect(show)
    controller.lifting.lifted.connect(show)


def _leave(controller: SketchController) -> None:
    """Leave nothing of a tab that is gone."""
    controller.close()
    annotation_dock.turn_to_front()


def _forget(key: open_tabs.Key, controller: SketchController) -> None:
    """A tab is gone; a new document of the same name may have a tab of its own by now."""
    if open_tabs.tab_of(key) is controller:
        open_tabs.remove(key)
    _leave(controller)


class _MdiView:
    """A tab as FreeCAD 1.0 and later ask for it."""

    def __init__(self, controller: SketchController) -> None:
        self._controller = controller
        self.document = FreeCADGui.getDocument(controller.document_name)

    def widget(self) -> QtGui.QWidget:
        """The tab's content."""
        return self._controller.tab

    def onMsg(self, message: str) -> bool:  # noqa: N802  FreeCAD's names
        """Do what a command of FreeCAD's asks the active tab to do."""
        action = self._actions().get(message)
        if action is None:
            return False
        action()
        return True

    def onHasMsg(self, message: str) -> bool:  # noqa: N802
        """Say whether `onMsg` would do something."""
        return message in self._actions()

    def canClose(self) -> bool:  # noqa: N802
        """Everything is in the document already."""
        return True

    def _actions(self) -> dict[str, Any]:
        controller = self._controller
        return {
            "ViewFit": controller.tab.view.fit,
            "Undo": controller.undo,
            "Redo": controller.redo,
        }


class _Observer:
    """Hears of changes in documents; FreeCAD calls these by name."""

    def __init__(self) -> None:
        self.started = False

    def start(self) -> None:
        """Begin to listen; only once a tab is there."""
        if not self.started:
            FreeCAD.addDocumentObserver(self)
            self.started = True

    def slotChangedObject(self, obj: Any, name: str) -> None:  # noqa: N802
        """A property changed, by a person, a script, undo or redo."""
        controller = open_tabs.tab_of(open_tabs.key_of(obj)) if is_photo_sketch(obj) else None
        if controller is not None:
            controller.on_changed(name)
        if open_tabs.keys_in(obj.Document.Name):
            recovery.note_change(obj.Document)

    def slotRecomputedDocument(self, document: Any) -> None:  # noqa: N802
        """The document was recomputed."""
        _show_outcomes(document)

    def slotUndoDocument(self, document: Any) -> None:  # noqa: N802
        """A step was undone."""
        _show_outcomes(document)

    def slotRedoDocument(self, document: Any) -> None:  # noqa: N802
        """A step was redone."""
        _show_outcomes(document)

    def slotDeletedObject(self, obj: Any) -> None:  # noqa: N802
        """An object goes, and its tab with it."""
        if is_photo_sketch(obj):
            _close(open_tabs.key_of(obj))

    def slotDeletedDocument(self, document: Any) -> None:  # noqa: N802
        """A document goes; on FreeCAD 0.20 our tabs would outlive it."""
        for key in open_tabs.keys_in(document.Name):
            _close(key)
        view_through.forget(document.Name)


_OBSERVER = _Observer()


def _show_outcomes(document: Any) -> None:
    for controller in open_tabs.open_tabs():
        if controller.document_name == document.Name:
            controller.show_outcome()


def _close(key: open_tabs.Key) -> None:
    controller = open_tabs.remove(key)
    if controller is not None:
        _leave(controller)
        subwindow = open_tabs.subwindow_of(controller.tab)
        # Not at once: FreeCAD is in the middle of taking the document apart.
        QtCore.QTimer.singleShot(0, subwindow.close if subwindow else controller.tab.close)
