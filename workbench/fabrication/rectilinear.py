"""Right-angled polygons less boxes, on the grid of their own coordinates: ten times as fast.

Terms
-----
corner
    A grid point around which one or three of the four cells are filled.
pinch
    A grid point where only two opposite cells are: there it is left to shapely.
"""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import Polygon

from ...solver.values import Array

Flags = NDArray[np.bool_]


def less_boxes(region: Polygon, boxes: Array) -> Polygon | None:
    """A right-angled polygon without some boxes.

    Parameters
    ----------
    region : Polygon
    boxes : (n, 4) array
        Low x and y, high x and y.

    Returns
    -------
    Polygon or None
        None where the region has other angles, or what is left is no one simple polygon.
    """
    rings = [shapely.get_coordinates(ring)[:-1] for ring in (region.exterior, *region.interiors)]
    flat = np.vstack(rings)
    xs = np.unique(np.concatenate([flat[:, 0], boxes[:, 0], boxes[:, 2]]))
    ys = np.unique(np.concatenate([flat[:, 1], boxes[:, 1], boxes[:, 3]]))
    # One empty row around, so that every corner has four cells.
    filled = np.zeros((len(xs) + 1, len(ys) + 1), dtype=bool)
    for ring in rings:
        if not _toggle(filled, np.searchsorted(xs, ring[:, 0]), np.searchsorted(ys, ring[:, 1])):
            return None
    low = np.searchsorted(xs, boxes[:, [0, 2]]) + 1
    high = np.searchsorted(ys, boxes[:, [1, 3]]) + 1
    for (x0, x1), (y0, y1) in zip(low.tolist(), high.tolist(), strict=True):
        filled[x0:x1, y0:y1] = False
    loops = _traced(filled)
    if loops is None:
        return None
    outer, *holes = [np.column_stack([xs[loop[:, 0]], ys[loop[:, 1]]]) for loop in loops]
    return Polygon(outer, holes)


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
