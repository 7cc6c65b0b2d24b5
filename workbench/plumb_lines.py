"""Edges of straight things in a photo whose lens may bend them, followed as far as they go.

An edge is looked for as one curve, with the bow that a lens gives to a line at that place: pieces
by themselves would find the other border of a joint, or what stands before it.
"""

from __future__ import annotations

import numpy as np

from ..solver.values import Array
from .photo_lines import Profiles
from .radial import MOST_K, Radial

#: Shorter edges show no bend, px.
_LEAST_PX = 24.0
#: So many points make an edge.
_LEAST_POINTS = 24
#: An edge is followed by this part of its length at a time, on either side, and at most so often,
_ON, _TIMES = 0.25, 8
#: unless it grows by less than this part.
_LITTLE = 0.06
#: How far from where it should go on its steps are looked for, px.
_NEAR_PX = 4.0
#: It goes on while so much of so many profiles has its step.
_SEEN, _WINDOW = 0.5, 9


def followed(grey: Array, p_px: Array, q_px: Array, reach_px: float, radial: Radial) -> Array:
    """Points (n, 2) of the edge near a drawn line, and of where it goes on.

    Parameters
    ----------
    grey : (height, width) array
    p_px, q_px : (2,) arrays
        The drawn ends.
    reach_px : float
        How far from them the edge is looked for.
    radial : Radial

    Returns
    -------
    (n, 2) array
        None of them where no edge is to be seen.
    """
    p, q = np.asarray(p_px, dtype=float), np.asarray(q_px, dtype=float)
    if float(np.linalg.norm(q - p)) < _LEAST_PX:
        return np.zeros((0, 2))
    seen = _profiles(grey, p, q, reach_px, MOST_K, radial)
    found = seen.fitted(seen.strongest(reach_px, MOST_K))
    if found is None:
        return np.zeros((0, 2))
    points, k = seen.points(found), float(found.offsets[2])
    for _ in range(_TIMES):
        length = float(np.linalg.norm(points[-1] - points[0]))
        points, k = _gone_on(grey, points, k, radial)
        if float(np.linalg.norm(points[-1] - points[0])) < (1 + _LITTLE) * length:
            break
    return points if len(points) >= _LEAST_POINTS else np.zeros((0, 2))


def _profiles(
    grey: Array, p: Array, q: Array, reach_px: float, k: float, radial: Radial
) -> Profiles:
    """Along an edge that lenses up to this k bend."""
    bow_px = k * abs(float(radial.bow(p, q, np.array([0.5]))[0]))
    return Profiles(grey, p, q, reach_px + bow_px, 0.0, lambda t: radial.bow(p, q, t))


def _gone_on(grey: Array, points: Array, k: float, radial: Radial) -> tuple[Array, float]:
    """The edge with where it goes on at both ends; as it was where it does not."""
    ends = radial.straightened(points[[0, -1]], k)
    t = np.linspace(-_ON, 1 + _ON, 65)
    way = radial.bent(ends[0] + np.outer(t, ends[1] - ends[0]), k)
    inside = way[_within(grey, way)]
    if len(inside) < 2:
        return points, k
    p, q = inside[[0, -1]]
    seen = _profiles(grey, p, q, _NEAR_PX, abs(k), radial)
    found = seen.fitted(np.array([0.0, 0.0, k]))
    if found is None:
        return points, k
    middle = (points[0] + points[-1]) / 2
    start = int(np.argmin(np.linalg.norm(seen.feet - middle, axis=1)))
    again = seen.fitted(found.offsets, _unbroken(found.kept, start))
    if again is None:
        return points, k
    return seen.points(again), float(again.offsets[2])


def _within(grey: Array, places: Array) -> Array:
    height, width = grey.shape
    far = np.array([width, height]) - _NEAR_PX
    return np.asarray(((places > _NEAR_PX) & (places < far)).all(axis=1))


def _unbroken(is_seen: Array, start: int) -> Array:
    """From the start on to both sides as long as most is seen."""
    share = np.convolve(is_seen, np.ones(_WINDOW) / _WINDOW, mode="same")
    gaps = np.flatnonzero(share < _SEEN)
    before, after = gaps[gaps < start], gaps[gaps >= start]
    run = np.zeros(len(is_seen), dtype=bool)
    run[(before.max() + 1 if len(before) else 0) : (after.min() if len(after) else len(run))] = True
    return run
