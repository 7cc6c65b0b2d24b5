"""Surfaces of revolution whose truth is known, and photographs of them."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ..annotations import Diameter
from ..camera import Camera
from ..graph import Ellipse, Photo, Point, Revolution, SketchGraph
from ..values import Array
from .photographs import HEIGHT, WIDTH, Views, random_camera
from .shapes import box


def image_ellipse(camera: Camera, centre: Array, radius: float) -> Ellipse:
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

    def ends(semi: Array) -> tuple[Point, Point]:
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
    turned: Turned,
    rng: np.random.Generator,
    *,
    noise: float = 0.0,
    views: Views | None = None,
    focal_known: bool = False,
) -> tuple[SketchGraph, Camera]:
    """Photograph a surface of revolution; its ground circle's diameter is annotated."""
    height = max(z for _, z in turned.circles)
    widest = max(r for r, _ in turned.circles)
    stand_in = box(2 * widest, 2 * widest, max(height, 1.0))
    camera = random_camera(stand_in, rng, views or Views())
    axis = np.array([widest, widest, 0.0])
    up = np.array([0.0, 0.0, 1.0])
    eye = camera.position_mm - axis
    side = np.cross(up, [eye[0], eye[1], 0.0])
    side /= np.linalg.norm(side)
    ellipses = [image_ellipse(camera, axis + z * up, r) for r, z in turned.circles]
    points = camera.project(np.array([axis + r * side + z * up for r, z in turned.profile]))
    diagonal = np.linalg.norm(np.ptp([p for e in ellipses for p in (*e.a, *e.b)], axis=0))

    def shaken(p: Point | Array) -> Point:
        moved = np.asarray(p) + rng.normal(size=2) * noise * diagonal / np.sqrt(2)
        return (float(moved[0]), float(moved[1]))

    names = [f"p{k}" for k in range(len(points))]
    graph = SketchGraph(
        photo=Photo(None, WIDTH, HEIGHT, camera.focal_px if focal_known else None),
        vertices=dict(zip(names, map(shaken, points), strict=True)),
        edges={f"s{k}": pair for k, pair in enumerate(pairwise(names))},
        circles={
            f"c{k}": Ellipse((shaken(e.a[0]), shaken(e.a[1])), (shaken(e.b[0]), shaken(e.b[1])))
            for k, e in enumerate(ellipses)
        },
        revolutions={"r1": Revolution("c0", "c1", "c2", tuple(names))},
        annotations={"wide": Diameter("c0", 2 * turned.circles[0][0])},
    )
    return graph, camera
