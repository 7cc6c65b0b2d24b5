"""The focal length that a camera wrote into its photo.

Terms
-----
35 mm equivalent
    The focal length that gives the same angle of view, corner to corner, on a 36 x 24 mm frame.
"""

from __future__ import annotations

import math
from pathlib import Path

_EXIF_IFD = 0x8769
_FOCAL_35MM = 0xA405
_FRAME_DIAGONAL_MM = math.hypot(36.0, 24.0)


def focal_length_px(path: str | Path) -> float | None:
    """The focal length in photo px, from the 35 mm equivalent in the photo's EXIF data.

    Returns
    -------
    float or None
        None where the photo does not say it, or no library is there to read it.
    """
    try:
        from PIL import Image
    except ModuleNotFoundError:
        return None
    try:
        with Image.open(path) as photo:
            focal_35mm = photo.getexif().get_ifd(_EXIF_IFD).get(_FOCAL_35MM)
            diagonal_px = math.hypot(*photo.size)
    except (OSError, ValueError, SyntaxError):
        # Qt reads formats that Pillow does not know: then nothing is known of the lens.
        return None
    try:
        focal_mm = float(focal_35mm or 0)
    except (TypeError, ValueError):
        return None
    # Cameras write 0 for "unknown".
    if not math.isfinite(focal_mm) or focal_mm <= 0:
        return None
    return focal_mm / _FRAME_DIAGONAL_MM * diagonal_px
