"""Pictures out of the clipboard, or dropped, as files."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from ..canvas.photo_giving import photo_in
from ..canvas.qt import QtGui

#: What a picture without a file is called.
NAME = "pasted.png"


@contextmanager
def photo_file(given: Path | QtGui.QImage | None = None) -> Iterator[Path | None]:
    """A file of a picture, to be copied before it goes; of the clipboard's where none is given."""
    if given is None:
        given = photo_in(QtGui.QApplication.clipboard().mimeData())
    if isinstance(given, QtGui.QImage):
        with tempfile.TemporaryDirectory(prefix="incontext-") as folder:
            path = Path(folder, NAME)
            given.save(str(path))
            yield path
    else:
        yield given
