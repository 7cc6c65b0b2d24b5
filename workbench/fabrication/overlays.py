"""Areas of plates at any angles laid over one another: areas again, on one fine grid.

What is narrower than the grid becomes a line or a point beside the areas; shapely refuses such a
mixture in the next step.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import shapely
from shapely.geometry import MultiPolygon, Polygon

#: Coordinates are multiples of this, mm: at slanted edges coarser ones would make plates overlap.
FINE_MM = 1e-9
#: A cut is wider by so much, so that rounding never makes two plates overlap, mm.
SPARE_MM = 4 * FINE_MM


def without(area: Polygon, lost: shapely.Geometry) -> Polygon:
    """What is left of an area."""
    return _areas(area.difference(lost, grid_size=FINE_MM))


def within(area: Polygon, other: shapely.Geometry) -> Polygon:
    """What two areas share."""
    return _areas(area.intersection(other, grid_size=FINE_MM))


def together(areas: Iterable[shapely.Geometry]) -> Polygon:
    """Areas as one."""
    return _areas(shapely.union_all(list(areas), grid_size=FINE_MM))


def wider(area: shapely.Geometry) -> Polygon:
    """An area that is to be cut away, wider by what rounding may take back."""
    return area.buffer(SPARE_MM, join_style="mitre")


def _areas(mixed: shapely.Geometry) -> Polygon:
    if mixed.geom_type in ("Polygon", "MultiPolygon"):
        return mixed
    parts = [part for part in shapely.get_parts(mixed) if part.geom_type == "Polygon"]
    return parts[0] if len(parts) == 1 else MultiPolygon(parts)


def sides_mm(polygon: Polygon) -> tuple[float, float]:
    """The shorter and the longer side of the narrowest box around a polygon."""
    around = shapely.get_coordinates(shapely.minimum_rotated_rectangle(polygon))
    short, long = sorted(np.linalg.norm(np.diff(around[:3], axis=0), axis=1).tolist())
    return short, long
