"""Photos dropped on the sketch or pasted into it."""

from __future__ import annotations

from pathlib import Path

from .qt import QtCore, QtGui


def photo_in(mime: QtCore.QMimeData) -> Path | QtGui.QImage | None:
    """The file or the picture that a drop or the clipboard holds; None where it holds none."""
    for url in mime.urls() if mime.hasUrls() else ():
        if url.isLocalFile():
            return Path(url.toLocalFile())
    if mime.hasImage():
        image = QtGui.QImage(mime.imageData())
        return None if image.isNull() else image
    return None
