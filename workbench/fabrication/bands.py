"""The band model: finger joints of walls at any angles ([dihedral.py] has the formulas).

Terms
-----
band
    The strip along an edge between the line of the tips and the line of the notches. Along its
    run it is cut into fingers; an odd number, the lower plate has both end fingers.
run
    The part of an edge that is clear of both its corners, in both walls.
end
    The rest of a band, up to the corner; it goes to the lower of the two plates. So the lowest
    plate at a corner owns the corner, and each plate stays in one piece.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.model import Model
from ...solver.values import Array
from .cut_up import CutUpError, cut_up, missing
from .dihedral import tip_and_notch
from .finger_joints import divide, least_finger_mm
from .joints import Joint, JointPlan, Meeting
from .outlines import NECK_MM
from .overlays import FINE_MM, together, wider, within, without
from .partitions import partitioned
from .seams import EdgeKey, EdgeNames, Seam, Seams, edge_frame, find_seams
from .settings import PlateSettings
from .slanted_walls import SlantedWall, slanted_walls
from .slivers import without_slivers
from .trimming import (
    on_its_side,
    pointed,
    takers_of,
    trimmed,
    trimmed_at_openings,
    without_pinholes,
)
from .walls import tidy, without_specks

#: Up to such a part of a plate may be left out: corners that joints would cut loose.
LOOSE_SHARE = 0.03
#: How far from its face's corner a plate may reach beyond concave edges, in parts of that width.
WIDENED_LIMIT = 2.0


@dataclass(frozen=True, slots=True, eq=False)
class _Edge:
    """An edge of a wall as it is cut: x goes from its line into the wall, s along it."""

    start: Array
    along: Array
    into: Array
    length: float
    tip: float
    notch: float
    seam: Seam | None

    def area(self, corners: Sequence[tuple[float, float]]) -> Polygon:
        """A polygon given by (s, x) pairs."""
        return Polygon([self.start + s * self.along + x * self.into for s, x in corners])


def band_outlines(
    model: Model, settings: PlateSettings, plan: JointPlan | None = None
) -> tuple[tuple[SlantedWall, ...], list[Polygon]]:
    """The walls of a model at any angles, and the outline of each one's plate in its plane.

    Parameters
    ----------
    model : Model
    settings : PlateSettings
    plan : JointPlan or None
        Decides the joints, and knows them afterwards.

    Returns
    -------
    walls : tuple of SlantedWall
        In the order of the model's faces.
    outlines : list of Polygon
        They overlap nowhere in space; where more than three plates meet, the higher ones are
        trimmed.

    Raises
    ------
    FabricationError
        Naming faces of which no plates can be made this way.
    """
    plan = plan or JointPlan(settings.finger_mm, settings.play_mm, settings.joints)
    while True:
        try:
            return _outlines(model, settings, plan)
        except CutUpError as error:
            reasoned = error.blaming(plan)
            if not plan.butt_instead(error.face_ids):
                raise reasoned from None


def _outlines(
    model: Model, settings: PlateSettings, plan: JointPlan
) -> tuple[tuple[SlantedWall, ...], list[Polygon]]:
    """The outlines with the joints that the plan allows."""
    walls, partitions, drawn = slanted_walls(model, settings.side)
    names = EdgeNames(model)
    seams = find_seams(walls, names)
    edges = [_edges(w, walls, seams) for w in range(len(walls))]
    made = tuple(wall for wall in walls if wall.thickness_mm > 0)
    openings = walls[len(made) :]
    walls = made
    # Openings come last: what is left are the seams between plates.
    seams = {key: s for key, s in seams.items() if max(key[0], s.other) < len(walls)}
    bands = _bands(walls, seams, edges, plan, settings, names)
    outlines = [_outline(w, walls, edges, bands) for w in range(len(walls))]
    slotted = list(outlines)
    outlines = pointed(walls, seams, outlines)
    outlines = on_its_side(walls, outlines, drawn, settings.side)
    if partitions:
        walls = (*walls, *partitions)
        outlines += [Polygon(wall.rings[0], wall.rings[1:]) for wall in partitions]
        outlines = trimmed_at_openings(walls, openings, outlines, len(made))
        whole = outlines
        outlines = partitioned(walls, outlines, len(made), plan, settings, names)
        lost = [a.difference(b) for a, b in zip(whole, outlines, strict=True)]
        slotted += whole[len(made) :]
        slotted = [a.difference(b) for a, b in zip(slotted, lost, strict=True)]
    outlines = without_pinholes(walls, trimmed(walls, outlines, plan), slotted)
    thinnest = min(wall.thickness_mm for wall in walls)
    outlines = [
        without_slivers(outline, wall.thickness_mm, settings.beam_mm, thinnest)
        for wall, outline in zip(walls, outlines, strict=True)
    ]
    cut = [_whole(n, walls, outlines) for n in range(len(walls))]
    order = list(model.faces)
    ranks = [order.index(wall.face_ids[0]) for wall in walls]
    sequence = sorted(range(len(walls)), key=ranks.__getitem__)
    return tuple(walls[n] for n in sequence), [cut[n] for n in sequence]


def _whole(n: int, walls: Sequence[SlantedWall], outlines: Sequence[Polygon]) -> Polygon:
    """An outline in one piece: without corners that joints have cut loose."""
    outline = outlines[n]
    thinned = outline.buffer(-NECK_MM, join_style="mitre")
    parts = [part for part in shapely.get_parts(thinned) if not part.is_empty]
    parts.sort(key=lambda part: -part.area)
    lost = sum(part.area for part in parts[1:])
    if not parts or lost > LOOSE_SHARE * parts[0].area:
        drawn = Polygon(walls[n].rings[0], walls[n].rings[1:])
        takers = takers_of(n, missing(drawn, parts), walls, outlines)
        thickness = max(walls[w].thickness_mm for w in (n, *takers))
        names = [walls[w].face_ids[0] for w in takers]
        raise cut_up(walls[n].face_ids, drawn, parts, names, thickness)
    if len(parts) > 1:
        held = parts[0].buffer(1.01 * NECK_MM, join_style="mitre")
        outline = within(outline, held)
    return without_specks(tidy(max(shapely.get_parts(outline), key=lambda part: part.area)))


@dataclass(frozen=True, slots=True)
class _Band:
    """How the band of a seam is given out: its run as s of the key's own edge."""

    joint: Joint
    low: float
    high: float
    count: int
    owner: int


