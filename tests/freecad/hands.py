"""Real mouse and keys by xdotool: unlike synthetic events they pass FreeCAD's shortcuts."""

from __future__ import annotations

import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import pairwise

import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

#: On a machine with much else to do, a while may be over before anything came.
LEAST_ROUNDS = 6


def pump(seconds: float = 0.3) -> None:
    """Let Qt work for a while."""
    end, rounds = time.monotonic() + seconds, 0
    while time.monotonic() < end or rounds < LEAST_ROUNDS:
        rounds += 1
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
        # Only an event loop of its own would delete what was closed.
        QtGui.QApplication.sendPostedEvents(None, QtCore.QEvent.DeferredDelete)
        time.sleep(0.01)


def wait_until(is_so: Callable[[], bool], seconds: float = 20.0) -> None:
    """Let Qt work until something is so.

    Raises
    ------
    AssertionError
        Where it does not come to be.
    """
    end = time.monotonic() + seconds
    while not is_so():
        assert time.monotonic() < end, "waited in vain"
        pump(0.02)


class Hands:
    """Points, drags and presses keys.

    Parameters
    ----------
    pause : float
        How long it waits after each, s.
    """

    def __init__(self, pause: float = 0.15) -> None:
        self.pause = pause

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

    def rightclick(self) -> None:
        """Press and let go the right button, where the pointer is."""
        self._do("click", "3")

    def wheel_up(self) -> None:
        """Turn the wheel by a notch, where the pointer is."""
        self._do("click", "4")

    @contextmanager
    def holding(self, key: str) -> Iterator[None]:
        """Hold a key down meanwhile."""
        self._do("keydown", key)
        try:
            yield
        finally:
            self._do("keyup", key)

    def double_click(self, point) -> None:
        """Press and let go twice at a position."""
        self.move(point)
        self._do("click", "--repeat", "2", "--delay", "80", "1")

    def press(self, keys: str) -> None:
        """Press a key, such as ``ctrl+z``."""
        self._do("key", keys)

    def type(self, text: str) -> None:
        """Type a text."""
        self._do("type", "--delay", "30", text)

    def _do(self, *arguments: str) -> None:
        subprocess.run(["xdotool", *arguments], check=True)
        pump(self.pause)


class Person:
    """Draws in a tab; counts the gestures: clicks, drags, keys."""

    def __init__(self, hands):
        self.hands = hands
        #: Of the tab that is drawn in.
        self.view = None
        #: Names of photo positions.
        self.places = {}
        self.gestures = 0
        main = FreeCADGui.getMainWindow()
        (self._report,) = main.findChildren(QtGui.QTextEdit, "Report view")
        self._report.clear()

    def at(self, *names):
        """The middle of some places, on the screen."""
        return self.at_px(*np.mean([self.places[name] for name in names], axis=0))

    def at_px(self, u, v):
        """A photo position on the screen."""
        return self.view.viewport().mapToGlobal(self.view.mapFromScene(QtCore.QPointF(u, v)))

    def click(self, *names):
        """Click in the middle of some places."""
        self.gestures += 1
        self.hands.click(self.at(*names))

    def click_freely(self, *names):
        """Click in the middle of some places with Ctrl held, so that nothing attracts it."""
        self.gestures += 1
        with self.hands.holding("ctrl"):
            self.click(*names)

    def click_at(self, u, v):
        """Click at a photo position."""
        self.gestures += 1
        self.hands.click(self.at_px(u, v))

    def drag_along(self, *names):
        """Drag from place to place."""
        for start, end in pairwise(names):
            self.drag(self.at(start), self.at(end))

    def drag(self, start, end):
        """Drag from one position on the screen to another."""
        self.gestures += 1
        self.hands.drag(start, end)

    def press(self, keys):
        """Press a key."""
        self.gestures += 1
        self.hands.press(keys)

    def type(self, text):
        """Type a text; each letter counts."""
        self.gestures += len(text)
        self.hands.type(text)

    def push(self, command):
        """Push a command's button in FreeCAD's toolbar."""
        self.gestures += 1
        buttons = FreeCADGui.getMainWindow().findChildren(QtGui.QToolButton)
        (button,) = [b for b in buttons if b.isVisible() and _names(b) == command]
        self.hands.click(button.mapToGlobal(button.rect().center()))
        pump(0.3)

    def complaints(self):
        """What FreeCAD's report view says of warnings and errors since the person began."""
        words = ("warning", "error", "traceback")
        lines = self._report.toPlainText().splitlines()
        return [line for line in lines if any(word in line.lower() for word in words)]


def _names(button) -> str:
    action = button.defaultAction()
    return "" if action is None else action.objectName()
