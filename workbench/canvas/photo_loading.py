"""A large photo read in the background, first small, then as it is."""

from __future__ import annotations

import threading
from pathlib import Path

from .photo import PhotoError, load_photo
from .qt import QtCore

#: Longer sides of the copies that come before the photo itself, px.
COPIES_PX = (2048, 6144)
POLL_MS = 30


class PhotoLoading(QtCore.QObject):
    """Reads one photo at a time; one that is asked for later ends the one before.

    Signals
    -------
    came(object)
        A copy of the photo, the next one larger, the photo itself at last: a QImage.
    failed(str)
        Why it cannot be read.
    """

    came = QtCore.Signal(object)
    failed = QtCore.Signal(str)

    def __init__(self, parent: QtCore.QObject | None = None) -> None:
        super().__init__(parent)
        self._reading: _Reading | None = None
        self._poll = QtCore.QTimer(self)
        self._poll.setInterval(POLL_MS)
        self._poll.timeout.connect(self._look)

    def load(self, path: str | Path) -> None:
        """Read a photo."""
        self.stop()
        self._reading = _Reading(path)
        self._poll.start()

    def stop(self) -> None:
        """Read no further."""
        if self._reading is not None:
            self._reading.is_wanted = False
        self._reading = None
        self._poll.stop()

    def _look(self) -> None:
        reading = self._reading
        if reading is None:
            return
        is_done = reading.is_done
        while reading.found and self._reading is reading:
            found = reading.found.pop(0)
            if isinstance(found, str):
                self.failed.emit(found)
            else:
                self.came.emit(found)
        if is_done and self._reading is reading:
            self.stop()


class _Reading:
    """A thread that reads; Qt lets go of Python's lock meanwhile."""

    def __init__(self, path: str | Path) -> None:
        self.is_wanted = True
        self.found: list[object] = []
        self._path = path
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    @property
    def is_done(self) -> bool:
        return not self._thread.is_alive()

    def _run(self) -> None:
        try:
            for within_px in (*COPIES_PX, None):
                if self.is_wanted:
                    self.found.append(load_photo(self._path, within_px))
        except PhotoError as error:
            self.found.append(str(error))
