"""Shapes of random sizes in no family of the benchmark, with what a person would say of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scenes import Shape, from_loops, photograph, prism, v

from incontext.solver.annotations import EqualLength, OnFace, Parallel, SymmetryPlane
from incontext.solver.graph import Face
from incontext.solver.synthetic.shapes import BOX_LOOPS

CORNERS = ((0, 0), (1, 0), (1, 1), (0, 1))


def upright(name: str, outline: Sequence[tuple[float, float]], height: float) -> Shape:
    """A floor plan, and the same at a height."""
    n = len(outline)
    X = [(x, y, z) for z in (0, height) for x, y in outline]
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    return from_loops(name, X, [range(n), range(n, 2 * n), *sides])


def _named(shape: Shape):
    edges = {frozenset(pair): f"e{k}" for k, pair in enumerate(shape.edges)}
    return lambda *ends: edges[frozenset(ends)]


def _saying(shape: Shape, **more) -> Shape:
    faces = {f"f{k}": Face(tuple(map(v, loop))) for k, loop in enumerate(shape.loops)}
    told = any(isinstance(a, OnFace) for a in more.values())
    return replace(
        shape, annotations={**shape.annotations, **more}, faces=faces if told else shape.faces
    )


def podium(rng) -> Shape:
    """Columns of different heights side by side, lying or standing."""
    n = int(rng.integers(2, 5))
    xs = [0.0, *np.cumsum(rng.uniform(40, 110, n)).tolist()]
    heights = (rng.permutation(n) * 40 + rng.uniform(45, 75, n)).tolist()
    profile = [(0.0, 0.0), (xs[-1], 0.0)]
    for k in reversed(range(n)):
        profile += [(xs[k + 1], heights[k]), (xs[k], heights[k])]
    make = prism if rng.random() < 0.5 else upright
    return make("podium", profile, rng.uniform(60, 200))


def three_sided(rng) -> Shape:
    """A triangular prism: two directions alone are square to each other."""
    a, b = rng.uniform(90, 200), rng.uniform(60, 180)
    make = prism if rng.random() < 0.5 else upright
    return make(
        "three-sided", [(0, 0), (a, 0), (rng.uniform(0.2, 0.8) * a, b)], rng.uniform(60, 180)
    )


def hip_roof(rng) -> Shape:
    """A house whose roof slants on all four sides."""
    w, d, h = rng.uniform(160, 300), rng.uniform(110, 200), rng.uniform(70, 150)
    top, in_ = h + rng.uniform(30, 90), rng.uniform(0.15, 0.35) * w
    X = [[x * w, y * d, z] for z in (0, h) for x, y in CORNERS]
    X += [[in_, d / 2, top], [w - in_, d / 2, top]]
    roof = [(4, 5, 9, 8), (5, 6, 9), (6, 7, 8, 9), (7, 4, 8)]
    shape = from_loops("hip roof", X, [BOX_LOOPS[0], *BOX_LOOPS[2:], *roof])
    e = _named(shape)
    return _saying(
        shape,
        ridge=Parallel((e(8, 9), e(0, 1))),
        across=SymmetryPlane((e(0, 1), e(2, 3), e(4, 5), e(6, 7), e(8, 9))),
        along=SymmetryPlane((e(1, 2), e(3, 0), e(5, 6), e(7, 4))),
    )


def frustum(rng) -> Shape:
    """Narrower above than below, two planes of symmetry."""
    w, d, h = rng.uniform(120, 260), rng.uniform(120, 260), rng.uniform(60, 180)
    i, j = rng.uniform(0.12, 0.35) * w, rng.uniform(0.12, 0.35) * d
    rim = [[i + x * (w - 2 * i), j + y * (d - 2 * j), h] for x, y in CORNERS]
    shape = from_loops("frustum", [[x * w, y * d, 0.0] for x, y in CORNERS] + rim, BOX_LOOPS)
    planes = {
        f"sym{k}": SymmetryPlane((f"e{k}", f"e{k + 2}", f"e{k + 4}", f"e{k + 6}")) for k in (0, 1)
    }
    return _saying(shape, par0=Parallel(("e0", "e4")), par1=Parallel(("e1", "e5")), **planes)


def folding_screen(rng) -> Shape:
    """Panels of one width at angles that nobody tells."""
    n, turn, width = int(rng.integers(3, 5)), rng.uniform(-0.3, 0.3), rng.uniform(60, 110)
    at = [np.zeros(2)]
    for k in range(n):
        turn += rng.uniform(0.6, 1.2) * (-1) ** k
        at.append(at[-1] + width * np.array([np.cos(turn), np.sin(turn)]))
    X = [[*p, z] for z in (0.0, rng.uniform(120, 240)) for p in at]
    loops = [(i, i + 1, i + n + 2, i + n + 1) for i in range(n)]
    shape = from_loops("folding screen", X, loops)
    e = _named(shape)
    return _saying(shape, equal=EqualLength(tuple(e(i, i + 1) for i in range(n))))


def box_on_box(rng) -> Shape:
    """A smaller box somewhere on a larger one."""
    size, low, part = rng.uniform(120, 240, 3), rng.uniform(0.05, 0.3, 2), rng.uniform(0.3, 0.6, 2)
    high = rng.uniform(30, 120)
    X = [[x * size[0], y * size[1], z] for z in (0, size[2]) for x, y in CORNERS]
    X += [
        [*(size[:2] * (low + part * corner)), size[2] + z] for z in (0, high) for corner in CORNERS
    ]
    shape = from_loops("box on box", X, [*BOX_LOOPS, *(tuple(8 + i for i in r) for r in BOX_LOOPS)])
    e = _named(shape)
    return _saying(shape, aligned=Parallel((e(0, 1), e(8, 9))), on=OnFace("v8", "f1"))


def notched(rng) -> Shape:
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


RANDOM = {
    f.__name__: f
    for f in (podium, three_sided, hip_roof, frustum, folding_screen, box_on_box, notched)
}


def drawn(name: str, run: int, **how):
    """A random one, photographed from a random side."""
    rng = np.random.default_rng([run, *name.encode()])
    return photograph(RANDOM[name](rng), rng, **how)
