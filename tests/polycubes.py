"""Random bodies of blocks joined face to face, as shapes whose truth is known."""

from __future__ import annotations

from itertools import product

import numpy as np

from incontext.solver.synthetic import Shape, from_loops

Cells = set[tuple[int, int, int]]


def polycube(rng: np.random.Generator) -> Shape:
    """Blocks joined face to face on the ground, rows of random widths; outlines only."""
    while True:
        shape = _outlines(_grown(rng, int(rng.integers(3, 7))), rng)
        if shape is not None and 10 <= len(shape.X) <= 40:
            return shape


def _grown(rng: np.random.Generator, n: int) -> Cells:
    cells = {(0, 0, 0)}
    while len(cells) < n:
        around = list(cells)
        at = list(around[int(rng.integers(len(around)))])
        at[int(rng.integers(3))] += int(rng.choice([-1, 1]))
        if at[2] >= 0:
            cells.add((at[0], at[1], at[2]))
    return cells


def _outlines(cells: Cells, rng: np.random.Generator) -> Shape | None:
    """The faces of joined blocks; None where one has a hole or touches itself at a corner."""
    loops: list[list[tuple[int, ...]]] = []
    for axis, side in product(range(3), (0, 1)):
        out = np.eye(3, dtype=int)[axis] * (2 * side - 1)
        bare = [c for c in cells if tuple(np.add(c, out).tolist()) not in cells]
        for level in {c[axis] for c in bare}:
            flat = {c for c in bare if c[axis] == level}
            while flat:
                part = _connected(flat, axis)
                flat -= part
                loop = _outline(part, axis, side)
                if loop is None:
                    return None
                loops.append(loop)
    corners = sorted({p for loop in loops for p in loop})
    index = {p: i for i, p in enumerate(corners)}
    lines = [np.cumsum([0.0, *rng.uniform(40, 110, 16)]) for _ in range(3)]
    X = [[lines[0][p[0] + 8], lines[1][p[1] + 8], lines[2][p[2]]] for p in corners]
    split = [[index[p] for p in _with_points_between(loop, corners)] for loop in loops]
    return from_loops("polycube", X, split)


def _connected(flat: Cells, axis: int) -> Cells:
    rim = [min(flat)]
    found = set(rim)
    while rim:
        at = rim.pop()
        for k, step in product({0, 1, 2} - {axis}, (-1, 1)):
            to = list(at)
            to[k] += step
            cell = (to[0], to[1], to[2])
            if cell in flat - found:
                found.add(cell)
                rim.append(cell)
    return found


def _outline(part: Cells, axis: int, side: int) -> list[tuple[int, ...]] | None:
    i, j = (k for k in range(3) if k != axis)
    follows: dict[tuple[int, ...], tuple[int, ...]] = {}
    ways = [((0, 0), (1, 0)), ((1, 0), (1, 1)), ((1, 1), (0, 1)), ((0, 1), (0, 0))]
    sides = {(_corner(c, axis, side, i, j, a), _corner(c, axis, side, i, j, b))
             for c in part for a, b in ways}  # fmt: skip
    for a, b in sides:
        if (b, a) not in sides:
            if a in follows:
                return None
            follows[a] = b
    loop = [min(follows)]
    while follows[loop[-1]] != loop[0]:
        loop.append(follows[loop[-1]])
    if len(loop) < len(follows):
        return None
    around = list(zip(loop[-1:] + loop[:-1], loop, loop[1:] + loop[:1], strict=True))
    return [b for a, b, c in around if tuple(np.subtract(b, a)) != tuple(np.subtract(c, b))]


def _corner(
    c: tuple[int, int, int], axis: int, side: int, i: int, j: int, at: tuple[int, int]
) -> tuple[int, ...]:
    p = list(c)
    p[axis] += side
    p[i] += at[0]
    p[j] += at[1]
    return tuple(p)


def _with_points_between(
    loop: list[tuple[int, ...]], corners: list[tuple[int, ...]]
) -> list[tuple[int, ...]]:
    found = []
    for a, b in zip(loop, loop[1:] + loop[:1], strict=True):
        (k,) = np.flatnonzero(np.subtract(b, a))
        along = [p for p in corners if all(p[m] == a[m] for m in range(3) if m != k)
                 and min(a[k], b[k]) < p[k] < max(a[k], b[k])]  # fmt: skip
        found += [a, *sorted(along, key=lambda p: abs(p[k] - a[k]))]
    return found
