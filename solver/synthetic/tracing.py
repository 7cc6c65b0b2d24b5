"""Construction geometry: a real box beside the imagined object, traced on the photo."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

from ..annotations import Annotation, Ground, Parallel, RightAngle
from .photographs import Photograph
from .shapes import box


def with_traced_box(
    photo: Photograph,
    rng: np.random.Generator,
    *,
    trace_px: float = 1.5,
    aligned: bool = True,
    turned_deg: float | None = None,
) -> Photograph:
    """The photograph with a box that really is there, traced as construction geometry.

    Parameters
    ----------
    photo : Photograph
    rng : Generator
    trace_px : float
        RMS displacement of each traced vertex, px.
    aligned : bool
        Whether the box stands parallel to the object, and this is annotated; else it is turned
        about the vertical, and only the ground is common.
    turned_deg : float, optional
        By so much; else by 10 to 80 degrees.
    """
    low, high = photo.shape.X.min(axis=0), photo.shape.X.max(axis=0)
    size = high - low
    w, d, h = rng.uniform(0.4, 0.9, 3) * np.maximum(size, 0.3 * size.max())
    real = box(w, d, h)
    angle = np.radians(0.0 if turned_deg is None else turned_deg)
    if not aligned and turned_deg is None:
        angle = rng.uniform(np.radians(10), np.radians(80))
    X = real.X @ Rotation.from_rotvec([0, 0, angle]).as_matrix().T
    # Beside the object: to the left or right of it as seen.
    right = photo.camera.rotation_cam_from_world[0] * [1, 1, 0]
    right /= np.linalg.norm(right)
    side = float(rng.choice([-1.0, 1.0]))
    away = 0.5 * np.linalg.norm(size[:2]) + 0.3 * np.linalg.norm(np.ptp(X, axis=0)[:2])
    X += (low + high) / 2 * [1, 1, 0] - X.mean(axis=0) * [1, 1, 0] + side * away * right
    drawn = photo.camera.project(X) + rng.normal(size=(len(X), 2)) * trace_px / np.sqrt(2)
    graph = photo.graph
    edges = {f"te{k}": (f"t{a}", f"t{b}") for k, (a, b) in enumerate(real.edges)}
    said: dict[str, Annotation] = {}
    for id_, a in real.annotations.items():
        if isinstance(a, RightAngle):
            first, second = a.between
            said[f"t{id_}"] = RightAngle(f"t{a.at[1:]}", (f"t{first}", f"t{second}"))
        elif isinstance(a, Ground):
            said[f"t{id_}"] = Ground(tuple(f"t{i[1:]}" for i in a.vertices))
    along = _edge_along_x(photo) if aligned else None
    if along is not None:
        said["tpar"] = Parallel((along, "te0"))
    graph = replace(
        graph,
        vertices={
            **graph.vertices,
            **{f"t{i}": (float(p[0]), float(p[1])) for i, p in enumerate(drawn)},
        },
        edges={**graph.edges, **edges},
        annotations={**graph.annotations, **said},
        construction=tuple(edges),
    )
    return replace(photo, graph=graph)


def _edge_along_x(photo: Photograph) -> str | None:
    """An edge of the object that is parallel to the world's x, as the box's first edge is."""
    for k, (a, b) in enumerate(photo.shape.edges):
        d = photo.shape.X[b] - photo.shape.X[a]
        if np.abs(d[1:]).max() < 1e-9 * abs(d[0]):
            return f"e{k}"
    return None
