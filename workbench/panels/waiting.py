"""Showing that something takes a while."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from ..canvas.qt import QtCore, QtGui


@contextmanager
def busy() -> Iterator[None]:
    """Show the waiting pointer meanwhile."""
    QtGui.QApplication.setOverrideCursor(QtGui.QCursor(QtCore.Qt.WaitCursor))
    try:
        yield
    finally:
        QtGui.QApplication.restoreOverrideCursor()
