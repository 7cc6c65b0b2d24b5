"""Reading the photo as a person sees it: upright, whatever way the camera was held."""

from __future__ import annotations

import threading
from pathlib import Path

from .qt import QtCore, QtGui

#: Formats that cameras, scanners and the web make; Qt knows some of them, by its plugins.
PHOTO_FORMATS = ("BMP", "GIF", "HEIC", "JPEG", "PNG", "TIFF", "WEBP")
#: A photo of more px than this is read in the background.
LARGE_PX = 16_000_000
#: Larger ones are refused before memory is taken for them: 200 megapixels are 800 MB.
MAX_PX = 200_000_000
#: Held while a photo is opened, by whichever thread, and by whoever moves it away for a moment.
FILES = threading.Lock()


class PhotoError(ValueError):
    """The photo cannot be read; says why."""


def readable_formats() -> tuple[str, ...]:
    """The photo formats that this Qt reads."""
    names = (bytes(name) for name in QtGui.QImageReader.supportedImageFormats())
    known = {name.decode("ascii").upper() for name in names}
    return tuple(name for name in PHOTO_FORMATS if name in known)


def load_photo(path: str | Path, within_px: int | None = None) -> QtGui.QImage:
    """Read an image file and turn it upright by its EXIF orientation.

    Parameters
    ----------
    path : path
    within_px : int, optional
        The longer side at the most; a JPEG file is read the faster for it.

    Raises
    ------
    PhotoError
        Where it is missing or no image that Qt knows.
    """
    reader = _reader(path)
    size = reader.size()
    if within_px is not None and max(size.width(), size.height()) > within_px:
        reader.setScaledSize(size.scaled(within_px, within_px, QtCore.Qt.KeepAspectRatio))
    image = reader.read()
    if image.isNull():
        raise _unreadable(path, reader.errorString())
    return image


def photo_size(path: str | Path) -> tuple[int, int]:
    """Width and height of the upright photo, px; its pixels are not read where it can tell.

    Raises
    ------
    PhotoError
        As `load_photo` does.
    """
    reader = _reader(path)
    size = reader.size()
    if not reader.canRead():
        raise _unreadable(path, reader.errorString())
    if not size.isValid() or size.width() * size.height() <= LARGE_PX:
        # Small enough to see now whether the file is whole.
        image = load_photo(path)
        return (image.width(), image.height())
    lies = reader.transformation() & QtGui.QImageIOHandler.TransformationRotate90
    width, height = size.width(), size.height()
    return (height, width) if lies else (width, height)


def _reader(path: str | Path) -> QtGui.QImageReader:
    file = QtCore.QFile(str(path))
    with FILES:
        is_open = file.open(QtCore.QIODevice.ReadOnly)
    reader = QtGui.QImageReader(file) if is_open else QtGui.QImageReader(str(path))
    # The reader does not keep it.
    reader.file = file
    reader.setAutoTransform(True)
    reader.setDecideFormatFromContent(True)
    if hasattr(reader, "setAllocationLimit"):
        # Qt 6 refuses what Qt 5 opened: a photo of 64 megapixels is 256 MB decoded.
        type(reader).setAllocationLimit(0)
    size = reader.size()
    if size.isValid() and size.width() * size.height() > MAX_PX:
        megapixels = size.width() * size.height() // 1_000_000
        words = f"the photo {Path(path).name} has {megapixels} megapixels"
        raise PhotoError(f"{words}, more than {MAX_PX // 1_000_000}; try: a smaller copy of it")
    return reader


def _unreadable(path: str | Path, why: str) -> PhotoError:
    formats = ", ".join(readable_formats())
    return PhotoError(
        f"cannot read the photo {Path(path).name}: {why}; try: save it as JPEG or PNG "
        f"(read here are {formats})"
    )
