"""Straight edges of the photo near the pointer, found by their gradients: pure, no Qt.

Only a small window around the pointer is looked at, so that the photo's size does not matter.

Terms
-----
patch
    A window of the photo in grey levels, with about one px for each of the screen.
line
    A straight edge of the photo: a place on it, and its direction.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ...solver.values import Array
from .plane import Point, line_crossing, on_line
from .snapping import Snap, SnapKind

#: Directions of lines that are told apart, and how far apart those of a corner are.
DIRECTIONS = 48
CORNER_RAD = math.radians(20.0)
#: Weaker gradients, in grey levels a px and in parts of the strongest, are noise and texture.
WEAKEST = 4.0
WEAKEST_PART = 0.25
#: A line goes through so much of the window, with points on so much of that, this near to it, px.
COVERED, WHOLE = 0.35, 0.75
STRAIGHT_PX = 1.5
#: The second line of a corner has at least this part of the first one's gradients.
SECOND = 0.3


@dataclass(frozen=True, slots=True, eq=False)
class Patch:
    """A window of the photo.

    Parameters
    ----------
    grey : (h, w) array
    corner_px : (u, v)
        Its top-left corner in the photo.
    size : float
        Photo px of one px of the patch.
    """

    grey: Array
    corner_px: Point
    size: float

    def to_photo(self, x: float, y: float) -> Point:
        """A position of the patch in the photo."""
        u, v = self.corner_px
        return (float(u + self.size * x), float(v + self.size * y))


def photo_snap(patch: Patch, point_px: Point, reach_px: float) -> Snap | None:
    """The corner or the straight edge of the photo that attracts the pen; None where none is.

    Parameters
    ----------
    patch : Patch
        Around the pointer.
    point_px : (u, v)
    reach_px : float
        In photo px.
    """
    here = tuple((p - c) / patch.size for p, c in zip(point_px, patch.corner_px, strict=True))
    lines = _lines(patch.grey, here, reach_px / patch.size)
    if not lines:
        return None
    # Each as two places of the photo, as far apart as the patch is wide.
    half = len(patch.grey) / 2
    seen = [
        (patch.to_photo(*(middle - half * along)), patch.to_photo(*(middle + half * along)))
        for middle, along in lines
    ]
    if len(seen) > 1:
        corner = line_crossing(*seen[0], *seen[1])
        if corner is not None and math.dist(corner, point_px) <= reach_px:
            return Snap(SnapKind.PHOTO_CORNER, corner)
    return Snap(SnapKind.PHOTO_EDGE, on_line(point_px, *seen[0]), guide=seen[0])


def _lines(grey: Array, here: tuple[float, ...], reach: float) -> list[tuple[Array, Array]]:
    """At most two lines, the strongest first: a place on each, and its direction."""
    places, gradients = _edge_points(grey)
    if not len(places):
        return []
    places = places - here
    strength = np.linalg.norm(gradients, axis=1)
    # Of the line's normal; a line has no sides, so half a turn has all.
    angles = np.arctan2(gradients[:, 1], gradients[:, 0]) % math.pi
    found: list[tuple[Array, Array]] = []
    first = 0.0
    for _ in range(8):
        peak = _strongest(places, angles, strength, reach)
        if peak is None:
            break
        normal_rad, offset, votes = peak
        near = _between(angles, normal_rad) < CORNER_RAD
        on_it = near & (abs(_offsets(places, normal_rad) - offset) < STRAIGHT_PX + 1)
        line = _fitted(places[on_it], strength[on_it], len(grey), reach)
        if line is not None and votes >= SECOND * first:
            found.append((line[0] + here, line[1]))
            first = first or votes
        # The next one crosses it, or is another one where this was none.
        left = ~near if line is not None else ~on_it
        places, angles, strength = places[left], angles[left], strength[left]
        if len(found) == 2 or not len(places):
            break
    return found


def _edge_points(grey: Array) -> tuple[Array, Array]:
    """Places with a strong gradient, px from the patch's corner, and their gradients."""
    smooth = grey
    for axis in (0, 1):
        before, after = np.roll(smooth, 1, axis), np.roll(smooth, -1, axis)
        smooth = (before + 2 * smooth + after) / 4
    down, across = np.gradient(smooth)
    size = np.hypot(across, down)
    # What was rolled over the border is none of ours.
    size[:2], size[-2:], size[:, :2], size[:, -2:] = 0, 0, 0, 0
    rows, columns = np.nonzero(size > max(WEAKEST, WEAKEST_PART * size.max()))
    places = np.stack([columns + 0.5, rows + 0.5], axis=1)
    return places, np.stack([across[rows, columns], down[rows, columns]], axis=1)


def _strongest(
    places: Array, angles: Array, strength: Array, reach: float
) -> tuple[float, float, float] | None:
    """The line through the most gradients that passes near: its normal, offset and votes."""
    if not len(places):
        return None
    bins = np.floor(angles / math.pi * DIRECTIONS).astype(int) % DIRECTIONS
    votes = np.zeros((DIRECTIONS, 2 * math.ceil(reach) + 1))
    for turn in (-1, 0, 1):
        # A gradient's direction is not exact: its neighbours get a part of its vote.
        of = (bins + turn) % DIRECTIONS
        offsets = _offsets(places, (of + 0.5) / DIRECTIONS * math.pi)
        columns = np.rint(offsets).astype(int) + math.ceil(reach)
        there = (columns >= 0) & (columns < votes.shape[1])
        np.add.at(votes, (of[there], columns[there]), strength[there] / (1 + abs(turn)))
    k, column = np.unravel_index(int(votes.argmax()), votes.shape)
    most = float(votes[k, column])
    offset = float(column) - math.ceil(reach)
    return None if most <= 0 else ((float(k) + 0.5) / DIRECTIONS * math.pi, offset, most)


def _offsets(places: Array, normal_rad: Array | float) -> Array:
    """How far lines through places, with given normals, pass from the pointer."""
    x, y = places.T
    return np.asarray(x * np.cos(normal_rad) + y * np.sin(normal_rad))


def _fitted(places: Array, strength: Array, side: int, reach: float) -> tuple[Array, Array] | None:
    """The line through some places, where they are straight and far enough along it."""
    if len(places) < 3:
        return None
    middle = np.average(places, axis=0, weights=strength)
    away = (places - middle) * np.sqrt(strength / strength.mean())[:, None]
    _, _, axes = np.linalg.svd(away, full_matrices=False)
    along, across = axes
    near = abs((places - middle) @ across) < STRAIGHT_PX
    steps = np.unique(np.rint((places[near] - middle) @ along))
    long_enough = len(steps) > COVERED * side and len(steps) > WHOLE * np.ptp(steps)
    if not long_enough or abs(float(middle @ across)) > reach:
        return None
    return middle, along


def _between(angles: Array, other: float) -> Array:
    away = abs(angles - other) % math.pi
    return np.minimum(away, math.pi - away)
