"""Right-angled polygons less boxes, on the grid of their own coordinates: ten times as fast.

Terms
-----
corner
    A grid point around which one or three of the four cells are filled.
pinch
    A grid point where only two opposite cells are: there it is left to shapely.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import Polygon

from ...solver.values import Array

Flags = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Raster:
    """A right-angled polygon and the boxes that may be taken from it, again and again.

    Parameters
    ----------
    xs, ys : (n,) arrays
        The grid's lines, ascending.
    filled : (nx + 1, ny + 1) array of bool
        The polygon's cells, with an empty row all around: every corner has four cells.
    boxes : (k, 4) array of int
        For each box the cells that it covers: from and to along x, from and to along y.
    """

    xs: Array
    ys: Array
    filled: Flags
    boxes: NDArray[np.intp]

    def less(self, numbers: Sequence[int]) -> Polygon | None:
        """What some boxes leave; None where that is no one simple polygon."""
        loops = _traced(self._less(numbers))
        if loops is None:
            return None
        outer, *holes = [np.column_stack([self.xs[a[:, 0]], self.ys[a[:, 1]]]) for a in loops]
        return Polygon(outer, holes)

    def largest_mm2(self, numbers: Sequence[int]) -> float:
        """The area of the largest part that some boxes leave; corners alone hold nothing."""
        from scipy.ndimage import label

        parts, count = label(self._less(numbers)[1:-1, 1:-1])
        if count == 0:
            return 0.0
        areas = np.outer(np.diff(self.xs), np.diff(self.ys))
        return float(np.bincount(parts.ravel(), weights=areas.ravel())[1:].max())

    def _less(self, numbers: Sequence[int]) -> Flags:
        x0, x1, y0, y1 = self.boxes[list(numbers)].T
        # Each box counts from its corner on and no longer beyond its sides; sums say the rest.
        steps = np.zeros((self.filled.shape[0] + 1, self.filled.shape[1] + 1), dtype=np.int32)
        np.add.at(steps, (x0, y0), 1)
        np.add.at(steps, (x1, y1), 1)
        np.add.at(steps, (x0, y1), -1)
        np.add.at(steps, (x1, y0), -1)
        covered = np.cumsum(np.cumsum(steps, axis=0), axis=1)[:-1, :-1]
        return np.asarray(self.filled & (covered == 0))


def rastered(region: Polygon, boxes: Array) -> Raster | None:
    """A polygon on the grid of its own coordinates and of some boxes.

    Parameters
    ----------
    region : Polygon
    boxes : (n, 4) array
        Low x and y, high x and y.

    Returns
    -------
    Raster or None
        None where the region has other angles.
    """
    rings = [shapely.get_coordinates(ring)[:-1] for ring in (region.exterior, *region.interiors)]
    flat = np.vstack(rings)
    xs = np.unique(np.concatenate([flat[:, 0], boxes[:, 0], boxes[:, 2]]))
    ys = np.unique(np.concatenate([flat[:, 1], boxes[:, 1], boxes[:, 3]]))
    filled = np.zeros((len(xs) + 1, len(ys) + 1), dtype=bool)
    for ring in rings:
        if not _toggle(filled, np.searchsorted(xs, ring[:, 0]), np.searchsorted(ys, ring[:, 1])):
            return None
    across = np.searchsorted(xs, boxes[:, [0, 2]]) + 1
    up = np.searchsorted(ys, boxes[:, [1, 3]]) + 1
    return Raster(xs, ys, filled, np.hstack([across, up]))


def wide_all_over(polygon: Polygon, least: float) -> bool:
    """Whether a right-angled polygon is wider than `least` everywhere, as its coordinates tell."""
    points = shapely.get_coordinates(polygon)
    steps = [np.diff(np.unique(points[:, k])) for k in range(2)]
    if min(step.min() for step in steps) <= least:
        return False
    rings = [shapely.get_coordinates(ring) for ring in (polygon.exterior, *polygon.interiors)]
    return all((np.diff(ring, axis=0) == 0).any(axis=1).all() for ring in rings)


def _toggle(filled: Flags, x: NDArray[np.intp], y: NDArray[np.intp]) -> bool:
    """Fill (or empty) what is within a ring; False where it has other angles."""
    after_x, after_y = np.concatenate([x[1:], x[:1]]), np.concatenate([y[1:], y[:1]])
    if ((x != after_x) & (y != after_y)).any():
        return False
    across = y == after_y
    for a, b, at in zip(
        x[across].tolist(), after_x[across].tolist(), y[across].tolist(), strict=True
    ):
        # Everything beyond the side changes.
        filled[min(a, b) + 1 : max(a, b) + 1, at + 1 :] ^= True
    return True


def _traced(filled: Flags) -> list[NDArray[np.intp]] | None:
    """The ring around the filled cells and those of its holes, as numbers of grid points.

    Along each grid line corners are joined two by two (a side begins and ends in a corner).
    """
    a, b, c, d = filled[:-1, :-1], filled[1:, :-1], filled[:-1, 1:], filled[1:, 1:]
    odd = a ^ b ^ c ^ d
    if ((a == d) & (b == c) & (a != b)).any():
        return None
    by_row = np.argwhere(odd)  # sorted by x, then y
    if not len(by_row):
        return None
    count = len(by_row)
    upright = np.arange(count) ^ 1
    order = np.lexsort((by_row[:, 0], by_row[:, 1]))
    level = np.empty(count, dtype=np.intp)
    level[order] = order[np.arange(count) ^ 1]
    along, across = upright.tolist(), level.tolist()
    loops: list[list[int]] = []
    seen = [False] * count
    for start in range(count):
        if seen[start]:
            continue
        loop, at, turn = [], start, True
        while not seen[at]:
            seen[at] = True
            loop.append(at)
            at = (across if turn else along)[at]
            turn = not turn
        loops.append(loop)
    # The first corner of a ring has the least x: an outline's only filled cell lies beyond it.
    outer = [loop for loop in loops if d[tuple(by_row[loop[0]])]]
    if len(outer) != 1:
        return None
    holes = [loop for loop in loops if not d[tuple(by_row[loop[0]])]]
    return [by_row[loop] for loop in (outer[0], *holes)]
