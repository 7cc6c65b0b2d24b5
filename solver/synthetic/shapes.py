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

from ..annotations import (
    Annotation,
    EqualLength,
    Ground,
    Length,
    OnFace,
    Parallel,
    RightAngle,
    SymmetryPlane,
)
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


def l_shape(
    w: float = 200, h: float = 180, foot: float = 60, back: float = 80, d: float = 110
) -> Shape:
    """The L of [Lau10], Figures 4, 5 and 7: 12 vertices; `foot` high, `back` deep."""
    return prism("L", [(0, 0), (w, 0), (w, foot), (back, foot), (back, h), (0, h)], d)


def wedge(w: float = 160, h: float = 90, d: float = 120) -> Shape:
    """A wedge: one slanted face."""
    return prism("wedge", [(0, 0), (w, 0), (w, h)], d)


def house(w: float = 160, d: float = 200, wall: float = 100, roof: float = 160) -> Shape:
    """A box with a saddle roof; heights of its walls and of its ridge."""
    return prism("house", [(0, 0), (w, 0), (w, wall), (w / 2, roof), (0, wall)], d)


def staircase(steps: int = 3, run: float = 60, rise: float = 40, d: float = 150) -> Shape:
    """Steps of one size."""
    profile = [(0.0, 0.0), (run * steps, 0.0)]
    for k in range(steps, 0, -1):
        height = rise * (steps - k + 1)
        profile += [(run * k, height), (run * (k - 1), height)]
    return prism("staircase", profile, d)


def tapered_tray(
    w: float = 200, d: float = 140, h: float = 60, slope_x: float = 30, slope_y: float = 20
) -> Shape:
    """Wider above than below: no right angle at any corner of its sides, two planes of symmetry."""
    rim = [(-slope_x, -slope_y), (w + slope_x, -slope_y), (w + slope_x, d + slope_y),
           (-slope_x, d + slope_y)]  # fmt: skip
    X = [[x, y, 0.0] for x, y in ((0.0, 0.0), (w, 0.0), (w, d), (0.0, d))]
    shape = from_loops("tapered tray", [*X, *([x, y, h] for x, y in rim)], BOX_LOOPS)
    # The edges of the bottom and of the rim along x, and those along y.
    more: dict[str, Annotation] = {"par0": Parallel(("e0", "e4")), "par1": Parallel(("e1", "e5"))}
    more |= {
        f"sym{k}": SymmetryPlane((f"e{k}", f"e{k + 2}", f"e{k + 4}", f"e{k + 6}")) for k in (0, 1)
    }
    return replace(shape, annotations={**shape.annotations, **more})


def bookshelf(w: float = 220, d: float = 190, h: float = 330, s: float = 250) -> Shape:
    """An open box with a shelf: 12 vertices, the side edges split where the shelf meets them."""
    X = [[x, y, z] for z in (0, s, h) for x, y in ((0, 0), (w, 0), (w, d), (0, d))]
    loops = [
        (0, 1, 2, 3), (4, 5, 6, 7), (8, 9, 10, 11),
        (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7),
        (4, 5, 9, 8), (5, 6, 10, 9), (6, 7, 11, 10), (7, 4, 8, 11),
    ]  # fmt: skip
    return from_loops("bookshelf", X, loops)


def organizer(nx: int = 3, ny: int = 2) -> Shape:
    """nx times ny compartments of unequal sizes."""
    return compartments(
        [60.0 + 15 * (i % 3) for i in range(nx)], [50.0 + 20 * (i % 2) for i in range(ny)], 90.0
    )


def compartments(widths: Iterable[float], depths: Iterable[float], h: float) -> Shape:
    """An organizer of compartments in rows and columns."""
    xs, ys = np.cumsum([0.0, *widths]), np.cumsum([0.0, *depths])
    nx, ny = len(xs) - 1, len(ys) - 1
    index: dict[tuple[int, int, int], int] = {}
    X: list[list[float]] = []
    for k, z in enumerate((0.0, h)):
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


def hexagonal_box(r: float = 90, h: float = 110) -> Shape:
    """A regular hexagonal prism: equal sides, opposite sides parallel."""
    angle = np.radians(60 * np.arange(6) + 10)
    X = [[r * np.cos(a), r * np.sin(a), z] for z in (0.0, h) for a in angle]
    sides = [(i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6) for i in range(6)]
    shape = from_loops("hexagonal box", X, [tuple(range(6)), tuple(range(6, 12)), *sides])
    edge = {pair: f"e{k}" for k, pair in enumerate(shape.edges)}
    around = [edge[min(i, (i + 1) % 6), max(i, (i + 1) % 6)] for i in range(6)]
    more: dict[str, Annotation] = {"equal": EqualLength(tuple(around))}
    more |= {f"par{k}": Parallel((around[k], around[k + 3])) for k in range(3)}
    return replace(shape, annotations={**shape.annotations, **more})


def table(
    w: float = 600, d: float = 400, h: float = 300, leg: float = 40, shelf: float = 80
) -> Shape:
    """A slab on four legs over a lower slab, a drawer's front: 52 vertices, parts touching.

    `h` is the height under the slab, `leg` the legs' thickness, `shelf` the lower slab's height.
    """
    inset = leg / 2
    near, far = inset, inset + leg  # of the legs, from the slab's sides
    parts = [(0.0, w, 0.0, d, h, h + leg / 2)]
    parts += [(x, x + leg, y, y + leg, 0.0, h) for x in (near, w - far) for y in (near, d - far)]
    parts += [(far, w - far, far, d - far, shelf, shelf + 0.4 * leg)]
    X: list[list[float]] = []
    loops: list[tuple[int, ...]] = []
    for x0, x1, y0, y1, z0, z1 in parts:
        base = len(X)
        X += [[x, y, z] for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
        loops += [tuple(base + i for i in loop) for loop in BOX_LOOPS]
    base = len(X)
    low, high = h + 0.05 * leg, h + 0.45 * leg
    X += [
        [x, 0.0, z] for x, z in ((w / 3, low), (2 * w / 3, low), (2 * w / 3, high), (w / 3, high))
    ]
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
    hexagonal_box, tapered_tray, table,
)  # fmt: skip
