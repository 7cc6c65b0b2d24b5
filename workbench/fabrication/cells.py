"""The cell model: which walls share which part of space, and how they meet there.

Terms
-----
cell
    A box between neighbouring grid lines; the lines are the borders of all slabs and regions.
member
    A wall whose slab holds the cell: wholly (full), or partly where its border runs aslant.
run
    A row of cells in which two walls meet, along the third axis, in one way:
    L (a corner: both end), T (one passes, the other ends on it), X (both pass).
yield
    Where two walls meet and a third ends on both of them, the third one takes no part.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import combinations, pairwise

import numpy as np
import shapely
from numpy.typing import NDArray

from ...solver.values import Array
from .walls import Wall

Flags = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class Run:
    """Two walls meeting in one way along `axis`, from `low_mm` to `high_mm`.

    Parameters
    ----------
    one, two : int
        Numbers of the walls. Of a T, `one` passes and `two` ends on it.
    kind : str
        ``L``, ``T`` or ``X``.
    """

    one: int
    two: int
    kind: str
    axis: int
    low_mm: float
    high_mm: float


@dataclass(slots=True, eq=False)
class Cells:
    """The grid of a model's walls.

    Parameters
    ----------
    walls : sequence of Wall
    """

    walls: Sequence[Wall]
    lines: tuple[Array, ...] = field(init=False)
    spans: list[slice] = field(init=False)
    full: list[Flags] = field(init=False)
    partial: list[Flags] = field(init=False)

    def __post_init__(self) -> None:
        self.lines = tuple(_grid_lines(self.walls, k) for k in range(3))
        self.spans = [self._span(wall) for wall in self.walls]
        covers = [self._cover(wall) for wall in self.walls]
        self.full = [cover > 1 - 1e-9 for cover in covers]
        self.partial = [(cover > 1e-9) & (cover <= 1 - 1e-9) for cover in covers]

    def _span(self, wall: Wall) -> slice:
        low, high = np.searchsorted(
            self.lines[wall.axis], [wall.low_mm - 1e-7, wall.high_mm - 1e-7]
        )
        return slice(int(low), int(high))

    def _cover(self, wall: Wall) -> Array:
        """Share of each cell of the wall's plane that its region covers, 0 to 1."""
        u, v = (self.lines[k] for k in wall.plane_axes)
        low_u, low_v = np.meshgrid(u[:-1], v[:-1], indexing="ij")
        high_u, high_v = np.meshgrid(u[1:], v[1:], indexing="ij")
        boxes = shapely.box(low_u, low_v, high_u, high_v)
        shapely.prepare(wall.region)
        covered: Array = shapely.covers(wall.region, boxes).astype(float)
        open_ = (covered == 0) & shapely.intersects(wall.region, boxes)
        areas = shapely.area(shapely.intersection(wall.region, boxes[open_]))
        covered[open_] = areas / shapely.area(boxes[open_])
        return covered

    def in_plane(self, flags: Flags, wall: int, along: int, cells: slice) -> Flags:
        """A wall's flags, the axis `along` cut to `cells` and put first."""
        first = self.walls[wall].plane_axes[0] == along
        turned: Flags = (flags if first else flags.T)[cells, :]
        return turned

    def members(self) -> NDArray[np.int8]:
        """0, 1 (partly) or 2 (fully) for each wall and cell, shape (walls, nx, ny, nz)."""
        shape = tuple(len(line) - 1 for line in self.lines)
        members = np.zeros((len(self.walls), *shape), dtype=np.int8)
        for i, wall in enumerate(self.walls):
            # (axis, u, v) is (k, k + 1, k + 2): a view with the axes rolled.
            view = np.moveaxis(members[i], (wall.axis, *wall.plane_axes), (0, 1, 2))
            view[self.spans[i]] = 2 * self.full[i] + self.partial[i]
        return members


def _grid_lines(walls: Sequence[Wall], axis: int) -> Array:
    values: list[float] = []
    for wall in walls:
        if wall.axis == axis:
            values += [wall.low_mm, wall.high_mm]
        else:
            column = wall.plane_axes.index(axis)
            values += shapely.get_coordinates(wall.region)[:, column].tolist()
    return np.unique(np.round(values, 6))


