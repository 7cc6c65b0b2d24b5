"""Slots kept one thickness from borders: narrower tabs, no tab, or another owner of what is near.

Terms
-----
near
    A slot less than its plate's thickness from the plate's border, or from a hole that was drawn.
lane
    The part of a slot that is near.
move
    Some pieces around a lane given to one wall: the slot ends further away, opens through the
    border, or goes. A move is good if it leaves no more space empty, each plate in one piece and
    fewer slots near.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain, combinations, pairwise

import numpy as np
import shapely
from shapely.geometry import LinearRing, Polygon

from .joints import Joint
from .pieces import Piece
from .repairs import Cutter, Repair
from .settings import USUAL_BEAM_MM
from .walls import Wall

_ROUNDING_MM = 1e-5
_ROUNDS = 40
#: So many moves are tried for one slot.
_MOST_TRIES = 1000
#: Of so many columns of a wall, the nearest, several are given at once.
_NEAREST = 8
#: Space that a move may leave empty is rounding, mm3.
_LEAST_MM3 = 1e-3
Box = tuple[float, float, float, float]
CutterOf = Callable[[Sequence[Wall], Sequence[Piece]], Cutter]
IsWhole = Callable[[Polygon], bool]


@dataclass(frozen=True, slots=True, eq=False)
class _Near:
    wall: int
    slot: Polygon
    lane: Polygon


def near_slots(wall: Wall, outline: Polygon) -> Iterator[tuple[Polygon, LinearRing]]:
    """The slots of a wall that are near, and the border that each is near to."""
    if outline.geom_type != "Polygon" or len(outline.interiors) == 0:
        return
    holes = list(outline.interiors)
    least = wall.thickness_mm - _ROUNDING_MM
    if not wall.region.interiors and shapely.distance(outline.exterior, holes).min() >= least:
        return  # no hole was drawn, and no slot is near: most walls
    rings = [Polygon(ring) for ring in holes]
    # What a slot takes is the wall's; a hole that was drawn is not.
    slots = [ring for ring in rings if ring.intersection(wall.region).area > _LEAST_MM3]
    borders = [outline.exterior, *(ring.exterior for ring in rings if ring not in slots)]
    for slot in slots:
        for border in borders:
            if border.distance(slot.exterior) < least:
                yield slot, border


def clear_slots(repair: Repair, cutter_of: CutterOf, is_whole: IsWhole) -> Repair:
    """The same walls with as few near slots as can be.

    Parameters
    ----------
    repair : Repair
        With the outlines found so far.
    cutter_of : callable
        From walls and pieces to a cutter.
    is_whole : callable
        Whether an outline is one plate.

    Returns
    -------
    Repair
        The same one where nothing is near.
    """
    near = list(_all_near(repair.walls, repair.outlines))
    for _ in range(_ROUNDS):
        if not near:
            return repair
        pieces = _split(repair, near)
        if len(pieces) > len(repair.pieces):
            walls = repair.walls
            repair = Repair(walls, pieces, repair.outlines, cutter_of(walls, pieces))
        if not any(_cleared(repair, one, is_whole) for one in near):
            return repair
        near = list(_all_near(repair.walls, repair.outlines))
    return repair


def lost_tabs(
    joints: Sequence[Joint], walls: Sequence[Wall], pieces: Sequence[Piece]
) -> list[tuple[Joint, str]]:
    """The joints of tabs that have none left, and why.

    Parameters
    ----------
    joints : sequence of Joint
        Still in the frame.
    walls : sequence of Wall
    pieces : sequence of Piece
        With their last owners.

    Returns
    -------
    list of (Joint, str)
    """
    numbers = {wall.face_ids: n for n, wall in enumerate(walls)}
    tabs: dict[tuple[int, ...], list[Piece]] = {}
    for piece in pieces:
        if piece.run_axis >= 0:
            tabs.setdefault((*piece.rivals[:1], piece.owner), []).append(piece)
    lost = []
    for joint in joints:
        if joint.kind != "tab_slot" or joint.meeting.form != "T":
            continue
        one, two = (numbers[ids] for ids in (joint.meeting.one, joint.meeting.two))
        if not any(_lies_along(piece, joint) for piece in tabs.get((one, two), ())):
            least = walls[one].thickness_mm
            name = joint.meeting.one[0]
            lost.append((joint, f"slots would be less than {least:g} mm from a border of {name}"))
    return lost


def _lies_along(piece: Piece, joint: Joint) -> bool:
    k, reach = piece.run_axis, joint.meeting.length_mm / 2
    middle = (piece.low_mm[k] + piece.high_mm[k]) / 2
    return abs(middle - joint.meeting.middle_mm[k]) < reach


def _all_near(walls: Sequence[Wall], outlines: Sequence[Polygon]) -> Iterator[_Near]:
    for n, (wall, outline) in enumerate(zip(walls, outlines, strict=True)):
        for slot, border in near_slots(wall, outline):
            around = border.buffer(wall.thickness_mm, join_style="mitre", cap_style="square")
            lane = slot.intersection(around)
            if lane.area > _ROUNDING_MM:
                yield _Near(n, slot, lane)


def _split(repair: Repair, near: Sequence[_Near]) -> list[Piece]:
    """Pieces of runs cut along the run where a lane begins, unless too little is left of them."""
    pieces = list(repair.pieces)
    for one in near:
        wall = repair.walls[one.wall]
        result: list[Piece] = []
        for piece in pieces:
            if piece.run_axis not in wall.plane_axes or not _lies_in(piece, wall, one.slot):
                result.append(piece)
                continue
            result += _cut(piece, _lane_ends(piece, wall, one.lane))
        pieces = result
    return pieces


def _lane_ends(piece: Piece, wall: Wall, lane: Polygon) -> list[float]:
    """Where a lane begins and ends along a piece's run."""
    column = wall.plane_axes.index(piece.run_axis)
    low, high = piece.low_mm[piece.run_axis], piece.high_mm[piece.run_axis]
    slack = max(piece.slack[piece.run_axis])
    ends = set()
    for part in shapely.get_parts(lane):
        bounds = part.bounds
        # A slot is longer than its piece by the play.
        ends |= {bounds[column] - slack, bounds[column + 2] + slack}
    return [low, *sorted(round(x, 6) for x in ends if low + 1e-3 < x < high - 1e-3), high]


