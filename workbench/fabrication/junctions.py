"""Junctions: the space in which more than two walls meet, given out so that none stays empty.

Terms
-----
column
    The cells that lie behind one another in a wall's thickness at one place. A plate is cut
    through its whole thickness, so a wall keeps all of a column or nothing.
block
    Cells that columns hold together. Each is solved on its own: columns are chosen that share no
    cell and leave none empty.
loose
    A chosen column that hangs together with the rest of its wall nowhere.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ...solver.union_find import UnionFind
from .cells import Cells, Flags, Run
from .pieces import Piece

Place = tuple[int, int, int]
Spot = tuple[int, int, int]  # wall, u, v
#: A search that has taken so many steps takes the best that it has found.
MOST_STEPS = 150_000


@dataclass(frozen=True, slots=True)
class _Column:
    """A wall's column in a block; `needed` where one of its cells is in no other wall."""

    wall: int
    u: int
    v: int
    cells: frozenset[int]
    whole: bool
    needed: bool

    @property
    def spot(self) -> Spot:
        return self.wall, self.u, self.v


def junction_pieces(
    cells: Cells, claimed: Flags, runs: Mapping[Run, int], ranks: Sequence[int]
) -> list[Piece]:
    """An owner for each cell that several walls share and that is part of no run.

    Parameters
    ----------
    cells : Cells
    claimed : array of bool
        The cells of all runs.
    runs : mapping of Run to int
        The owner of each run's ends; -1 where nobody has it.
    ranks : sequence of int
        The walls' global order.

    Returns
    -------
    list of Piece
        One for each cell. Wherever the square cut allows it, their owners leave no cell empty.
    """
    members = cells.members()
    shared = ((members > 0).sum(axis=0) > 1) & ~claimed
    kept = _kept_by_runs(cells, runs)
    blocks = _blocks(cells, shared, claimed)
    alone = _alone(cells, shared | claimed)
    pieces: list[Piece] = []
    for block in _grouped(blocks, shared):
        columns = _columns(cells, members, claimed, block, ranks)
        chosen = _Search(cells, block, columns, kept, alone).best()
        owners = {cell: column.wall for column in chosen for cell in column.cells}
        kept |= {column.spot: column in chosen for column in columns}
        pieces += _pieces(cells, block, columns, owners)
    return pieces


def _alone(cells: Cells, busy: Flags) -> list[Flags]:
    """For each wall where it is, with no other wall in its thickness there."""
    result = []
    for w, wall in enumerate(cells.walls):
        turned = np.moveaxis(busy, (wall.axis, *wall.plane_axes), (0, 1, 2))
        there = cells.full[w] | cells.partial[w]
        result.append(there & ~turned[cells.spans[w]].any(axis=0))
    return result


def _grouped(blocks: NDArray[np.int_], shared: Flags) -> list[list[Place]]:
    """The shared cells of each block."""
    groups: dict[int, list[Place]] = {}
    for x, y, z in np.argwhere(shared).tolist():
        groups.setdefault(int(blocks[x, y, z]), []).append((x, y, z))
    return list(groups.values())


def _blocks(cells: Cells, shared: Flags, claimed: Flags) -> NDArray[np.int_]:
    """Numbers of blocks: cells that lie behind one another in a wall's thickness."""
    numbers = np.arange(shared.size).reshape(shared.shape)
    sets = UnionFind(shared.size)
    for w, wall in enumerate(cells.walls):
        turned = (wall.axis, *wall.plane_axes)
        span = cells.spans[w]
        ids, mixed, taken = (
            np.moveaxis(array, turned, (0, 1, 2))[span] for array in (numbers, shared, claimed)
        )
        for u, v in np.argwhere(cells.full[w] & mixed.any(axis=0)).tolist():
            column = ids[:, u, v][~taken[:, u, v]].tolist()
            for a, b in pairwise(column):
                sets.union(a, b)
    return np.array(sets.labels()).reshape(shared.shape)


def _kept_by_runs(cells: Cells, runs: Mapping[Run, int]) -> dict[Spot, bool]:
    """Which spots of walls lie in runs, and whether the wall keeps material there.

    At a run's ends only the owner of the end fingers does; between them both do.
    """
    kept: dict[Spot, bool] = {}
    for run, owner in runs.items():
        lines = cells.lines[run.axis]
        low, high = (int(np.abs(lines - at).argmin()) for at in (run.low_mm, run.high_mm))
        for wall, other in ((run.one, run.two), (run.two, run.one)):
            across = cells.spans[other]
            first = cells.walls[wall].plane_axes[0] == run.axis
            for along in range(low, high):
                ends = along in (low, high - 1) and run.kind != "X"
                for k in range(across.start, across.stop):
                    u, v = (along, k) if first else (k, along)
                    kept[wall, u, v] = owner == wall or (owner >= 0 and not ends)
    return kept


