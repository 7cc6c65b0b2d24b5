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

blur
    How wide the step from dark to light is, its standard deviation in px: of a lens out of focus,
    of a camera that moved.

First the straight line is taken along which the brightness changes most, all profiles together, so
that no single dark spot leads astray; then each profile tells where its own step is, and a line is
fitted to these points, leaving out what is far off. Where the photo is blurred, profiles are
smoothed by as much: a ramp has no steepest place, but a middle.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d, map_coordinates

from ..solver.values import Array
from .marker_sheet import FIELDS

#: Steps of a profile in one pixel, and the smoothing along it, px.
_PER_PX, _SMOOTH_PX = 2, 1.0
#: Most profiles of a side, and the part of it at each end that is left out: corners are round.
_MAX_PROFILES, _END = 160, 0.07
#: Points further than this from the line, px, belong to something else.
_NEAR_PX = 2.0
#: A profile whose step is below this part of the median one has none.
_FAINT = 0.12
#: What is as bright as photos get, within so many grey levels, hides how far the step goes on: the
#: step seems to be beside it by so many px.
_GLARE, _GLARING, _GLARING_PX = 2.0, 250.0, 0.8
#: So many profiles, and this part of them, have to have a step.
_LEAST_POINTS, _LEAST_PART = 6, 0.5
#: No corner is found more exactly than this, nor than these parts of the blur.
_LEAST_SIGMA_PX, _OF_BLUR = 0.05, 0.06
#: Blur is looked for so far from the edge, in parts of the side's length and in px.
_WIDE, _WIDEST_PX = 1 / 16, 16.0
#: The step ends where it is this flat, in parts of its steepest.
_FLAT = 0.15
#: Blur above this, px, is reckoned with; so many times it, ends are round.
_SOFT_PX, _ROUND = 0.9, 2.0
#: Where no sharp edge is seen, one is looked for that is so blurred, px.
_TRIED_PX = (0.0, 2.0, 5.0)
_LARGEST_END = 0.25
#: Where edges may bend, one of so many profiles tells which one it is: there are many more ways.
_SOME = 4
#: Parts of a line that may lie beside it together, by what the photo shows there.
_BLOCKS = 8


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
    blur_px : float
        How wide the edge is; 0 where it is as sharp as pixels are.
    """

    ends_px: Array
    points_px: Array
    sigma_px: float
    blur_px: float = 0.0


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
    ring = np.array(found)
    sigma = max(_LEAST_SIGMA_PX, _smeared(ring, lines), *map(float, sigmas))
    return FoundCorners(ring, sigma, tuple(lines))


def _smeared(ring: Array, lines: list[FoundLine]) -> float:
    """How far what lies within may draw its sides away, px: a marker's fields where they are small.

    The tail of a blurred edge reaches the next one.
    """
    sides = np.roll(ring, -1, axis=0) - ring
    lengths = np.linalg.norm(sides, axis=1)
    (ax, ay), (bx, by) = ring[2] - ring[0], ring[3] - ring[1]
    area = abs(float(ax * by - ay * bx)) / 2
    field = area / float(lengths.max()) / FIELDS
    soft = float(np.hypot(_SMOOTH_PX, max(line.blur_px for line in lines)))
    return soft * float(np.exp(-((field / soft) ** 2) / 8))


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
    for blur_px in _TRIED_PX:
        seen = Profiles(grey, p, q, reach_px, blur_px)
        found = seen.fitted(seen.strongest(reach_px))
        if found is not None:
            break
    if found is None:
        return None
    blur_px = seen.blur_px(found)
    if blur_px > _SOFT_PX:
        soft = Profiles(grey, p, q, reach_px, blur_px)
        again = soft.fitted(found.offsets)
        if again is not None:
            seen, found = soft, again
    across = seen.across
    ends = np.array([p + across * found.offsets[0], q + across * found.offsets[1]])
    unsure = (found.sigma_px, _OF_BLUR * blur_px, _GLARING_PX * found.glaring)
    sigma_px = float(np.linalg.norm(unsure))
    return FoundLine(ends, seen.points(found), sigma_px, blur_px)


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """A line through steps: offsets at both ends (and its bow), and the ends' standard error.

    Each profile's own step, which of them count, and the part of these beside which there is glare.
    """

    offsets: Array
    sigma_px: float
    own: Array
    kept: Array
    glaring: float


class Profiles:
    """The profiles along a drawn line.

    Parameters
    ----------
    grey : (height, width) array
    p, q : (2,) arrays
        Its ends.
    reach_px : float
    blur_px : float
        Where the photo is blurred so much.
    bow_px : callable, optional
        How far beside the line at t the edge is where it bends by one unit; by default it is
        straight.
    """

    def __init__(
        self,
        grey: Array,
        p: Array,
        q: Array,
        reach_px: float,
        blur_px: float,
        bow_px: Callable[[Array], Array] | None = None,
    ) -> None:
        length = float(np.linalg.norm(q - p))
        along = (q - p) / length
        self.across = np.array([-along[1], along[0]])
        end = min(max(_END, _ROUND * blur_px / length), _LARGEST_END)
        count = int(np.clip(length * (1 - 2 * end), _LEAST_POINTS, _MAX_PROFILES))
        self.t = np.linspace(end, 1 - end, count)
        columns = [1 - self.t, self.t, *([] if bow_px is None else [bow_px(self.t)])]
        #: What the offsets at both ends, and the bow, make of a line's offset at each profile.
        self.basis = np.column_stack(columns)
        margin = max(4.0, min(_WIDE * length, _WIDEST_PX))
        self.offsets = np.arange(-(reach_px + margin), reach_px + margin + 1e-9, 1 / _PER_PX)
        self.feet = p + np.outer(self.t * length, along)
        self._smooth_px = max(_SMOOTH_PX, blur_px)
        self._near_px = max(_NEAR_PX, 1.5 * blur_px)
        values = _values(grey, self.feet, self.across, self.offsets)
        self.slopes = np.asarray(
            gaussian_filter1d(values, self._smooth_px * _PER_PX, axis=1, order=1)
        )
        self._values = values
        most = float(grey.max())
        #: What is brighter may be much brighter: a photo ends there.
        self._brightest = most - _GLARE if most >= _GLARING else np.inf

    def fitted(self, guess: Array, among: Array | None = None) -> Fit | None:
        """The line near a guess; None where too few profiles (among these) have a step."""
        among = np.ones(len(self.t), dtype=bool) if among is None else among
        for _ in range(2):
            own, kept, bright = self._steps(guess)
            kept &= among
            if kept.sum() < max(_LEAST_POINTS, _LEAST_PART * among.sum()):
                return None
            clear = kept & ~bright
            if clear.sum() >= _LEAST_POINTS and np.ptp(self.t[clear]) > _LEAST_PART:
                kept = clear
            guess, sigma_px, kept = _fitted(self.basis, own, kept)
        return Fit(guess, sigma_px, own, kept, float(bright[kept].mean()))

    def strongest(self, reach_px: float, most_bow: float = 0.0) -> Array:
        """Offsets at both ends (and the bow) of the line with the most change, (2,) or (3,)."""
        some = slice(None) if self.basis.shape[1] == 2 else slice(None, None, _SOME)
        slopes, basis = self.slopes[some], self.basis[some]
        limit = float(np.median(np.abs(slopes).max(axis=1))) + 1e-300
        clipped = np.clip(slopes, -limit, limit)
        step = 1 / _PER_PX if basis.shape[1] == 2 else 1.0
        ends = np.arange(-reach_px, reach_px + 1e-9, step)
        bows = [_bows(column, most_bow) for column in basis.T[2:]]
        ways = np.stack([g.ravel() for g in np.meshgrid(ends, ends, *bows, indexing="ij")])
        places = self._index(np.tensordot(ways, basis, axes=(0, 1)))
        change = np.abs(clipped[np.arange(len(basis)), places].sum(axis=1))
        # Of several edges, the one that was meant is the nearer one.
        change *= np.exp(-(ways[0] ** 2 + ways[1] ** 2) / (4 * reach_px**2))
        return np.asarray(ways[:, int(np.argmax(change))])

    def points(self, fit: Fit) -> Array:
        """The steps that count, (n, 2) in the photo."""
        return np.asarray((self.feet + fit.own[:, None] * self.across)[fit.kept])

    def _steps(self, guess: Array) -> tuple[Array, Array, Array]:
        """Each profile's own step near the line: its offset, whether there is one, and glare."""
        slopes, offsets = self.slopes, self.offsets
        line = self.basis @ guess
        rows = np.arange(len(self.t))
        sign = np.sign(np.sum(slopes[rows, self._index(line)]))
        near = np.abs(offsets[None, :] - line[:, None]) <= self._near_px
        rising = np.where(near, sign * slopes, -np.inf)
        k = np.clip(np.argmax(rising, axis=1), 1, len(offsets) - 2)
        before, at, after = (sign * slopes[rows, k + d] for d in (-1, 0, 1))
        curve = before - 2 * at + after
        is_peak = (at >= before) & (at >= after) & (curve < 0) & (at > 0)
        inside = np.where(is_peak, 0.5 * (before - after) / np.where(curve < 0, curve, -1.0), 0.0)
        strong = at > _FAINT * float(np.median(at))
        bright = np.any(near & (self._values > self._brightest), axis=1)
        return offsets[k] + inside / _PER_PX, is_peak & strong, bright

    def _index(self, offsets: Array) -> Array:
        found = np.rint((offsets - self.offsets[0]) * _PER_PX).astype(int)
        return np.asarray(np.clip(found, 0, len(self.offsets) - 1))

    def blur_px(self, fit: Fit) -> float:
        """How wide the step is on the whole, without what smoothing has added."""
        reach = max(2, int((self.offsets[-1] - np.abs(fit.offsets).max()) * _PER_PX))
        middle = self._index(fit.own[fit.kept])
        steps = np.clip(middle[:, None] + np.arange(-reach, reach + 1), 0, len(self.offsets) - 1)
        mean = self.slopes[np.flatnonzero(fit.kept)[:, None], steps].mean(axis=0)
        mean = mean * np.sign(mean[reach])
        low = mean <= _FLAT * mean[reach - 1 : reach + 2].max()
        left = reach - int(np.argmax(low[reach::-1])) if low[: reach + 1].any() else -1
        right = reach + int(np.argmax(low[reach:])) if low[reach:].any() else 2 * reach + 1
        at = np.arange(left + 1, right) / _PER_PX
        share = mean[left + 1 : right] / mean[left + 1 : right].sum()
        wide = float(share @ at**2 - (share @ at) ** 2)
        return float(np.sqrt(max(0.0, wide - self._smooth_px**2)))


