"""Drawn circles as numbers, and the camera that they suggest.

Terms
-----
centre
    A circle's centre takes part as one more point, behind the vertices; its radius is one more
    shared coordinate, behind the others.
tangent
    One of eight tangent lines in which drawn and projected ellipse are compared.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .energies.circle import ellipse_support
from .geometry import cross
from .graph import SketchGraph
from .values import Array

N_TANGENTS = 8
#: Eight tangents stand for an ellipse's five freedoms.
WEIGHT = float(np.sqrt(5 / N_TANGENTS))


@dataclass(frozen=True, slots=True, eq=False)
class DrawnCircles:
    """The drawn ellipses, image units.

    Parameters
    ----------
    centres : (k, 2) array
    semi_axes : (k, 2, 2) array
        Major and minor semi-axis.
    directions : (k, 8, 2) array
        Outward unit normals of the tangents.
    supports : (k, 8) array
    weights : (k,) array
    """

    centres: Array
    semi_axes: Array
    directions: Array
    supports: Array
    weights: Array

    def __len__(self) -> int:
        return len(self.centres)


def drawn_circles(graph: SketchGraph, unit_px: float, traced_weight: float) -> DrawnCircles:
    """The circles of a graph in its order."""
    if not graph.circles:
        return _NONE
    points = np.array([[*c.a, *c.b] for c in graph.circles.values()], dtype=float)
    points = (points.reshape(-1, 4, 2) - np.array(graph.principal_point_px)) / unit_px
    centres = points.mean(axis=1)
    semi = np.stack([points[:, 1] - points[:, 0], points[:, 3] - points[:, 2]], axis=1) / 2
    t = 2 * np.pi * np.arange(N_TANGENTS) / N_TANGENTS
    directions = np.zeros((len(points), N_TANGENTS, 2))
    supports = np.zeros((len(points), N_TANGENTS))
    for k, (va, vb) in enumerate(semi):
        # Normals at evenly spread points of the outline.
        q = np.outer(np.cos(t), va / (va @ va)) + np.outer(np.sin(t), vb / (vb @ vb))
        directions[k] = q / np.linalg.norm(q, axis=1, keepdims=True)
        supports[k] = ellipse_support(va, vb, centres[k], directions[k])
    traced = set(graph.construction)
    weights = np.array([traced_weight if c in traced else 1.0 for c in graph.circles])
    return DrawnCircles(centres, semi, directions, supports, WEIGHT * weights)


_NONE = DrawnCircles(
    np.zeros((0, 2)),
    np.zeros((0, 2, 2)),
    np.zeros((0, N_TANGENTS, 2)),
    np.zeros((0, N_TANGENTS)),
    np.zeros(0),
)


def flat_circles(graph: SketchGraph) -> tuple[str, ...]:
    """Circles drawn without any width or height."""
    flat = []
    for id_, circle in graph.circles.items():
        a, b = (np.subtract(*axis) for axis in (circle.a, circle.b))
        if min(float(a @ a), float(b @ b)) < 1e-6:
            flat.append(id_)
    return tuple(flat)


def tilted_views(circles: DrawnCircles) -> list[Array]:
    """Rotations camera from object axes, axis 2 up, as the largest ellipse suggests.

    Seen from afar at elevation e, a horizontal circle's image has the minor axis along the image of
    the vertical, and minor / major = sin e.
    """
    lengths = np.linalg.norm(circles.semi_axes, axis=2)
    k = int(np.argmax(lengths.max(axis=1)))
    minor = circles.semi_axes[k, int(np.argmin(lengths[k]))]
    ratio = float(lengths[k].min() / lengths[k].max())
    towards_top = minor if minor[1] < 0 else -minor
    towards_top = towards_top / np.linalg.norm(towards_top)
    if ratio > 0.98:
        towards_top = np.array([0.0, -1.0])
    views = []
    # The steeper one leads to other readings more often than the flatter one.
    for sine in (ratio, 0.5 * (1 + ratio), 0.5 * ratio):
        e = float(np.arcsin(min(max(sine, 0.02), 0.999)))
        up = np.array([*(np.cos(e) * towards_top), -np.sin(e)])
        x = np.array([1.0, 0.0, 0.0]) - up[0] * up
        x /= np.linalg.norm(x)
        views.append(np.column_stack([x, cross(up, x), up]))
    return views
