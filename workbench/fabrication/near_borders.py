"""Slots that lie nearer to a border of their plate than the plate is thick.

Runs of tabs keep away from borders. Where walls cross near an edge, a half-lap or the end of a
third wall may still leave less: then it is said.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np
import shapely

from ...solver.values import Array

if TYPE_CHECKING:
    from .joints import Joint
    from .plates import Plate

#: Corners of plates are multiples of 1e-6 mm.
_ROUNDING_MM = 1e-5


def slots_near_borders(plates: Sequence[Plate], joints: Sequence[Joint]) -> Iterator[str]:
    """One line for each slot that is too near to its plate's border.

    Parameters
    ----------
    plates : sequence of Plate
    joints : sequence of Joint
        Between them.

    Yields
    ------
    str
        The plate, the plate in the slot, their edges and the distance; holes of the drawing that
        nothing fills are nobody's slots.
    """
    for plate in plates:
        border = shapely.LinearRing(plate.outline)
        least = plate.thickness_mm
        for hole in plate.holes:
            gap = border.distance(shapely.LinearRing(hole))
            other = _filling(plate, hole, plates) if gap < least - _ROUNDING_MM else None
            if other is not None:
                where = ", ".join(_edges(plate, other, joints))
                yield (
                    f"{plate.id}: the slot for {other.id}{f' ({where})' if where else ''} is "
                    f"{gap:.1f} mm from a border, less than the plate's {least:g} mm; it may break"
                )


def _filling(plate: Plate, hole: Array, plates: Sequence[Plate]) -> Plate | None:
    """The plate that has material in a hole."""
    spot = shapely.Polygon(hole).representative_point()
    at = plate.world_from_plate @ [spot.x, spot.y, plate.thickness_mm / 2, 1.0]
    for other in plates:
        x, y, z = (np.linalg.inv(other.world_from_plate) @ at)[:3].tolist()
        inside = other is not plate and 0 < z < other.thickness_mm
        if inside and shapely.intersects_xy(other.polygon, x, y):
            return other
    return None


def _edges(plate: Plate, other: Plate, joints: Sequence[Joint]) -> list[str]:
    """The sketch's edges in which two plates meet."""
    pair = [set(plate.face_ids), set(other.face_ids)]
    found = [
        edge
        for joint in joints
        for edge in joint.meeting.edge_ids
        if all(ids & {*joint.meeting.one, *joint.meeting.two} for ids in pair)
    ]
    return list(dict.fromkeys(found))