def _point(position: Array) -> tuple[float, float, float]:
    x, y, z = position.tolist()
    return x, y, z


def _bands(
    walls: Sequence[SlantedWall],
    seams: Seams,
    edges: Sequence[list[list[_Edge]]],
    plan: JointPlan,
    settings: PlateSettings,
    names: EdgeNames,
) -> dict[EdgeKey, _Band]:
    bands = {}
    for key, seam in seams.items():
        w, r, e = key
        if w > seam.other:
            continue
        one, two, edge = walls[w], walls[seam.other], edges[w][r][e]
        low, high = _run(key, seams, edges)
        least = least_finger_mm(max(one.thickness_mm, two.thickness_mm), settings.beam_mm)
        ends = one.in_world(np.array([edge.start, edge.start + edge.length * edge.along]))
        meeting = Meeting(
            "L",
            one.face_ids,
            two.face_ids,
            names.on(one, two, ends),
            seam.theta_rad,
            high - low,
            least,
            3 * least,
            _point(ends.mean(axis=0)),
        )

        def count(finger: float, length: float = high - low, least: float = least) -> int:
            return divide(length, finger, least)

        joint = plan.decide(meeting, count)
        n = count(joint.finger_mm) if joint.kind == "finger" else 1
        owner = -1 if joint.kind == "none" else seam.other if joint.swapped else w
        bands[key] = _Band(joint, low, high, n, owner)
        other_key = (seam.other, *seam.other_edge)
        length = edge.length
        bands[other_key] = _Band(joint, length - high, length - low, n, owner)
    return bands


