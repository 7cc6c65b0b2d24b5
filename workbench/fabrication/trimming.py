"""Plates at any angles, kept out of one another where more than two meet in a point.

Terms
-----
shadow
    What must be cut from a plate to be rid of a part of its body: the cut is square to it.
"""

from __future__ import annotations

from collections.abc import Sequence

import manifold3d
import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.values import Array
from .errors import FabricationError
from .seams import Seams, find_corners
from .slanted_walls import FINE_MM, SlantedWall

#: Plates may share so little, mm3: rounding.
OVERLAP_MM3 = 1e-6


def _body(wall: SlantedWall, outline: Polygon) -> manifold3d.Manifold:
    rings = [
        np.array(ring.coords)[:-1]
        for part in shapely.get_parts(outline)
        for ring in (part.exterior, *part.interiors)
    ]
    section = manifold3d.CrossSection(rings, manifold3d.FillRule.EvenOdd)
    solid = manifold3d.Manifold.extrude(section, wall.thickness_mm)
    return solid.transform(wall.world_from_wall[:3])


def pointed(
    walls: Sequence[SlantedWall], seams: Seams, outlines: Sequence[Polygon]
) -> list[Polygon]:
    """The outlines without what sticks out where more than three plates come to a point.

    A plate keeps behind its neighbours by its tips; behind the others it is kept here.
    """
    result = list(outlines)
    for corner in find_corners(walls):
        convex = all(
            seams[w, r, e].theta_rad < np.pi for w, r, e in corner.edges if (w, r, e) in seams
        )
        if len(corner.walls) < 4 or not convex:
            continue
        for w in corner.walls:
            for other in corner.walls:
                outside = _outside(walls[other], corner.point, corner.reach / 2)
                shared = _body(walls[w], result[w]) ^ outside
                if w != other and shared.volume() > OVERLAP_MM3:
                    result[w] = result[w].difference(_shadow(walls[w], shared), grid_size=FINE_MM)
    return result


def _outside(wall: SlantedWall, point: Array, reach: float) -> manifold3d.Manifold:
    """What lies beyond a wall's outer plane, near a point."""
    cube = manifold3d.Manifold.cube([2 * reach] * 3, center=True).translate(point)
    return cube.trim_by_plane(-wall.inwards, float(-wall.inwards @ point))


def _shadow(wall: SlantedWall, solid: manifold3d.Manifold) -> Polygon:
    """What must be cut from a wall to be rid of a part of its body: the cut is square to it."""
    back = np.linalg.inv(wall.world_from_wall)[:3]
    return _polygon(solid.transform(back).project()).buffer(1e-4, join_style="mitre")


def trimmed(walls: Sequence[SlantedWall], outlines: Sequence[Polygon]) -> list[Polygon]:
    """The outlines without what overlaps a lower plate: the shadow of it, square to the sheet."""
    result = list(outlines)
    bodies = [_body(wall, outline) for wall, outline in zip(walls, result, strict=True)]
    for high in range(len(walls)):
        for low in range(high):
            shared = bodies[low] ^ bodies[high]
            if shared.volume() <= OVERLAP_MM3:
                continue
            shadow = _shadow(walls[high], shared)
            if shadow.area > 0.5 * result[high].area:
                raise FabricationError(
                    "the plates would lie in one another",
                    (*walls[low].face_ids, *walls[high].face_ids),
                    "thinner plates",
                )
            result[high] = result[high].difference(shadow, grid_size=FINE_MM)
            bodies[high] = _body(walls[high], result[high])
    return result


def _polygon(section: manifold3d.CrossSection) -> Polygon:
    rings = [Polygon(ring) for ring in section.to_polygons() if len(ring) > 2]
    return shapely.union_all([ring.buffer(0) for ring in rings])
