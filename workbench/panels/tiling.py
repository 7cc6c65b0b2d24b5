"""The photo on the left, the 3D view on the right, for as long as nobody arranges them anew."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from ..canvas.qt import QtCore, QtGui
from .controller import SketchController
from .open_tabs import mdi_area, subwindow_of

_Pair = tuple[QtGui.QMdiSubWindow, QtGui.QMdiSubWindow]


class _Tiling(QtCore.QObject):
    """Pairs of tabs that share the area half and half, also when its size changes."""

    def __init__(self, area: QtGui.QMdiArea) -> None:
        super().__init__(area)
        self._area = area
        self._pairs: list[_Pair] = []
        area.viewport().installEventFilter(self)

    def add(self, pair: _Pair) -> None:
        """Let two tabs share the area from now on."""
        self._pairs = [other for other in self._pairs if not set(other) & set(pair)]
        self._pairs.append(pair)
        for window in pair:
            window.showNormal()
        self.arrange()

    def eventFilter(self, watched: QtCore.QObject, event: QtCore.QEvent) -> bool:  # noqa: N802
        """Follow the area's size."""
        if event.type() == QtCore.QEvent.Resize:
            self.arrange()
        return False

    def arrange(self) -> None:
        """Left half, right half; not where a person has made one of them large."""
        open_ = self._area.subWindowList()
        self._pairs = [pair for pair in self._pairs if all(window in open_ for window in pair)]
        size = self._area.viewport().size()
        middle = size.width() // 2
        for left, right in self._pairs:
            if not any(w.isMaximized() or w.isMinimized() for w in (left, right)):
                left.setGeometry(0, 0, middle, size.height())
                right.setGeometry(middle, 0, size.width() - middle, size.height())


_tiling: list[_Tiling] = []


def show_side_by_side(controller: SketchController) -> None:
    """Put a sketch's tab beside its document's 3D view, where there is one."""
    left = subwindow_of(controller.tab)
    right = _view_3d(FreeCADGui.getDocument(controller.document_name))
    if left is None or right is None:
        return
    if not _tiling:
        _tiling.append(_Tiling(mdi_area()))
    _tiling[0].add((left, right))
    mdi_area().setActiveSubWindow(left)


def _view_3d(document: Any) -> QtGui.QMdiSubWindow | None:
    """The subwindow of a document's first 3D view.

    FreeCAD gives no way from a view to its widget; titles begin with the document's label.
    """
    for window in mdi_area().subWindowList():
        inner = window.widget()
        is_3d = inner is not None and inner.metaObject().className() == "Gui::View3DInventor"
        if is_3d and window.windowTitle().startswith(document.Document.Label):
            return window
    return None
