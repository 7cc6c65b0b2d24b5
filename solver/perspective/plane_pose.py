"""The camera that sees known points of one plane: in closed form, then by least squares.

Terms
-----
homography
    The 3 x 3 matrix that takes the plane's (x, y, 1) to the photo; [r1 r2 t] seen through the lens.
twin
    The other pose that explains a small or distant rectangle almost as well: its plane leans the
    other way (the two-fold ambiguity of planes).

Positions on the plane are in units of its own size, those in the photo in image units from the
principal point (see `problem`). The homography gives the focal length because r1 and r2 are square
to each other and equally long; where the plane is seen square-on both hold for every focal length.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..geometry import cross, rotation
from ..initial import LOG_FOCAL_RANGE
from ..least_squares import Evaluation, minimise
from ..values import Array

#: A logarithm of the focal length that steps further than this is held back.
_LONGEST_STEP = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class PlanePose:
    """A camera over a plane: rotation camera from plane, translation, log focal length."""

    R: Array
    t: Array
    log_focal: float

    def project(self, plane: Array) -> Array:
        """Image positions (n, 2) of the plane's points (n, 2)."""
        in_cam = plane @ self.R[:, :2].T + self.t
        return np.asarray(np.exp(self.log_focal) * in_cam[:, :2] / in_cam[:, 2:])


@dataclass(frozen=True, slots=True)
class Known:
    """What is known of the log focal length beforehand, and how surely."""

    log_focal: float
    sigma: float


@dataclass(frozen=True, slots=True, eq=False)
class Sight:
    """The least-squares problem: points of a plane (n, 2) and where they are seen (n, 2).

    Parameters
    ----------
    plane, seen : (n, 2) arrays
    sigma : float
        Standard error of each seen coordinate, image units.
    known : Known or None
    """

    plane: Array
    seen: Array
    sigma: float
    known: Known | None = None

    curved = False

    def residual(self, x: PlanePose) -> Array:
        """In standard errors, (2 n,), and one more where the focal length is known."""
        r = ((x.project(self.plane) - self.seen) / self.sigma).reshape(-1)
        if self.known is None:
            return np.asarray(r)
        return np.append(r, (x.log_focal - self.known.log_focal) / self.known.sigma)

    def jacobian(self, x: PlanePose) -> Array:
        """Derivatives of the residual by a turn (camera frame), the translation, log focal."""
        turned = self.plane @ x.R[:, :2].T
        in_cam = turned + x.t
        f, depth = np.exp(x.log_focal), in_cam[:, 2]
        D = np.zeros((len(in_cam), 2, 3))
        D[:, 0, 0] = D[:, 1, 1] = f / depth
        D[:, :, 2] = -f * in_cam[:, :2] / depth[:, None] ** 2
        by_turn = cross(turned[:, None, :], D)
        by_focal = (f * in_cam[:, :2] / depth[:, None])[..., None]
        J = np.concatenate([by_turn, D, by_focal], axis=2).reshape(-1, 7) / self.sigma
        if self.known is None:
            return np.asarray(J)
        return np.vstack([J, np.append(np.zeros(6), 1 / self.known.sigma)])

    def evaluate(self, x: PlanePose) -> Evaluation:
        """See `least_squares.Objective`."""
        J = self.jacobian(x)
        return Evaluation(J.T @ J, J.T @ self.residual(x), np.zeros(0), np.zeros((0, 7)))

    def merit(self, x: PlanePose, rho: float) -> float:
        """See `least_squares.Objective`."""
        r = self.residual(x)
        return float(r @ r)

    def retract(self, x: PlanePose, step: Array) -> PlanePose | None:
        """See `least_squares.Objective`."""
        if float(np.abs(step[:3]).max()) > 1.0 or abs(float(step[6])) > _LONGEST_STEP:
            return None
        log_focal = float(np.clip(x.log_focal + step[6], *LOG_FOCAL_RANGE))
        moved = PlanePose(rotation(step[:3]) @ x.R, x.t + step[3:6], log_focal)
        depth = self.plane @ moved.R[2, :2] + moved.t[2]
        return moved if float(depth.min()) > 0 else None

    def restore(self, x: PlanePose) -> PlanePose:
        """See `least_squares.Objective`: there is nothing to restore."""
        return x

    def covariance(self, x: PlanePose) -> Array:
        """Of a turn, the translation and the log focal length, (7, 7); infinite where open."""
        J = self.jacobian(x)
        scale = np.maximum(np.linalg.norm(J, axis=0), 1e-300)
        values, vectors = np.linalg.eigh((J / scale).T @ (J / scale))
        values = np.where(values > 1e-14 * values[-1], values, 1e-300)
        return np.asarray((vectors / values) @ vectors.T / np.outer(scale, scale))


