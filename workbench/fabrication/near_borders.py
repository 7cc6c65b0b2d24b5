"""Slots that lie nearer to a border of their plate than the plate is thick.

Tabs and half-laps keep away from borders, and from holes that were drawn. Where the drawing leaves
no other way it is said.
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
        least = plate.thickness_mm
        for other, gap in _near(plate, plates):
            where = ", ".join(_edges(plate, other, joints))
            yield (
                f"{plate.id}: the slot for {other.id}{f' ({where})' if where else ''} is "
                f"{gap:.1f} mm from a border, less than the plate's {least:g} mm; it may break"
            )


def _near(plate: Plate, plates: Sequence[Plate]) -> Iterator[tuple[Plate, float]]:
    """What fills the slots of a plate that are too near to a border, and how near they are."""
    rings = [shapely.LinearRing(ring) for ring in (plate.outline, *plate.holes)]
    for n, hole in enumerate(plate.holes, 1):
        gaps = shapely.distance(rings[n], rings)
        near = [m for m in np.flatnonzero(gaps < plate.thickness_mm - _ROUNDING_MM) if m != n]
        other = _filling(plate, hole, plates) if near else None
        if other is None:
            continue
        # A hole that nothing fills was drawn: a border too.
        drawn = [m for m in near if not m or _filling(plate, plate.holes[m - 1], plates) is None]
        if drawn:
            yield other, float(gaps[drawn].min())


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
