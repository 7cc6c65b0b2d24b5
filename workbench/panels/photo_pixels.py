"""The photo's pixels as arrays, and back."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..canvas.photo import load_photo
from ..canvas.qt import QtCore, QtGui

if TYPE_CHECKING:
    from ...solver.graph import Photo


def grey_photo(path: str, photo: Photo) -> np.ndarray | None:
    """The photo's brightness (height, width), 0 to 255, at the size that the sketch knows.

    None where there is no file.
    """
    return _pixels(path, photo, QtGui.QImage.Format_Grayscale8, 1) if path else None


def colour_photo(path: str, photo: Photo) -> np.ndarray:
    """The photo (height, width, 3), red, green and blue."""
    flat = _pixels(path, photo, QtGui.QImage.Format_RGB888, 3)
    return flat.reshape(len(flat), -1, 3)


def _pixels(path: str, photo: Photo, kind: QtGui.QImage.Format, layers: int) -> np.ndarray:
    image = load_photo(path).convertToFormat(kind)
    if (image.width(), image.height()) != (photo.width_px, photo.height_px):
        image = image.scaled(
            QtCore.QSize(photo.width_px, photo.height_px),
            QtCore.Qt.IgnoreAspectRatio,
            QtCore.Qt.SmoothTransformation,
        )
    rows = np.frombuffer(image.constBits(), dtype=np.uint8).reshape(-1, image.bytesPerLine())
    return rows[:, : layers * image.width()].copy()


def save_colours(pixels: np.ndarray, path: str) -> None:
    """Write pixels as `colour_photo` gives them, as a JPEG file."""
    height, width = pixels.shape[:2]
    data = np.ascontiguousarray(pixels).tobytes()
    image = QtGui.QImage(data, width, height, 3 * width, QtGui.QImage.Format_RGB888)
    if not image.save(path, "JPG", 95):
        raise OSError(f"cannot write {path}")
