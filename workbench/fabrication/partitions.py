"""Partitions at any angle: tabs in closed slots where they end, half-laps where they cross.

Terms
-----
carrier
    The wall on which an edge of a partition ends, and which passes it on both sides.
contact
    A stretch of a partition's edge on a carrier. s runs along the edge, x from the drawn edge into
    the partition; y across the edge in the carrier's plane.
tip, notch
    Where tabs end, and where the partition ends between them, as x. Cut square, a tab is
    t / sin(theta) long and ends where its first corner meets the carrier's far side.
run
    What of a contact is clear of all other walls and one thickness from the carrier's borders.

A partition's edge that has no carrier (where two walls meet, or on a border) is cut off square
where it would enter another plate.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import manifold3d
import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.values import Array
from .finger_joints import divide, least_finger_mm
from .joints import Joint, JointPlan, Meeting
from .seams import EdgeNames, edge_frame
from .settings import PlateSettings
from .slanted_walls import FINE_MM, SlantedWall
from .trimming import plate_body, shadow_of

#: Flatter contacts get no joint; the partition is only cut off there.
_FLAT_SINE = 0.1
_ON_PLANE_MM = 1e-4

Interval = tuple[float, float]


@dataclass(frozen=True, slots=True, eq=False)
class _Contact:
    """See the module's terms; `origin`, `along`, `across` place (s, y) in the carrier's plane."""

    partition: int
    carrier: int
    start: Array
    along: Array
    into: Array
    span: Interval
    tip: float
    notch: float
    sine: float
    origin: Array
    way: Array
    across: Array
    slot: Interval

    def strip(self, ends: Interval, depths: Interval) -> Polygon:
        """A rectangle in the partition's plane."""
        corners = [(ends[0], depths[0]), (ends[1], depths[0])]
        corners += [(ends[1], depths[1]), (ends[0], depths[1])]
        return Polygon([self.start + s * self.along + x * self.into for s, x in corners])

    def opening(self, ends: Interval, play: float) -> Polygon:
        """A slot in the carrier's plane."""
        low, high = self.slot[0] - play / 2, self.slot[1] + play / 2
        a, b = ends[0] - play / 2, ends[1] + play / 2
        corners = [(a, low), (b, low), (b, high), (a, high)]
        return Polygon([self.origin + s * self.way + y * self.across for s, y in corners])


def partitioned(
    walls: Sequence[SlantedWall],
    outlines: Sequence[Polygon],
    first: int,
    plan: JointPlan,
    settings: PlateSettings,
    names: EdgeNames,
) -> list[Polygon]:
    """The outlines after partitions were fitted in.

    Parameters
    ----------
    walls : sequence of SlantedWall
        Outer walls, then partitions from number `first` on.
    outlines : sequence of Polygon
        Of all of them; a partition's as it was drawn.
    plan : JointPlan
    settings : PlateSettings
        The kerf is used, for the narrowest tab.
    names : EdgeNames
        For the joints.

    Returns
    -------
    list of Polygon
        Partitions may still reach into other plates where they have no carrier.
    """
    result = list(outlines)
    bodies = [plate_body(wall, outline) for wall, outline in zip(walls, outlines, strict=True)]
    numbers = range(first, len(walls))
    laps = [lap for p in numbers for q in range(p + 1, len(walls)) for lap in _laps(walls, p, q)]
    for p in numbers:
        for contact in _contacts(walls, p):
            _join(contact, walls, result, bodies, plan, settings, names)
    for lap in laps:
        _cross(lap, walls, outlines, result, plan, names)
    return result


def _contacts(walls: Sequence[SlantedWall], p: int) -> list[_Contact]:
    wall, found = walls[p], []
    for r, ring in enumerate(wall.rings):
        for e in range(len(ring)):
            start, along, into, length = edge_frame(wall, r, e)
            for w, carrier in enumerate(walls):
                if w != p and not {*carrier.face_ids} & {*wall.face_ids}:
                    found += _contact(wall, p, carrier, w, (start, along, into, length))
    return found


