"""The marker where its own black and white cannot be read: any dark four-sided spot like it.

Terms
-----
spot
    A connected dark part of a picture in black and white. Shadows' edges and glare cut into it, but
    the sides of its hull are still those of the marker.
steps
    How the logarithm of the brightness changes from each field of the marker to the next, the white
    ring round it included. A shadow's edge changes few of them, uneven light none.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from .marker_sheet import FIELDS, PATTERN

if TYPE_CHECKING:
    from ..solver.values import Array

#: So alike, of 1, the steps of a spot and the marker's are; those of its pattern alone as well.
#: Other markers of the dictionary come to less, and what lies on desks to far less.
ALIKE, PATTERN_ALIKE = 0.75, 0.7
#: A hull with more sides is no square; its sides may bend so much, in parts of its length round.
_MOST_SIDES, _BEND = 8, 0.012
_LEAST_SIDE_PX, _LEAST_SINE = 14.0, 0.12
#: Gaps between dark parts that are bridged, in parts of the picture's longer side.
_GAPS = (0.005, 0.015)
#: Pixels of a field where it is compared, with a white ring one field wide.
_FIELD_PX = 8
_ACROSS = FIELDS + 2
#: Brightness below this is noise.
_DARKEST = 6.0


def best_quad(calm: Array, pictures: Iterator[Array]) -> Array | None:
    """The corners (4, 2) of what looks most like the marker, or None where nothing does.

    Parameters
    ----------
    calm : (height, width) array of uint8
        The photo.
    pictures : of (height, width) arrays of uint8
        The same in black and white, in some ways.
    """
    light = np.log(calm + _DARKEST).astype(np.float32)
    quads = [q for picture in pictures for way in _joined(picture) for q in _quads(way)]
    alike = [likeness(light, quad) for quad in quads]
    return quads[int(np.argmax(alike))] if alike and max(alike) > ALIKE else None


def shows_marker(grey: Array, quad: Array) -> bool:
    """Whether four corners in a photo are those of the marker's black square.

    Parameters
    ----------
    grey : (height, width) array
        Brightness, 0 to 255.
    quad : (4, 2) array
        In order around, photo px.

    Raises
    ------
    ModuleNotFoundError
        Where OpenCV is not installed.
    """
    around = np.ptp(quad, axis=0) / FIELDS
    low = np.floor(np.maximum(quad.min(axis=0) - around, 0.0)).astype(int)
    high = np.ceil(quad.max(axis=0) + around).astype(int)
    spot = grey[low[1] : high[1], low[0] : high[0]]
    light = np.log(np.clip(spot, 0, 255) + _DARKEST).astype(np.float32)
    # OpenCV counts from the middle of the first pixel.
    return bool(spot.size) and likeness(light, quad - low - 0.5) > ALIKE


def _joined(picture: Array) -> Iterator[Array]:
    """The picture, and the same where dark parts near each other are one: shadows part them."""
    import cv2

    yield picture
    for part in _GAPS:
        wide = 2 * int(part * max(picture.shape) / 2) + 1
        yield cv2.morphologyEx(picture, cv2.MORPH_OPEN, np.ones((wide, wide), np.uint8))


def _quads(picture: Array) -> Iterator[Array]:
    """What may be the sides of the marker: four of a dark spot's hull, each (4, 2)."""
    import cv2

    spots, _ = cv2.findContours(255 - picture, cv2.RETR_LIST, cv2.CHAIN_APPROX_SIMPLE)
    for spot in spots:
        if min(np.ptp(spot.reshape(-1, 2), axis=0)) < _LEAST_SIDE_PX / 2:
            continue
        hull = cv2.convexHull(spot)
        around = cv2.arcLength(hull, True)
        corners = cv2.approxPolyDP(hull, _BEND * around, True).reshape(-1, 2).astype(float)
        if around < 4 * _LEAST_SIDE_PX or not 4 <= len(corners) <= _MOST_SIDES:
            continue
        for sides in combinations(range(len(corners)), 4):
            quad = _where_sides_meet(corners, sides)
            if quad is not None:
                yield quad


