"""Photographs of shapes as sketch graphs, and what a person's hand adds to them.

Terms
-----
photograph
    A camera looking at the shape from a given elevation, azimuth and field of view; the sketch is
    its projection.
hand
    How the drawing differs from the projection, described apart from the scene (COLMAP's idea), so
    that one view can be drawn with many hands.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from ..camera import Camera
from ..graph import Photo, SketchGraph
from ..values import Array
from .shapes import Shape, v

WIDTH, HEIGHT = 1600, 1200


@dataclass(frozen=True, slots=True)
class Hand:
    """How a drawing differs from the exact projection.

    Parameters
    ----------
    vertex_rms : float
        RMS displacement of each vertex, in parts of the sketch's diagonal, independent.
    tilt_deg : (float, float)
        Each of the object's three directions is drawn towards a vanishing point that is so many
        degrees off, between these two: a wrong perspective, drawn consistently.
    length_off : float
        Lengths along each direction are drawn wrong by up to this part.
    """

    vertex_rms: float = 0.0
    tilt_deg: tuple[float, float] = (0.0, 0.0)
    length_off: float = 0.0

    def imagined(self, X: Array, rng: np.random.Generator) -> Array:
        """The shape (n, 3) as this hand believes that it looks."""
        if self.tilt_deg == (0.0, 0.0) and self.length_off == 0.0:
            return X
        leaning = np.zeros((3, 3))
        for k in range(3):
            tilt = np.radians(rng.uniform(*self.tilt_deg))
            towards = rng.uniform(0, 2 * np.pi)
            length = 1 + rng.uniform(-self.length_off, self.length_off)
            leaning[:, k] = length * np.roll(
                [np.cos(tilt), np.sin(tilt) * np.cos(towards), np.sin(tilt) * np.sin(towards)], k
            )
        middle = X.mean(axis=0)
        return np.asarray((X - middle) @ leaning.T + middle)


@dataclass(frozen=True, slots=True)
class Views:
    """Where photographs are taken from.

    Parameters
    ----------
    elevation_deg, azimuth_deg, fov_deg : (float, float)
        Least and largest angle above the ground, angle about the vertical (-90 sees the front), and
        horizontal field of view.
    roll_deg : float
        The camera leans to a side by up to so much.
    off_centre : float
        The shape's middle is off the photo's by up to this part of half its width and height.
    """

    elevation_deg: tuple[float, float] = (15.0, 50.0)
    fov_deg: tuple[float, float] = (25.0, 65.0)
    azimuth_deg: tuple[float, float] = (0.0, 360.0)
    roll_deg: float = 0.0
    off_centre: float = 0.0


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
    hand: Hand | None = None,
    views: Views | None = None,
    focal_known: bool = False,
) -> Photograph:
    """Photograph a shape from a random direction.

    `noise` stands for a hand that displaces each vertex by so much (RMS), in parts of the sketch's
    diagonal.
    """
    hand = hand or Hand(noise)
    camera = random_camera(shape, rng, views or Views())
    imagined = replace(shape, X=hand.imagined(shape.X, rng))
    graph = with_noise(photograph_exactly(imagined, camera), hand.vertex_rms, rng)
    if focal_known and graph.photo is not None:
        graph = replace(graph, photo=replace(graph.photo, focal_px=camera.focal_px))
    return Photograph(shape, graph, camera)


def photograph_exactly(shape: Shape, camera: Camera) -> SketchGraph:
    """What a camera sees of a shape; its focal length is not told."""
    drawn = camera.project(shape.X)
    return SketchGraph(
        photo=Photo(None, WIDTH, HEIGHT),
        vertices={v(i): (float(p[0]), float(p[1])) for i, p in enumerate(drawn)},
        edges={f"e{k}": (v(a), v(b)) for k, (a, b) in enumerate(shape.edges)},
        annotations=shape.annotations,
        faces=shape.faces,
    )


def with_noise(graph: SketchGraph, vertex_rms: float, rng: np.random.Generator) -> SketchGraph:
    """The graph with each vertex displaced on its own, RMS in parts of the sketch's diagonal."""
    drawn = np.array(list(graph.vertices.values()))
    diagonal = np.linalg.norm(np.ptp(drawn, axis=0))
    drawn = drawn + rng.normal(size=drawn.shape) * vertex_rms * diagonal / np.sqrt(2)
    moved = {id_: (float(p[0]), float(p[1])) for id_, p in zip(graph.vertices, drawn, strict=True)}
    return replace(graph, vertices=moved)


def random_camera(shape: Shape, rng: np.random.Generator, views: Views) -> Camera:
    """A camera that looks at the shape's middle from above and sees all of it."""
    elevation = np.radians(rng.uniform(*views.elevation_deg))
    azimuth = np.radians(rng.uniform(*views.azimuth_deg))
    focal = float(WIDTH / 2 / np.tan(np.radians(rng.uniform(*views.fov_deg)) / 2))
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
    t = -R @ (middle + distance * back)
    if views.roll_deg or views.off_centre:
        aside = views.off_centre * rng.uniform(-1, 1, 2) * center / focal
        turn = Rotation.from_rotvec([aside[1], -aside[0], 0.0])
        roll = np.radians(views.roll_deg) * rng.uniform(-1, 1)
        aim = (Rotation.from_rotvec([0, 0, roll]) * turn).as_matrix()
        R, t = aim @ R, aim @ t
    return Camera(focal, center, R, t)