def _contact(
    wall: SlantedWall,
    p: int,
    carrier: SlantedWall,
    w: int,
    edge: tuple[Array, Array, Array, float],
) -> list[_Contact]:
    start, along, into, length = edge
    into_carrier = np.linalg.inv(carrier.world_from_wall)
    place = wall.world_from_wall

    def local(point: Array) -> Array:
        in_world = place[:3] @ np.array([*point, wall.drawn_mm, 1.0])
        return np.asarray((into_carrier @ np.array([*in_world, 1.0]))[:3])

    a, b = local(start), local(start + length * along)
    if max(abs(a[2] - carrier.drawn_mm), abs(b[2] - carrier.drawn_mm)) > _ON_PLANE_MM:
        return []
    inwards = into_carrier[:3, :3] @ place[:3, :3] @ np.array([*into, 0.0])
    sine = abs(float(inwards[2]))
    if sine < _FLAT_SINE:
        return []
    height, t = float(a[2]), carrier.thickness_mm
    low, high = (-height, t - height) if inwards[2] > 0 else (height - t, height)
    way = (b - a)[:2] / np.linalg.norm((b - a)[:2])
    across = np.array([-way[1], way[0]])
    # How far the partition moves across while it rises through the carrier, mm for each mm.
    slope = float(inwards[:2] @ across) / sine
    cosine = math.sqrt(max(0.0, 1 - sine**2))
    half = wall.thickness_mm / 2
    sides = sorted((low * slope, high * slope))
    found = []
    for span in _inside(Polygon(carrier.rings[0], carrier.rings[1:]), a[:2], way, length):
        found.append(
            _Contact(
                p,
                w,
                start,
                along,
                into,
                span,
                (low + half * cosine) / sine,
                (high + half * cosine) / sine,
                sine,
                a[:2],
                way,
                across,
                (sides[0] - half / sine, sides[1] + half / sine),
            )
        )
    return found


def _inside(region: Polygon, origin: Array, way: Array, length: float) -> list[Interval]:
    """Where a line runs within a region, not on its border."""
    line = shapely.LineString([origin, origin + length * way])
    inner = region.buffer(-1e-3, join_style="mitre")
    spans = []
    for part in shapely.get_parts(line.intersection(inner)):
        if part.geom_type == "LineString" and part.length > 1e-3:
            ends = sorted(float((np.array(c) - origin) @ way) for c in part.coords)
            spans.append((max(0.0, ends[0] - 2e-3), min(length, ends[-1] + 2e-3)))
    return spans


def _join(
    contact: _Contact,
    walls: Sequence[SlantedWall],
    outlines: list[Polygon],
    bodies: Sequence[manifold3d.Manifold],
    plan: JointPlan,
    settings: PlateSettings,
    names: EdgeNames,
) -> None:
    """Cut tabs and slots of one contact."""
    p, w = contact.partition, contact.carrier
    lost = contact.strip(contact.span, (min(contact.tip, 0.0) - 1.0, contact.notch))
    lost = lost.buffer(4 * FINE_MM, join_style="mitre")
    tabs: list[Polygon] = []
    if walls[w].thickness_mm > 0:
        runs = _runs(contact, walls, outlines, bodies)
        thickness = max(walls[p].thickness_mm, walls[w].thickness_mm)
        least = least_finger_mm(thickness, settings.kerf_mm)
        longest = max((high - low for low, high in runs), default=0.0)
        joint = plan.decide(
            Meeting(
                "T",
                walls[w].face_ids,
                walls[p].face_ids,
                names.between(walls[p], walls[w], (contact.start, contact.along), contact.span),
                math.asin(min(1.0, contact.sine)),
                longest,
                least,
            ),
            lambda finger: 1 + len(_tabs((0.0, longest), finger, least)),
        )
        for run in runs if joint.kind == "tab_slot" else ():
            for ends in _tabs(run, joint.finger_mm, least):
                tabs.append(contact.strip(ends, (contact.tip, contact.notch + 1.0)))
                slot = contact.opening(ends, joint.play_mm)
                outlines[w] = outlines[w].difference(
                    slot.buffer(4 * FINE_MM, join_style="mitre"), grid_size=FINE_MM
                )
    cut = outlines[p].difference(lost, grid_size=FINE_MM)
    outlines[p] = shapely.union_all([cut, *tabs], grid_size=FINE_MM) if tabs else cut


def _point(position: Array) -> tuple[float, float, float]:
    x, y, z = position.tolist()
    return x, y, z


def _world(wall: SlantedWall, point: Array) -> tuple[float, float, float]:
    """A point of a partition's drawn plane in the world."""
    return _point(wall.world_from_wall[:3] @ np.array([*point, wall.drawn_mm, 1.0]))


def _tabs(run: Interval, finger: float, least: float) -> list[Interval]:
    """Where the tabs of a run are; one where it is too short for more."""
    low, high = run
    count = divide(high - low, finger, least)
    if count > 1:
        step = (high - low) / count
        return [(low + k * step, low + (k + 1) * step) for k in range(1, count, 2)]
    if high - low < least:
        return []
    half = max(least, (high - low) / 3) / 2
    return [((low + high) / 2 - half, (low + high) / 2 + half)]


