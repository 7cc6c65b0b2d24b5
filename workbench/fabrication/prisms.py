"""Prisms over polygons, exact to the last digit.

`manifold3d.CrossSection` rounds to eight decimals, which over a large face is more than plates may
share; here the corners stay as they are.
"""

from __future__ import annotations

import manifold3d
import numpy as np
import shapely
from shapely.geometry.polygon import orient

from ...solver.values import Array


def prism(area: shapely.Geometry, low_mm: float, high_mm: float) -> manifold3d.Manifold:
    """The body over polygons from one height to another.

    Parameters
    ----------
    area : shapely Polygon or MultiPolygon
    low_mm, high_mm : float

    Returns
    -------
    manifold3d.Manifold
        In the polygons' own frame.
    """
    parts = [orient(part) for part in shapely.get_parts(area) if part.area > 0]
    bodies = [_prism(_rings(part), low_mm, high_mm) for part in parts]
    return bodies[0] if len(bodies) == 1 else manifold3d.Manifold.compose(bodies)


def _rings(polygon: shapely.Polygon) -> list[Array]:
    rings = (polygon.exterior, *polygon.interiors)
    return [np.array(ring.coords)[:-1, :2] for ring in rings]


def _prism(rings: list[Array], low: float, high: float) -> manifold3d.Manifold:
    flat = np.vstack(rings)
    count = len(flat)
    caps = np.asarray(manifold3d.triangulate(rings), dtype=np.uint64)
    here = np.arange(count, dtype=np.uint64)
    ends = np.cumsum([len(ring) for ring in rings])
    after = here + 1
    after[ends - 1] = np.concatenate([[0], ends[:-1]])
    sides = [np.array([here, after, after + count]), np.array([here, after + count, here + count])]
    triangles = np.vstack([caps[:, ::-1], caps + count, *(side.T for side in sides)])
    points = np.vstack([np.column_stack([flat, np.full(count, z)]) for z in (low, high)])
    return manifold3d.Manifold(manifold3d.Mesh64(points, triangles.astype(np.uint64)))
