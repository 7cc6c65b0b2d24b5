"""A last look for space that nobody fills, and other owners for the pieces around it.

Terms
-----
trouble
    A box of the walls' space that no plate fills: an island that falls off its plate, or a piece
    whose owner has nothing there.
move
    Some pieces near a trouble given to one wall. A move is good if more space is filled after it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Protocol

import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.values import Array
from .pieces import NO_SLACK, Piece
from .walls import Wall

_ROUNDS = 24
#: So many moves are tried in all; on bodies of dozens of boxes there would be no end.
_MOST_TRIES = 2000
#: Pieces whose boxes are no further from a trouble may change hands, mm.
_NEAR_MM = 0.1
#: Less than this is rounding, mm3.
_LEAST_MM3 = 1e-3
_EIGHTHS = np.array([(x, y, z) for x in (0.25, 0.75) for y in (0.25, 0.75) for z in (0.25, 0.75)])


class Cutter(Protocol):
    """Cuts a wall by its number and the pieces."""

    def outline(self, number: int, pieces: Sequence[Piece]) -> Polygon:
        """What is left of it."""

    def main_mm2(self, number: int, pieces: Sequence[Piece]) -> float:
        """The area of the largest part of that."""


class Repair:
    """The walls' pieces, changed as long as more space becomes filled.

    Parameters
    ----------
    walls : sequence of Wall
    pieces : sequence of Piece
    outlines : sequence of Polygon
        What the pieces make of the walls.
    cutter : Cutter
        From a wall's number and pieces to its outline.
    """

    def __init__(
        self,
        walls: Sequence[Wall],
        pieces: Sequence[Piece],
        outlines: Sequence[Polygon],
        cutter: Cutter,
    ) -> None:
        self.walls, self.pieces, self.cutter = walls, list(pieces), cutter
        self.outlines = list(outlines)
        self.mains = [_main(outline) for outline in outlines]
        self.left = _MOST_TRIES
        self._shares: Array | None = None

    def run(self) -> list[Polygon]:
        """The outlines with the pieces' last owners."""
        for _ in range(_ROUNDS):
            if not any(self._improve(box) for box in self._troubles()):
                break
        return self.outlines

    def empty(self) -> dict[tuple[int, ...], float]:
        """What stays empty, mm3, by the walls that share it; not what nobody should have."""
        found: dict[tuple[int, ...], float] = {}
        for n, share in enumerate(self._unfilled().tolist()):
            piece = self.pieces[n]
            if piece.owner >= 0 and share > 0:
                walls = tuple(sorted({piece.owner, *piece.rivals}))
                size = float(np.prod(np.subtract(piece.high_mm, piece.low_mm)))
                found[walls] = found.get(walls, 0.0) + share * size
        for walls, size in self._beside_pieces():
            found[walls] = found.get(walls, 0.0) + size
        return found

    def _beside_pieces(self) -> Iterator[tuple[tuple[int, ...], float]]:
        """What of walls' own space lies behind pieces that others own, and so is cut away."""
        low = np.array([piece.low_mm for piece in self.pieces]).reshape(-1, 3)
        high = np.array([piece.high_mm for piece in self.pieces]).reshape(-1, 3)
        owners = np.array([piece.owner for piece in self.pieces])
        for n, wall in enumerate(self.walls):
            deep = np.minimum(high[:, wall.axis], wall.high_mm)
            deep = deep - np.maximum(low[:, wall.axis], wall.low_mm)
            cut = (deep > 1e-6) & (deep < wall.thickness_mm - 1e-6) & (owners != n) & (owners >= 0)
            u, v = wall.plane_axes
            seen: set[tuple[float, ...]] = set()
            for k in np.flatnonzero(cut).tolist():
                bounds = (low[k, u], low[k, v], high[k, u], high[k, v])
                if bounds in seen:
                    continue
                seen.add(bounds)
                column = np.array([low[k], high[k]])
                column[:, wall.axis] = wall.low_mm, wall.high_mm
                shared = np.minimum(high, column[1]) - np.maximum(low, column[0])
                area = wall.region.intersection(shapely.box(*bounds)).area
                rest = area * wall.thickness_mm - np.prod(np.clip(shared, 0.0, None), axis=1).sum()
                if rest > _LEAST_MM3:
                    yield tuple(sorted({n, int(owners[k])})), float(rest)

    def _troubles(self) -> Iterator[Array]:
        """Boxes (low and high corner) that nobody fills."""
        for n, wall in enumerate(self.walls):
            parts = shapely.get_parts(self.outlines[n])
            for part in parts if len(parts) > 1 else ():
                if not part.equals(self.mains[n]) and part.area > _LEAST_MM3:
                    yield _box(wall, part)
        for n in np.flatnonzero(self._unfilled()).tolist():
            yield np.array([self.pieces[n].low_mm, self.pieces[n].high_mm])

    def _unfilled(self) -> Array:
        """What share of each piece nobody fills: seen in the middles of its eighths."""
        if self._shares is None:
            self._shares = self._looked_at() if self.pieces else np.zeros(0)
        return self._shares

    def _looked_at(self) -> Array:
        low = np.array([piece.low_mm for piece in self.pieces])
        size = np.array([piece.high_mm for piece in self.pieces]) - low
        spots = (low[:, None] + _EIGHTHS * size[:, None]).reshape(-1, 3)
        filled = np.zeros(len(spots), dtype=bool)
        for n, wall in enumerate(self.walls):
            heights = spots[:, wall.axis]
            within = np.flatnonzero((heights > wall.low_mm) & (heights < wall.high_mm) & ~filled)
            u, v = (spots[within, k] for k in wall.plane_axes)
            shapely.prepare(self.mains[n])
            filled[within] |= shapely.intersects_xy(self.mains[n], u, v)
        return np.asarray(1.0 - filled.reshape(-1, 8).mean(axis=1))

    def _improve(self, box: Array) -> bool:
        """Make the best of the small moves near a box; False where none is good."""
        near = [n for n, piece in enumerate(self.pieces) if piece.rivals and _touches(piece, box)]
        moves = [
            (wall, tuple(n for n in near if wall in self.pieces[n].rivals))
            for wall in sorted({w for n in near for w in self.pieces[n].rivals})
        ]
        behind = {
            wall: tuple(n for n in able if self._behind(wall, n, box)) for wall, able in moves
        }
        for size in (0, 1, 2):
            tries = [(w, some) for w, able in moves for some in combinations(able, size + 1)]
            tries += [
                (w, (*behind[w], *some))
                for w, able in moves
                for some in combinations([n for n in able if n not in behind[w]], size)
                if behind[w]
            ]
            best, gain = None, _LEAST_MM3
            for wall, some in tries[: max(0, self.left)]:
                self.left -= 1
                more = self.gain(wall, some)
                if more > gain:
                    best, gain = (wall, some), more
            if best is not None:
                self.move(*best)
                return True
        return False

    def _behind(self, wall: int, piece: int, box: Array) -> bool:
        """Whether a piece lies in a wall's thickness where a box does."""
        member, given = self.walls[wall], self.pieces[piece]
        return all(
            min(given.high_mm[k], box[1][k]) - max(given.low_mm[k], box[0][k]) > _NEAR_MM
            for k in member.plane_axes
        )

    def _given(self, wall: int, some: Sequence[int]) -> list[Piece]:
        pieces = list(self.pieces)
        for n in some:
            pieces[n] = pieces[n].given_to(wall)
        return pieces

    def _changed(self, wall: int, some: Sequence[int]) -> set[int]:
        """The walls that a move may change: others are cut there before and after it."""
        given = [self.pieces[n] for n in some]
        loose = [w for piece in given if piece.slack != NO_SLACK for w in piece.rivals[:1]]
        return {wall, *loose, *(piece.owner for piece in given)}

    def gain(self, wall: int, some: Sequence[int]) -> float:
        """How much more space a move fills, mm3."""
        pieces = self._given(wall, some)
        more = sum(
            (self.cutter.main_mm2(w, pieces) - self.mains[w].area) * self.walls[w].thickness_mm
            for w in sorted(self._changed(wall, some))
        )
        return float(more)

    def outlines_after(self, wall: int, some: Sequence[int]) -> dict[int, Polygon]:
        """The outlines that a move changes."""
        pieces = self._given(wall, some)
        return {w: self.cutter.outline(w, pieces) for w in sorted(self._changed(wall, some))}

    def move(self, wall: int, some: Sequence[int]) -> None:
        """Give some pieces to a wall."""
        changed = self._changed(wall, some)
        self.pieces, self._shares = self._given(wall, some), None
        for w in changed:
            self.outlines[w] = self.cutter.outline(w, self.pieces)
            self.mains[w] = _main(self.outlines[w])


def _main(outline: Polygon) -> Polygon:
    return max(shapely.get_parts(outline), key=lambda part: part.area, default=Polygon())


def _box(wall: Wall, part: Polygon) -> Array:
    low, high = np.zeros(3), np.zeros(3)
    u, v = wall.plane_axes
    low[u], low[v], high[u], high[v] = part.bounds
    low[wall.axis], high[wall.axis] = wall.low_mm, wall.high_mm
    return np.array([low, high])


def _touches(piece: Piece, box: Array) -> bool:
    return all(
        low <= high_box + _NEAR_MM and high >= low_box - _NEAR_MM
        for low, high, low_box, high_box in zip(
            piece.low_mm, piece.high_mm, box[0], box[1], strict=True
        )
    )