def _cut(piece: Piece, ends: Sequence[float]) -> list[Piece]:
    """A piece in parts, of which one at least is not too narrow."""
    if max(b - a for a, b in pairwise(ends)) < piece.least_mm - 1e-9 or len(ends) < 3:
        return [piece]
    k = piece.run_axis
    slack = list(piece.slack)
    slack[k] = (max(slack[k]), max(slack[k]))
    parts = []
    for a, b in pairwise(ends):
        low, high = list(piece.low_mm), list(piece.high_mm)
        low[k], high[k] = a, b
        parts.append(
            replace(
                piece,
                low_mm=(low[0], low[1], low[2]),
                high_mm=(high[0], high[1], high[2]),
                slack=(slack[0], slack[1], slack[2]),
            )
        )
    return parts


def _cleared(repair: Repair, near: _Near, is_whole: IsWhole) -> bool:
    """Make the best move at a near slot, if one is good."""
    if near.slot not in {slot for slot, _ in near_slots(*_of(repair, near.wall))}:
        return False  # a move before has changed it
    best: tuple[float, float] | None = None
    chosen: tuple[int, tuple[int, ...]] | None = None
    tries = list(_moves(repair, near))[:_MOST_TRIES]
    for wall, some in tries:
        cost = _cost(repair, wall, some, is_whole)
        if cost is not None and (best is None or cost < best):
            best, chosen = cost, (wall, some)
    if chosen is None:
        return False
    repair.move(*chosen)
    return True


def _of(repair: Repair, wall: int) -> tuple[Wall, Polygon]:
    return repair.walls[wall], repair.outlines[wall]


