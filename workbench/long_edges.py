"""Long edges anywhere in a photo, straight or a little bent: where to look for them.

Terms
-----
slope
    How the brightness changes, across and down, grey levels a px.
turn
    The direction of a slope; along one edge it hardly changes.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import find_objects, gaussian_filter, label

from ..solver.values import Array

#: Photos are looked at so coarsely that their longer side has at most so many px.
_COARSE_PX = 1600
#: Slopes are taken over so many px.
_OVER_PX = 1.5
#: A slope counts that is so many times the middle one of all, and at least so steep.
_STEEP, _LEAST_SLOPE = 4.0, 0.8
#: So many ranges of turns, of which each overlaps half of the next.
_TURNS = 16
#: An edge is long that is this part of the photo's longer side.
_LONG = 0.1
#: A lens bends an edge by less than this part of its length.
_BENT = 0.05
#: At most so many are told, the longest.
_MOST = 60


def long_edges(grey: Array) -> list[tuple[Array, Array]]:
    """Both ends of each, px, the longest first.

    Parameters
    ----------
    grey : (height, width) array
        The photo's brightness.
    """
    every = max(1, -(-max(grey.shape) // _COARSE_PX))
    coarse = np.asarray(grey, dtype=np.float32)
    if every > 1:
        coarse = gaussian_filter(coarse, every / 2)[::every, ::every]
    across, down = (gaussian_filter(coarse, _OVER_PX, order=o) for o in ((0, 1), (1, 0)))
    size = np.hypot(across, down)
    steep = size > max(_LEAST_SLOPE, _STEEP * float(np.median(size)))
    steep &= _is_ridge(size, across, down)
    rows, columns = np.nonzero(steep)
    turns = np.arctan2(down[rows, columns], across[rows, columns]) % (2 * np.pi)
    least = _LONG * max(coarse.shape)
    found = []
    for k in range(_TURNS):
        middle = 2 * np.pi * k / _TURNS
        near = np.abs((turns - middle + np.pi) % (2 * np.pi) - np.pi) < 2 * np.pi / _TURNS
        along = np.array([-np.sin(middle), np.cos(middle)])
        found += _long_ones(coarse.shape, rows[near], columns[near], along, least)
    found.sort(key=lambda ends: -float(np.linalg.norm(ends[1] - ends[0])))
    return [(every * p + 0.5, every * q + 0.5) for p, q in found[:_MOST]]


def _is_ridge(size: Array, across: Array, down: Array) -> Array:
    """Where a slope is the steepest on its way, to about a pixel."""
    flat = np.abs(across) > np.abs(down)
    higher = size >= np.maximum(np.roll(size, 1, 1), np.roll(size, -1, 1))
    steeper = size >= np.maximum(np.roll(size, 1, 0), np.roll(size, -1, 0))
    return np.asarray(np.where(flat, higher, steeper))


def _long_ones(
    shape: tuple[int, int], rows: Array, columns: Array, along: Array, least: float
) -> list[tuple[Array, Array]]:
    """Ends of the long runs of such places, in columns and rows."""
    is_there = np.zeros(shape, dtype=bool)
    is_there[rows, columns] = True
    names, _ = label(is_there, np.ones((3, 3)))
    found = []
    for name, box in enumerate(find_objects(names), 1):
        if np.hypot(*(s.stop - s.start for s in box)) < least:
            continue
        places = np.argwhere(names[box] == name)[:, ::-1] + [box[1].start, box[0].start]
        t = places @ along
        p, q = places[np.argmin(t)], places[np.argmax(t)]
        chord = q - p
        length = float(np.linalg.norm(chord))
        off = np.abs((places - p) @ [-chord[1], chord[0]]) / max(length, 1.0)
        if length > least and off.max() < _BENT * length:
            found.append((p, q))
    return found
