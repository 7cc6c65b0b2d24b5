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
partner
    A contact with the same line on the same carrier. From the carrier's two sides the tabs of both
    take turns; on one side the first partition has tabs and the second is cut off before it.

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
from .contacts import Contact, Interval, contacts_of
from .crossings import cross, laps_of
from .finger_joints import divide, least_finger_mm
from .joints import JointPlan, Meeting
from .overlays import together, wider, without
from .seams import EdgeNames
from .settings import PlateSettings
from .slanted_walls import SlantedWall
from .trimming import plate_body, shadow_of


@dataclass(slots=True)
class _Taken:
    """All contacts, and the tabs of those that are joined."""

    contacts: Sequence[Contact]
    tabs: list[tuple[Contact, Interval]]

    def partners(self, contact: Contact) -> list[Contact]:
        return [other for other in self.contacts if contact.is_partner(other)]

    def gaps(self, contact: Contact, runs: Sequence[Interval], least: float) -> list[Interval]:
        """Where a contact's tabs fit in between those of partners that were there before."""
        before = [
            contact.along_of(other, ends) for other, ends in self.tabs if contact.is_partner(other)
        ]
        return [
            (low, high)
            for run in runs
            for low, high in _without(run, before)
            if high - low >= least and not {low, high} & {*run}
        ]


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
        The beam is used, for the narrowest tab.
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
    laps = [lap for p in numbers for q in range(p + 1, len(walls)) for lap in laps_of(walls, p, q)]
    taken = _Taken([contact for p in numbers for contact in contacts_of(walls, p)], [])
    for contact in taken.contacts:
        _join(contact, walls, result, bodies, plan, settings, names, taken)
    for lap in laps:
        cross(lap, walls, outlines, result, plan, names)
    return result


def _join(
    contact: Contact,
    walls: Sequence[SlantedWall],
    outlines: list[Polygon],
    bodies: Sequence[manifold3d.Manifold],
    plan: JointPlan,
    settings: PlateSettings,
    names: EdgeNames,
    taken: _Taken,
) -> None:
    """Cut tabs and slots of one contact."""
    p, w = contact.partition, contact.carrier
    lost = contact.strip(contact.span, (min(contact.tip, 0.0) - 1.0, contact.notch))
    tabs: list[Polygon] = []
    if walls[w].thickness_mm > 0:
        runs = _runs(contact, walls, outlines, bodies, taken)
        thickness = max(walls[p].thickness_mm, walls[w].thickness_mm)
        least = least_finger_mm(thickness, settings.beam_mm)
        longest = max((high - low for low, high in runs), default=0.0)
        shares = any(contact.is_partner(other) for other, _ in taken.tabs)

        def wished(finger: float) -> list[Interval]:
            if shares:
                return taken.gaps(contact, runs, least)
            return [ends for run in runs for ends in _tabs(run, finger, least)]

        joint = plan.decide(
            Meeting(
                "T",
                walls[w].face_ids,
                walls[p].face_ids,
                names.between(walls[p], walls[w], (contact.start, contact.along), contact.span),
                math.asin(min(1.0, contact.sine)),
                longest,
                least,
                least,
                _world(walls[p], contact.start + sum(contact.span) / 2 * contact.along),
            ),
            lambda finger: 1 + len(wished(finger)),
        )
        for ends in wished(joint.finger_mm) if joint.kind == "tab_slot" else ():
            taken.tabs.append((contact, ends))
            tabs.append(contact.strip(ends, (contact.tip, contact.notch + 1.0)))
            slot = contact.opening(ends, joint.play_mm)
            outlines[w] = without(outlines[w], wider(slot))
    cut = without(outlines[p], wider(lost))
    outlines[p] = together([cut, *tabs]) if tabs else cut


def _world(wall: SlantedWall, point: Array) -> tuple[float, float, float]:
    """A point of a partition's drawn plane in the world."""
    x, y, z = (wall.world_from_wall[:3] @ np.array([*point, wall.drawn_mm, 1.0])).tolist()
    return x, y, z


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
    contact: Contact,
    walls: Sequence[SlantedWall],
    outlines: Sequence[Polygon],
    bodies: Sequence[manifold3d.Manifold],
    taken: _Taken,
) -> list[Interval]:
    """The runs of a contact."""
    p, w = contact.partition, contact.carrier
    partners = taken.partners(contact)
    joined = [other for other, _ in taken.tabs]
    if any(other.side == contact.side and other in joined for other in partners):
        return []
    sharing = {other.partition for other in partners}
    partition, carrier = walls[p], walls[w]
    depths = (contact.tip, contact.notch)
    band = contact.strip(contact.span, depths)
    blocked: list[Interval] = []
    in_band = plate_body(partition, band)
    for o, other in enumerate(bodies):
        shared = in_band ^ other if o not in (p, w) and o not in sharing else None
        if shared is not None and shared.volume() > 1e-6:
            clear = carrier.thickness_mm
            for low, high in _spans(shadow_of(partition, shared), contact.start, contact.along):
                blocked.append((low - clear, high + clear))
    whole = together([outlines[p], band])
    deep = contact.strip(contact.span, (contact.tip, contact.notch + partition.thickness_mm))
    blocked += _spans(without(deep, whole), contact.start, contact.along)
    # The slots of partners are no borders.
    slots = [other.opening(ends, 1e-3) for other, ends in taken.tabs if other in partners]
    whole = together([outlines[w], *slots])
    free = whole.buffer(-carrier.thickness_mm, join_style="mitre")
    lane = contact.opening(contact.span, 0.0)
    blocked += _spans(without(lane, free), contact.origin, contact.way)
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