def _runs(
    contact: _Contact,
    walls: Sequence[SlantedWall],
    outlines: Sequence[Polygon],
    bodies: Sequence[manifold3d.Manifold],
) -> list[Interval]:
    """The runs of a contact."""
    p, w = contact.partition, contact.carrier
    partition, carrier = walls[p], walls[w]
    depths = (contact.tip, contact.notch)
    band = contact.strip(contact.span, depths)
    blocked: list[Interval] = []
    in_band = plate_body(partition, band)
    for o, other in enumerate(bodies):
        shared = in_band ^ other if o not in (p, w) else None
        if shared is not None and shared.volume() > 1e-6:
            clear = carrier.thickness_mm
            for low, high in _spans(shadow_of(partition, shared), contact.start, contact.along):
                blocked.append((low - clear, high + clear))
    whole = outlines[p].union(band)
    deep = contact.strip(contact.span, (contact.tip, contact.notch + partition.thickness_mm))
    blocked += _spans(deep.difference(whole), contact.start, contact.along)
    free = outlines[w].buffer(-carrier.thickness_mm, join_style="mitre")
    lane = contact.opening(contact.span, 0.0)
    blocked += _spans(lane.difference(free), contact.origin, contact.way)
    return _without(contact.span, blocked)


def _spans(area: shapely.Geometry, origin: Array, way: Array) -> list[Interval]:
    """From where to where an area's parts reach along a direction."""
    spans = []
    for part in shapely.get_parts(area):
        if part.area > 1e-6:
            along = (shapely.get_coordinates(part) - origin) @ way
            spans.append((float(along.min()), float(along.max())))
    return spans


def _without(span: Interval, blocked: Sequence[Interval]) -> list[Interval]:
    """What is left of an interval."""
    left, at = [], span[0]
    for low, high in sorted(blocked):
        if low > at:
            left.append((at, min(low, span[1])))
        at = max(at, high)
    left.append((at, span[1]))
    return [(low, high) for low, high in left if high - low > 1e-3]


@dataclass(frozen=True, slots=True, eq=False)
class _Lap:
    """Two partitions through one another along a line from `start` on, `length` mm."""

    one: int
    two: int
    start: Array
    way: Array
    length: float


def _laps(walls: Sequence[SlantedWall], one: int, two: int) -> list[_Lap]:
    """Where both of two partitions pass the other."""
    normals = [walls[n].inwards for n in (one, two)]
    way = np.cross(normals[0], normals[1])
    size = float(np.linalg.norm(way))
    if size < _FLAT_SINE:
        return []
    way = way / size
    points = [walls[n].world_from_wall[:3] @ [0.0, 0.0, walls[n].drawn_mm, 1.0] for n in (one, two)]
    heights = [n @ q for n, q in zip(normals, points, strict=True)]
    origin = np.linalg.lstsq(np.array([*normals, way]), np.array([*heights, 0.0]), rcond=None)[0]
    spans = [_passes(walls[n], origin, way) for n in (one, two)]
    return [
        _Lap(one, two, origin + low * way, way, high - low)
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
    spans = _inside(Polygon(wall.rings[0], wall.rings[1:]), base - reach * along, along, 2 * reach)
    return [(low - reach, high - reach) for low, high in spans]


def _cross(
    lap: _Lap,
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
    meeting = Meeting(
        "X",
        walls[one].face_ids,
        walls[two].face_ids,
        names.on(walls[one], walls[two], ends),
        math.acos(min(1.0, cosine)),
        lap.length,
        0.0,
        _point(ends.mean(axis=0)),
    )
    joint = plan.decide(meeting, lambda _: 1)
    first, second = (two, one) if joint.swapped else (one, two)
    for wall, low, high in _halves(lap, walls, drawn, first, second, joint):
        other = second if wall == first else first
        slot = _slot(lap, walls[wall], walls[other], (low, high), joint.play_mm)
        outlines[wall] = outlines[wall].difference(
            slot.buffer(4 * FINE_MM, join_style="mitre"), grid_size=FINE_MM
        )


def _halves(
    lap: _Lap,
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


def _goes_on(lap: _Lap, wall: SlantedWall, drawn: Polygon) -> tuple[bool, bool]:
    """Whether a wall has material just before and just beyond a lap."""
    step = 2 * wall.thickness_mm
    spots = _in_plane(
        wall,
        np.array([lap.start - step * lap.way, lap.start + (lap.length + step) * lap.way]),
    )
    before, beyond = shapely.contains_xy(drawn, spots[:, 0], spots[:, 1]).tolist()
    return before, beyond


def _slot(lap: _Lap, wall: SlantedWall, other: SlantedWall, ends: Interval, play: float) -> Polygon:
    """A slot of t_other / sin + t_own |cot| in a wall's plane."""
    start = _in_plane(wall, lap.start)
    along = lap.way @ wall.world_from_wall[:3, :2]
    across = np.array([-along[1], along[0]])
    cosine = abs(float(wall.inwards @ other.inwards))
    sine = math.sqrt(max(1e-12, 1 - cosine**2))
    half = (other.thickness_mm + wall.thickness_mm * cosine) / sine / 2 + play / 2
    corners = [(ends[0], -half), (ends[1], -half), (ends[1], half), (ends[0], half)]
    return Polygon([start + s * along + y * across for s, y in corners])
