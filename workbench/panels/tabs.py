"""The open tabs of photo sketches, at most one for each, and their life with the document."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from ..canvas.qt import QtCore, QtGui
from ..features.photo_sketch import is_photo_sketch
from . import recovery
from .controller import SketchController

_Key = tuple[str, str]
_open: dict[_Key, SketchController] = {}


def show_tab(obj: Any) -> SketchController:
    """Open the tab of a photo sketch, or bring it to the front.

    Raises
    ------
    SketchError
        Where the object's text is no sketch.
    """
    from .tool_buttons import show_active_tool

    key = _key(obj)
    controller = _open.get(key)
    if controller is None:
        controller = _open[key] = SketchController(obj)
        _add_to_window(controller)
        _OBSERVER.start()
    subwindow = subwindow_of(controller.tab)
    if subwindow is not None:
        mdi_area().setActiveSubWindow(subwindow)
    controller.tab.view.setFocus()
    show_active_tool()
    return controller


def open_tabs() -> tuple[SketchController, ...]:
    """All open tabs."""
    return tuple(_open.values())


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


def _key(obj: Any) -> _Key:
    return (obj.Document.Name, obj.Name)


def _add_to_window(controller: SketchController) -> None:
    window = FreeCADGui.getMainWindow()
    if hasattr(window, "addWindow"):
        window.addWindow(_MdiView(controller))
        # FreeCAD 1.1 gives the keys to its own frame whenever a click activates the tab.
        controller.tab.parentWidget().setFocusProxy(controller.tab.view)
    else:
        # FreeCAD 0.20 has no views written in Python, only Qt's own subwindows.
        subwindow = mdi_area().addSubWindow(controller.tab)
        subwindow.setWindowIcon(controller.tab.windowIcon())
        subwindow.show()
    key = _key(controller.obj)
    controller.tab.destroyed.connect(lambda *_: _forget(key, controller))
    _keep_buttons_right(controller)
    _list_annotations(controller)
    _share_selection(controller)


def _keep_buttons_right(controller: SketchController) -> None:
    """Have the toolbar show the tool at work, whichever tab is at the front."""
    from .tool_buttons import show_active_tool

    controller.tab.view.tool_changed.connect(show_active_tool)
    controller.tab.view.helpers_changed.connect(show_active_tool)
    if not _OBSERVER.started:
        mdi_area().subWindowActivated.connect(show_active_tool)


def _list_annotations(controller: SketchController) -> None:
    from .annotation_dock import follow

    follow(controller)


def _share_selection(controller: SketchController) -> None:
    from .shared_selection import SelectionOverlay, start_listening

    start_listening()
    overlay, view = SelectionOverlay(controller.document_name), controller.tab.view

    def show(*_: object) -> None:
        solution = None if controller.lift is None else controller.lift[1]
        overlay.show(view.selection.with_targets(view.graph), solution)

    view.selection_changed.connect(show)
    controller.lifting.lifted.connect(show)


def _leave(controller: SketchController) -> None:
    """Leave nothing of a tab that is gone."""
    from .annotation_dock import turn_to_front

    controller.close()
    turn_to_front()


def _forget(key: _Key, controller: SketchController) -> None:
    """A tab is gone; a new document of the same name may have a tab of its own by now."""
    if _open.get(key) is controller:
        del _open[key]
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
        controller = _open.get(_key(obj)) if is_photo_sketch(obj) else None
        if controller is not None:
            controller.on_changed(name)
        if any(key[0] == obj.Document.Name for key in _open):
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
            _close(_key(obj))

    def slotDeletedDocument(self, document: Any) -> None:  # noqa: N802
        """A document goes; on FreeCAD 0.20 our tabs would outlive it."""
        from . import view_through

        for key in [key for key in _open if key[0] == document.Name]:
            _close(key)
        view_through.forget(document.Name)


_OBSERVER = _Observer()


def _show_outcomes(document: Any) -> None:
    for controller in open_tabs():
        if controller.document_name == document.Name:
            controller.show_outcome()


def _close(key: _Key) -> None:
    controller = _open.pop(key, None)
    if controller is not None:
        _leave(controller)
        subwindow = subwindow_of(controller.tab)
        # Not at once: FreeCAD is in the middle of taking the document apart.
        QtCore.QTimer.singleShot(0, subwindow.close if subwindow else controller.tab.close)
