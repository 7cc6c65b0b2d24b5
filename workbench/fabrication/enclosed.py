"""The body that flat faces enclose."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

import manifold3d
import numpy as np
import shapely

from ...solver.values import Array
from .frame import newell

Loops = Sequence[Sequence[str]]


def enclosed(
    loops: Mapping[str, Loops], vertices: Mapping[str, Array], sides: Mapping[str, int]
) -> manifold3d.Manifold | None:
    """The body within faces, where they close.

    Parameters
    ----------
    loops : mapping of face id to loops of vertex ids
        Outer loop and holes.
    vertices : mapping of vertex id to (3,) array
    sides : mapping of face id to 1 or -1
        See `face_sides`.

    Returns
    -------
    manifold3d.Manifold or None
        None where an edge has not exactly two faces.
    """
    users: dict[frozenset[str], int] = {}
    for face in loops.values():
        for loop in face:
            for pair in pairwise((*loop, loop[0])):
                users[frozenset(pair)] = users.get(frozenset(pair), 0) + 1
    if len(loops) < 4 or set(users.values()) != {2}:
        return None
    numbers = {v: n for n, v in enumerate(vertices)}
    triangles = []
    for id_, face in loops.items():
        corners = np.array([numbers[v] for loop in face for v in loop])
        flat = corners[triangulated([np.array([vertices[v] for v in loop]) for loop in face])]
        triangles.append(flat[:, ::-1] if sides[id_] > 0 else flat)
    points = np.array(list(vertices.values()))
    body = manifold3d.Manifold(manifold3d.Mesh64(points, np.vstack(triangles).astype(np.uint64)))
    return None if body.is_empty() or body.volume() <= 0 else body


def plane_axes(loop: Array) -> Array:
    """Two directions in a loop's plane and its normal, as rows."""
    normal = newell(loop) / np.linalg.norm(newell(loop))
    along = loop[1] - loop[0]
    along = along / np.linalg.norm(along)
    return np.array([along, np.cross(normal, along), normal])


def triangulated(loops: Sequence[Array]) -> Array:
    """Triangles of a face as numbers of its corners, turning as its outer loop does."""
    axes = plane_axes(loops[0])
    flat = [(loop - loops[0][0]) @ axes[:2].T for loop in loops]
    start = np.cumsum([0, *(len(loop) for loop in loops)])
    order = [np.arange(a, b) for a, b in pairwise(start)]
    for n, ring in enumerate(flat):
        if shapely.LinearRing(ring).is_ccw != (n == 0):
            flat[n], order[n] = ring[::-1], order[n][::-1]
    return np.asarray(np.concatenate(order)[np.asarray(manifold3d.triangulate(flat))])
