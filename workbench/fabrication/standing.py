"""Will it stand? The centre of mass over what it stands on.

Terms
-----
support
    The convex polygon around all points in which the object touches what it stands on.
margin
    How far within the support the centre of mass lies, mm; negative beyond it.
tipping angle
    By how much the ground may lean before it falls over.

One density everywhere; nothing is put into or onto the object.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import shapely
from shapely.geometry import MultiPoint, Point, Polygon

from ...solver.values import Array
from .parts_in_space import Part, centroid, corners

#: What lies so little above the lowest point touches the ground too, mm.
FOOT_MM = 0.1
#: Borders whose distances differ by less are equally near, mm.
ALIKE_MM = 1e-3
#: What tips over at less is easily knocked over, degrees.
WOBBLY_DEG = 10.0


@dataclass(frozen=True, slots=True, eq=False)
class Standing:
    """How an object stands.

    Parameters
    ----------
    centre_mm : (3,) array
        Centre of mass.
    ground_mm : float
        Height of its lowest point.
    support : (n, 2) array
        Corners of the support, counter-clockwise; fewer than three where it stands on a line or
        a point.
    margin_mm : float
    way : str
        The way to which it falls over most easily.
    """

    centre_mm: Array
    ground_mm: float
    support: Array
    margin_mm: float
    way: str

    @property
    def stands(self) -> bool:
        """Whether it stays as it is."""
        return self.margin_mm > 0

    @property
    def tipping_deg(self) -> float:
        """The tipping angle; negative where it does not stand."""
        height = float(self.centre_mm[2]) - self.ground_mm
        return math.degrees(math.atan2(self.margin_mm, height))

    @property
    def words(self) -> str:
        """One line about it."""
        side = "upwards" if self.way == "up" else f"to the {self.way}"
        if len(self.support) < 3:
            return f"it does not stand: it touches the ground in a line only, and tips {side}"
        if not self.stands:
            return (
                f"it does not stand: it tips {side}, its centre of mass lies "
                f"{-self.margin_mm:.1f} mm beyond what it stands on"
            )
        ease = " (easily knocked over)" if self.tipping_deg < WOBBLY_DEG else ""
        return (
            f"it stands{ease}: its centre of mass lies {self.margin_mm:.1f} mm within what it "
            f"stands on; it tips {side} when the ground leans by {self.tipping_deg:.0f} degrees"
        )


def standing_of(parts: Sequence[Part], ways: Mapping[str, Array]) -> Standing:
    """How an object stands on its lowest points.

    Parameters
    ----------
    parts : sequence of Part
    ways : mapping of name to unit vector
        Names of directions.

    Returns
    -------
    Standing
    """
    bodies = [part.body for part in parts]
    centre, _ = centroid(bodies)
    points = corners(bodies)
    ground = float(points[:, 2].min())
    feet = MultiPoint(points[points[:, 2] < ground + FOOT_MM, :2])
    area, spot = shapely.convex_hull(feet).simplify(1e-3), Point(centre[:2])
    if area.geom_type != "Polygon":
        out = _ends(area)
        near = np.array(shapely.shortest_line(spot, area).coords)
        return Standing(centre, ground, out, -float(area.distance(spot)), _way(near, ways))
    area = shapely.geometry.polygon.orient(area)
    margin = float(area.exterior.distance(spot)) * (1 if area.covers(spot) else -1)
    return Standing(centre, ground, _ends(area), margin, _tips(spot, area, ways, inside=margin > 0))


def _tips(spot: Point, area: Polygon, ways: Mapping[str, Array], *, inside: bool) -> str:
    """The way over the nearest border; of two equally near ones, the first of the ways."""
    sides = [shapely.LineString(ends) for ends in pairwise(area.exterior.coords)]
    least = min(float(side.distance(spot)) for side in sides)
    named = set()
    for side in sides:
        if float(side.distance(spot)) < least + ALIKE_MM:
            border = np.array(shapely.shortest_line(spot, side).coords)
            named.add(_way(border if inside else border[::-1], ways))
    return next(name for name in ways if name in named)


def _ends(area: shapely.Geometry) -> Array:
    ring = area.exterior.coords[:-1] if isinstance(area, Polygon) else area.coords
    return np.array(ring)


def _way(line: Array, ways: Mapping[str, Array]) -> str:
    """The name of the level way that a line's direction is nearest to."""
    level = {name: way for name, way in ways.items() if abs(way[2]) < 0.5}
    return max(level, key=lambda name: float(level[name][:2] @ (line[1] - line[0])))
