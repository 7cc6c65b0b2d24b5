"""Which cells of a right-angled object lie outside, by flooding them from far away.

Terms
-----
cell
    A box between neighbouring coordinates of the faces' corners; one more row all around.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ...solver.values import Array
from .frame import newell

Flags = NDArray[np.bool_]
#: Coordinates that differ by less are one, mm.
_ONE_MM = 1e-6
#: Corners of closing polygons lie this near to those of faces, in parts of the size.
_NEAR = 1e-4
_MOST_CELLS = 200_000


def flooded(
    faces: Mapping[str, Sequence[Array]], closing: Sequence[Sequence[Array]], made: Sequence[str]
) -> dict[str, tuple[float, float]] | None:
    """How much of each face has an enclosed cell below it and above it.

    Parameters
    ----------
    faces : mapping of face id to loops
        Outer loop and holes, (n, 3) each, mm.
    closing : sequence of loops
        Further polygons that nothing passes.
    made : sequence of face ids
        The faces to answer for.

    Returns
    -------
    dict of face id to (below, above) or None
        Shares of the area, 0 to 1; above is where the normal of the loop points. None where not
        all edges keep to the axes.
    """
    points = np.vstack([loop for loops in faces.values() for loop in loops])
    lines = [_lines(points[:, k]) for k in range(3)]
    near = _NEAR * float(np.ptp(points, axis=0).max())
    if np.prod([len(line) + 1 for line in lines]) > _MOST_CELLS:
        return None
    blocked = [_no_wall(lines, k) for k in range(3)]
    placed = {}
    for name, loops in [*faces.items(), *((None, loops) for loops in closing)]:
        found = _raster(loops, lines, near)
        if found is None:
            return None
        axis, at, mask = placed[name] = found
        blocked[axis][at] |= mask
    outside = _flood(blocked)
    sizes = [np.concatenate([[0.0], np.diff(line), [0.0]]) for line in lines]
    result = {}
    for id_ in made:
        axis, at, mask = placed[id_]
        u, v = _others(axis)
        area = mask * np.outer(sizes[u], sizes[v])
        turned = np.moveaxis(outside, (axis, *_others(axis)), (0, 1, 2))
        low, high = (float((area * ~turned[n]).sum() / area.sum()) for n in (at, at + 1))
        up = newell(np.asarray(faces[id_][0]))[axis] > 0
        result[id_] = (low, high) if up else (high, low)
    return result


def _others(axis: int) -> tuple[int, int]:
    return (axis + 1) % 3, (axis + 2) % 3


def _lines(values: Array) -> Array:
    ordered = np.sort(values)
    return np.asarray(ordered[np.concatenate([[True], np.diff(ordered) > _ONE_MM])])


def _no_wall(lines: Sequence[Array], axis: int) -> Flags:
    """For each line of an axis and each cell across it."""
    u, v = _others(axis)
    return np.zeros((len(lines[axis]), len(lines[u]) + 1, len(lines[v]) + 1), dtype=bool)


def _raster(
    loops: Sequence[Array], lines: Sequence[Array], near: float
) -> tuple[int, int, Flags] | None:
    """The axis and the line of a face, and the cells that it covers; None where it runs aslant."""
    corners = np.vstack(loops)
    gaps = [np.abs(corners[:, k, None] - lines[k]) for k in range(3)]
    at = [gap.argmin(axis=1).tolist() for gap in gaps]
    flat = [k for k in range(3) if len(set(at[k])) == 1]
    if len(flat) != 1 or max(float(gap.min(axis=1).max()) for gap in gaps) > near:
        return None
    axis = flat[0]
    u, v = _others(axis)
    mask = np.zeros((len(lines[u]) + 1, len(lines[v]) + 1), dtype=bool)
    start = 0
    for loop in loops:
        ring = range(start, start + len(loop))
        for a, b in pairwise([*ring, ring[0]]):
            if at[v][a] == at[v][b]:
                low, high = sorted((at[u][a], at[u][b]))
                # Everything beyond the edge changes sides.
                mask[low + 1 : high + 1, at[v][a] + 1 :] ^= True
            elif at[u][a] != at[u][b]:
                return None
        start += len(loop)
    return axis, at[axis][0], mask


def _flood(blocked: Sequence[Flags]) -> Flags:
    outside = np.zeros([len(flags) + 1 for flags in blocked], dtype=bool)
    outside[0, 0, 0] = True
    count = 0
    while outside.sum() > count:
        count = int(outside.sum())
        for axis, flags in enumerate(blocked):
            rows = np.moveaxis(outside, (axis, *_others(axis)), (0, 1, 2))
            for n in range(len(flags)):
                rows[n + 1] |= rows[n] & ~flags[n]
            for n in reversed(range(len(flags))):
                rows[n] |= rows[n + 1] & ~flags[n]
    return outside
