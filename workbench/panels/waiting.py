"""Showing that something takes a while."""

from __future__ import annotations

from collections.abc import Callable, Iterator
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


def wait_for(is_so: Callable[[], bool], seconds: float = 20.0) -> None:
    """Let FreeCAD work on the side until something is so, or too long a time is over."""
    timer = QtCore.QElapsedTimer()
    timer.start()
    while not is_so() and timer.elapsed() < 1000 * seconds:
        QtGui.QApplication.processEvents(QtCore.QEventLoop.ExcludeUserInputEvents, 50)
