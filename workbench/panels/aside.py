"""Jobs in a thread: those that nobody waits for come back in the window's own thread."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

from ..canvas.qt import QtCore

#: How often a thread is asked whether it is done.
POLL_MS = 30


class InThread(threading.Thread):
    """A job in a thread, and what comes of it."""

    def __init__(self, job: Callable[[], Any]) -> None:
        super().__init__(daemon=True)
        self._job = job
        self.result: Any = None
        self.error: BaseException | None = None
        self.start()

    def run(self) -> None:
        """See `threading.Thread`."""
        try:
            self.result = self._job()
        except BaseException as error:  # raised again where the result is taken up
            self.error = error


class Aside(QtCore.QObject):
    """Does one thing at a time."""

    def __init__(self, parent: QtCore.QObject | None = None) -> None:
        super().__init__(parent)
        self._thread: InThread | None = None
        self._then: Callable[[Any], None] = lambda result: None
        self._poll = QtCore.QTimer(self)
        self._poll.setInterval(POLL_MS)
        self._poll.timeout.connect(self._look)

    @property
    def is_busy(self) -> bool:
        """Whether something is being done."""
        return self._thread is not None

    def begin(self, job: Callable[[], Any], then: Callable[[Any], None]) -> None:
        """Do the job in a thread, then hand its result over here; what was begun is forgotten."""
        self._thread, self._then = InThread(job), then
        self._poll.start()

    def _look(self) -> None:
        thread = self._thread
        if thread is None or thread.is_alive():
            return
        self._poll.stop()
        self._thread = None
        if thread.error is not None:
            raise thread.error
        self._then(thread.result)