def _moves(repair: Repair, near: _Near) -> Iterator[tuple[int, tuple[int, ...]]]:
    """Columns of a wall around a lane, given to that wall: near ones first."""
    wall = repair.walls[near.wall]
    zone = near.lane.buffer(1.5 * wall.thickness_mm, join_style="mitre").union(near.slot)
    around = [
        n
        for n, piece in enumerate(repair.pieces)
        if not piece.carries
        and near.wall in (piece.owner, *piece.rivals)
        and _lies_in(piece, wall, zone)
    ]
    around.sort(key=lambda n: near.lane.distance(_spot(repair.pieces[n], wall)))
    takers = dict.fromkeys(w for n in around for w in repair.pieces[n].rivals)
    columns = {
        w: _columns(repair, w, [n for n in around if w in repair.pieces[n].rivals]) for w in takers
    }
    some = {w: every[:_NEAREST] for w, every in columns.items()}
    # The tries may run out: first come one column alone and all together, of which there are few.
    for w, chosen in chain(
        ((w, (one,)) for w, every in columns.items() for one in every),
        columns.items(),
        ((w, few) for n in (2, 3, 4) for w, near in some.items() for few in combinations(near, n)),
    ):
        yield w, tuple(n for column in chosen for n in column)


def _spot(piece: Piece, wall: Wall) -> shapely.Point:
    """The middle of a piece in a wall's plane."""
    middle = [(low + high) / 2 for low, high in zip(piece.low_mm, piece.high_mm, strict=True)]
    return shapely.Point([middle[k] for k in wall.plane_axes])


def _columns(repair: Repair, w: int, some: Sequence[int]) -> list[tuple[int, ...]]:
    """Pieces that lie behind one another in a wall's thickness."""
    u, v = repair.walls[w].plane_axes
    found: dict[Box, list[int]] = {}
    for n in some:
        low, high = repair.pieces[n].low_mm, repair.pieces[n].high_mm
        found.setdefault((low[u], low[v], high[u], high[v]), []).append(n)
    return [tuple(column) for column in found.values()]


def _lies_in(piece: Piece, wall: Wall, area: Polygon) -> bool:
    k, (u, v) = wall.axis, wall.plane_axes
    if min(piece.high_mm[k], wall.high_mm) - max(piece.low_mm[k], wall.low_mm) < 1e-6:
        return False
    box = shapely.box(piece.low_mm[u], piece.low_mm[v], piece.high_mm[u], piece.high_mm[v])
    return bool(box.intersection(area).area > 1e-6)


def _cost(
    repair: Repair, wall: int, some: Sequence[int], is_whole: IsWhole
) -> tuple[float, float] | None:
    """How many slots are near after a move, and how much it moves; None where it is not good."""
    if repair.gain(wall, some) < -_LEAST_MM3:
        return None
    before = after = 0
    for w, outline in repair.outlines_after(wall, some).items():
        if not is_whole(outline):
            return None
        if _slits_mm2(outline) > _slits_mm2(repair.outlines[w]) + _ROUNDING_MM:
            return None
        before += sum(1 for _ in near_slots(*_of(repair, w)))
        after += sum(1 for _ in near_slots(repair.walls[w], outline))
    moved = sum(
        float(np.prod(np.subtract(repair.pieces[n].high_mm, repair.pieces[n].low_mm))) for n in some
    )
    return (after, moved) if after < before else None


def _slits_mm2(outline: Polygon) -> float:
    """The area of gaps too narrow for a beam, and one more for each mouth that is.

    Of loose corners too, which a wall may still have.
    """
    half = USUAL_BEAM_MM / 2
    closed = outline.buffer(half, join_style="mitre")
    filled = [Polygon(part.exterior) for part in shapely.get_parts(outline)]
    mouths = sum(len(part.buffer(half, join_style="mitre").interiors) for part in filled)
    return float(closed.buffer(-half, join_style="mitre").area - outline.area) + mouths
