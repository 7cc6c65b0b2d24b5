"""Room for square corners where a round cutter leaves them round.

Terms
-----
inner corner
    A corner at which the material goes more than half around: of a notch or a hole.
dog bone
    A circle of the cutter's size through the corner, its centre on the corner's bisector.
T-bone
    The same with its centre on the longer of the two sides: it shows on that side only.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
import shapely

from ...solver.values import Array
from .narrow_places import TooNarrowError, narrow_place, room_mm
from .plates import Plate

#: Corners turned by less need no room, rad.
_LEAST_TURN = math.radians(20.0)
_QUARTER = 6
#: So that the sides of the drawn polygon, and not its corners, lie on the circle.
_CIRCUMSCRIBED = 1 / math.cos(math.pi / (4 * _QUARTER))


def relieved(plate: Plate, relief: str, tool_mm: float) -> list[Array]:
    """The plate's rings with room at its inner corners.

    Parameters
    ----------
    plate : Plate
    relief : str
        ``dogbone`` or ``tbone``.
    tool_mm : float
        Diameter of the cutter.

    Returns
    -------
    list of (k, 2) arrays
        The outline, counter-clockwise, then the holes, clockwise.

    Raises
    ------
    TooNarrowError
        Naming the plate, where the cutter is too thick for a notch or hole.
    """
    rings = _relieved(plate, relief, tool_mm)
    if rings is not None:
        return rings
    room = room_mm(lambda tool: _relieved(plate, relief, tool) is not None, tool_mm)
    raise TooNarrowError(
        f"a notch or hole has no room for a cutter of {tool_mm:g} mm: one of {room:g} mm just "
        "gets in",
        plate,
        narrow_place(plate.polygon, min(tool_mm, room + 0.05)),
        "a thinner cutter, or wider fingers",
    )


def _relieved(plate: Plate, relief: str, tool_mm: float) -> list[Array] | None:
    """The relieved rings; None where the cutter does not get in."""
    circles = [
        shapely.Point(spot).buffer(tool_mm / 2 * _CIRCUMSCRIBED, quad_segs=_QUARTER)
        for spot in relief_centres(plate, relief, tool_mm)
    ]
    if not circles:
        return [plate.outline, *plate.holes]
    cut = plate.polygon.difference(shapely.union_all(circles), grid_size=1e-6)
    # What vanishes when the material grows by the cutter and shrinks again is too narrow for it.
    reach = 0.499 * tool_mm
    grown = plate.polygon.buffer(reach, join_style="mitre")
    back = grown.buffer(-reach, join_style="mitre", mitre_limit=20.0)
    missed = back.difference(plate.polygon)
    if cut.geom_type != "Polygon" or missed.area > 0.01 * tool_mm**2:
        return None
    cut = shapely.geometry.polygon.orient(cut)
    return [np.array(ring.coords)[:-1] for ring in (cut.exterior, *cut.interiors)]


def relief_centres(plate: Plate, relief: str, tool_mm: float) -> Iterator[Array]:
    """Where the cutter's middle goes at each inner corner."""
    for ring in (plate.outline, *plate.holes):
        for before, corner, after in zip(
            np.roll(ring, 1, axis=0), ring, np.roll(ring, -1, axis=0), strict=True
        ):
            back, ahead = before - corner, after - corner
            lengths = float(np.linalg.norm(back)), float(np.linalg.norm(ahead))
            back, ahead = back / lengths[0], ahead / lengths[1]
            # Material lies on the left: a right turn is an inner corner.
            turn = math.atan2(float(-back[0] * ahead[1] + back[1] * ahead[0]), float(-back @ ahead))
            if turn > -_LEAST_TURN:
                continue
            if relief == "tbone":
                way = back if lengths[0] >= lengths[1] else ahead
            else:
                way = (back + ahead) / np.linalg.norm(back + ahead)
            yield corner + tool_mm / 2 * way
