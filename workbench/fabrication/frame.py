"""The object's own axes, and coordinates made clean in them.

Terms
-----
frame
    Three mutually perpendicular directions that all faces to be made keep to. ``p_in_frame =
    frame_from_world @ (p_in_world - origin_in_world_mm)``.
snap
    Coordinates that differ by less than `SNAP_MM` along an axis become one number.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from ...solver.model import Model, ModelFace
from ...solver.values import Array, frozen_array
from .errors import FabricationError, NotRightAngledError

#: What a solve or a person may leave between coordinates that are meant to be one, mm.
SNAP_MM = 0.02
#: Sine of the angle by which a face may miss its axis; what it does to sizes, snapping decides.
AXIS_TOLERANCE = 5e-3


@dataclass(frozen=True, slots=True, eq=False)
class Frame:
    """The object's axes (rows of `frame_from_world`) and its least corner, the origin."""

    frame_from_world: Array
    origin_in_world_mm: Array

    def to_frame(self, points_in_world: Array) -> Array:
        """World points in the frame, (n, 3)."""
        return (points_in_world - self.origin_in_world_mm) @ self.frame_from_world.T

    def world_from_frame(self) -> Array:
        """The 4x4 transform back to the world."""
        matrix = np.eye(4)
        matrix[:3, :3] = self.frame_from_world.T
        matrix[:3, 3] = self.origin_in_world_mm
        return matrix


def newell(points: Array) -> Array:
    """Area vector of a closed loop: its direction is the normal, its length the area (Newell)."""
    spans = points - points[0]
    # Three dot products, and no roll: numpy's cross and roll take several times as long.
    (x, y, z), (u, v, w) = spans.T, np.concatenate((spans[1:], spans[:1])).T
    return 0.5 * np.array([y @ w - z @ v, z @ u - x @ w, x @ v - y @ u])


def find_frame(faces: Mapping[str, ModelFace]) -> Frame:
    """The axes of faces that all stand at right angles to one another.

    Parameters
    ----------
    faces : mapping of face id to ModelFace
        The faces to be made; at least one.

    Returns
    -------
    Frame
        Axes sorted so that each lies near the world axis of its number.

    Raises
    ------
    NotRightAngledError
        Naming the faces that fit no common set of right-angled axes.
    """
    areas = {id_: newell(np.asarray(face.loop_mm)) for id_, face in faces.items()}
    for id_, area in areas.items():
        if np.linalg.norm(area) < SNAP_MM**2:
            raise FabricationError("the face has no area", (id_,), "delete it or draw it again")
    axes = _first_axes(list(areas.values()), faces)
    sums = np.zeros((3, 3))
    strays = []
    for id_, area in areas.items():
        along = axes @ area
        k = int(np.argmax(np.abs(along)))
        if np.linalg.norm(np.delete(along, k)) > AXIS_TOLERANCE * np.linalg.norm(area):
            strays.append(id_)
        sums[k] += np.sign(along[k]) * area
    if strays:
        raise NotRightAngledError(
            "these faces do not stand at right angles to the others",
            strays,
            "right-angle annotations",
        )
    for k in range(3):
        if not sums[k].any():
            # No face looks this way: where the axis is, the other faces say.
            sums[k] = axes[k] * np.linalg.norm(sums)
    u, _, vt = np.linalg.svd(sums / np.linalg.norm(sums, axis=1, keepdims=True))
    axes = _sorted_like_world(u @ vt)
    points = np.vstack([face.loop_mm for face in faces.values()]) @ axes.T
    return Frame(frozen_array(axes), frozen_array(points.min(axis=0) @ axes))


def _first_axes(areas: Sequence[Array], faces: Mapping[str, ModelFace]) -> Array:
    """The axes of that perpendicular pair of faces to which most of the area keeps.

    Where all faces look one way, the longest edge says where the second axis is.
    """
    normals = np.array([area / np.linalg.norm(area) for area in areas])
    sizes = np.linalg.norm(areas, axis=1)
    best, best_score = None, (-1, -1.0)
    for i, j in combinations(range(len(normals)), 2):
        if abs(normals[i] @ normals[j]) < AXIS_TOLERANCE:
            axes = np.array([normals[i], normals[j], np.cross(normals[i], normals[j])])
            keeps = np.abs(normals @ axes.T).max(axis=1) > 1 - AXIS_TOLERANCE**2
            score = (int(keeps.sum()), float(sizes[keeps].sum()))
            if score > best_score:
                best, best_score = axes, score
        if best_score[0] == len(normals):
            break
    if best is not None:
        return best
    first = normals[int(np.argmax(sizes))]
    across = max(normals, key=lambda n: float(np.linalg.norm(np.cross(n, first))))
    second = across - first * (across @ first)
    if np.linalg.norm(second) < 10 * AXIS_TOLERANCE:
        edges = np.vstack(
            [np.roll(face.loop_mm, -1, axis=0) - face.loop_mm for face in faces.values()]
        )
        edges = edges - np.outer(edges @ first, first)
        second = edges[int(np.argmax(np.linalg.norm(edges, axis=1)))]
    second = second / np.linalg.norm(second)
    return np.array([first, second, np.cross(first, second)])


def _sorted_like_world(axes: Array) -> Array:
    """The same axes, right-handed, each nearest to the world axis of its own number."""
    rest = [0, 1, 2]
    z = max(rest, key=lambda k: abs(axes[k, 2]))
    rest.remove(z)
    x = max(rest, key=lambda k: abs(axes[k, 0]))
    rest.remove(x)
    up = axes[z] * (1.0 if axes[z, 2] >= 0 else -1.0)
    right = axes[x] * (1.0 if axes[x, 0] >= 0 else -1.0)
    return np.array([right, np.cross(up, right), up])


def leaning_openings(model: Model, frame: Frame) -> list[str]:
    """The ids of the faces left out that are square to no axis of a frame."""
    found = []
    for id_, face in model.faces.items():
        if not face.included:
            area = frame.frame_from_world @ newell(face.loop_mm)
            if np.abs(area).max() <= np.linalg.norm(area) * (1 - AXIS_TOLERANCE**2):
                found.append(id_)
    return found


def snapped(model: Model, frame: Frame) -> dict[str, Array]:
    """The vertices of all faces in the frame, near-equal coordinates made equal.

    Parameters
    ----------
    model : Model
    frame : Frame

    Returns
    -------
    dict of vertex id to (3,) array
        Coordinates in mm, multiples of 1e-6 mm.
    """
    world: dict[str, Array] = {}
    for face in model.faces.values():
        loops = zip((face.loop, *face.holes), (face.loop_mm, *face.holes_mm), strict=True)
        for ids, positions in loops:
            world.update(zip(ids, positions, strict=True))
    points = frame.to_frame(np.array(list(world.values())))
    for k in range(3):
        points[:, k] = _clustered(points[:, k])
    return dict(zip(world, points, strict=True))


def _clustered(values: Array) -> Array:
    order = np.argsort(values, kind="stable")
    group = np.concatenate([[0], np.cumsum(np.diff(values[order]) > SNAP_MM)])
    means = np.bincount(group, weights=values[order]) / np.bincount(group)
    result = np.empty_like(values)
    result[order] = np.round(means[group], 6) + 0.0
    return result
