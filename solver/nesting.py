"""Loops of one plane that lie within each other: outer loops and their holes."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from .values import Array, BoolArray, IntArray
from .walks import Walk

#: Vertices in order.
Loop = tuple[int, ...]
#: Loops that are compared with all others at once.
CHUNK = 500


def smallest_around(
    walk: Walk, parts: IntArray, positions: Array, areas: Array, candidates: BoolArray
) -> IntArray:
    """For each cycle the smallest one of another part of its plane that it lies in, or -1.

    Parameters
    ----------
    walk : Walk
    parts : (c,) int array
        The connected part of the drawing that each cycle belongs to.
    positions : (h, 2) array
        In the plane, in the order of the walk.
    areas : (c,) array
    candidates : (c,) bool array
        The cycles concerned.
    """
    low = np.minimum.reduceat(positions, walk.first)
    high = np.maximum.reduceat(positions, walk.first)
    # What lies inside may touch the border, and rounding must not put it outside.
    slack = 1e-9 * float(np.abs(high - low).max())
    around = np.full(len(areas), -1)
    ordered = np.flatnonzero(candidates)
    ordered = ordered[np.argsort(areas[ordered], kind="stable")]
    last = np.append(walk.first[1:], len(positions))
    for start in range(0, len(ordered), CHUNK):
        outer = ordered[start : start + CHUNK, None]
        fits = (areas[ordered] < areas[outer]) & (walk.plane[ordered] == walk.plane[outer])
        fits &= parts[ordered] != parts[outer]
        for k in range(2):
            fits &= low[ordered, k] >= low[outer, k] - slack
            fits &= high[ordered, k] <= high[outer, k] + slack
        for row in np.flatnonzero(fits.any(axis=1)).tolist():
            cycle = int(outer[row, 0])
            inner = ordered[fits[row]]
            inner = inner[around[inner] < 0]
            polygon = positions[walk.first[cycle] : last[cycle]]
            around[inner[_contains(polygon, positions[walk.first[inner]])]] = cycle
    return around


def _contains(polygon: Array, points: Array) -> BoolArray:
    """Whether each point (k, 2) is inside, by the crossing number."""
    a, b = polygon, polygon[np.arange(1, len(polygon) + 1) % len(polygon)]
    x, y = points[:, :1], points[:, 1:]
    crosses = (a[:, 1] > y) != (b[:, 1] > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        at = a[:, 0] + (y - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
    return np.asarray(np.count_nonzero(crosses & (at > x), axis=1) % 2 == 1)


def outlines(loops: Iterable[Loop]) -> tuple[Loop, ...]:
    """The common outlines of loops: half-edges whose reverse is not walked by another loop."""
    walked = {(a, b) for loop in loops for a, b in zip(loop, loop[1:] + loop[:1], strict=True)}
    following = {a: b for a, b in sorted(walked) if (b, a) not in walked}
    found = []
    for start in list(following):
        if start not in following:
            continue
        outline = [start]
        while (nxt := following.pop(outline[-1], start)) != start:
            outline.append(nxt)
        found.append(tuple(outline))
    return tuple(found)
