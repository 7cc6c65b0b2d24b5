"""Photographs of shapes as sketch graphs, and what a person's hand adds to them.

Terms
-----
photograph
    A camera looking at the shape from a given elevation, azimuth and field of view; the sketch is
    its projection.
noise
    How the drawing differs from the projection, described apart from the scene (COLMAP's idea), so
    that one view can be drawn with many hands.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..camera import Camera
from ..graph import Photo, SketchGraph
from ..values import Array
from .shapes import Shape, v

WIDTH, HEIGHT = 1600, 1200


@dataclass(frozen=True, slots=True)
class Noise:
    """How a drawing differs from the exact projection.

    Parameters
    ----------
    vertex_rms : float
        RMS displacement of each vertex, in parts of the sketch's diagonal.
    """

    vertex_rms: float = 0.0


@dataclass(frozen=True)
class Photograph:
    """A shape as drawn, and the truth."""

    shape: Shape
    graph: SketchGraph
    camera: Camera

    def error(self, vertices_mm: Mapping[str, Array]) -> float:
        """RMS distance to the truth after the best similarity, in parts of the diameter."""
        return shape_error(self.shape, vertices_mm)


def shape_error(shape: Shape, vertices_mm: Mapping[str, Array]) -> float:
    """RMS over the vertices of the distance to the truth after the best rigid move and scale.

    In parts of the shape's diameter; mirror images are not the same.
    """
    A = np.array([vertices_mm[v(i)] for i in range(len(shape.X))])
    B = shape.X - shape.X.mean(axis=0)
    A = A - A.mean(axis=0)
    U, s, Vt = np.linalg.svd(A.T @ B)
    D = np.diag([1, 1, np.sign(np.linalg.det(U @ Vt))])
    scale = np.trace(np.diag(s) @ D) / max(float(np.sum(A**2)), 1e-300)
    diameter = np.linalg.norm(B[:, None] - B[None], axis=2).max()
    off = scale * A @ (U @ D @ Vt) - B
    return float(np.sqrt(np.mean(np.sum(off**2, axis=1))) / diameter)


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
    camera = random_camera(shape, rng, elevation_deg=elevation_deg, fov_deg=fov_deg)
    drawn = camera.project(shape.X)
    graph = SketchGraph(
        photo=Photo(None, WIDTH, HEIGHT, camera.focal_px if focal_known else None),
        vertices={v(i): (float(p[0]), float(p[1])) for i, p in enumerate(drawn)},
        edges={f"e{k}": (v(a), v(b)) for k, (a, b) in enumerate(shape.edges)},
        annotations=shape.annotations,
        faces=shape.faces,
    )
    return Photograph(shape, with_noise(graph, Noise(noise), rng), camera)


def with_noise(graph: SketchGraph, noise: Noise, rng: np.random.Generator) -> SketchGraph:
    """The graph drawn by a hand that is not exact."""
    drawn = np.array(list(graph.vertices.values()))
    diagonal = np.linalg.norm(np.ptp(drawn, axis=0))
    drawn = drawn + rng.normal(size=drawn.shape) * noise.vertex_rms * diagonal / np.sqrt(2)
    moved = {id_: (float(p[0]), float(p[1])) for id_, p in zip(graph.vertices, drawn, strict=True)}
    return replace(graph, vertices=moved)


def random_camera(
    shape: Shape,
    rng: np.random.Generator,
    *,
    elevation_deg: tuple[float, float] = (15, 50),
    fov_deg: tuple[float, float] = (25, 65),
) -> Camera:
    """A camera that looks at the shape's middle from above and sees all of it."""
    elevation = np.radians(rng.uniform(*elevation_deg))
    azimuth = rng.uniform(0, 2 * np.pi)
    focal = float(WIDTH / 2 / np.tan(np.radians(rng.uniform(*fov_deg)) / 2))
    middle = (shape.X.min(axis=0) + shape.X.max(axis=0)) / 2
    level = np.cos(elevation)
    back = np.array([level * np.cos(azimuth), level * np.sin(azimuth), np.sin(elevation)])
    right = np.cross([0, 0, 1.0], back)
    right /= np.linalg.norm(right)
    R = np.array([right, np.cross(right, -back) * -1.0, -back])
    R[1] = np.cross(R[2], R[0])
    radius = np.linalg.norm(shape.X - middle, axis=1).max()
    distance = rng.uniform(2.2, 3.2) * radius * focal / (WIDTH / 2)
    distance = max(distance, 1.6 * radius)
    center = np.array([WIDTH / 2, HEIGHT / 2])
    return Camera(focal, center, R, -R @ (middle + distance * back))