def homography(plane: Array, seen: Array) -> Array:
    """The homography (3, 3) of at least four points, by the direct linear transform.

    H. h33 > 0 on the visible side: depths of the points are positive.
    """
    x, y = plane.T
    u, v = seen.T
    zero, one = np.zeros_like(x), np.ones_like(x)
    A = np.vstack(
        [
            np.column_stack([x, y, one, zero, zero, zero, -u * x, -u * y, -u]),
            np.column_stack([zero, zero, zero, x, y, one, -v * x, -v * y, -v]),
        ]
    )
    H = np.linalg.svd(A)[2][-1].reshape(3, 3)
    depth = np.column_stack([plane, one]) @ H[2]
    return np.asarray(H if float(depth.sum()) > 0 else -H)


def log_focal_of(H: Array) -> float | None:
    """The log focal length of a homography, None where it is seen too square-on to tell.

    With k = 1 / f^2: k (h1 . h2)_xy + (h1 h2)_z = 0 and k (|h1|^2 - |h2|^2)_xy + (h1^2 - h2^2)_z =
    0, in the least-squares sense.
    """
    a, b = H[:, 0], H[:, 1]
    by_k = np.array([2 * (a[:2] @ b[:2]), a[:2] @ a[:2] - b[:2] @ b[:2]])
    rest = np.array([2 * a[2] * b[2], a[2] ** 2 - b[2] ** 2])
    k = -float(by_k @ rest) / max(float(by_k @ by_k), 1e-300)
    low, high = LOG_FOCAL_RANGE
    if not np.exp(-2 * high) < k < np.exp(-2 * low):
        return None
    return -0.5 * float(np.log(k))


def pose_of(H: Array, log_focal: float) -> PlanePose:
    """The pose of a homography seen through a lens of this focal length."""
    f = np.exp(log_focal)
    M = H / np.array([f, f, 1.0])[:, None]
    size = np.sqrt(np.linalg.norm(M[:, 0]) * np.linalg.norm(M[:, 1]))
    r1, r2, t = (M / size).T
    U, _, Vt = np.linalg.svd(np.column_stack([r1, r2, cross(r1, r2)]))
    R = U @ np.diag([1.0, 1.0, np.linalg.det(U @ Vt)]) @ Vt
    return PlanePose(np.asarray(R), np.asarray(t), log_focal)


def leaning_the_other_way(x: PlanePose) -> PlanePose:
    """The start of the twin: the plane mirrored at the plane square to the line of sight."""
    sight = x.t / np.linalg.norm(x.t)
    normal = x.R[:, 2]
    mirrored = 2 * (normal @ sight) * sight - normal
    axis = cross(normal, mirrored)
    sine = float(np.linalg.norm(axis))
    if sine < 1e-12:
        return x
    turn = axis / sine * np.arctan2(sine, float(normal @ mirrored))
    return PlanePose(rotation(turn) @ x.R, x.t, x.log_focal)


def fitted(sight: Sight, start: PlanePose) -> PlanePose:
    """The pose that meets what is seen best, from a start."""
    return minimise(sight, start, max_iterations=200, enough=1e-15).x
