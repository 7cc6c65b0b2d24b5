"""The camera of a photo from a rectangle in it: the printed marker, or four corners that are told.

OpenCV finds the marker; it is optional, and corners that are told do without it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..solver.errors import SketchError
from ..solver.perspective.marker import RectangleView, camera_from_rectangle, ring_of
from ..solver.problem import TRACED_SIGMA_PX
from .marker_quads import best_quad, shows_marker
from .photo_lines import FoundCorners, FoundLine, refined_corners

if TYPE_CHECKING:
    from ..solver.graph import Photo, Point
    from ..solver.values import Array

#: How near corners that were clicked are to the true ones, in parts of the photo's longer side.
CLICK_REACH = 0.012
#: Standard error of corners that are clicked and not refined, in parts of the longer side.
CLICK_SIGMA = 0.001
#: Of refined ones, px: what paper that is not quite flat, and lenses, make of it.
LEAST_SIGMA_PX = 0.1
NOT_SEEN = (
    "No straight edges are seen between the corners, which are taken as they are: place them well."
)
#: Edges this blurred (standard deviation, px) are told; a shaken one is so many times as wide.
TOLD_BLUR_PX, WIDTH = 2.5, 12**0.5
#: How near those are that OpenCV finds, in parts of the longer side.
FOUND_REACH = 0.004
#: Where the marker is not seen at once: in a photo made so small, px; with paper seen within this
#: part of it, all that is darker than these parts of the paper being black.
EASY_PX = 1600.0
PAPER_PARTS = (0.06, 0.15, 0.03)
BLACK_LEVELS = (0.3, 0.45, 0.6, 0.75)


@dataclass(frozen=True, slots=True, eq=False)
class SeenCorners:
    """Four corners as they are seen in the photo.

    Parameters
    ----------
    corners_px : (4, 2) array
        Counterclockwise.
    sigma_px : float
        Standard error of a coordinate.
    sides : tuple of FoundLine
        The straight edges that they were found by; none where they are as told.
    notes : tuple of str
        What a person should know of it, a sentence each.
    is_marker : bool
        Whether they are seen to be those of the printed marker.
    """

    corners_px: Array
    sigma_px: float
    sides: tuple[FoundLine, ...] = ()
    notes: tuple[str, ...] = ()
    is_marker: bool = False


@dataclass(frozen=True, slots=True)
class Found:
    """A camera, and the corners that led to it."""

    view: RectangleView
    seen: SeenCorners

    @property
    def notes(self) -> tuple[str, ...]:
        """What a person should know of it, a sentence each."""
        return (*self.seen.notes, *self.view.notes)


def marker_corners(grey: Array) -> Array:
    """Where the printed marker is in a photo.

    Parameters
    ----------
    grey : (height, width) array
        Brightness, 0 to 255.

    Returns
    -------
    (4, 2) array
        The black square's corners, photo px.

    Raises
    ------
    SketchError
        Where there is none, or more than one.
    ModuleNotFoundError
        Where OpenCV is not installed.
    """
    import cv2

    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    detector = cv2.aruco.ArucoDetector(dictionary)
    pictures = []
    for picture, shrunk in _pictures(np.clip(np.rint(grey), 0, 255).astype(np.uint8)):
        pictures.append((picture, shrunk))
        corners, names, _ = detector.detectMarkers(picture)
        numbers = [] if names is None else names.ravel().tolist()
        own = [c for c, number in zip(corners, numbers, strict=True) if number == 0]
        if len(own) > 1:
            raise SketchError(f"{len(own)} markers are seen", (), "one only, or click its corners")
        if own:
            # OpenCV counts from the middle of the first pixel.
            return (np.asarray(own[0], dtype=float).reshape(4, 2) + 0.5) * shrunk
    calm, shrunk = pictures[1]
    quad = best_quad(calm, (picture for picture, _ in pictures[2:]))
    if quad is not None:
        return (quad + 0.5) * shrunk
    raise SketchError(
        "no marker is seen in the photo", (), "a photo with all of it, or click its corners"
    )


def _pictures(grey: Array) -> Iterator[tuple[Array, float]]:
    """The photo, then what makes of it less noise, even light, plain black and white."""
    import cv2

    yield grey, 1.0
    shrunk = max(1.0, max(grey.shape) / EASY_PX)
    size = (round(grey.shape[1] / shrunk), round(grey.shape[0] / shrunk))
    small = cv2.resize(grey, size, interpolation=cv2.INTER_AREA)
    calm = cv2.GaussianBlur(small, (0, 0), 1.5)
    yield calm, shrunk
    for part in PAPER_PARTS:
        # The brightest nearby is paper: in the shade as well.
        side = 2 * int(part * max(size) / 2) + 1
        paper = cv2.morphologyEx(calm, cv2.MORPH_CLOSE, np.ones((side, side), np.uint8))
        even = calm / np.maximum(paper, 1.0)
        for level in BLACK_LEVELS:
            yield np.where(even < level, 0, 255).astype(np.uint8), shrunk


def seen_corners(
    photo: Photo,
    grey: Array | None,
    corners_px: Sequence[Point] | Array | None,
    *,
    exactly: bool = False,
) -> SeenCorners:
    """Corners of a rectangle, found to a fraction of a pixel where the photo shows its sides.

    Parameters
    ----------
    photo : Photo
    grey : (height, width) array or None
        The upright photo's brightness; None where its file is missing: then the corners are
        taken as they are told.
    corners_px : four (u, v), or None
        In any order; None has the printed marker looked for.
    exactly : bool
        Take the corners as they are told.

    Raises
    ------
    SketchError
        Where there is no such rectangle.
    ModuleNotFoundError
        Where the marker is to be looked for, and OpenCV is not installed.
    """
    longer = max(photo.width_px, photo.height_px)
    if corners_px is not None:
        ring, reach_px = ring_of(np.asarray(corners_px, dtype=float)), CLICK_REACH * longer
    elif grey is not None:
        ring, reach_px = ring_of(marker_corners(grey)), FOUND_REACH * longer
    else:
        raise SketchError("without the photo no marker can be found", (), "tell the corners")
    seen = None if exactly or grey is None else refined_corners(grey, ring, reach_px)
    if seen is None and corners_px is None and grey is not None and not exactly:
        # A finger on a corner, or a shadow's edge, had it found beside.
        seen = refined_corners(grey, ring, CLICK_REACH * longer)
    if seen is not None:
        sigma_px = max(LEAST_SIGMA_PX, seen.sigma_px)
        is_marker = corners_px is None or _shows_marker(grey, seen.corners_px)
        return SeenCorners(seen.corners_px, sigma_px, seen.sides, _of_blur(seen), is_marker)
    notes = () if exactly or grey is None else (NOT_SEEN,)
    sigma_px = max(TRACED_SIGMA_PX, CLICK_SIGMA * longer)
    return SeenCorners(ring, sigma_px, (), notes, is_marker=corners_px is None)


def _shows_marker(grey: Array | None, corners_px: Array) -> bool:
    """Whether the corners are the marker's; without OpenCV nobody knows."""
    try:
        return grey is not None and shows_marker(grey, corners_px)
    except ModuleNotFoundError:
        return False


def _of_blur(seen: FoundCorners) -> tuple[str, ...]:
    """What is said where the photo is blurred."""
    blur_px = max(side.blur_px for side in seen.sides)
    if blur_px < TOLD_BLUR_PX:
        return ()
    return (
        f"The photo is blurred there, edges are {WIDTH * blur_px:.0f} px wide: sizes are less "
        "sure; take it with a steady hand, or in more light.",
    )


def camera_of_corners(photo: Photo, seen: SeenCorners, size_mm: tuple[float, float]) -> Found:
    """The camera that sees a rectangle of this size so, see `camera_from_rectangle`."""
    corners, sigma_px = seen.corners_px, seen.sigma_px
    return Found(camera_from_rectangle(photo, corners, size_mm, corner_sigma_px=sigma_px), seen)
