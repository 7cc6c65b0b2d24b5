"""Telling a person that something did not work, in a small window."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import FreeCADGui

from .. import host
from ..canvas.qt import QtCore, QtGui
from .wording import in_language


def tell(words: str) -> None:
    """Say what went wrong and what to try; also in the report view, to copy from."""
    words = in_language(words)
    host.report(words)
    QtGui.QMessageBox.warning(
        FreeCADGui.getMainWindow(), host.translate("InContext", "Modeling in Context"), words
    )


def mention(words: str) -> None:
    """Say how something went; also in the report view."""
    host.note(words)
    QtGui.QMessageBox.information(
        FreeCADGui.getMainWindow(), host.translate("InContext", "Modeling in Context"), words
    )


@contextmanager
def busy() -> Iterator[None]:
    """Show a waiting pointer meanwhile."""
    QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        yield
    finally:
        QtGui.QApplication.restoreOverrideCursor()
