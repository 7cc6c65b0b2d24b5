"""Openings: free edges, and the flat polygons that would close them.

Terms
-----
free edge
    A piece of an edge that belongs to one face only.
cap
    A polygon in a flat loop of free edges, an opening for which no face was drawn.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import shapely

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
    uses: Counter[tuple[int, int]] = Counter()
    for face in faces:
        for loop in face:
            for a, b in zip(loop, np.roll(loop, -1, axis=0), strict=True):
                uses.update(pieces(a, b, corners, tolerance))
    return [(corners[p], corners[q]) for (p, q), count in uses.items() if count == 1]


def pieces(a: Array, b: Array, corners: Array, tolerance: float) -> list[tuple[int, int]]:
    """The stretches of an edge between the corners that lie on it, as pairs of their numbers."""
    length = float(np.linalg.norm(b - a))
    way = (b - a) / length
    along = (corners - a) @ way
    off = np.linalg.norm(corners - a - np.outer(along, way), axis=1)
    on = np.flatnonzero(
        (off < 20 * tolerance) & (along > -20 * tolerance) & (along < length + 20 * tolerance)
    )
    on = on[np.argsort(along[on], kind="stable")]
    return [(min(p, q), max(p, q)) for p, q in pairwise(on.tolist())]


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
