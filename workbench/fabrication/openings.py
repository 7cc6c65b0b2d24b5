"""Openings: free edges, and the flat polygons that would close them.

Terms
-----
free edge
    A piece of an edge that belongs to one face only.
cap
    A polygon in a flat loop of free edges, an opening for which no face was drawn.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from ...solver.values import Array

Loops = tuple[Array, ...]


def caps(faces: Sequence[Loops], size: float) -> list[Array]:
    """Polygons in flat loops of free edges (edges that belong to one face only)."""
    ends = free_edges(faces, 1e-6 * size)
    if not ends:
        return []
    points = np.array(ends)
    directions = points[:, 1] - points[:, 0]
    directions = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    gaps = np.linalg.norm(points[:, None, :, None] - points[None, :, None], axis=-1)
    touching = gaps.min(axis=(2, 3)) < 1e-5 * size
    normals = np.cross(directions[:, None], directions[None])
    sines = np.linalg.norm(normals, axis=-1)
    found: list[Array] = []
    seen: set[tuple[float, ...]] = set()
    for i, a in enumerate(points[:, 0]):
        for j in np.flatnonzero(touching[i, :i] & (sines[i, :i] >= 0.05)).tolist():
            normal = normals[i, j] / sines[i, j]
            normal = normal * np.sign(normal[np.argmax(np.abs(normal))])
            key = (*np.round(normal, 3), round(float(normal @ a) / size, 3))
            if key not in seen:
                seen.add(key)
                found += _loops_in_plane(ends, a, normal, 1e-5 * size)
    return found


def free_edges(faces: Sequence[Loops], tolerance: float) -> list[tuple[Array, Array]]:
    """Edges of one face only, split at the corners of all faces that lie on them."""
    corners = np.vstack([loop for face in faces for loop in face])
    _, first = np.unique(np.round(corners / tolerance / 10), axis=0, return_index=True)
    corners = corners[np.sort(first)]
    loops = [loop for face in faces for loop in face]
    starts = np.vstack(loops)
    ends = np.vstack([np.concatenate((loop[1:], loop[:1])) for loop in loops])
    edges, numbers = _corners_on(starts, ends, corners, 20 * tolerance)
    steps = np.column_stack([numbers[:-1], numbers[1:]])[edges[:-1] == edges[1:]]
    steps.sort(axis=1)
    pairs, first, count = np.unique(steps, axis=0, return_index=True, return_counts=True)
    single = pairs[count == 1][np.argsort(first[count == 1])]
    return [(corners[p], corners[q]) for p, q in single.tolist()]


def _corners_on(
    starts: Array, ends: Array, corners: Array, tolerance: float
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Numbers of edges, and of the corners that lie on each, from its start to its end."""
    spans = ends - starts
    lengths = np.linalg.norm(spans, axis=1)
    ways = spans / lengths[:, None]
    away = corners[None] - starts[:, None]
    along = np.einsum("ecx,ex->ec", away, ways)
    off = np.linalg.norm(away - along[..., None] * ways[:, None], axis=2)
    on = (off < tolerance) & (along > -tolerance) & (along < lengths[:, None] + tolerance)
    edges, numbers = np.nonzero(on)
    order = np.lexsort((along[edges, numbers], edges))
    return edges[order], numbers[order]


def _loops_in_plane(
    ends: Sequence[tuple[Array, Array]], origin: Array, normal: Array, tolerance: float
) -> list[Array]:
    axis = np.eye(3)[int(np.argmin(np.abs(normal)))]
    right = np.cross(axis, normal)
    right = right / np.linalg.norm(right)
    axes = np.array([right, np.cross(normal, right)])
    lines = [
        np.array([a - origin, b - origin]) @ axes.T
        for a, b in ends
        if max(abs((a - origin) @ normal), abs((b - origin) @ normal)) < tolerance
    ]
    flat = shapely.union_all(shapely.linestrings(np.array(lines)), grid_size=tolerance)
    cells = shapely.get_parts(shapely.polygonize(shapely.get_parts(flat)))
    return [origin + np.array(cell.exterior.coords)[:-1] @ axes for cell in cells]
