"""Edge marks: the two sides of a joint get the same number, engraved beside it.

Terms
-----
mark
    The joint's number in single strokes, in the plate's frame, as near to the joint as there is
    room for it. One that is another number upside down, as 6 is, has a bar below.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.values import Array
from .joints import Joint
from .plates import Plate
from .strokes import text_strokes, text_width_mm

HEIGHT_MM = 3.0
#: Between a mark and the bar below it.
BAR_MM = 0.8
_UPSIDE_DOWN = dict(zip("01689", "01986", strict=True))
#: How far from its joint a mark may lie, mm, and how far from borders and other marks.
_REACH_MM, _CLEAR_MM = 40.0, 1.0


def edge_marks(plates: Sequence[Plate], joints: Sequence[Joint]) -> dict[str, list[Array]]:
    """The strokes of all marks.

    Parameters
    ----------
    plates : sequence of Plate
    joints : sequence of Joint
        Numbered from 1 in this order.

    Returns
    -------
    dict of plate id to strokes
        In the plate's frame. Both plates of a joint have its mark, or none has.
    """
    holders = {face: plate for plate in plates for face in plate.face_ids}
    free = {plate.id: plate.polygon.buffer(-_CLEAR_MM, join_style="mitre") for plate in plates}
    for polygon in free.values():
        shapely.prepare(polygon)
    strokes: dict[str, list[Array]] = {plate.id: [] for plate in plates}
    taken: dict[str, list[Array]] = {plate.id: [] for plate in plates}
    for number, joint in enumerate(joints, start=1):
        ends = (joint.meeting.one[0], joint.meeting.two[0])
        sides = [holders[face] for face in ends if face in holders]
        text = _text(number, len(joints))
        spots = [_spot(plate, free[plate.id], taken[plate.id], joint, text) for plate in sides]
        if len(sides) < 2 or any(spot is None for spot in spots):
            continue
        for plate, spot in zip(sides, spots, strict=True):
            assert spot is not None
            strokes[plate.id] += _strokes(text, spot)
            taken[plate.id].append(_rooms(np.array([spot]), text)[0])
    return strokes


def _text(number: int, most: int) -> str:
    """A mark's text: a number, and an underscore after it for the bar."""
    text = str(number)
    other = "".join(_UPSIDE_DOWN.get(digit, "?") for digit in reversed(text))
    twofold = other.isdigit() and other != text and other[0] != "0" and int(other) <= most
    return f"{text}_" if twofold else text


def _strokes(text: str, spot: tuple[float, float]) -> list[Array]:
    digits, (x, y) = text.rstrip("_"), spot
    if digits == text:
        return text_strokes(text, spot, HEIGHT_MM)
    bar = np.round([(x, y), (x + text_width_mm(digits, HEIGHT_MM), y)], 6)
    return [*text_strokes(digits, (x, y + BAR_MM), HEIGHT_MM), bar]


def _size(text: str) -> tuple[float, float]:
    digits = text.rstrip("_")
    return text_width_mm(digits, HEIGHT_MM), HEIGHT_MM + (0.0 if digits == text else BAR_MM)


@cache
def _grid() -> Array:
    """Places around a joint, the nearest first."""
    steps = np.arange(-_REACH_MM, _REACH_MM + 1.0, 2.0)
    grid = np.array(np.meshgrid(steps, steps)).reshape(2, -1).T
    return np.asarray(grid[np.argsort(np.round(np.linalg.norm(grid, axis=1), 3), kind="stable")])


def _rooms(lows: Array, text: str) -> Array:
    """The boxes of a mark by their lower left corners: x and y from, x and y to, (n, 4)."""
    return np.hstack([lows, lows + _size(text)])


def _spot(
    plate: Plate, free: Polygon, taken: Sequence[Array], joint: Joint, text: str
) -> tuple[float, float] | None:
    """The lower left corner of a mark near its joint; None where there is no room."""
    place = plate.world_from_plate
    x, y, _ = (place[:3, :3].T @ (np.array(joint.meeting.middle_mm) - place[:3, 3])).tolist()
    width, height = _size(text)
    lows = np.add(_grid(), [x - width / 2, y - height / 2])
    # Most find room at once.
    for part in np.split(lows, (40, 200)):
        rooms = _rooms(part, text)
        for other in taken:
            beside = (rooms[:, :2] >= other[2:] + _CLEAR_MM) | (
                rooms[:, 2:] <= other[:2] - _CLEAR_MM
            )
            rooms = rooms[beside.any(axis=1)]
        fitting = np.flatnonzero(shapely.contains(free, shapely.box(*rooms.T)))
        if len(fitting):
            return float(rooms[fitting[0], 0]), float(rooms[fitting[0], 1])
    return None
