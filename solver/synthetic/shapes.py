"""Shapes whose truth is known.

Terms
-----
shape
    Vertices in the world (mm, z up, standing on z = 0), edges, and the annotations a person gives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace

import numpy as np

from ..annotations import Annotation, EqualLength, Ground, Length, OnFace, Parallel, RightAngle
from ..graph import Face
from ..values import Array


@dataclass(frozen=True)
class Shape:
    """Truth: positions (n, 3) in mm, edges as vertex pairs, loops of faces, annotations."""

    name: str
    X: Array
    edges: tuple[tuple[int, int], ...]
    loops: tuple[tuple[int, ...], ...]
    annotations: dict[str, Annotation] = field(default_factory=dict)
    faces: dict[str, Face] | None = None

    def without(self, *ids: str) -> Shape:
        """The shape with some annotations taken away."""
        kept = {k: a for k, a in self.annotations.items() if k not in ids}
        return replace(self, annotations=kept)


def v(i: int) -> str:
    """The id of the vertex with an index."""
    return f"v{i}"


def from_loops(name: str, X: Iterable[Iterable[float]], loops: Iterable[Iterable[int]]) -> Shape:
    """A shape from its faces; right angles wherever a face has one, the ground, one length."""
    points = np.array(list(map(list, X)), dtype=float)
    rings = tuple(tuple(loop) for loop in loops)
    edges: dict[tuple[int, int], str] = {}
    for loop in rings:
        for a, b in zip(loop, loop[1:] + loop[:1], strict=True):
            edges.setdefault((min(a, b), max(a, b)), f"e{len(edges)}")
    annotations: dict[str, Annotation] = {}
    corners = set()
    for loop in rings:
        for a, b, c in zip(loop[-1:] + loop[:-1], loop, loop[1:] + loop[:1], strict=True):
            p, q = points[a] - points[b], points[c] - points[b]
            if abs(p @ q) < 1e-9 * np.linalg.norm(p) * np.linalg.norm(q):
                pair = tuple(sorted((edges[min(a, b), max(a, b)], edges[min(b, c), max(b, c)])))
                if (b, pair) not in corners:
                    corners.add((b, pair))
                    annotations[f"ra{len(corners)}"] = RightAngle(v(b), pair)
    ground = tuple(v(int(i)) for i in np.flatnonzero(np.abs(points[:, 2]) < 1e-9))
    annotations["ground"] = Ground(ground)
    (a, b), first = next(iter(edges.items()))
    annotations["length"] = Length(first, float(np.linalg.norm(points[a] - points[b])))
    return Shape(name, points, tuple(edges), rings, annotations)


def box(w: float = 200, d: float = 150, h: float = 120, name: str = "box") -> Shape:
    """A box, by default with three different sides."""
    X = [[x, y, z] for z in (0, h) for x, y in ((0, 0), (w, 0), (w, d), (0, d))]
    return from_loops(name, X, BOX_LOOPS)


BOX_LOOPS = ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def prism(name: str, profile: Iterable[tuple[float, float]], depth: float) -> Shape:
    """A profile in x and z, extruded along y."""
    corners = list(profile)
    n = len(corners)
    X = [[x, y, z] for y in (0.0, depth) for x, z in corners]
    sides = [(i, (i + 1) % n, (i + 1) % n + n, i + n) for i in range(n)]
    return from_loops(name, X, [tuple(range(n)), tuple(range(n, 2 * n)), *sides])


def l_shape() -> Shape:
    """The L of [Lau10], Figures 4, 5 and 7: 12 vertices."""
    return prism("L", [(0, 0), (200, 0), (200, 60), (80, 60), (80, 180), (0, 180)], 110)


def wedge() -> Shape:
    """A wedge: one slanted face."""
    return prism("wedge", [(0, 0), (160, 0), (160, 90)], 120)


def house() -> Shape:
    """A box with a saddle roof."""
    return prism("house", [(0, 0), (160, 0), (160, 100), (80, 160), (0, 100)], 200)


def staircase(steps: int = 3) -> Shape:
    """Steps of one size."""
    profile = [(0.0, 0.0), (60.0 * steps, 0.0)]
    for k in range(steps, 0, -1):
        profile += [(60.0 * k, 40.0 * (steps - k + 1)), (60.0 * (k - 1), 40.0 * (steps - k + 1))]
    return prism("staircase", profile, 150)


def bookshelf() -> Shape:
    """An open box with a shelf: 12 vertices, the side edges split where the shelf meets them."""
    w, d, h, s = 220.0, 190.0, 330.0, 250.0
    X = [[x, y, z] for z in (0, s, h) for x, y in ((0, 0), (w, 0), (w, d), (0, d))]
    loops = [
        (0, 1, 2, 3), (4, 5, 6, 7), (8, 9, 10, 11),
        (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7),
        (4, 5, 9, 8), (5, 6, 10, 9), (6, 7, 11, 10), (7, 4, 8, 11),
    ]  # fmt: skip
    return from_loops("bookshelf", X, loops)


def organizer(nx: int = 3, ny: int = 2) -> Shape:
    """nx times ny compartments of unequal sizes."""
    xs = np.cumsum([0.0, *(60.0 + 15 * (i % 3) for i in range(nx))])
    ys = np.cumsum([0.0, *(50.0 + 20 * (i % 2) for i in range(ny))])
    index: dict[tuple[int, int, int], int] = {}
    X: list[list[float]] = []
    for k, z in enumerate((0.0, 90.0)):
        for j, y in enumerate(ys):
            for i, x in enumerate(xs):
                index[i, j, k] = len(X)
                X.append([float(x), float(y), z])
    loops: list[tuple[int, ...]] = []
    for j in range(ny + 1):
        for i in range(nx + 1):
            if i < nx and j < ny:
                for k in (0, 1):
                    corners = ((0, 0), (1, 0), (1, 1), (0, 1))
                    loops.append(tuple(index[i + a, j + b, k] for a, b in corners))
            if i < nx:
                loops.append(
                    (index[i, j, 0], index[i + 1, j, 0], index[i + 1, j, 1], index[i, j, 1])
                )
            if j < ny:
                loops.append(
                    (index[i, j, 0], index[i, j + 1, 0], index[i, j + 1, 1], index[i, j, 1])
                )
    return from_loops(f"organizer {nx * ny}", X, loops)


def hexagonal_box() -> Shape:
    """A regular hexagonal prism: equal sides, opposite sides parallel."""
    angle = np.radians(60 * np.arange(6) + 10)
    X = [[90 * np.cos(a), 90 * np.sin(a), z] for z in (0.0, 110.0) for a in angle]
    sides = [(i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6) for i in range(6)]
    shape = from_loops("hexagonal box", X, [tuple(range(6)), tuple(range(6, 12)), *sides])
    edge = {pair: f"e{k}" for k, pair in enumerate(shape.edges)}
    around = [edge[min(i, (i + 1) % 6), max(i, (i + 1) % 6)] for i in range(6)]
    more: dict[str, Annotation] = {"equal": EqualLength(tuple(around))}
    more |= {f"par{k}": Parallel((around[k], around[k + 3])) for k in range(3)}
    return replace(shape, annotations={**shape.annotations, **more})


def table() -> Shape:
    """A slab on four legs over a lower slab, a drawer's front: 52 vertices, parts touching."""
    parts = [(0, 600, 0, 400, 300, 320)]
    parts += [(x, x + 40, y, y + 40, 0, 300) for x in (20, 540) for y in (20, 340)]
    parts += [(60, 540, 60, 340, 80, 95)]
    X: list[list[float]] = []
    loops: list[tuple[int, ...]] = []
    for x0, x1, y0, y1, z0, z1 in parts:
        base = len(X)
        X += [[x, y, z] for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
        loops += [tuple(base + i for i in loop) for loop in BOX_LOOPS]
    base = len(X)
    X += [[x, 0.0, z] for x, z in ((200, 302), (400, 302), (400, 318), (200, 318))]
    loops.append(tuple(range(base, base + 4)))
    shape = from_loops("table", X, loops)
    edge = {pair: f"e{k}" for k, pair in enumerate(shape.edges)}
    along = [(*(edge[8 * p, 8 * p + 1] for p in range(6)), edge[48, 49])]
    along.append(tuple(edge[8 * p + 1, 8 * p + 2] for p in range(6)))
    more: dict[str, Annotation] = {f"par{k}": Parallel(e) for k, e in enumerate(along)}
    faces = {f"f{k}": Face(tuple(map(v, loop))) for k, loop in enumerate(shape.loops)}
    for p in range(1, 5):
        more[f"touch{p}"] = OnFace(v(8 * p + 4), "f0")
    # The drawer's front lies in the slab's front, two corners of the lower slab
    # touch the sides of legs.
    more["drawer"] = OnFace(v(48), "f2")
    more["drawer2"] = OnFace(v(51), "f2")
    corners = ((40, "f9"), (40, "f10"), (42, "f26"), (42, "f29"))
    more |= {f"side{k}": OnFace(v(i), f) for k, (i, f) in enumerate(corners)}
    return replace(shape, annotations={**shape.annotations, **more}, faces=faces)


#: All of them, and a cube.
SHAPES: tuple[Callable[[], Shape], ...] = (
    box, lambda: box(100, 100, 100, "cube"), l_shape, wedge, house, staircase, bookshelf, organizer,
    hexagonal_box, table,
)  # fmt: skip
