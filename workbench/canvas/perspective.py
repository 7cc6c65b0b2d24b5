"""Rectangles in a known perspective: where a drag on the photo lies in space. Pure, no Qt.

Terms
-----
lie
    How a rectangle lies in space: level, upright along one of the object's two horizontal
    directions, or flat on the photo.
anchor
    The place in space where the drag began, mm.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np

from ...solver.camera import Camera
from ...solver.values import Array
from .plane import Point

#: No corner of a rectangle is further off than this many times the anchor: the horizon is near.
FAR = 8.0


class Lie(Enum):
    """How a rectangle lies; the value names its world axes, none for flat on the photo."""

    LEVEL = (0, 1)
    ALONG_X = (0, 2)
    ALONG_Y = (1, 2)
    PHOTO = ()


@dataclass(frozen=True, slots=True, eq=False)
class Drag:
    """A drag from one place on the photo to another, seen in space.

    Parameters
    ----------
    camera : Camera
    anchor_mm : (3,) array
    end_px : (u, v)
    """

    camera: Camera
    anchor_mm: Array
    end_px: Point

    def corners_mm(self, lie: Lie, *, square: bool = False) -> Array | None:
        """The rectangle's corners, (4, 3), from the anchor on around; None where there is none."""
        first, second = lie.value
        (through,) = {0, 1, 2} - {first, second}
        normal = np.eye(3)[through]
        end = on_plane(self.camera, self.end_px, self.anchor_mm, normal)
        if end is None or _is_far(self.camera, self.anchor_mm, end):
            return None
        offset = end - self.anchor_mm
        if square:
            side = max(abs(offset[first]), abs(offset[second]))
            offset[[first, second]] = np.copysign(side, offset[[first, second]])
        one, two = np.zeros(3), np.zeros(3)
        one[first], two[second] = offset[first], offset[second]
        return np.asarray(self.anchor_mm + np.array([0 * one, one, one + two, two]))


def on_plane(camera: Camera, place_px: Point, point_mm: Array, normal: Array) -> Array | None:
    """Where the ray through a photo position meets a plane, before the camera.

    Parameters
    ----------
    camera : Camera
    place_px : (u, v)
    point_mm, normal : (3,) arrays
        Of the plane.
    """
    u, v = (np.array(place_px) - camera.principal_point_px) / camera.focal_px
    ray = camera.rotation_cam_from_world.T @ np.array([u, v, 1.0])
    slope = float(ray @ normal)
    if abs(slope) < 1e-9:
        return None
    part = float((point_mm - camera.position_mm) @ normal) / slope
    return None if part <= 0 else np.asarray(camera.position_mm + part * ray)


def _is_far(camera: Camera, near: Array, far: Array) -> bool:
    eye = camera.position_mm
    return bool(np.linalg.norm(far - eye) > FAR * np.linalg.norm(near - eye))
