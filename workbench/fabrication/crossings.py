"""Half-laps: partitions at any angle through one another.

Terms
-----
lap
    The line along which two partitions pass each other.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.values import Array
from .contacts import FLAT_SINE, Interval, inside
from .joints import Joint, JointPlan, Meeting
from .overlays import wider, without
from .seams import EdgeNames
from .slanted_walls import SlantedWall


@dataclass(frozen=True, slots=True, eq=False)
class Lap:
    """Two partitions through one another along a line from `start` on, `length` mm."""

    one: int
    two: int
    start: Array
    way: Array
    length: float


def laps_of(walls: Sequence[SlantedWall], one: int, two: int) -> list[Lap]:
    """Where both of two partitions pass the other."""
    normals = [walls[n].inwards for n in (one, two)]
    way = np.cross(normals[0], normals[1])
    size = float(np.linalg.norm(way))
    if size < FLAT_SINE:
        return []
    way = way / size
    points = [walls[n].world_from_wall[:3] @ [0.0, 0.0, walls[n].drawn_mm, 1.0] for n in (one, two)]
    heights = [n @ q for n, q in zip(normals, points, strict=True)]
    origin = np.linalg.lstsq(np.array([*normals, way]), np.array([*heights, 0.0]), rcond=None)[0]
    spans = [_passes(walls[n], origin, way) for n in (one, two)]
    return [
        Lap(one, two, origin + low * way, way, high - low)
        for a in spans[0]
        for b in spans[1]
        for low, high in [(max(a[0], b[0]), min(a[1], b[1]))]
        if high - low > 1e-3
    ]


def _in_plane(wall: SlantedWall, points: Array) -> Array:
    """World points as coordinates of a wall's plane, (n, 2)."""
    return np.asarray((points - wall.world_from_wall[:3, 3]) @ wall.world_from_wall[:3, :2])


def _passes(wall: SlantedWall, origin: Array, way: Array) -> list[Interval]:
    base, along = _in_plane(wall, origin), way @ wall.world_from_wall[:3, :2]
    reach = 1e5
    spans = inside(Polygon(wall.rings[0], wall.rings[1:]), base - reach * along, along, 2 * reach)
    return [(low - reach, high - reach) for low, high in spans]


def cross(
    lap: Lap,
    walls: Sequence[SlantedWall],
    drawn: Sequence[Polygon],
    outlines: list[Polygon],
    plan: JointPlan,
    names: EdgeNames,
) -> None:
    """Cut two partitions half through where they cross."""
    one, two = lap.one, lap.two
    cosine = abs(float(walls[one].inwards @ walls[two].inwards))
    ends = np.array([lap.start, lap.start + lap.length * lap.way])
    x, y, z = ends.mean(axis=0).tolist()
    meeting = Meeting(
        "X",
        walls[one].face_ids,
        walls[two].face_ids,
        names.on(walls[one], walls[two], ends),
        math.acos(min(1.0, cosine)),
        lap.length,
        0.0,
        0.0,
        (x, y, z),
    )
    joint = plan.decide(meeting, lambda _: 1)
    first, second = (two, one) if joint.swapped else (one, two)
    for wall, low, high in _halves(lap, walls, drawn, first, second, joint):
        other = second if wall == first else first
        slot = _slot(lap, walls[wall], walls[other], (low, high), joint.play_mm)
        outlines[wall] = without(outlines[wall], wider(slot))


def _halves(
    lap: Lap,
    walls: Sequence[SlantedWall],
    drawn: Sequence[Polygon],
    first: int,
    second: int,
    joint: Joint,
) -> list[tuple[int, float, float]]:
    """Which wall is slotted from where to where along a lap.

    A slot can only open where its wall ends; one that goes on at both ends gets a closed slot.
    """
    goes_on = {n: _goes_on(lap, walls[n], drawn[n]) for n in (first, second)}
    far = 6 * max(walls[first].thickness_mm, walls[second].thickness_mm)
    middle, end = lap.length / 2, lap.length + far
    play = joint.play_mm / 4
    if joint.kind == "tab_slot":
        return [(second, -play, lap.length + play)]
    for low, high in ((second, first), (first, second)):
        if not goes_on[low][0] and not goes_on[high][1]:
            return [(low, -far, middle + play), (high, middle - play, end)]
    for wall in (second, first):
        if all(goes_on[wall]):
            return [(wall, -play, lap.length + play)]
    return [(second, -far, middle + play), (first, middle - play, end)]


def _goes_on(lap: Lap, wall: SlantedWall, drawn: Polygon) -> tuple[bool, bool]:
    """Whether a wall has material just before and just beyond a lap."""
    step = 2 * wall.thickness_mm
    spots = _in_plane(
        wall,
        np.array([lap.start - step * lap.way, lap.start + (lap.length + step) * lap.way]),
    )
    before, beyond = shapely.contains_xy(drawn, spots[:, 0], spots[:, 1]).tolist()
    return before, beyond


def _slot(lap: Lap, wall: SlantedWall, other: SlantedWall, ends: Interval, play: float) -> Polygon:
    """A slot of t_other / sin + t_own |cot| in a wall's plane."""
    start = _in_plane(wall, lap.start)
    along = lap.way @ wall.world_from_wall[:3, :2]
    across = np.array([-along[1], along[0]])
    cosine = abs(float(wall.inwards @ other.inwards))
    sine = math.sqrt(max(1e-12, 1 - cosine**2))
    half = (other.thickness_mm + wall.thickness_mm * cosine) / sine / 2 + play / 2
    corners = [(ends[0], -half), (ends[1], -half), (ends[1], half), (ends[0], half)]
    return Polygon([start + s * along + y * across for s, y in corners])
