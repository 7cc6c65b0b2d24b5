"""Shapes whose truth is known, and photographs of them as sketch graphs.

Terms
-----
shape
    Vertices in the world (mm, z up, standing on z = 0), edges, and the annotations a person gives.
photograph
    A camera looking at the shape from a given elevation, azimuth and field of view; the sketch is
    its projection, with or without noise.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from incontext.solver.annotations import (
    Annotation,
    Diameter,
    EqualLength,
    Ground,
    Length,
    OnFace,
    Parallel,
    RightAngle,
)
from incontext.solver.camera import Camera
from incontext.solver.graph import Ellipse, Face, Photo, Revolution, SketchGraph

WIDTH, HEIGHT = 1600, 1200


@dataclass(frozen=True)
class Shape:
    """Truth: positions (n, 3) in mm, edges as vertex pairs, loops of faces, annotations."""

    name: str
    X: np.ndarray
    edges: tuple[tuple[int, int], ...]
    loops: tuple[tuple[int, ...], ...]
    annotations: dict[str, Annotation] = field(default_factory=dict)
    faces: dict[str, Face] | None = None

    def without(self, *ids: str) -> Shape:
        """The shape with some annotations taken away."""
        kept = {k: a for k, a in self.annotations.items() if k not in ids}
        return replace(self, annotations=kept)


def v(i: int) -> str:
    return f"v{i}"


def from_loops(name: str, X: Iterable[Iterable[float]], loops: Iterable[Iterable[int]]) -> Shape:
    """A shape from its faces; right angles wherever a face has one, the ground, one length."""
    points = np.array(list(map(list, X)), dtype=float)
    loops = tuple(tuple(loop) for loop in loops)
    edges: dict[tuple[int, int], str] = {}
    for loop in loops:
        for a, b in zip(loop, loop[1:] + loop[:1], strict=True):
            edges.setdefault((min(a, b), max(a, b)), f"e{len(edges)}")
    annotations: dict[str, Annotation] = {}
    corners = set()
    for loop in loops:
        for a, b, c in zip(loop[-1:] + loop[:-1], loop, loop[1:] + loop[:1], strict=True):
            p, q = points[a] - points[b], points[c] - points[b]
            if abs(p @ q) < 1e-9 * np.linalg.norm(p) * np.linalg.norm(q):
                pair = tuple(sorted((edges[min(a, b), max(a, b)], edges[min(b, c), max(b, c)])))
                if (b, pair) not in corners:
                    corners.add((b, pair))
                    annotations[f"ra{len(corners)}"] = RightAngle(v(b), pair)
    ground = tuple(v(i) for i in np.flatnonzero(np.abs(points[:, 2]) < 1e-9))
    annotations["ground"] = Ground(ground)
    (a, b), first = next(iter(edges.items()))
    annotations["length"] = Length(first, float(np.linalg.norm(points[a] - points[b])))
    return Shape(name, points, tuple(edges), loops, annotations)


def box(w: float = 200, d: float = 150, h: float = 120, name: str = "box") -> Shape:
    X = [[x, y, z] for z in (0, h) for x, y in ((0, 0), (w, 0), (w, d), (0, d))]
    return from_loops(name, X, BOX_LOOPS)


BOX_LOOPS = ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def prism(name: str, profile: Iterable[tuple[float, float]], depth: float) -> Shape:
    """A profile in x and z, extruded along y."""
    profile = list(profile)
    n = len(profile)
    X = [[x, y, z] for y in (0.0, depth) for x, z in profile]
    sides = [(i, (i + 1) % n, (i + 1) % n + n, i + n) for i in range(n)]
    return from_loops(name, X, [tuple(range(n)), tuple(range(n, 2 * n)), *sides])


def l_shape() -> Shape:
    return prism("L", [(0, 0), (200, 0), (200, 60), (80, 60), (80, 180), (0, 180)], 110)


def wedge() -> Shape:
    return prism("wedge", [(0, 0), (160, 0), (160, 90)], 120)


def house() -> Shape:
    return prism("house", [(0, 0), (160, 0), (160, 100), (80, 160), (0, 100)], 200)


def staircase(steps: int = 3) -> Shape:
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
    index = {}
    X = []
    for k, z in enumerate((0.0, 90.0)):
        for j, y in enumerate(ys):
            for i, x in enumerate(xs):
                index[i, j, k] = len(X)
                X.append([x, y, z])
    loops = []
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
    X, loops = [], []
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
    # The drawer's front lies in the slab's front, the lower slab's corner touches a leg's sides.
    more["drawer"] = OnFace(v(48), "f2")
    more["side"] = OnFace(v(40), "f9")
    return replace(shape, annotations={**shape.annotations, **more}, faces=faces)


SHAPES = (
    box, lambda: box(100, 100, 100, "cube"), l_shape, wedge, house, staircase, bookshelf, organizer,
    hexagonal_box, table,
)  # fmt: skip


@dataclass(frozen=True)
class Photograph:
    """A shape as drawn, and the truth."""

    shape: Shape
    graph: SketchGraph
    camera: Camera

    def error(self, vertices_mm) -> float:
        """RMS over the vertices of the distance to the truth after the best rigid move and scale,
        in parts of the shape's diameter."""
        A = np.array([vertices_mm[v(i)] for i in range(len(self.shape.X))])
        B = self.shape.X
        A, B = A - A.mean(axis=0), B - B.mean(axis=0)
        U, s, Vt = np.linalg.svd(A.T @ B)
        D = np.diag([1, 1, np.sign(np.linalg.det(U @ Vt))])
        scale = np.trace(np.diag(s) @ D) / np.sum(A**2)
        diameter = np.linalg.norm(B[:, None] - B[None], axis=2).max()
        return (
            float(np.sqrt(np.mean(np.sum((scale * A @ (U @ D @ Vt) - B) ** 2, axis=1)))) / diameter
        )


