"""What is left of each wall: its region without the pieces that others own.

Terms
-----
island
    A part of a plate that hangs together with the rest nowhere, or by a corner only.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from shapely.geometry import Polygon, box

from .clear_slots import clear_slots
from .cut_up import CutUpError, cut_up, missing
from .pieces import NO_SLACK, Piece
from .rectilinear import Raster, rastered, wide_all_over
from .repairs import Repair
from .walls import GRID_MM, Wall, tidy

#: A connection narrower than twice this is none, mm.
NECK_MM = 0.05
_ROUNDS = 12


def cut_outlines(
    walls: Sequence[Wall], pieces: Sequence[Piece]
) -> tuple[list[Polygon], dict[tuple[str, ...], float], list[Piece]]:
    """The outline of each wall's plate, in the coordinates of its region, and what stays empty.

    Parameters
    ----------
    walls : sequence of Wall
    pieces : sequence of Piece
        Where a plate would fall apart, islands' pieces are given to their rivals.

    Returns
    -------
    outlines : list of Polygon
        One for each wall, in one piece.
    empty : dict of face ids to mm3
        Where walls touch in one point only, each wants a column there of which it has a part
        alone: a square cut leaves one part empty.
    pieces : list of Piece
        With their last owners.

    Raises
    ------
    CutUpError
        Where a wall falls apart whatever is done.
    """
    shared = list(pieces)
    settled: set[int] = set()
    cutter = _Cutter(walls, pieces)
    outlines = [cutter.outline(i, shared) for i in range(len(walls))]
    seen: dict[int, Polygon] = {}  # outlines that were found to be in one piece
    for _ in range(_ROUNDS):
        changes: dict[int, int] = {}
        for i in range(len(walls)):
            parts = _parts(outlines[i])
            if len(parts) == 1:
                seen[i] = outlines[i]
            if len(parts) < 2:
                continue
            for n, owner in _mended(i, walls, parts, shared).items():
                if n not in settled:
                    changes.setdefault(n, owner)
        if not changes:
            break
        # Each piece changes hands once: two walls cannot go on taking it from one another.
        settled |= set(changes)
        touched = {w for n in changes for w in (shared[n].owner, *shared[n].rivals)}
        for n, owner in changes.items():
            shared[n] = shared[n].given_to(owner)
        for i in touched:
            outlines[i] = cutter.outline(i, shared)
    repair = Repair(walls, shared, outlines, cutter)
    repair.run()
    repair = clear_slots(repair, _Cutter, lambda outline: len(_parts(outline)) == 1)
    outlines = repair.outlines
    empty = {tuple(walls[w].face_ids[0] for w in some): v for some, v in repair.empty().items()}
    outlines = [_main_part(wall, outline) for wall, outline in zip(walls, outlines, strict=True)]
    for i, outline in enumerate(outlines):
        parts = [outline] if seen.get(i) is outline else _parts(outline)
        if len(parts) != 1:
            raise _cut_up(i, walls, parts, repair.pieces)
    whole = [tidy(max(shapely.get_parts(o), key=lambda part: part.area)) for o in outlines]
    return whole, empty, repair.pieces


class _Cutter:
    """Cuts walls again and again while pieces change hands; where they lie stays.

    Parameters
    ----------
    walls : sequence of Wall
    pieces : sequence of Piece
    """

    def __init__(self, walls: Sequence[Wall], pieces: Sequence[Piece]) -> None:
        self.walls = walls
        self.boxes, self.plain, self.loose = [], [], []
        low = np.array([piece.low_mm for piece in pieces]).reshape(-1, 3)
        high = np.array([piece.high_mm for piece in pieces]).reshape(-1, 3)
        for number, wall in enumerate(walls):
            k, plane = wall.axis, list(wall.plane_axes)
            deep = np.minimum(high[:, k], wall.high_mm) - np.maximum(low[:, k], wall.low_mm)
            there = np.flatnonzero(deep > GRID_MM).tolist()
            wider = [n for n in there if _is_loose(pieces[n], number)]
            bounds = np.hstack([low[there][:, plane], high[there][:, plane]]).tolist()
            bounds += [_bounds(pieces[n], wall, number) for n in wider]
            self.boxes.append(np.array(bounds).reshape(-1, 4))
            self.plain.append({n: k for k, n in enumerate(there)})
            self.loose.append({n: k for k, n in enumerate(wider, len(there))})
        self._rasters: dict[int, Raster | None] = {}

    def outline(self, number: int, pieces: Sequence[Piece]) -> Polygon:
        """A wall without the pieces that are not its own."""
        lost = self._lost(number, pieces)
        if not lost:
            return self.walls[number].region
        raster = self._raster(number)
        quick = raster.less(lost) if raster else None
        if quick is not None:
            return quick
        boxes = shapely.union_all(shapely.box(*self.boxes[number][lost].T))
        return _without_dust(self.walls[number].region.difference(boxes, grid_size=GRID_MM))

    def main_mm2(self, number: int, pieces: Sequence[Piece]) -> float:
        """The area of the largest part of a wall's outline."""
        raster = self._raster(number)
        if raster is not None:
            return raster.largest_mm2(self._lost(number, pieces))
        parts = shapely.get_parts(self.outline(number, pieces))
        return float(max(shapely.area(parts), default=0.0))

    def _lost(self, number: int, pieces: Sequence[Piece]) -> list[int]:
        """The numbers of the boxes that others own."""
        loose = self.loose[number]
        return [
            loose[n] if n in loose and _is_loose(pieces[n], number) else box
            for n, box in self.plain[number].items()
            if pieces[n].owner != number
        ]

    def _raster(self, number: int) -> Raster | None:
        if number not in self._rasters:
            boxes = np.round(self.boxes[number], 6) + 0.0
            self._rasters[number] = rastered(self.walls[number].region, boxes)
        return self._rasters[number]