def _edges(w: int, walls: Sequence[SlantedWall], seams: Seams) -> list[list[_Edge]]:
    """All edges of a wall, ring by ring."""
    wall, result = walls[w], []
    for r, ring in enumerate(wall.rings):
        edges = []
        for e in range(len(ring)):
            seam = seams.get((w, r, e))
            tip = notch = 0.0
            if seam is not None:
                other = walls[seam.other].thickness_mm
                tip, notch = tip_and_notch(seam.theta_rad, wall.thickness_mm, other)
                if other == 0:  # at an opening the plate only must not stick out
                    tip = notch = _past_opening(seam.theta_rad, wall)
                    seam = None
            edges.append(_Edge(*edge_frame(wall, r, e), tip, notch, seam))
        result.append(edges)
    return result


def _past_opening(theta: float, wall: SlantedWall) -> float:
    """How far back a plate ends at an opening, so that it sticks out nowhere.

    Where the edge is concave only material outside of the drawn face can lie in the object.
    """
    deep = wall.thickness_mm if theta < math.pi else wall.drawn_mm
    return max(0.0, deep / math.tan(theta))


def _meeting(edge: _Edge, x: float, neighbour: _Edge, depth: float, *, at_end: bool) -> float:
    """Where the line x of an edge meets the line `depth` of its neighbour, as s of the edge."""
    across = float(edge.along @ neighbour.into)
    if abs(across) < 1e-9:  # the two run on in one line
        return edge.length if at_end else 0.0
    corner = edge.start + (edge.length if at_end else 0.0) * edge.along
    inwards = float((edge.start + x * edge.into - corner) @ neighbour.into)
    return (depth - inwards) / across


def _turns_in(edge: _Edge, neighbour: _Edge, *, at_end: bool) -> bool:
    """Whether the wall's corner between two edges is convex."""
    first, second = (edge, neighbour) if at_end else (neighbour, edge)
    turn = first.along[0] * second.along[1] - first.along[1] * second.along[0]
    return bool(turn > 0)


def _own_run(edges: Sequence[_Edge], e: int) -> tuple[float, float]:
    """The part of an edge that is clear of its corners in this wall."""
    edge, before, after = edges[e], edges[e - 1], edges[(e + 1) % len(edges)]
    low, high = 0.0, edge.length
    for x in (edge.tip, edge.notch):
        if _turns_in(edge, before, at_end=False):
            for depth in (before.tip, before.notch):
                low = max(low, _meeting(edge, x, before, depth, at_end=False))
        if _turns_in(edge, after, at_end=True):
            for depth in (after.tip, after.notch):
                high = min(high, _meeting(edge, x, after, depth, at_end=True))
    return low, high


def _run(
    key: tuple[int, int, int], seams: Seams, edges: Sequence[list[list[_Edge]]]
) -> tuple[float, float]:
    """The run of a seam, as s of this wall's edge; (0, 0) where nothing is left."""
    w, r, e = key
    seam = seams[key]
    length = edges[w][r][e].length
    low, high = _own_run(edges[w][r], e)
    other_low, other_high = _own_run(edges[seam.other][seam.other_edge[0]], seam.other_edge[1])
    low, high = max(low, length - other_high), min(high, length - other_low)
    return (low, high) if low < high else (0.0, 0.0)