def meetings(cells: Cells) -> tuple[list[Run], Flags]:
    """How the walls meet: all runs, and the cells that are in them.

    Parameters
    ----------
    cells : Cells

    Returns
    -------
    runs : list of Run
    claimed : array of bool
        One for each cell.
    """
    members = cells.members()
    kinds = _kinds(cells)
    claimed = np.zeros(members.shape[1:], dtype=bool)
    runs: list[Run] = []
    for (i, j), kind in kinds.items():
        axis = 3 - cells.walls[i].axis - cells.walls[j].axis
        zone = _zone(cells, i, j)
        free = np.array([_only_two(cells, kinds, members, i, j, g) for g in range(len(kind))])
        kind = np.where(free, kind, "")
        for start, stop in _stretches(kind):
            zone[axis] = slice(start, stop)
            claimed[tuple(zone)] = True
            one, two = (j, i) if kind[start] == "t" else (i, j)
            ends = cells.lines[axis][[start, stop]]
            runs.append(
                Run(one, two, str(kind[start]).upper(), axis, float(ends[0]), float(ends[1]))
            )
    return runs, claimed


def _zone(cells: Cells, i: int, j: int) -> list[slice]:
    """The cells of both slabs, for all positions along the third axis."""
    zone = [slice(None)] * 3
    zone[cells.walls[i].axis] = cells.spans[i]
    zone[cells.walls[j].axis] = cells.spans[j]
    return zone


def _kinds(cells: Cells) -> dict[tuple[int, int], NDArray[np.str_]]:
    """For each pair of walls, along its third axis: L, T (the first passes), t, X or nothing."""
    kinds = {}
    for i, j in combinations(range(len(cells.walls)), 2):
        if cells.walls[i].axis == cells.walls[j].axis:
            continue
        here_i, passes_i = _across(cells, i, j)
        here_j, passes_j = _across(cells, j, i)
        both = here_i & here_j
        if both.any():
            names = np.array([["L", "t"], ["T", "X"]])[passes_i.astype(int), passes_j.astype(int)]
            kinds[i, j] = np.where(both, names, "")
    return kinds


def _across(cells: Cells, wall: int, other: int) -> tuple[Flags, Flags]:
    """Where a wall fills the other's slab, and where it goes on beyond both sides of it."""
    span, along = cells.spans[other], cells.walls[other].axis
    flags = cells.in_plane(cells.full[wall], wall, along, slice(None))
    nothing = np.zeros(flags.shape[1], dtype=bool)
    before = flags[span.start - 1] if span.start > 0 else nothing
    after = flags[span.stop] if span.stop < len(flags) else nothing
    here: Flags = np.all(flags[span], axis=0, keepdims=True)[0]
    beyond: Flags = before & after
    return here, beyond


def _only_two(
    cells: Cells,
    kinds: dict[tuple[int, int], NDArray[np.str_]],
    members: NDArray[np.int8],
    i: int,
    j: int,
    g: int,
) -> bool:
    """Whether two walls are alone at place g of their run, but for walls that yield."""
    zone = _zone(cells, i, j)
    zone[3 - cells.walls[i].axis - cells.walls[j].axis] = slice(g, g + 1)
    there = members[(slice(None), *zone)].reshape(len(cells.walls), -1).max(axis=1)
    thirds = set(np.flatnonzero(there).tolist()) - {i, j}
    return all(
        _ends_on(cells, kinds, third, i, cells.spans[j], cells.walls[j].axis)
        and _ends_on(cells, kinds, third, j, cells.spans[i], cells.walls[i].axis)
        for third in sorted(thirds)
    )


def _ends_on(
    cells: Cells,
    kinds: dict[tuple[int, int], NDArray[np.str_]],
    wall: int,
    other: int,
    span: slice,
    axis: int,
) -> bool:
    """Whether a wall ends on another one all along a span of the given axis."""
    if 3 - cells.walls[wall].axis - cells.walls[other].axis != axis:
        return False
    pair, name = ((wall, other), "t") if wall < other else ((other, wall), "T")
    return pair in kinds and bool((kinds[pair][span] == name).all())


def _stretches(kind: NDArray[np.str_]) -> list[tuple[int, int]]:
    """From where to where one kind goes on."""
    borders = np.flatnonzero(kind[1:] != kind[:-1]) + 1
    ends = [0, *borders.tolist(), len(kind)]
    return [(a, b) for a, b in pairwise(ends) if kind[a]]