def photograph(
    shape: Shape,
    rng: np.random.Generator,
    *,
    noise: float = 0.0,
    elevation_deg: tuple[float, float] = (15, 50),
    fov_deg: tuple[float, float] = (25, 65),
    focal_known: bool = False,
) -> Photograph:
    """Photograph a shape from a random direction.

    `noise` is the RMS displacement of each vertex in parts of the sketch's diagonal.
    """
    elevation = np.radians(rng.uniform(*elevation_deg))
    azimuth = rng.uniform(0, 2 * np.pi)
    focal = WIDTH / 2 / np.tan(np.radians(rng.uniform(*fov_deg)) / 2)
    middle = (shape.X.min(axis=0) + shape.X.max(axis=0)) / 2
    back = np.array(
        [
            np.cos(elevation) * np.cos(azimuth),
            np.cos(elevation) * np.sin(azimuth),
            np.sin(elevation),
        ]
    )
    right = np.cross([0, 0, 1.0], back)
    right /= np.linalg.norm(right)
    R = np.array([right, np.cross(right, -back) * -1.0, -back])
    R[1] = np.cross(R[2], R[0])
    radius = np.linalg.norm(shape.X - middle, axis=1).max()
    distance = rng.uniform(2.2, 3.2) * radius * focal / (WIDTH / 2)
    distance = max(distance, 1.6 * radius)
    camera = Camera(focal, [WIDTH / 2, HEIGHT / 2], R, -R @ (middle + distance * back))
    drawn = camera.project(shape.X)
    diagonal = np.linalg.norm(np.ptp(drawn, axis=0))
    drawn = drawn + rng.normal(size=drawn.shape) * noise * diagonal / np.sqrt(2)
    graph = SketchGraph(
        photo=Photo(None, WIDTH, HEIGHT, focal if focal_known else None),
        vertices={v(i): (float(p[0]), float(p[1])) for i, p in enumerate(drawn)},
        edges={f"e{k}": (v(a), v(b)) for k, (a, b) in enumerate(shape.edges)},
        annotations=shape.annotations,
        faces=shape.faces,
    )
    return Photograph(shape, graph, camera)


