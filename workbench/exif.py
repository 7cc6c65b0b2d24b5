"""What a camera wrote into its photo: its lens, and how large the photo was.

Terms
-----
35 mm equivalent
    The focal length that gives the same angle of view, corner to corner, on a 36 x 24 mm frame.
written size
    Of the photo as the camera took it. Programs that crop photos often leave it as it was.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

_EXIF_IFD = 0x8769
_FOCAL_35MM, _WRITTEN_WIDTH, _WRITTEN_HEIGHT = 0xA405, 0xA002, 0xA003
FRAME_DIAGONAL_MM = math.hypot(36.0, 24.0)
#: Sides of photos as cameras take them, the longer one in shorter ones: sensors and screens.
_USUAL_SHAPES = (
    1.0,
    5 / 4,
    4 / 3,
    11 / 8,
    7 / 5,
    3 / 2,
    16 / 10,
    5 / 3,
    16 / 9,
    2.0,
    18.5 / 9,
    19.5 / 9,
    20 / 9,
    21 / 9,
    65 / 24,
)
#: Shapes that differ by less are one.
_SAME_SHAPE = 0.012


@dataclass(frozen=True, slots=True)
class PhotoData:
    """What is written in a photo.

    Parameters
    ----------
    size_px : (width, height)
        Of the file's picture, which may lie on its side.
    focal_35mm : float or None
    written_size_px : (width, height) or None
    """

    size_px: tuple[int, int]
    focal_35mm: float | None = None
    written_size_px: tuple[int, int] | None = None

    @property
    def whole_size_px(self) -> tuple[int, int] | None:
        """Of the photo before it was cropped; None where that is not known to have been done."""
        if self.written_size_px is None:
            return None
        whole, now = (sorted(size) for size in (self.written_size_px, self.size_px))
        is_alike = abs(whole[1] * now[0] / (whole[0] * now[1]) - 1) < _SAME_SHAPE
        is_within = now[0] <= whole[0] and now[1] <= whole[1]
        return self.written_size_px if is_within and not is_alike else None

    @property
    def is_of_a_camera(self) -> bool:
        """Whether a camera wrote anything that we know."""
        return self.focal_35mm is not None or self.written_size_px is not None

    @property
    def has_unusual_shape(self) -> bool:
        """Whether no camera takes photos with such sides."""
        shape = max(self.size_px) / min(self.size_px)
        return all(abs(shape / usual - 1) > _SAME_SHAPE for usual in _USUAL_SHAPES)

    @property
    def focal_px(self) -> float | None:
        """The focal length in photo px, which cropping leaves as it was."""
        if self.focal_35mm is None:
            return None
        return (
            self.focal_35mm / FRAME_DIAGONAL_MM * math.hypot(*(self.whole_size_px or self.size_px))
        )


def photo_data(path: str | Path) -> PhotoData | None:
    """What is written in a photo's EXIF data; None where nothing can be read."""
    try:
        from PIL import Image
    except ModuleNotFoundError:
        return None
    try:
        with _of_any_size(Image), Image.open(path) as photo:
            exif, size = photo.getexif().get_ifd(_EXIF_IFD), photo.size
    except (OSError, ValueError, SyntaxError):
        # Qt reads formats that Pillow does not know: then nothing is known of the lens.
        return None
    width, height = (_number(exif.get(tag)) for tag in (_WRITTEN_WIDTH, _WRITTEN_HEIGHT))
    written = None if width is None or height is None else (int(width), int(height))
    return PhotoData(size, _number(exif.get(_FOCAL_35MM)), written)


@contextlib.contextmanager
def _of_any_size(images: ModuleType) -> Iterator[None]:
    """Pillow warns of photos over 89 megapixels; nothing but what is written in them is read."""
    most, images.MAX_IMAGE_PIXELS = images.MAX_IMAGE_PIXELS, None
    try:
        yield
    finally:
        images.MAX_IMAGE_PIXELS = most


def focal_length_px(path: str | Path) -> float | None:
    """The focal length in photo px, from the 35 mm equivalent in the photo's EXIF data.

    Returns
    -------
    float or None
        None where the photo does not say it, or no library is there to read it.
    """
    data = photo_data(path)
    return None if data is None else data.focal_px


def _number(written: object) -> float | None:
    """What a tag says; None where it says nothing: cameras write 0 for "unknown"."""
    try:
        number = float(written or 0)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        return None
    return number if math.isfinite(number) and number > 0 else None