def _columns(
    cells: Cells,
    members: NDArray[np.int8],
    claimed: Flags,
    block: Sequence[Place],
    ranks: Sequence[int],
) -> list[_Column]:
    """All columns of a block that a wall may keep, in the walls' order."""
    numbers = {place: n for n, place in enumerate(block)}
    found: dict[Spot, _Column] = {}
    for place in block:
        for w in np.flatnonzero(members[:, place[0], place[1], place[2]]).tolist():
            wall = cells.walls[w]
            u, v = (place[k] for k in wall.plane_axes)
            if (w, u, v) in found:
                continue
            behind = [_with(place, wall.axis, k) for k in range(*cells.spans[w].indices(10**9))]
            if any(claimed[b] for b in behind):
                continue  # in a run it yields there
            alone = any((members[:, x, y, z] > 0).sum() == 1 for x, y, z in behind)
            inside = frozenset(numbers[b] for b in behind if b in numbers)
            whole = bool(cells.full[w][u, v])
            found[w, u, v] = _Column(w, u, v, inside, whole, alone and whole)
    return sorted(found.values(), key=lambda c: (not c.whole, ranks[c.wall], c.u, c.v))


def _with(place: Place, axis: int, value: int) -> Place:
    x, y, z = (value if k == axis else place[k] for k in range(3))
    return x, y, z


class _Search:
    """Chooses the columns of a block: little left empty, nothing loose, low walls first."""

    def __init__(
        self,
        cells: Cells,
        block: Sequence[Place],
        columns: Sequence[_Column],
        kept: Mapping[Spot, bool],
        alone: Sequence[Flags],
    ) -> None:
        self.columns, self.kept, self.alone = columns, kept, alone
        self.sizes = [_volume(cells, place) for place in block]
        masks = [sum(1 << n for n in c.cells) for c in columns]
        voids = [self._partly(c) for c in columns]
        every = list(zip(columns, masks, voids, strict=True))
        self.over = [[some for some in every if n in some[0].cells] for n in range(len(block))]
        self.found: list[_Column] = []
        self.cost = (np.inf, 1)
        self.left = MOST_STEPS

    def best(self) -> list[_Column]:
        """The columns that are kept."""
        start: list[_Column] = []
        for column in self.columns:
            if column.needed and not any(column.cells & other.cells for other in start):
                start.append(column)
        taken = sum(1 << n for c in start for n in c.cells)
        self._choose(start, taken, 0, sum(map(self._partly, start)))
        return self.found

    def _partly(self, column: _Column) -> float:
        """What a column with an aslant border leaves empty: about a half."""
        return 0.0 if column.whole else sum(self.sizes[n] / 2 for n in column.cells)

    def _choose(self, chosen: list[_Column], taken: int, cell: int, void: float) -> None:
        while taken >> cell & 1:
            cell += 1
        # Where nothing is loose any more, only less void is better.
        if self.left <= 0 or void > self.cost[0] + (1e-9 if self.cost[1] else -1e-9):
            return
        self.left -= 1
        if cell == len(self.sizes):
            cost = (void, self._loose(chosen))
            if cost[0] < self.cost[0] - 1e-9 or cost[1] < self.cost[1]:
                self.cost, self.found = cost, list(chosen)
            return
        for column, mask, more in self.over[cell]:
            if not mask & taken:
                self._choose([*chosen, column], taken | mask, cell + 1, void + more)
        self._choose(chosen, taken | 1 << cell, cell + 1, void + self.sizes[cell])

    def _loose(self, chosen: Sequence[_Column]) -> int:
        """How many chosen columns hang together with the rest of their walls nowhere."""
        held = {c.spot for c in chosen}
        waiting = [spot for spot in held if any(map(self._holds, _beside(spot)))]
        reached = set(waiting)
        while waiting:
            for spot in _beside(waiting.pop()):
                if spot in held and spot not in reached:
                    reached.add(spot)
                    waiting.append(spot)
        return len(held) - len(reached)

    def _holds(self, spot: Spot) -> bool:
        """Whether a wall has material at a spot outside this block."""
        if spot in self.kept:
            return self.kept[spot]
        w, u, v = spot
        there = self.alone[w]
        return bool(0 <= u < there.shape[0] and 0 <= v < there.shape[1] and there[u, v])


def _volume(cells: Cells, place: Place) -> float:
    sides = [line[n + 1] - line[n] for line, n in zip(cells.lines, place, strict=True)]
    return float(np.prod(sides))


def _beside(spot: Spot) -> tuple[Spot, ...]:
    w, u, v = spot
    return (w, u - 1, v), (w, u + 1, v), (w, u, v - 1), (w, u, v + 1)


def _pieces(
    cells: Cells,
    block: Sequence[Place],
    columns: Sequence[_Column],
    owners: Mapping[int, int],
) -> list[Piece]:
    pieces = []
    for n, place in enumerate(block):
        walls = list(dict.fromkeys(c.wall for c in columns if n in c.cells))
        owner = owners.get(n, walls[0] if walls else -1)
        low, high = (
            [float(line[k + end]) for line, k in zip(cells.lines, place, strict=True)]
            for end in (0, 1)
        )
        pieces.append(
            Piece(
                (low[0], low[1], low[2]),
                (high[0], high[1], high[2]),
                owner,
                tuple(w for w in walls if w != owner),
            )
        )
    return pieces