def _outline(
    w: int,
    walls: Sequence[SlantedWall],
    edges: Sequence[list[list[_Edge]]],
    bands: dict[EdgeKey, _Band],
) -> Polygon:
    """A wall's region: widened at concave edges, without what its neighbours own."""
    wall = walls[w]
    added, removed = [], []
    for r, ring in enumerate(edges[w]):
        ends = [bands[w, r, e] if edge.seam is not None else None for e, edge in enumerate(ring)]
        owned = [band is None or band.owner == w for band in ends]
        for e, edge in enumerate(ring):
            before, after, band = ring[e - 1], ring[(e + 1) % len(ring)], ends[e]
            if edge.tip < 0:
                added.append(_strip(edge, before, after, (edge.tip, 0.0), reach="tips"))
                if before.tip < 0 and owned[e] and owned[e - 1]:
                    added.append(_corner(edge, before))
            if edge.tip > 0:
                # Behind a corner that looks inwards nothing sticks out; there only others' ends
                # need room.
                reach = "tip" if owned[e] else "notch"
                removed.append(_strip(edge, before, after, (0.0, edge.tip), reach=reach))
            if band is not None:
                removed += _lost(edge, before, after, band, owner=band.owner == w)
    base = Polygon(wall.rings[0], wall.rings[1:])
    whole = together([base, *added])
    if added:
        # Where it is drawn to a point, what is added must not go on beyond it.
        widest = -min(edge.tip for ring in edges[w] for edge in ring)
        near = base.buffer(widest + FINE_MM, join_style="mitre", mitre_limit=WIDENED_LIMIT)
        whole = within(whole, near)
    cut = without(whole, wider(together(removed)))
    parts = [part for part in shapely.get_parts(cut) if part.area > 1e-4]
    return shapely.union_all(parts)


def _corner(edge: _Edge, before: _Edge) -> Polygon:
    """What two widened edges share at their corner: strips leave it open where it looks inwards."""
    corners = ((0.0, 0.0), (0.0, before.tip), (edge.tip, before.tip), (edge.tip, 0.0))
    return edge.area(
        [(_meeting(edge, x, before, depth, at_end=False), x) for x, depth in corners]
    ).buffer(0)


def _lost(edge: _Edge, before: _Edge, after: _Edge, band: _Band, *, owner: bool) -> list[Polygon]:
    """The parts of a band that go to the other wall."""
    low, high, count = band.low, band.high, band.count
    depths = (edge.tip, edge.notch)
    if count == 1:
        return [] if owner else [_strip(edge, before, after, depths)]
    borders = [low + (high - low) * k / count for k in range(count + 1)]
    slack = band.joint.play_mm / 4
    lost = []
    if not owner:
        lost.append(_strip(edge, before, after, depths, (None, borders[1] + slack)))
        lost.append(_strip(edge, before, after, depths, (borders[-2] - slack, None)))
    for k in range(1 if owner else 2, count - (1 if owner else 2), 2):
        ends = (borders[k] - slack, borders[k + 1] + slack)
        lost.append(_strip(edge, before, after, depths, ends))
    return lost


def _strip(
    edge: _Edge,
    before: _Edge,
    after: _Edge,
    band: tuple[float, float],
    ends: tuple[float | None, float | None] = (None, None),
    *,
    reach: str = "notch",
) -> Polygon:
    """The part of an edge's strip between two depths; an end of None goes on to the corner.

    Behind corners that look inwards to the neighbour's line of ``notch`` or ``tip``; ``tips``
    says the latter of all corners.
    """
    corners = []
    for x, order in ((band[0], (0, 1)), (band[1], (1, 0))):
        for end in order:
            s = ends[end]
            if s is None:
                neighbour = after if end else before
                s = _corner_end(edge, x, neighbour, at_end=bool(end), reach=reach)
            corners.append((s, x))
    return edge.area(corners).buffer(0)


def _corner_end(edge: _Edge, x: float, neighbour: _Edge, *, at_end: bool, reach: str) -> float:
    """How far a strip goes on at a corner: to the neighbour's line, or behind its notches."""
    if reach == "tips":
        depth = neighbour.tip
    elif _turns_in(edge, neighbour, at_end=at_end):
        depth = min(0.0, neighbour.tip)
    else:
        depth = max(neighbour.tip if reach == "tip" else neighbour.notch, 0.0)
    return _meeting(edge, x, neighbour, depth, at_end=at_end)
