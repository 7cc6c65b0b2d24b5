"""Where a plate is too narrow for the beam or the cutter: the notch, its edges, what gets in.

Terms
-----
place
    A point of the plate in the notch or hole that is too narrow.
room
    The widest beam or cutter that gets in, mm.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np
import shapely
from shapely.geometry import Point, Polygon

from ...solver.values import Array
from .errors import FabricationError
from .joints import Joint
from .plates import Plate

_HALVINGS = 14
#: A joint is at a place if it passes so near, in thicknesses; the nearest always is.
_BESIDE = 0.5


class TooNarrowError(FabricationError):
    """A notch or hole that the beam or cutter does not get into.

    Parameters
    ----------
    what, remedy : str
    plate : Plate
    place : (2,) array
        In the plate's frame.
    """

    def __init__(self, what: str, plate: Plate, place: Array, remedy: str) -> None:
        self.plate, self.place = plate, place
        super().__init__(what, (plate.id,), remedy)

    def at_edges(self, joints: Sequence[Joint], plates: Sequence[Plate]) -> FabricationError:
        """The same with the ids of the edges that are joined there."""
        near = _edges_at(self.plate, self.place, joints, plates)
        return FabricationError(self.what, dict.fromkeys((self.plate.id, *near)), self.remedy)


def room_mm(gets_in: Callable[[float], bool], most: float) -> float:
    """The widest that gets in; `most` does not."""
    low, high = 0.0, most
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if gets_in(middle) else (low, middle)
    return round(low, 2)


def narrow_place(polygon: Polygon, width_mm: float) -> Array:
    """A point in the largest of the gaps that something so wide does not get into."""
    grown = polygon.buffer(width_mm / 2, join_style="mitre")
    closed = grown.buffer(-width_mm / 2, join_style="mitre", mitre_limit=20.0)
    gaps = shapely.get_parts(closed.difference(polygon))
    largest = max(gaps, key=lambda part: part.area, default=polygon)
    place = (largest if largest.area > 0 else polygon).representative_point()
    return np.array([place.x, place.y])


def _edges_at(
    plate: Plate, place: Array, joints: Sequence[Joint], plates: Sequence[Plate]
) -> Iterator[str]:
    """The edges of the joints nearest to a point of a plate; the other face where there is none."""
    homes = {face: other for other in plates for face in other.face_ids}
    around = []
    for joint in joints:
        others = [ids for ids in (joint.meeting.one, joint.meeting.two) if plate.id not in ids]
        if len(others) == 1 and others[0][0] in homes:
            line = _line(plate, homes[others[0][0]], joint)
            around.append((line.distance(Point(place)), joint.meeting.edge_ids or others[0][:1]))
    nearest = min((gap for gap, _ in around), default=0.0)
    for gap, ids in around:
        if gap <= nearest + _BESIDE * plate.thickness_mm:
            yield from ids


def _line(plate: Plate, other: Plate, joint: Joint) -> shapely.LineString:
    """Where a joint runs, in a plate's plane."""
    world_from_plate = plate.world_from_plate
    way = np.cross(world_from_plate[:3, 2], other.world_from_plate[:3, 2])
    size = float(np.linalg.norm(way))
    half = way * (joint.meeting.length_mm / 2 / size if size > 0 else 0.0)
    ends = np.array(joint.meeting.middle_mm) + np.array([-half, half])
    return shapely.LineString(((ends - world_from_plate[:3, 3]) @ world_from_plate[:3, :3])[:, :2])