def image_ellipse(camera: Camera, centre: np.ndarray, radius: float) -> Ellipse:
    """The image of a horizontal circle: an exact ellipse, by its axes' ends."""
    t = 2 * np.pi * np.arange(5) / 5
    ring = centre + radius * np.column_stack([np.cos(t), np.sin(t), 0 * t])
    x, y = ((camera.project(ring) - camera.principal_point_px) / camera.focal_px).T
    # The conic through five points: A x^2 + B x y + C y^2 + D x + E y + F = 0.
    A, B, C, D, E, F = np.linalg.svd(np.column_stack([x * x, x * y, y * y, x, y, x * 0 + 1]))[2][5]
    M = np.array([[A, B / 2], [B / 2, C]])
    middle = np.linalg.solve(2 * M, [-D, -E])
    values, vectors = np.linalg.eigh(M / -(middle @ M @ middle + D * middle[0] + E * middle[1] + F))
    axes = vectors / np.sqrt(values)
    major, minor = axes[:, 0], axes[:, 1]

    def ends(semi: np.ndarray) -> tuple[tuple[float, float], tuple[float, float]]:
        p = (np.array([middle - semi, middle + semi]) * camera.focal_px) + camera.principal_point_px
        return ((float(p[0, 0]), float(p[0, 1])), (float(p[1, 0]), float(p[1, 1])))

    return Ellipse(ends(major), ends(minor))


@dataclass(frozen=True)
class Turned:
    """A surface of revolution: (r, z) of the ground, bottom and top circle, and of the profile."""

    name: str
    circles: tuple[tuple[float, float], ...]
    profile: tuple[tuple[float, float], ...]


LID = Turned(
    "lid", ((70.0, 0.0), (45.0, 95.0), (12.0, 135.0)), ((45.0, 95.0), (38.0, 110.0), (12.0, 135.0))
)


def photograph_turned(
    turned: Turned, rng: np.random.Generator, *, noise: float = 0.0, focal_known: bool = False
) -> tuple[SketchGraph, Camera]:
    """Photograph a surface of revolution; its ground circle's diameter is annotated."""
    height = max(z for _, z in turned.circles)
    stand_in = box(140, 140, max(height, 1.0))
    camera = photograph(stand_in, rng).camera
    axis = np.array([70.0, 70.0, 0.0])
    up = np.array([0.0, 0.0, 1.0])
    eye = camera.position_mm - axis
    side = np.cross(up, [eye[0], eye[1], 0.0])
    side /= np.linalg.norm(side)
    ellipses = [image_ellipse(camera, axis + z * up, r) for r, z in turned.circles]
    points = camera.project(np.array([axis + r * side + z * up for r, z in turned.profile]))
    diagonal = np.linalg.norm(np.ptp([p for e in ellipses for p in (*e.a, *e.b)], axis=0))

    def shaken(p):
        moved = np.asarray(p) + rng.normal(size=2) * noise * diagonal / np.sqrt(2)
        return (float(moved[0]), float(moved[1]))

    names = [f"p{k}" for k in range(len(points))]
    graph = SketchGraph(
        photo=Photo(None, WIDTH, HEIGHT, camera.focal_px if focal_known else None),
        vertices=dict(zip(names, map(shaken, points), strict=True)),
        edges={f"s{k}": pair for k, pair in enumerate(pairwise(names))},
        circles={
            f"c{k}": Ellipse(tuple(map(shaken, e.a)), tuple(map(shaken, e.b)))
            for k, e in enumerate(ellipses)
        },
        revolutions={"r1": Revolution("c0", "c1", "c2", tuple(names))},
        annotations={"wide": Diameter("c0", 2 * turned.circles[0][0])},
    )
    return graph, camera