def _where_sides_meet(corners: Array, sides: tuple[int, ...]) -> Array | None:
    """The corners between four sides of a polygon; None where they make no fair quadrilateral."""
    starts, ends = corners[list(sides)], np.roll(corners, -1, axis=0)[list(sides)]
    along = ends - starts
    along /= np.linalg.norm(along, axis=1)[:, None]
    before = np.roll(along, 1, axis=0)
    sines = before[:, 0] * along[:, 1] - before[:, 1] * along[:, 0]
    if not (np.all(sines > _LEAST_SINE) or np.all(sines < -_LEAST_SINE)):
        return None
    off = starts - np.roll(starts, 1, axis=0)
    reach = (off[:, 0] * along[:, 1] - off[:, 1] * along[:, 0]) / sines
    found = np.roll(starts, 1, axis=0) + reach[:, None] * before
    lengths = np.linalg.norm(np.roll(found, -1, axis=0) - found, axis=1)
    return np.asarray(found) if lengths.min() > _LEAST_SIDE_PX else None


def likeness(light: Array, quad: Array) -> float:
    """How alike a quadrilateral and the marker are, in any of its four positions, up to 1.

    Parameters
    ----------
    light : (height, width) array of float32
        Logarithm of the brightness.
    quad : (4, 2) array
        In order around, either way.
    """
    import cv2

    size = _ACROSS * _FIELD_PX
    low, high = _FIELD_PX - 0.5, size - _FIELD_PX - 0.5
    square = np.array([[low, low], [high, low], [high, high], [low, high]], np.float32)
    (ax, ay), (bx, by) = quad[1] - quad[0], quad[3] - quad[0]
    around = quad if ax * by - ay * bx > 0 else quad[::-1]
    to_square = cv2.getPerspectiveTransform(around.astype(np.float32), square)
    steps = _steps(cv2.warpPerspective(light, to_square, (size, size), flags=cv2.INTER_LINEAR))
    limit = 1.5 * float(np.median(np.abs(steps[np.abs(_OWN_STEPS[0]) > 0]))) + 1e-6
    steps = np.clip(steps, -limit, limit)
    best = 0.0
    for own in _OWN_STEPS:
        if _cosine(steps[_INNER], own[_INNER]) > PATTERN_ALIKE:
            best = max(best, _cosine(steps, own))
    return best


def _cosine(a: Array, b: Array) -> float:
    return float(a @ b / max(np.linalg.norm(a) * np.linalg.norm(b), 1e-12))


def _steps(square: Array) -> Array:
    """From each field to the next, right and then down, in the logarithm of the brightness."""
    n, half = _FIELD_PX, _FIELD_PX // 2
    found = []
    for page in (square, square.T):
        fields = page.reshape(_ACROSS, n, _ACROSS, n)[:, 1:-1].mean(axis=1)
        found.append(
            (fields[:, 1:, :half].mean(axis=2) - fields[:, :-1, half:].mean(axis=2)).ravel()
        )
    return np.concatenate(found)


def _own_steps() -> tuple[Array, ...]:
    fields = np.ones((_ACROSS, _ACROSS))
    fields[1:-1, 1:-1] = 0.0
    fields[2:-2, 2:-2] = [[float(bit) for bit in line] for line in PATTERN]
    square = np.kron(fields, np.ones((_FIELD_PX, _FIELD_PX)))
    return tuple(_steps(np.rot90(square, turn)) for turn in range(4))


def _inner() -> Array:
    """Which steps are between fields of the black square."""
    square = np.zeros((_ACROSS, _ACROSS))
    square[1:-1, 1:-1] = 1.0
    pairs = [square[:, 1:] * square[:, :-1], (square[1:] * square[:-1]).T]
    return np.concatenate([pair.ravel() for pair in pairs]) > 0


_OWN_STEPS, _INNER = _own_steps(), _inner()