def _bows(column: Array, most: float) -> Array:
    """Bows of which each bends a line by a pixel more than the one before."""
    count = int(most * float(np.abs(column).max()))
    return np.linspace(-most, most, 2 * count + 1)


def _values(grey: Array, feet: Array, across: Array, offsets: Array) -> Array:
    """The brightness along each profile, (profiles, offsets)."""
    places = feet[:, None, :] + offsets[None, :, None] * across
    at = np.array([places[..., 1] - 0.5, places[..., 0] - 0.5])
    values = map_coordinates(grey, at, order=1, mode="nearest", output=np.float64)
    # A little along the side, too: paper has grain, sensors have noise.
    return np.asarray(gaussian_filter1d(values, 1.0, axis=0, mode="nearest"))


def _fitted(A: Array, own: Array, kept: Array) -> tuple[Array, float, Array]:
    """The line through the steps: offsets at both ends, their standard error, which points."""
    for _ in range(4):
        guess = np.linalg.lstsq(A[kept], own[kept], rcond=None)[0]
        off = np.abs(own - A @ guess)
        spread = max(1.4826 * float(np.median(off[kept])), 0.02)
        fewer = kept & (off <= 3 * spread)
        if bool((fewer == kept).all()) or fewer.sum() < _LEAST_POINTS:
            break
        kept = fewer
    off = (own - A @ guess)[kept]
    # Neighbouring profiles see the same pixels: about every third tells something new. Where a
    # whole part of the line lies beside it, parts are what tells something new.
    spare = max(1.0, len(off) / 3 - 2)
    parts = [part.mean() for part in np.array_split(off, min(_BLOCKS, len(off)))]
    alike = max(
        3.0 * float(off @ off) / len(off), len(off) / _BLOCKS * float(np.square(parts).mean())
    )
    variance = alike * np.linalg.inv(A[kept].T @ A[kept])
    return guess, float(np.sqrt(variance.diagonal().max() * len(off) / 3 / spare)), kept
