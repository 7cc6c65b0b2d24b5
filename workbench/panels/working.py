"""Work that takes long, before a person's eyes: how far it is, and a button that ends it."""

from __future__ import annotations

import threading
from typing import Any

from .. import host
from ..canvas.qt import QtCore, QtGui

#: How often the window is asked, s.
POLL_S = 0.03
#: Work that is done sooner shows no window, ms.
SOON_MS = 500
STEPS = 1000


class _Job(threading.Thread):
    """The work in a thread, and how far it is."""

    def __init__(self, job: host.Work[Any]) -> None:
        super().__init__(daemon=True)
        self._job = job
        self.unwanted = threading.Event()
        self.done = 0.0
        self.result: Any = None
        self.error: BaseException | None = None
        self.start()

    def run(self) -> None:
        """See `threading.Thread`."""
        try:
            self.result = self._job(self.unwanted.is_set, self._tell)
        except BaseException as error:  # it goes on in the thread that waits
            self.error = error

    def _tell(self, done: float, what: str) -> None:
        self.done = done


def work(words: str, job: host.Work[Any]) -> Any:
    """Do it in a thread, and wait for it with a window that shows how far it is.

    Returns
    -------
    What the job gave; None where a person stopped it.
    """
    window = QtGui.QProgressDialog(
        words, host.translate("InContext", "Cancel"), 0, STEPS, QtGui.QApplication.activeWindow()
    )
    window.setWindowTitle(host.translate("InContext", "Modeling in Context"))
    window.setWindowModality(QtCore.Qt.ApplicationModal)
    window.setMinimumDuration(SOON_MS)
    window.setMinimumWidth(380)
    window.setAutoReset(False)
    window.setAutoClose(False)
    window.setValue(0)
    running = _Job(job)
    while running.is_alive():
        running.join(POLL_S)
        if window.wasCanceled():
            running.unwanted.set()
            window.setLabelText(host.translate("InContext", "Stopping ..."))
        # Shows the window when it is time, and lets it live.
        window.setValue(min(int(running.done * STEPS), STEPS - 1))
        QtCore.QCoreApplication.processEvents()
    window.close()
    window.deleteLater()
    if running.error is not None:
        raise running.error
    return None if running.unwanted.is_set() else running.result
