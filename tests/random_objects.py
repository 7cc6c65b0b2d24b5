"""Random objects that belong to no family of `incontext.solver.synthetic`, whose truth is known."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import product

import numpy as np

from incontext.solver.annotations import (
    Annotation,
    EqualLength,
    OnFace,
    Parallel,
    SymmetryPlane,
)
from incontext.solver.graph import Face
from incontext.solver.synthetic import Shape, box, from_loops, prism
from incontext.solver.synthetic.shapes import BOX_LOOPS, v

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


def upright_prism(rng: np.random.Generator) -> Shape:
    """Over a random polygon of four to eight corners."""
    n = int(rng.integers(4, 9))
    angle = 2 * np.pi * (np.arange(n) + rng.uniform(-0.3, 0.3, n)) / n
    radius = rng.uniform(60, 130, n)
    X = [[r * np.cos(a), r * np.sin(a), z] for z in (0, rng.uniform(60, 200))
         for r, a in zip(radius, angle, strict=True)]  # fmt: skip
    sides = [(i, (i + 1) % n, (i + 1) % n + n, i + n) for i in range(n)]
    return from_loops("upright prism", X, [range(n), range(n, 2 * n), *sides])


def profile(rng: np.random.Generator) -> Shape:
    """A skyline of level, upright and slanted strokes, extruded."""
    n = int(rng.integers(2, 5))
    xs = np.cumsum(rng.uniform(30, 90, n))
    top = [(0.0, float(rng.uniform(40, 160)))]
    for x in xs:
        level = rng.random() < 0.5
        top.append((float(x), top[-1][1] if level else float(rng.uniform(30, 160))))
        if x != xs[-1] and rng.random() < 0.5:
            top.append((float(x), top[-1][1] + float(rng.uniform(25, 60))))
    corners = [(0.0, 0.0), (float(xs[-1]), 0.0), *reversed(top)]
    return prism("profile", corners, float(rng.uniform(70, 220)))


def podium(rng: np.random.Generator) -> Shape:
    """Boxes one on the other, each set back from the rim of the one below."""
    low, high, z = np.zeros(2), rng.uniform(180, 320, 2), 0.0
    X: list[list[float]] = []
    loops: list[tuple[int, ...]] = []
    for k in range(int(rng.integers(2, 4))):
        h = rng.uniform(30, 90)
        (x0, y0), (x1, y1) = low, high
        ring = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        X += [[x, y, up] for up in (z, z + h) for x, y in ring]
        # Nobody sees what it stands on, but for the ground.
        seen = BOX_LOOPS[1:] if k else BOX_LOOPS
        loops += [tuple(8 * k + i for i in loop) for loop in seen]
        z += h
        low, high = low + rng.uniform(15, 45, 2), high - rng.uniform(15, 45, 2)
    shape = from_loops("podium", X, loops)
    edge = {pair: f"e{k}" for k, pair in enumerate(shape.edges)}
    faces = {f"f{k}": Face(tuple(map(v, loop))) for k, loop in enumerate(shape.loops)}
    more: dict[str, Annotation] = {}
    for k in range(8, len(X), 8):
        more[f"x{k}"] = Parallel((edge[0, 1], edge[k, k + 1]))
        more[f"y{k}"] = Parallel((edge[1, 2], edge[k + 1, k + 2]))
        more[f"on{k}"] = OnFace(v(k), f"f{shape.loops.index((k - 4, k - 3, k - 2, k - 1))}")
    return replace(shape, annotations={**shape.annotations, **more}, faces=faces)


def cut_pyramid(rng: np.random.Generator) -> Shape:
    """Over a rectangle, its top level; two planes of symmetry."""
    w, d = rng.uniform(100, 240, 2)
    h, s = rng.uniform(60, 200), rng.uniform(0.35, 0.8)
    low = np.array([[-w, -d], [w, -d], [w, d], [-w, d]]) / 2
    X = [[*p, 0.0] for p in low] + [[*(s * p), h] for p in low]
    shape = from_loops("cut pyramid", X, BOX_LOOPS)
    more: dict[str, Annotation] = {"par0": Parallel(("e0", "e4")), "par1": Parallel(("e1", "e5"))}
    more |= {
        f"sym{k}": SymmetryPlane(tuple(f"e{i}" for i in (k, k + 2, k + 4, k + 6))) for k in (0, 1)
    }
    return replace(shape, annotations={**shape.annotations, **more})


def hip_roof(rng: np.random.Generator) -> Shape:
    """A box under a roof whose ridge is shorter than its eaves; its slopes are equal in pairs."""
    w, d = rng.uniform(180, 300), rng.uniform(100, 170)
    wall, rise, inset = rng.uniform(60, 140), rng.uniform(40, 120), rng.uniform(25, 70)
    base = box(w, d, wall)
    X = [*base.X.tolist(), [inset, d / 2, wall + rise], [w - inset, d / 2, wall + rise]]
    loops = [*(loop for loop in BOX_LOOPS if loop != (4, 5, 6, 7)),
             (4, 5, 9, 8), (5, 6, 9), (6, 7, 8, 9), (7, 4, 8)]  # fmt: skip
    shape = from_loops("hip roof", X, loops)
    edge = {pair: f"e{k}" for k, pair in enumerate(shape.edges)}
    more = {
        "ridge": Parallel((edge[8, 9], edge[0, 1])),
        "slopes": EqualLength((edge[4, 8], edge[5, 9], edge[6, 9], edge[7, 8])),
    }
    return replace(shape, annotations={**shape.annotations, **more})


def turned_boxes(rng: np.random.Generator) -> Shape:
    """Two boxes beside each other on the ground, one turned."""
    first, second = (box(*rng.uniform(60, 180, 3)) for _ in range(2))
    a = np.radians(rng.uniform(15, 75))
    X = second.X.copy()
    X[:, :2] = X[:, :2] @ np.array([[np.cos(a), np.sin(a)], [-np.sin(a), np.cos(a)]])
    X[:, 0] += first.X[:, 0].max() + rng.uniform(10, 40) - X[:, 0].min()
    loops = [*first.loops, *(tuple(i + 8 for i in loop) for loop in second.loops)]
    return from_loops("turned boxes", np.vstack([first.X, X]), loops)


def gable(rng: np.random.Generator) -> Shape:
    """An uneven gable with a porch in front of it."""
    w, d, wall, rise = rng.uniform((120, 120, 60, 30), (220, 220, 120, 90))
    out, wide, high = rng.uniform((30, 0.3 * w, 0.4 * wall), (70, 0.6 * w, 0.9 * wall))
    ridge, left = w * rng.uniform(0.3, 0.7), 0.1 * w
    front = [(0, 0), (w, 0), (w, wall), (ridge, wall + rise), (0, wall)]
    door = [(left, 0), (left + wide, 0), (left + wide, high), (left, high)]
    X = [[x, y, z] for y in (0.0, d) for x, z in front]
    X += [[x, y, z] for y in (0.0, -out) for x, z in door]
    sides = [(i, (i + 1) % 5, (i + 1) % 5 + 5, i + 5) for i in range(5)]
    porch = [(10 + i, 10 + (i + 1) % 4, 14 + (i + 1) % 4, 14 + i) for i in range(4)]
    loops = [range(5), range(5, 10), *sides, (14, 15, 16, 17), *porch]
    shape = from_loops("gable with porch", X, loops)
    edge = {pair: f"e{k}" for k, pair in enumerate(shape.edges)}
    along = Parallel((edge[0, 1], edge[10, 11]))
    return replace(shape, annotations={**shape.annotations, "porch": along})


OBJECTS: tuple[Callable[[np.random.Generator], Shape], ...] = (
    polycube, upright_prism, profile, podium, cut_pyramid, hip_roof, turned_boxes, gable,
)  # fmt: skip
