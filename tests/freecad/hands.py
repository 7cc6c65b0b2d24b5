"""Real mouse and keys by xdotool: unlike synthetic events they pass FreeCAD's shortcuts."""

from __future__ import annotations

import subprocess
import time

from PySide import QtCore, QtGui


def pump(seconds: float = 0.3) -> None:
    """Let Qt work for a while."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
        # Only an event loop of its own would delete what was closed.
        QtGui.QApplication.sendPostedEvents(None, QtCore.QEvent.DeferredDelete)
        time.sleep(0.01)


class Hands:
    """Points, drags and presses keys."""

    def move(self, point) -> None:
        """Move the pointer to a position on the screen, in Qt's px."""
        # The X server counts the screen's own px.
        ratio = QtGui.QApplication.primaryScreen().devicePixelRatio()
        self._do("mousemove", str(round(point.x() * ratio)), str(round(point.y() * ratio)))

    def drag(self, start, end, steps: int = 5) -> None:
        """Press at one position, let go at another."""
        self.move(start)
        self._do("mousedown", "1")
        for k in range(1, steps + 1):
            self.move(start + (end - start) * k / steps)
        self._do("mouseup", "1")

    def click(self, point) -> None:
        """Press and let go at a position."""
        self.move(point)
        self._do("click", "1")

    def press(self, keys: str) -> None:
        """Press a key, such as ``ctrl+z``."""
        self._do("key", keys)

    def type(self, text: str) -> None:
        """Type a text."""
        self._do("type", "--delay", "30", text)

    def _do(self, *arguments: str) -> None:
        subprocess.run(["xdotool", *arguments], check=True)
        pump(0.15)
