"""Straight edges in the photo, found to a fraction of a pixel near where they are drawn.

Terms
-----
grey
    The photo's brightness, (height, width), any unit. Photo positions have their origin at the
    photo's corner: the middle of the first pixel is (0.5, 0.5).
reach
    How far from the drawn line the edge is looked for, px.
profile
    Brightness along a short line square to the drawn one.

First the straight line is taken along which the brightness changes most, all profiles together, so
that no single dark spot leads astray; then each profile tells where its own step is, and a line is
fitted to these points, leaving out what is far off.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d, map_coordinates

from ..solver.values import Array

#: Steps of a profile in one pixel, and the smoothing along it, px.
_PER_PX, _SMOOTH_PX = 2, 1.0
#: Most profiles of a side, and the part of it at each end that is left out: corners are round.
_MAX_PROFILES, _END = 160, 0.07
#: Points further than this from the line, px, belong to something else.
_NEAR_PX = 2.0
#: A profile whose step is below this part of the median one has none.
_FAINT = 0.35
#: So many profiles, and this part of them, have to have a step.
_LEAST_POINTS, _LEAST_PART = 6, 0.5
#: No corner is found more exactly than this.
_LEAST_SIGMA_PX = 0.05


@dataclass(frozen=True, slots=True, eq=False)
class FoundLine:
    """A straight edge: its ends beside those drawn, the points it was fitted to, its exactness.

    Parameters
    ----------
    ends_px : (2, 2) array
    points_px : (k, 2) array
        In order along the edge.
    sigma_px : float
        Standard error of an end, square to the edge.
    """

    ends_px: Array
    points_px: Array
    sigma_px: float


@dataclass(frozen=True, slots=True, eq=False)
class FoundCorners:
    """Corners of a quadrilateral after a look at the photo.

    Parameters
    ----------
    corners_px : (4, 2) array
    sigma_px : float
        Standard error of a corner's coordinates, the worst of the four.
    sides : tuple of FoundLine
    """

    corners_px: Array
    sigma_px: float
    sides: tuple[FoundLine, ...]


def refined_corners(grey: Array, corners_px: Array, reach_px: float) -> FoundCorners | None:
    """Corners of a quadrilateral, from the straight edges near its drawn sides.

    Parameters
    ----------
    grey : (height, width) array
    corners_px : (4, 2) array
        In order around.
    reach_px : float

    Returns
    -------
    FoundCorners or None
        None where a side is not to be seen, or the corners ran away.
    """
    drawn = np.asarray(corners_px, dtype=float)
    shortest = float(np.linalg.norm(np.roll(drawn, -1, axis=0) - drawn, axis=1).min())
    reach_px = min(reach_px, shortest / 4)
    corners, found = drawn, None
    # Once more from better corners: the ends left out are then the right ones.
    for reach in (reach_px, max(2 * _NEAR_PX, reach_px / 3)):
        found = _corners(grey, corners, min(reach, reach_px))
        if found is None:
            return None
        corners = found.corners_px
    ran = float(np.linalg.norm(corners - drawn, axis=1).max())
    return found if ran <= 2 * reach_px else None


def _corners(grey: Array, corners: Array, reach_px: float) -> FoundCorners | None:
    sides = [found_line(grey, corners[k], corners[(k + 1) % 4], reach_px) for k in range(4)]
    lines = [side for side in sides if side is not None]
    if len(lines) < 4:
        return None
    found, sigmas = [], []
    for k in range(4):
        (p, q), (r, s) = lines[k - 1].ends_px, lines[k].ends_px
        along, across = q - p, s - r
        sine = along[0] * across[1] - along[1] * across[0]
        if abs(sine) < 0.05 * float(np.linalg.norm(along) * np.linalg.norm(across)):
            return None
        offset = r - p
        found.append(p + along * ((offset[0] * across[1] - offset[1] * across[0]) / sine))
        flat = abs(sine) / float(np.linalg.norm(along) * np.linalg.norm(across))
        sigmas.append(np.hypot(lines[k - 1].sigma_px, lines[k].sigma_px) / flat / np.sqrt(2))
    sigma = max(_LEAST_SIGMA_PX, *map(float, sigmas))
    return FoundCorners(np.array(found), sigma, tuple(lines))


def found_line(grey: Array, p_px: Array, q_px: Array, reach_px: float) -> FoundLine | None:
    """The straight edge near a drawn line.

    Parameters
    ----------
    grey : (height, width) array
    p_px, q_px : (2,) arrays
        The drawn ends.
    reach_px : float

    Returns
    -------
    FoundLine or None
        None where nothing straight is to be seen there.
    """
    p, q = np.asarray(p_px, dtype=float), np.asarray(q_px, dtype=float)
    length = float(np.linalg.norm(q - p))
    if length < 2 * _LEAST_POINTS or reach_px < 1:
        return None
    along = (q - p) / length
    across = np.array([-along[1], along[0]])
    count = int(np.clip(length * (1 - 2 * _END), _LEAST_POINTS, _MAX_PROFILES))
    t = np.linspace(_END, 1 - _END, count)
    offsets = np.arange(-(reach_px + 4), reach_px + 4 + 1e-9, 1 / _PER_PX)
    slopes = _slopes(grey, p + np.outer(t * length, along), across, offsets)
    guess = _strongest(slopes, t, offsets, reach_px)
    for _ in range(2):
        own, kept = _steps(slopes, t, offsets, guess)
        if kept.sum() < max(_LEAST_POINTS, _LEAST_PART * count):
            return None
        guess, sigma, kept = _fitted(t, own, kept)
    ends = np.array([p + across * guess[0], q + across * guess[1]])
    points = p + np.outer(t * length, along) + own[:, None] * across
    return FoundLine(ends, points[kept], sigma)


def _slopes(grey: Array, feet: Array, across: Array, offsets: Array) -> Array:
    """How steeply the brightness changes along each profile, (profiles, offsets)."""
    places = feet[:, None, :] + offsets[None, :, None] * across
    at = np.array([places[..., 1] - 0.5, places[..., 0] - 0.5])
    values = map_coordinates(grey, at, order=1, mode="nearest", output=np.float64)
    # A little along the side, too: paper has grain, sensors have noise.
    values = gaussian_filter1d(values, 1.0, axis=0, mode="nearest")
    return np.asarray(gaussian_filter1d(values, _SMOOTH_PX * _PER_PX, axis=1, order=1))


def _strongest(slopes: Array, t: Array, offsets: Array, reach_px: float) -> Array:
    """Offsets at both ends of the straight line with the most change, (2,)."""
    limit = float(np.median(np.abs(slopes).max(axis=1))) + 1e-300
    clipped = np.clip(slopes, -limit, limit)
    shifts = np.arange(-reach_px, reach_px + 1e-9, 1 / _PER_PX)
    a, b = (grid.ravel() for grid in np.meshgrid(shifts, shifts, indexing="ij"))
    places = np.rint((a[:, None] * (1 - t) + b[:, None] * t - offsets[0]) * _PER_PX).astype(int)
    change = np.abs(clipped[np.arange(len(t)), places].sum(axis=1))
    # Of several edges, the one that was meant is the nearer one.
    change *= np.exp(-(a**2 + b**2) / (4 * reach_px**2))
    best = int(np.argmax(change))
    return np.array([a[best], b[best]])


def _steps(slopes: Array, t: Array, offsets: Array, guess: Array) -> tuple[Array, Array]:
    """Each profile's own step near the line: its offset, and whether there is one."""
    line = guess[0] * (1 - t) + guess[1] * t
    rows = np.arange(len(t))
    sign = np.sign(np.sum(slopes[rows, np.rint((line - offsets[0]) * _PER_PX).astype(int)]))
    near = np.abs(offsets[None, :] - line[:, None]) <= _NEAR_PX
    rising = np.where(near, sign * slopes, -np.inf)
    k = np.clip(np.argmax(rising, axis=1), 1, len(offsets) - 2)
    before, at, after = (sign * slopes[rows, k + d] for d in (-1, 0, 1))
    curve = before - 2 * at + after
    is_peak = (at >= before) & (at >= after) & (curve < 0) & (at > 0)
    inside = np.where(is_peak, 0.5 * (before - after) / np.where(curve < 0, curve, -1.0), 0.0)
    strong = at > _FAINT * float(np.median(at))
    return offsets[k] + inside / _PER_PX, is_peak & strong


def _fitted(t: Array, own: Array, kept: Array) -> tuple[Array, float, Array]:
    """The line through the steps: offsets at both ends, their standard error, which points."""
    A = np.column_stack([1 - t, t])
    for _ in range(4):
        guess = np.linalg.lstsq(A[kept], own[kept], rcond=None)[0]
        off = np.abs(own - A @ guess)
        spread = max(1.4826 * float(np.median(off[kept])), 0.02)
        fewer = kept & (off <= 3 * spread)
        if bool((fewer == kept).all()) or fewer.sum() < _LEAST_POINTS:
            break
        kept = fewer
    off = (own - A @ guess)[kept]
    # Neighbouring profiles see the same pixels: about every third tells something new.
    spare = max(1.0, len(off) / 3 - 2)
    variance = float(off @ off) / len(off) * 3 * np.linalg.inv(A[kept].T @ A[kept])
    return guess, float(np.sqrt(variance.diagonal().max() * len(off) / 3 / spare)), kept
