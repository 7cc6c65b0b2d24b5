"""Where the edges of partitions lie on other walls.

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
partner
    A contact with the same line on the same carrier.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.values import Array
from .seams import edge_frame
from .slanted_walls import SlantedWall

#: Flatter contacts get no joint; the partition is only cut off there.
FLAT_SINE = 0.1
_ON_PLANE_MM = 1e-4

Interval = tuple[float, float]


@dataclass(frozen=True, slots=True, eq=False)
class Contact:
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
    side: int

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

    def is_partner(self, other: Contact) -> bool:
        """Whether two contacts want the same slots."""
        if self.carrier != other.carrier or self.partition == other.partition:
            return False
        if abs(float(self.way @ other.across)) > FLAT_SINE / 10:
            return False
        apart = float((other.origin - self.origin) @ self.across)
        sense = float(self.across @ other.across)
        low, high = sorted(apart + sense * y for y in other.slot)
        if min(high, self.slot[1]) - max(low, self.slot[0]) < _ON_PLANE_MM:
            return False
        low, high = self.along_of(other, other.span)
        return min(high, self.span[1]) - max(low, self.span[0]) > _ON_PLANE_MM

    def along_of(self, other: Contact, ends: Interval) -> Interval:
        """A stretch of another contact as s of this one."""
        points = [other.origin + s * other.way for s in ends]
        low, high = sorted(float((point - self.origin) @ self.way) for point in points)
        return low, high


def contacts_of(walls: Sequence[SlantedWall], p: int) -> list[Contact]:
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
) -> list[Contact]:
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
    if sine < FLAT_SINE:
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
    for span in inside(Polygon(carrier.rings[0], carrier.rings[1:]), a[:2], way, length):
        found.append(
            Contact(
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
                1 if inwards[2] > 0 else -1,
            )
        )
    return found


def inside(region: Polygon, origin: Array, way: Array, length: float) -> list[Interval]:
    """Where a line runs within a region, not on its border."""
    line = shapely.LineString([origin, origin + length * way])
    inner = region.buffer(-1e-3, join_style="mitre")
    spans = []
    for part in shapely.get_parts(line.intersection(inner)):
        if part.geom_type == "LineString" and part.length > 1e-3:
            ends = sorted(float((np.array(c) - origin) @ way) for c in part.coords)
            spans.append((max(0.0, ends[0] - 2e-3), min(length, ends[-1] + 2e-3)))
    return spans
