"""Random objects in no family of the benchmark, with what a person would say of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np
from polycubes import polycube

from incontext.solver.annotations import (
    Annotation,
    EqualLength,
    OnFace,
    Parallel,
    SymmetryPlane,
)
from incontext.solver.graph import Face
from incontext.solver.synthetic import Photograph, Shape, box, from_loops, photograph, prism
from incontext.solver.synthetic.shapes import BOX_LOOPS, v

Edge = Callable[[int, int], str]
CORNERS = ((0, 0), (1, 0), (1, 1), (0, 1))


def upright(name: str, outline: Sequence[tuple[float, float]], height: float) -> Shape:
    """A floor plan, and the same at a height."""
    n = len(outline)
    X = [(x, y, z) for z in (0, height) for x, y in outline]
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    return from_loops(name, X, [range(n), range(n, 2 * n), *sides])


def _edges(shape: Shape) -> Edge:
    """The edge between two vertices."""
    edges = {frozenset(pair): f"e{k}" for k, pair in enumerate(shape.edges)}
    return lambda a, b: edges[frozenset((a, b))]


def _saying(shape: Shape, **more: Annotation) -> Shape:
    faces = {f"f{k}": Face(tuple(map(v, loop))) for k, loop in enumerate(shape.loops)}
    told = any(isinstance(a, OnFace) for a in more.values())
    return replace(
        shape, annotations={**shape.annotations, **more}, faces=faces if told else shape.faces
    )


def upright_prism(rng: np.random.Generator) -> Shape:
    """Over a random polygon of four to eight corners."""
    n = int(rng.integers(4, 9))
    angle = 2 * np.pi * (np.arange(n) + rng.uniform(-0.3, 0.3, n)) / n
    radius = rng.uniform(60, 130, n)
    outline = [
        (float(r * np.cos(a)), float(r * np.sin(a))) for r, a in zip(radius, angle, strict=True)
    ]
    return upright("upright prism", outline, float(rng.uniform(60, 200)))


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
    e = _edges(shape)
    more: dict[str, Annotation] = {}
    for k in range(8, len(X), 8):
        more[f"x{k}"] = Parallel((e(0, 1), e(k, k + 1)))
        more[f"y{k}"] = Parallel((e(1, 2), e(k + 1, k + 2)))
        more[f"on{k}"] = OnFace(v(k), f"f{shape.loops.index((k - 4, k - 3, k - 2, k - 1))}")
    return _saying(shape, **more)


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
    e = _edges(shape)
    return _saying(shape, porch=Parallel((e(0, 1), e(10, 11))))


def columns(rng: np.random.Generator) -> Shape:
    """Columns of different heights side by side, lying or standing."""
    n = int(rng.integers(2, 5))
    xs = [0.0, *np.cumsum(rng.uniform(40, 110, n)).tolist()]
    heights = (rng.permutation(n) * 40 + rng.uniform(45, 75, n)).tolist()
    profile = [(0.0, 0.0), (xs[-1], 0.0)]
    for k in reversed(range(n)):
        profile += [(xs[k + 1], heights[k]), (xs[k], heights[k])]
    make = prism if rng.random() < 0.5 else upright
    return make("columns", profile, rng.uniform(60, 200))


def three_sided(rng: np.random.Generator) -> Shape:
    """A triangular prism: two directions alone are square to each other."""
    a, b = rng.uniform(90, 200), rng.uniform(60, 180)
    make = prism if rng.random() < 0.5 else upright
    return make(
        "three-sided", [(0, 0), (a, 0), (rng.uniform(0.2, 0.8) * a, b)], rng.uniform(60, 180)
    )


def hip_roof(rng: np.random.Generator) -> Shape:
    """A house whose roof slants on all four sides."""
    w, d, h = rng.uniform(160, 300), rng.uniform(110, 200), rng.uniform(70, 150)
    top, in_ = h + rng.uniform(30, 90), rng.uniform(0.15, 0.35) * w
    X = [[x * w, y * d, z] for z in (0, h) for x, y in CORNERS]
    X += [[in_, d / 2, top], [w - in_, d / 2, top]]
    roof = [(4, 5, 9, 8), (5, 6, 9), (6, 7, 8, 9), (7, 4, 8)]
    shape = from_loops("hip roof", X, [BOX_LOOPS[0], *BOX_LOOPS[2:], *roof])
    e = _edges(shape)
    return _saying(
        shape,
        ridge=Parallel((e(8, 9), e(0, 1))),
        across=SymmetryPlane((e(0, 1), e(2, 3), e(4, 5), e(6, 7), e(8, 9))),
        along=SymmetryPlane((e(1, 2), e(3, 0), e(5, 6), e(7, 4))),
    )


def frustum(rng: np.random.Generator) -> Shape:
    """Narrower above than below, two planes of symmetry."""
    w, d, h = rng.uniform(120, 260), rng.uniform(120, 260), rng.uniform(60, 180)
    i, j = rng.uniform(0.12, 0.35) * w, rng.uniform(0.12, 0.35) * d
    rim = [[i + x * (w - 2 * i), j + y * (d - 2 * j), h] for x, y in CORNERS]
    shape = from_loops("frustum", [[x * w, y * d, 0.0] for x, y in CORNERS] + rim, BOX_LOOPS)
    planes = {
        f"sym{k}": SymmetryPlane((f"e{k}", f"e{k + 2}", f"e{k + 4}", f"e{k + 6}")) for k in (0, 1)
    }
    return _saying(shape, par0=Parallel(("e0", "e4")), par1=Parallel(("e1", "e5")), **planes)


def folding_screen(rng: np.random.Generator) -> Shape:
    """Panels of one width at angles that nobody tells."""
    n, turn, width = int(rng.integers(3, 5)), rng.uniform(-0.3, 0.3), rng.uniform(60, 110)
    at = [np.zeros(2)]
    for k in range(n):
        turn += rng.uniform(0.6, 1.2) * (-1) ** k
        at.append(at[-1] + width * np.array([np.cos(turn), np.sin(turn)]))
    X = [[*p, z] for z in (0.0, rng.uniform(120, 240)) for p in at]
    loops = [(i, i + 1, i + n + 2, i + n + 1) for i in range(n)]
    shape = from_loops("folding screen", X, loops)
    e = _edges(shape)
    return _saying(shape, equal=EqualLength(tuple(e(i, i + 1) for i in range(n))))


def box_on_box(rng: np.random.Generator) -> Shape:
    """A smaller box somewhere on a larger one."""
    size, low, part = rng.uniform(120, 240, 3), rng.uniform(0.05, 0.3, 2), rng.uniform(0.3, 0.6, 2)
    high = rng.uniform(30, 120)
    X = [[x * size[0], y * size[1], z] for z in (0, size[2]) for x, y in CORNERS]
    X += [
        [*(size[:2] * (low + part * corner)), size[2] + z] for z in (0, high) for corner in CORNERS
    ]
    shape = from_loops("box on box", X, [*BOX_LOOPS, *(tuple(8 + i for i in r) for r in BOX_LOOPS)])
    e = _edges(shape)
    return _saying(shape, aligned=Parallel((e(0, 1), e(8, 9))), on=OnFace("v8", "f1"))


def notched(rng: np.random.Generator) -> Shape:
    """A box without one of its corners."""
    (w, d, h), part = rng.uniform(120, 240, 3), rng.uniform(0.3, 0.7, 3)
    a, b, c = part * [w, d, h]
    X = [
        (0, 0, 0), (w, 0, 0), (w, d, 0), (0, d, 0), (0, 0, h), (w, 0, c), (w, d, h), (0, d, h),
        (a, 0, h), (a, 0, c), (a, b, h), (a, b, c), (w, b, h), (w, b, c),
    ]  # fmt: skip
    loops = [
        (0, 1, 2, 3), (0, 1, 5, 9, 8, 4), (1, 2, 6, 12, 13, 5), (2, 3, 7, 6), (3, 0, 4, 7),
        (4, 8, 10, 12, 6, 7), (8, 9, 11, 10), (10, 11, 13, 12), (9, 5, 13, 11),
    ]  # fmt: skip
    return from_loops("notched", X, loops)


def box_with_pyramid(rng: np.random.Generator) -> Shape:
    """A box under a pyramid of four equal slopes: equal lengths alone hold its tip."""
    w, d, h, rise = rng.uniform((100, 100, 60, 40), (220, 220, 140, 120))
    X = [*box(w, d, h).X.tolist(), [w / 2, d / 2, h + rise]]
    sides = [(4 + i, 4 + (i + 1) % 4, 8) for i in range(4)]
    shape = from_loops("box with pyramid", X, [BOX_LOOPS[0], *BOX_LOOPS[2:], *sides])
    e = _edges(shape)
    return _saying(shape, slopes=EqualLength(tuple(e(i, 8) for i in range(4, 8))))


def parted_tray(rng: np.random.Generator) -> Shape:
    """A tray with a partition, and a second one from it to a side."""
    w, d, h = rng.uniform((160, 120, 40), (300, 220, 90))
    a, b = rng.uniform(0.3, 0.7, 2) * (w, d)
    floor = [*((x * w, y * d) for x, y in CORNERS), (a, 0), (a, d), (a, b), (w, b)]
    X = [(x, y, z) for z in (0, h) for x, y in floor]
    loops = [
        (0, 4, 1, 7, 2, 5, 3), (0, 4, 12, 8), (4, 1, 9, 12), (1, 7, 15, 9), (7, 2, 10, 15),
        (2, 5, 13, 10), (5, 3, 11, 13), (3, 0, 8, 11), (4, 6, 5, 13, 14, 12), (6, 7, 15, 14),
    ]  # fmt: skip
    return from_loops("parted tray", X, loops)


def parted_hexagon(rng: np.random.Generator) -> Shape:
    """A hexagonal box with a wall from corner to corner."""
    r, h = rng.uniform((60, 60), (120, 200))
    plan = [(float(r * np.cos(a)), float(r * np.sin(a))) for a in np.arange(6) * np.pi / 3]
    bare = upright("parted hexagon", plan, float(h))
    shape = from_loops(bare.name, bare.X.tolist(), [*bare.loops[:1], *bare.loops[2:], (0, 3, 9, 6)])
    e = _edges(shape)
    more: dict[str, Annotation] = {
        f"par{i}": Parallel((e(i, i + 1), e((i + 3) % 6, (i + 4) % 6))) for i in range(3)
    }
    around = tuple(e(i, (i + 1) % 6) for i in range(6))
    return _saying(shape, equal=EqualLength(around), wall=Parallel((e(0, 3), e(1, 2))), **more)


def stool(rng: np.random.Generator) -> Shape:
    """A seat on four square legs of one size."""
    w, d, h, thick, leg = rng.uniform((200, 200, 250, 20, 25), (400, 400, 500, 45, 50))
    near, across, along = 15.0, w - 15 - leg, d - 15 - leg
    parts = [(0.0, 0.0, h - thick, w, d, h)]
    parts += [
        (x, y, 0.0, x + leg, y + leg, h - thick) for x in (near, across) for y in (near, along)
    ]
    X = [
        (x0 + x * (x1 - x0), y0 + y * (y1 - y0), z)
        for x0, y0, z0, x1, y1, z1 in parts
        for z in (z0, z1)
        for x, y in CORNERS
    ]
    loops = [tuple(8 * k + i for i in loop) for k in range(5) for loop in BOX_LOOPS]
    shape = from_loops("stool", X, loops)
    e, legs = _edges(shape), range(8, 40, 8)
    more: dict[str, Annotation] = {f"along{k}": Parallel((e(0, 1), e(k, k + 1))) for k in legs}
    more |= {f"on{k}": OnFace(v(k + 4), "f0") for k in legs}
    sizes = tuple(e(k + i, k + i + 1) for k in legs for i in (0, 1))
    return _saying(shape, equal=EqualLength(sizes), **more)


def gambrel(rng: np.random.Generator) -> Shape:
    """A house under a roof of two slopes on each side, equal in pairs."""
    w, d, h = rng.uniform((140, 120, 70), (240, 260, 140))
    inset, low = rng.uniform((0.12, 0.25), (0.25, 0.4)) * w
    high = low + rng.uniform(0.1, 0.2) * w
    front = [
        (0, 0),
        (w, 0),
        (w, h),
        (w - inset, h + low),
        (w / 2, h + high),
        (inset, h + low),
        (0, h),
    ]
    shape = prism("gambrel", front, float(d))
    e = _edges(shape)
    return _saying(shape, low=EqualLength((e(2, 3), e(5, 6))), high=EqualLength((e(3, 4), e(4, 5))))


def stairs_with_landing(rng: np.random.Generator) -> Shape:
    """Some steps, a long one, and one or two more."""
    depth, rise, landing, wide = rng.uniform((40, 30, 80, 80), (70, 60, 160, 160))
    before, after = int(rng.integers(2, 4)), int(rng.integers(1, 3))
    side, x = [(0.0, 0.0)], 0.0
    for k in range(before + after):
        side.append((x, (k + 1) * rise))
        x += landing if k == before - 1 else depth
        side.append((x, (k + 1) * rise))
    return prism("stairs with landing", [(x, 0.0), *reversed(side)], float(wide))


#: What falsehoods are planted in.
OBJECTS: tuple[Callable[[np.random.Generator], Shape], ...] = (
    polycube, upright_prism, profile, podium, frustum, hip_roof, turned_boxes, gable,
)  # fmt: skip
#: What is drawn exactly and by people who lean.
RANDOM: Mapping[str, Callable[[np.random.Generator], Shape]] = {
    f.__name__: f
    for f in (
        columns, three_sided, hip_roof, frustum, folding_screen, box_on_box, notched,
        box_with_pyramid, parted_tray, parted_hexagon, stool, gambrel, stairs_with_landing,
    )
}  # fmt: skip


def drawn(name: str, run: int, **how) -> Photograph:
    """A random one, photographed from a random side."""
    rng = np.random.default_rng([run, *name.encode()])
    return photograph(RANDOM[name](rng), rng, **how)
