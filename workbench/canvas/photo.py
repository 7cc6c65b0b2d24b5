"""Reading the photo as a person sees it: upright, whatever way the camera was held."""

from __future__ import annotations

from pathlib import Path

from .qt import QtGui


class PhotoError(ValueError):
    """The photo cannot be read; says why."""


def load_photo(path: str | Path) -> QtGui.QImage:
    """Read an image file and turn it upright by its EXIF orientation.

    Raises
    ------
    PhotoError
        Where it is missing or no image that Qt knows.
    """
    reader = QtGui.QImageReader(str(path))
    reader.setAutoTransform(True)
    reader.setDecideFormatFromContent(True)
    if hasattr(reader, "setAllocationLimit"):
        # Qt 6 refuses what Qt 5 opened: a photo of 64 megapixels is 256 MB decoded.
        type(reader).setAllocationLimit(0)
    image = reader.read()
    if image.isNull():
        raise PhotoError(
            f"cannot read the photo {Path(path).name}: {reader.errorString()}; "
            "try: save it as JPEG or PNG"
        )
    return image
