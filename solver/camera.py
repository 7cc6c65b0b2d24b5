"""The camera: a pinhole without distortion.

Terms
-----
camera frame
    x right, y down, z forward (the direction of view).
``x_in_cam = rotation_cam_from_world @ x_in_world + translation_cam_from_world_mm``
    and ``u = focal_px * x / z + cx``, ``v = focal_px * y / z + cy``, (0, 0) being the photo's
    top-left corner.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .values import Array, frozen_array


@dataclass(frozen=True, slots=True, eq=False)
class Camera:
    """A camera with its pose ([Lau10] 4.3: position, orientation and focal length).

    Parameters
    ----------
    focal_px : float
        Focal length, px.
    principal_point_px : (2,) array
        Where the axis of view meets the photo, px.
    rotation_cam_from_world : (3, 3) array
    translation_cam_from_world_mm : (3,) array
    """

    focal_px: float
    principal_point_px: Array
    rotation_cam_from_world: Array
    translation_cam_from_world_mm: Array

    def __post_init__(self) -> None:
        for name, shape in (
            ("principal_point_px", (2,)),
            ("rotation_cam_from_world", (3, 3)),
            ("translation_cam_from_world_mm", (3,)),
        ):
            object.__setattr__(self, name, frozen_array(getattr(self, name), shape))

    @property
    def position_mm(self) -> Array:
        """Centre of projection in the world, mm, shape (3,)."""
        return -self.rotation_cam_from_world.T @ self.translation_cam_from_world_mm

    def project(self, points_in_world_mm: NDArray[Any]) -> Array:
        """Photo positions of world points.

        Parameters
        ----------
        points_in_world_mm : (n, 3) array

        Returns
        -------
        (n, 2) array
            Positions in px; not finite where a point lies in the camera's own plane.
        """
        points = np.asarray(points_in_world_mm, dtype=float).reshape(-1, 3)
        in_cam = points @ self.rotation_cam_from_world.T + self.translation_cam_from_world_mm
        with np.errstate(divide="ignore", invalid="ignore"):
            return self.focal_px * in_cam[:, :2] / in_cam[:, 2:] + self.principal_point_px

    def to_json(self) -> dict[str, Any]:
        """The camera as it stands in the sketch and the solution file."""
        return {
            "focal_px": float(self.focal_px),
            "principal_point_px": self.principal_point_px.tolist(),
            "rotation_cam_from_world": self.rotation_cam_from_world.tolist(),
            "translation_cam_from_world_mm": self.translation_cam_from_world_mm.tolist(),
        }
