"""What a plate passes through on a straight way."""

from __future__ import annotations

from collections.abc import Sequence

import manifold3d
import numpy as np
import shapely
import shapely.affinity

from ...solver.values import Array
from .facing import SLACK_MM
from .plates import Plate
from .prisms import prism

_SHRINK_MM = SLACK_MM / 2


def together(parts: Sequence[manifold3d.Manifold]) -> manifold3d.Manifold:
    return manifold3d.Manifold.batch_boolean(parts, manifold3d.OpType.Add)


def swept(plate: Plate, move: Array) -> list[manifold3d.Manifold]:
    """What a plate passes through on a straight way; a little thinner, for it may touch.

    In parts that may overlap.
    """
    polygon = plate.polygon.buffer(-_SHRINK_MM, join_style="mitre")
    thin = plate.thickness_mm - 2 * _SHRINK_MM
    rotation = plate.world_from_plate[:3, :3]
    local = rotation.T @ move
    if abs(local[2]) < 1e-9 * max(1.0, float(np.abs(local).max())) or not move.any():
        low, area = _SHRINK_MM, _swept_area(polygon, local[:2])
        return [prism(area, low, low + thin).transform(plate.world_from_plate[:3])]
    if np.abs(local[:2]).max() < 1e-9 * abs(local[2]):
        low = _SHRINK_MM + min(0.0, float(local[2]))
        body = prism(polygon, low, low + thin + abs(float(local[2])))
        return [body.transform(plate.world_from_plate[:3])]
    rings = [
        np.array(ring.coords)[:-1]
        for part in map(shapely.geometry.polygon.orient, shapely.get_parts(polygon))
        for ring in (part.exterior, *part.interiors)
    ]
    corners, hulls = np.vstack(rings), []
    for triangle in np.asarray(manifold3d.triangulate(rings), dtype=int):
        flat = corners[triangle]
        ends = np.vstack(
            [np.column_stack([flat, np.full(3, z)]) for z in (_SHRINK_MM, _SHRINK_MM + thin)]
        )
        hulls.append(manifold3d.Manifold.hull_points(np.vstack([ends, ends + local])))
    return [hull.transform(plate.world_from_plate[:3]) for hull in hulls]


def _swept_area(polygon: shapely.Polygon, move: Array) -> shapely.Geometry:
    """What a polygon passes over on a straight way in its plane."""
    if not move.any():
        return polygon
    parts = [polygon, shapely.affinity.translate(polygon, *move.tolist())]
    for ring in (polygon.exterior, *polygon.interiors):
        for a, b in zip(ring.coords[:-1], ring.coords[1:], strict=True):
            p, q = np.array(a), np.array(b)
            strip = shapely.Polygon([p, q, q + move, p + move])
            if strip.area > 1e-9:
                parts.append(strip.buffer(0))
    return shapely.union_all(parts)
