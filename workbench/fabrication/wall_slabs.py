"""Flat slabs of prints: what windows take away from walls, and what partitions add.

Terms
-----
window
    An opening that lies in one plane with a wall beside it; it is cut through that wall.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from manifold3d import Manifold

from ...solver.values import Array
from .enclosed import plane_axes
from .polyhedra import Loop, Polyhedron
from .prisms import prism

_NEAR_MM = 1e-4
#: Outlines are multiples of this.
_GRID_MM = 1e-7


def is_window(body: Polyhedron, id_: str) -> bool:
    """Whether an opening and a face that is made hang together in one plane, by edges."""
    origin, normal = body.vertices_mm[body.skin[id_][0][0]], _axes(body, id_)[2]
    flat = {
        other: {v for loop in loops for v in loop}
        for other, loops in body.skin.items()
        if all(np.abs((body.points(loop) - origin) @ normal).max() < _NEAR_MM for loop in loops)
    }
    reached, waiting = {id_}, [id_]
    while waiting:
        corners = flat[waiting.pop()]
        beside = {f for f in flat.keys() - reached if len(flat[f] & corners) > 1}
        reached |= beside
        waiting += beside
    return not reached <= set(body.openings)


def _axes(body: Polyhedron, id_: str) -> Array:
    return plane_axes(body.points(body.skin[id_][0]))


def window_slab(body: Polyhedron, id_: str, reach_mm: float) -> Manifold:
    """What lies straight over a window on both sides, up to `reach_mm`."""
    rings = [body.points(loop) for loop in body.skin[id_]]
    axes = plane_axes(rings[0])
    flat = [(ring - rings[0][0]) @ axes[:2].T for ring in rings]
    return _slab(shapely.Polygon(flat[0], flat[1:]), rings[0][0], axes, reach_mm)


def partition_slab(body: Polyhedron, loops: Sequence[Loop], wall_mm: float) -> Manifold:
    """A partition's wall, long enough to reach the block's surface where it leans on it."""
    rings = [body.points(loop) for loop in loops]
    axes = plane_axes(rings[0])
    flat = [(ring - rings[0][0]) @ axes[:2].T for ring in rings]
    outer = shapely.Polygon(flat[0])
    grown = outer.buffer(wall_mm, join_style="mitre")
    for n in range(len(rings[0])):
        ends = [n - 1, n]
        if not _on_skin(body, rings[0][ends]):
            side = shapely.LineString(flat[0][ends]).buffer(wall_mm, cap_style="square")
            grown = grown.difference(side.difference(outer))
    # Rounding may leave a side that goes out and back.
    parts = shapely.get_parts(shapely.set_precision(grown, _GRID_MM))
    outline = max(parts, key=lambda one: one.area).exterior
    return _slab(shapely.Polygon(outline, flat[1:]), rings[0][0], axes, wall_mm / 2)


def _slab(area: shapely.Polygon, origin: Array, axes: Array, reach_mm: float) -> Manifold:
    slab = prism(area, -reach_mm, reach_mm)
    return slab.transform(np.column_stack([axes.T, origin]))


def _on_skin(body: Polyhedron, ends: Array) -> bool:
    """Whether an edge lies on the block's surface."""
    for loops in body.skin.values():
        rings = [body.points(loop) for loop in loops]
        axes = plane_axes(rings[0])
        if np.abs((ends - rings[0][0]) @ axes[2]).max() > _NEAR_MM:
            continue
        flat = [(ring - rings[0][0]) @ axes[:2].T for ring in rings]
        middle = (ends.mean(axis=0) - rings[0][0]) @ axes[:2].T
        if shapely.Polygon(flat[0], flat[1:]).distance(shapely.Point(middle)) < _NEAR_MM:
            return True
    return False
