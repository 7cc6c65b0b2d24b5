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

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.model import Model
from ...solver.values import Array
from .dihedral import takes_fingers, tip_and_notch
from .errors import FabricationError
from .finger_joints import divide, least_finger_mm
from .outlines import NECK_MM
from .seams import Seam, Seams, edge_frame, find_seams
from .settings import PlateSettings
from .slanted_walls import FINE_MM, SlantedWall, slanted_walls
from .trimming import pointed, trimmed
from .walls import tidy


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
    model: Model, settings: PlateSettings
) -> tuple[tuple[SlantedWall, ...], list[Polygon]]:
    """The walls of a model at any angles, and the outline of each one's plate in its plane.

    Parameters
    ----------
    model : Model
    settings : PlateSettings

    Returns
    -------
    walls : tuple of SlantedWall
    outlines : list of Polygon
        They overlap nowhere in space; where more than three plates meet, the higher ones are
        trimmed.

    Raises
    ------
    FabricationError
        Naming faces of which no plates can be made this way.
    """
    walls = slanted_walls(model, settings.side)
    seams = find_seams(walls)
    edges = [_edges(w, walls, seams) for w in range(len(walls))]
    walls = tuple(wall for wall in walls if wall.thickness_mm > 0)
    # Openings come last: what is left are the seams between plates.
    seams = {key: s for key, s in seams.items() if max(key[0], s.other) < len(walls)}
    runs = {key: _run(key, seams, edges) for key in seams}
    outlines = [_outline(w, walls, edges, runs, settings) for w in range(len(walls))]
    outlines = pointed(walls, seams, outlines)
    outlines = trimmed(walls, outlines)
    for wall, outline in zip(walls, outlines, strict=True):
        if outline.is_empty or len(shapely.get_parts(outline.buffer(-NECK_MM))) != 1:
            raise FabricationError(
                "the joints leave no whole plate", wall.face_ids, "thinner plates"
            )
    whole = [max(shapely.get_parts(outline), key=lambda p: p.area) for outline in outlines]
    return walls, [tidy(outline) for outline in whole]


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
                    tip = notch = max(tip, 0.0) if seam.theta_rad < np.pi else 0.0
                    seam = None
            edges.append(_Edge(*edge_frame(wall, r, e), tip, notch, seam))
        result.append(edges)
    return result


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
    runs: dict[tuple[int, int, int], tuple[float, float]],
    settings: PlateSettings,
) -> Polygon:
    """A wall's region: widened at concave edges, without what its neighbours own."""
    wall = walls[w]
    added, removed = [], []
    for r, ring in enumerate(edges[w]):
        for e, edge in enumerate(ring):
            before, after = ring[e - 1], ring[(e + 1) % len(ring)]
            if edge.tip < 0:
                added.append(_strip(edge, before, after, (edge.tip, 0.0), to_tips=True))
            if edge.tip > 0:
                removed.append(_strip(edge, before, after, (0.0, edge.tip)))
            if edge.seam is None:
                continue
            thickness = max(wall.thickness_mm, walls[edge.seam.other].thickness_mm)
            lower = w < edge.seam.other
            removed += _lost(edge, before, after, runs[w, r, e], thickness, settings, lower=lower)
    base = Polygon(wall.rings[0], wall.rings[1:])
    whole = shapely.union_all([base, *added], grid_size=FINE_MM)
    # Wider by a few grid steps, so that rounding never makes two plates overlap.
    lost = shapely.union_all(removed, grid_size=FINE_MM).buffer(4 * FINE_MM, join_style="mitre")
    cut = whole.difference(lost, grid_size=FINE_MM)
    parts = [p for p in shapely.get_parts(cut) if p.geom_type == "Polygon" and p.area > 1e-4]
    return shapely.union_all(parts)


def _lost(
    edge: _Edge,
    before: _Edge,
    after: _Edge,
    run: tuple[float, float],
    thickness: float,
    settings: PlateSettings,
    *,
    lower: bool,
) -> list[Polygon]:
    """The parts of a band that go to the other wall."""
    low, high = run
    theta = edge.seam.theta_rad if edge.seam is not None else 0.0
    band = (edge.tip, edge.notch)
    count = 1
    if takes_fingers(theta):
        least = least_finger_mm(thickness, settings.kerf_mm)
        count = divide(high - low, settings.finger_mm, least)
    if count == 1:
        return [] if lower else [_strip(edge, before, after, band)]
    borders = [low + (high - low) * k / count for k in range(count + 1)]
    slack = settings.play_mm / 4
    lost = []
    if not lower:
        lost.append(_strip(edge, before, after, band, (None, borders[1] + slack)))
        lost.append(_strip(edge, before, after, band, (borders[-2] - slack, None)))
    for k in range(1 if lower else 2, count - (1 if lower else 2), 2):
        ends = (borders[k] - slack, borders[k + 1] + slack)
        lost.append(_strip(edge, before, after, band, ends))
    return lost


def _strip(
    edge: _Edge,
    before: _Edge,
    after: _Edge,
    band: tuple[float, float],
    ends: tuple[float | None, float | None] = (None, None),
    *,
    to_tips: bool = False,
) -> Polygon:
    """The part of an edge's strip between two depths; an end of None goes on to the corner."""
    corners = []
    for x, order in ((band[0], (0, 1)), (band[1], (1, 0))):
        for end in order:
            s = ends[end]
            if s is None:
                neighbour = after if end else before
                s = _corner_end(edge, x, neighbour, at_end=bool(end), to_tips=to_tips)
            corners.append((s, x))
    return edge.area(corners).buffer(0)


def _corner_end(edge: _Edge, x: float, neighbour: _Edge, *, at_end: bool, to_tips: bool) -> float:
    """How far a strip goes on at a corner: to the neighbour's line, or behind its notches."""
    if to_tips:
        depth = neighbour.tip
    elif _turns_in(edge, neighbour, at_end=at_end):
        depth = min(0.0, neighbour.tip)
    else:
        depth = max(neighbour.notch, 0.0)
    return _meeting(edge, x, neighbour, depth, at_end=at_end)
