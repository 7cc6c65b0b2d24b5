"""Work that takes long, before a person's eyes: how far it is, and a button that ends it."""

from __future__ import annotations

import threading
from typing import Any

from .. import host
from ..canvas.qt import QtCore, QtGui
from .aside import InThread

#: How often the window is asked, s.
POLL_S = 0.03
#: Work that is done sooner shows no window, s.
SOON_S = 0.3
STEPS = 1000


#: Work that somebody is waiting for: meanwhile events are handled in the middle of others.
_waited_for: list[InThread] = []


def is_waiting() -> bool:
    """Whether work is shown that somebody waits for; what they hold on to must not be deleted."""
    return bool(_waited_for)


class _Job(InThread):
    """The work in a thread, and how far it is."""

    def __init__(self, job: host.Work[Any]) -> None:
        self.unwanted = threading.Event()
        #: Between 0 and 1; None where the work does not tell.
        self.done: float | None = None
        super().__init__(lambda: job(self.unwanted.is_set, self._tell))

    def _tell(self, done: float, what: str) -> None:
        self.done = done


def work(words: str, job: host.Work[Any]) -> Any:
    """Do it in a thread, and wait for it; with a window that shows how far it is, if it is long.

    What a person does not wait for is left alone: it ends when it next asks whether to stop.

    Returns
    -------
    What the job gave; None where a person stopped it.
    """
    if threading.current_thread() is not threading.main_thread():
        # A part of work that is shown already.
        return job(lambda: False, lambda done, what: None)
    running = _Job(job)
    running.join(SOON_S)
    if running.is_alive():
        _wait_in_sight(words, running)
    if running.unwanted.is_set():
        return None
    if running.error is not None:
        raise running.error
    return running.result


def _wait_in_sight(words: str, running: _Job) -> None:
    _waited_for.append(running)
    try:
        _show_and_wait(words, running)
    finally:
        _waited_for.remove(running)


def _show_and_wait(words: str, running: _Job) -> None:
    window = _window(words)
    while running.is_alive() and not running.unwanted.is_set():
        running.join(POLL_S)
        if running.done is not None:
            window.setMaximum(STEPS)
            window.setValue(min(int(running.done * STEPS), STEPS - 1))
        QtCore.QCoreApplication.processEvents()
        if window.wasCanceled():
            running.unwanted.set()
    window.close()
    window.deleteLater()


def _window(words: str) -> QtGui.QProgressDialog:
    """A window that lets nothing else be done meanwhile; a bar without an end at first."""
    parent = QtGui.QApplication.activeWindow()
    window = QtGui.QProgressDialog(words, host.translate("InContext", "Cancel"), 0, 0, parent)
    window.setWindowTitle(host.translate("InContext", "Modeling in Context"))
    window.setWindowModality(QtCore.Qt.ApplicationModal)
    window.setMinimumWidth(380)
    window.setAutoReset(False)
    window.setAutoClose(False)
    window.show()
    return window
