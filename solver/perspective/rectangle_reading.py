"""A rectangle on the ground taken in one way: its pose, and what the corners' errors do to it.

Positions on the ground are in parts of the rectangle's longer side, see `plane_pose`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..camera import Camera
from ..geometry import rotation
from ..initial import USUAL_LOG_FOCAL
from ..starting.focal_prior import USUAL_SIGMA
from ..values import Array
from .plane_pose import (
    Known,
    PlanePose,
    Sight,
    fitted,
    homography,
    leaning_the_other_way,
    log_focal_of,
    pose_of,
)

#: As in `focal_prior`.
USUAL = Known(USUAL_LOG_FOCAL, USUAL_SIGMA)
#: Where the corners tell the log focal length less surely than this, what is usual counts too.
UNSURE_FOCAL = 0.1
#: Twice the log likelihood by which one reading has to be better than another.
CLEARLY = 9.0
#: Poses that lean this much alike are one.
SAME_LEAN_RAD = 0.035


def on_ground(size: tuple[float, float]) -> Array:
    """The corners on the ground (4, 2), the first at (-x, -y), counterclockwise."""
    signs = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    return np.asarray(signs * np.array(size) / 2)


@dataclass(frozen=True, slots=True, eq=False)
class RectangleReading:
    """One way to take the corners, fitted.

    Parameters
    ----------
    size_mm : (float, float)
    sight : Sight
    pose : PlanePose
    focal_from : str
        ``corners``, ``photo`` or ``usual``.
    badness : float
        Twice the negative log likelihood, with what is known or usual of the focal length.
    """

    size_mm: tuple[float, float]
    sight: Sight
    pose: PlanePose
    focal_from: str
    badness: float

    @classmethod
    def of(
        cls, size_mm: tuple[float, float], seen: Array, sigma: float, told: Known | None
    ) -> RectangleReading:
        """Fit corners seen (4, 2) with a standard error, in image units."""
        plane = on_ground(size_mm) / max(size_mm)
        H = homography(plane, seen)
        known = told or USUAL
        careful = Sight(plane, seen, sigma, known)
        formula = None if told is not None else log_focal_of(H)
        starts = [pose_of(H, f) for f in (known.log_focal, formula) if f is not None]
        pose = min((fitted(careful, s) for s in starts), key=lambda x: careful.merit(x, 0.0))
        badness = careful.merit(pose, 0.0)
        if told is not None:
            return cls(size_mm, careful, pose, "photo", badness)
        free = Sight(plane, seen, sigma)
        if _focal_sigma(free, pose) > UNSURE_FOCAL:
            return cls(size_mm, careful, pose, "usual", badness)
        return cls(size_mm, free, fitted(free, pose), "corners", badness)

    @property
    def misfit(self) -> float:
        """RMS distance of the corners, image units."""
        off = self.pose.project(self.sight.plane) - self.sight.seen
        return float(np.sqrt(np.mean(np.sum(off**2, axis=1))))

    @property
    def focal_sigma(self) -> float:
        """Standard error of the log focal length."""
        return _focal_sigma(self.sight, self.pose)

    def upright(self) -> tuple[RectangleReading, RectangleReading | None]:
        """The better pose, and the other one where it explains the corners almost as well.

        Of two that cannot be told apart, that which has the world's up upwards in the photo.
        """
        other = fitted(self.sight, leaning_the_other_way(self.pose))
        worse = self.sight.merit(other, 0.0) - self.sight.merit(self.pose, 0.0)
        same = float(other.R[:, 2] @ self.pose.R[:, 2]) > np.cos(SAME_LEAN_RAD)
        if same or worse > CLEARLY:
            return self, None
        twin = replace(self, pose=other)
        return (self, twin) if self.pose.R[1, 2] < other.R[1, 2] else (twin, self)

    def size_sigma(self) -> float:
        """See `marker.RectangleView`: what the camera's errors do to a height measured with it."""
        covariance = self.sight.covariance(self.pose)
        gradient = np.zeros(7)
        foot, top = (_seen_at(self.pose, z) for z in (0.0, 1.0))
        for k in range(7):
            step = np.zeros(7)
            step[k] = 1e-6
            high = _height(_moved(self.pose, step), foot, top)
            low = _height(_moved(self.pose, -step), foot, top)
            gradient[k] = (high - low) / 2e-6
        variance = float(gradient @ covariance @ gradient)
        return float(np.sqrt(max(0.0, variance)))

    def camera(self, unit: float, principal: Array) -> Camera:
        """The camera, from px per image unit and the principal point."""
        return Camera(
            focal_px=float(np.exp(self.pose.log_focal)) * unit,
            principal_point_px=principal,
            rotation_cam_from_world=self.pose.R,
            translation_cam_from_world_mm=self.pose.t * max(self.size_mm),
        )


def _focal_sigma(sight: Sight, pose: PlanePose) -> float:
    return float(np.sqrt(max(0.0, sight.covariance(pose)[6, 6])))


def _moved(x: PlanePose, step: Array) -> PlanePose:
    return PlanePose(rotation(step[:3]) @ x.R, x.t + step[3:6], x.log_focal + float(step[6]))


def _seen_at(x: PlanePose, z: float) -> Array:
    """Where a point above the rectangle's middle is seen, (2,)."""
    in_cam = x.t + z * x.R[:, 2]
    return np.asarray(np.exp(x.log_focal) * in_cam[:2] / in_cam[2])


def _height(x: PlanePose, foot: Array, top: Array) -> float:
    """How tall an upright edge is that is seen from foot to top."""
    focal = np.exp(x.log_focal)
    up = x.R[:, 2]
    low, high = (np.append(p / focal, 1.0) for p in (foot, top))
    on_ground = low * float(x.t @ up) / float(low @ up)
    # foot + z up = s high, in the least-squares sense
    A = np.column_stack([up, -high])
    return float(np.linalg.lstsq(A, -on_ground, rcond=None)[0][0])
