"""One line that says how far a slow command is, on a terminal only."""

from __future__ import annotations

import time
from typing import TextIO

#: What takes no longer than this says nothing.
PATIENCE_S = 1.0
WIDTH = 78


class ProgressLine:
    """Writes over itself, and is gone when the work is done."""

    def __init__(self, out: TextIO) -> None:
        self._out = out
        self._began = time.monotonic()
        self._shown = False

    def tell(self, done: float, what: str) -> None:
        """Show how far the work is (0 to 1) and what is being done."""
        if not self._out.isatty() or time.monotonic() - self._began < PATIENCE_S:
            return
        self._shown = True
        self._out.write("\r" + f"{100 * done:3.0f} %  {what}"[:WIDTH].ljust(WIDTH))
        self._out.flush()

    def clear(self) -> None:
        """Leave an empty line."""
        if self._shown:
            self._out.write("\r" + " " * WIDTH + "\r")
            self._out.flush()
