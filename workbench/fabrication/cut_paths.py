"""Where the beam goes: the only place that knows the kerf.

Terms
-----
kerf
    Full width that the beam removes.
cut path
    The middle of the beam: outlines moved outwards by kerf / 2, holes inwards, so that what is
    left has the finished size. Corners are mitred.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.values import Array
from .errors import FabricationError
from .plates import Plate
from .relief import relieved

#: How far a mitre may reach, in half kerfs; sharper corners are cut off.
MITRE_LIMIT = 5.0
#: Shorter segments are left out, mm.
LEAST_SEGMENT_MM = 0.05
_LOST_MM2 = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class CutPath:
    """The closed paths of one plate, in the plate frame.

    Parameters
    ----------
    plate_id : str
    thickness_mm : float
    outer : (k, 2) array
        mm, counter-clockwise, not closed by a repeated point.
    inner : tuple of (k, 2) arrays
        mm, clockwise.
    """

    plate_id: str
    thickness_mm: float
    outer: Array
    inner: tuple[Array, ...]


def cut_path(plate: Plate, kerf_mm: float, relief: str = "none", tool_mm: float = 0.0) -> CutPath:
    """The path of the beam around a plate.

    Parameters
    ----------
    plate : Plate
    kerf_mm : float
        0 gives the finished outline itself.
    relief, tool_mm
        At corners that look inwards; see `relieved`.

    Returns
    -------
    CutPath

    Raises
    ------
    FabricationError
        Naming the plate, where a notch or hole is narrower than the kerf.
    """
    rings = [plate.outline, *plate.holes]
    if relief != "none":
        rings = relieved(plate, relief, tool_mm)
    if kerf_mm == 0:
        return CutPath(plate.id, plate.thickness_mm, rings[0], tuple(rings[1:]))
    outline, *hollows = (Polygon(ring) for ring in rings)
    outer = _moved(outline, kerf_mm / 2)
    holes = [_moved(hollow, -kerf_mm / 2) for hollow in hollows]
    narrow = _lost_mm2(outline, kerf_mm / 2) + sum(_lost_mm2(h, -kerf_mm / 2) for h in hollows)
    if narrow > _LOST_MM2 or any(len(rings) != 1 for rings in (outer, *holes)):
        raise FabricationError(
            f"a notch or hole is narrower than the kerf of {kerf_mm:g} mm",
            (plate.id,),
            "a smaller kerf, or wider fingers",
        )
    return CutPath(plate.id, plate.thickness_mm, outer[0], tuple(rings[0][::-1] for rings in holes))


def _lost_mm2(polygon: Polygon, distance: float) -> float:
    """Area of notches (or arms of holes) that vanish when the polygon is moved there and back."""
    there = polygon.buffer(distance, join_style="mitre", mitre_limit=MITRE_LIMIT)
    back = there.buffer(-distance, join_style="mitre", mitre_limit=MITRE_LIMIT)
    lost = back.difference(polygon) if distance > 0 else polygon.difference(back)
    return float(lost.area)


def _moved(polygon: Polygon, distance: float) -> list[Array]:
    """All rings of the polygon moved outwards (distance > 0) or inwards, counter-clockwise."""
    moved = polygon.buffer(distance, join_style="mitre", mitre_limit=MITRE_LIMIT)
    rings = []
    for part in shapely.get_parts(moved):
        if not part.is_empty:
            part = shapely.geometry.polygon.orient(part)
            rings += [_ring(ring) for ring in (part.exterior, *part.interiors)]
    return rings


def _ring(ring: shapely.LinearRing) -> Array:
    points = np.array(ring.coords)[:-1]
    long_enough = np.linalg.norm(points - np.roll(points, 1, axis=0), axis=1) >= LEAST_SEGMENT_MM
    points = np.round(points[long_enough], 6) + 0.0
    first = min(range(len(points)), key=lambda n: (points[n, 0], points[n, 1]))
    rolled: Array = np.roll(points, -first, axis=0)
    return rolled