def _is_loose(piece: Piece, number: int) -> bool:
    """Whether a piece is cut out of a wall with play."""
    return piece.slack != NO_SLACK and piece.owner != number and piece.rivals[:1] == (number,)


def _without_dust(cut: Polygon) -> Polygon:
    """The polygon without slivers that rounding leaves along aslant borders."""
    parts = [p for p in shapely.get_parts(cut) if p.geom_type == "Polygon" and p.area > 1e-4]
    return parts[0] if len(parts) == 1 else shapely.MultiPolygon(parts)


def _overlaps(piece: Piece, wall: Wall) -> bool:
    return _depth(piece, wall) > GRID_MM


def _depth(piece: Piece, wall: Wall) -> float:
    """How much of a wall's thickness a piece takes; negative where it lies beside it."""
    low, high = piece.low_mm[wall.axis], piece.high_mm[wall.axis]
    return min(high, wall.high_mm) - max(low, wall.low_mm)


def _projected(piece: Piece, wall: Wall, number: int) -> Polygon:
    return box(*_bounds(piece, wall, number))


def _bounds(piece: Piece, wall: Wall, number: int) -> tuple[float, float, float, float]:
    """Low u and v, high u and v of a piece in a wall's region."""
    slack = piece.slack if piece.rivals[:1] == (number,) else NO_SLACK
    u, v = wall.plane_axes
    return (
        piece.low_mm[u] - slack[u][0],
        piece.low_mm[v] - slack[v][0],
        piece.high_mm[u] + slack[u][1],
        piece.high_mm[v] + slack[v][1],
    )


def _parts(outline: Polygon) -> list[Polygon]:
    """The parts of an outline that hang together by more than a neck."""
    if outline.geom_type == "Polygon" and wide_all_over(outline, 2 * NECK_MM):
        return [outline]
    thinned = outline.buffer(-NECK_MM, join_style="mitre")
    return [part for part in shapely.get_parts(thinned) if part.area > NECK_MM**2]


def _cut_up(
    number: int, walls: Sequence[Wall], parts: list[Polygon], pieces: Sequence[Piece]
) -> CutUpError:
    """Why a plate is not in one piece: who owns what lies between its parts."""
    wall = walls[number]
    parts = sorted(parts, key=lambda part: -part.area)
    area = missing(wall.drawn, parts)
    taken: dict[int, float] = {}
    for piece in pieces:
        if piece.owner != number and _overlaps(piece, wall):
            mm2 = _projected(piece, wall, number).intersection(area).area
            taken[piece.owner] = taken.get(piece.owner, 0.0) + mm2
    takers = sorted((w for w, mm2 in taken.items() if mm2 > 0), key=lambda w: -taken[w])[:2]
    thickness = max(walls[w].thickness_mm for w in (number, *takers))
    names = [walls[w].face_ids[0] for w in takers]
    return cut_up(wall.face_ids, wall.drawn, parts, names, thickness)


def _main_part(wall: Wall, outline: Polygon) -> Polygon:
    """The outline without loose corners that were never drawn, only added by lengthening."""
    if outline.geom_type == "Polygon":
        return outline
    parts = sorted(shapely.get_parts(outline), key=lambda part: -part.area)
    drawn = wall.drawn.buffer(-NECK_MM)
    return shapely.union_all([*parts[:1], *(part for part in parts[1:] if part.intersects(drawn))])


def _mended(
    number: int, walls: Sequence[Wall], parts: Sequence[Polygon], pieces: Sequence[Piece]
) -> dict[int, int]:
    """New owners for pieces, so that a plate that falls apart hangs together.

    What makes islands goes to the first rival that can keep it. An island that nobody else could
    have takes the pieces beside it.
    """
    wall = walls[number]
    main = max(parts, key=lambda part: part.area)
    islands = [part for part in parts if part is not main]
    changes: dict[int, int] = {}
    near = {
        n: _projected(piece, wall, number)
        for n, piece in enumerate(pieces)
        if number in (piece.owner, *piece.rivals) and _overlaps(piece, wall)
    }
    for island in islands:
        own = {
            n
            for n, area in near.items()
            if pieces[n].owner == number and island.intersects(area.centroid)
        }
        covered = sum(near[n].area * _depth(pieces[n], wall) for n in own)
        alone = covered < 0.9 * island.area * wall.thickness_mm
        taker = None if alone else _taker(own, walls, pieces)
        if taker is not None:
            changes |= dict.fromkeys(own, taker)
        else:
            reach = island.buffer(3 * NECK_MM, join_style="mitre")
            beside = (n for n in near if pieces[n].owner != number)
            changes |= {n: number for n in beside if reach.intersection(near[n]).area > NECK_MM}
    return changes


def _taker(given: set[int], walls: Sequence[Wall], pieces: Sequence[Piece]) -> int | None:
    """A wall that can keep all of these pieces: nobody else owns anything behind them."""
    rivals = [set(pieces[n].rivals) for n in given]
    for rival in sorted(set.intersection(*rivals), key=pieces[min(given)].rivals.index):
        wall = walls[rival]
        wanted = shapely.union_all([_projected(pieces[n], wall, -1) for n in given])
        if wall.region.intersection(wanted).area < 0.9 * wanted.area:
            continue
        inside = wanted.buffer(-NECK_MM, join_style="mitre")
        if not any(
            n not in given
            and piece.owner != rival
            and _overlaps(piece, wall)
            and inside.intersects(_projected(piece, wall, -1))
            for n, piece in enumerate(pieces)
        ):
            return rival
    return None
