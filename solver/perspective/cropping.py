"""Where the axis of view meets a photo that may have been cropped, told by traced lines.

Three bundles of lines that are square to each other in space have vanishing points of which the
principal point is the orthocentre (B. Caprile, V. Torre, Using vanishing points for camera
calibration, 1990). Here all lines count, by how well each can be drawn: rotation, focal length and
principal point are fitted to them together, whatever the solve took the principal point to be.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..camera import Camera
from ..geometry import cross, rotation
from ..problem import TRACED_SIGMA_PX
from ..values import Array

#: Directions this far from square to each other (cosine) are not.
_SQUARE = 1e-6
#: It counts as off where it is by so many standard errors, and by this part of the photo.
_SIGNIFICANT, _LEAST_OFF = 4.0, 0.02
#: Where it is told less surely than this part of the photo, nothing is said.
_UNSURE = 0.05
_STEPS = np.array([1e-6, 1e-6, 1e-6, 1e-6, 1e-3, 1e-3])


@dataclass(frozen=True, slots=True, eq=False)
class ViewMiddle:
    """The principal point as traced lines tell it.

    Parameters
    ----------
    principal_px : (2,) array
    sigma_px : float
        Its standard error, the larger of both coordinates.
    focal_px : float
    """

    principal_px: Array
    sigma_px: float
    focal_px: float

    def is_elsewhere(self, taken_px: Array, longer_px: float) -> bool:
        """Whether it is surely not where it was taken to be, in a photo with this longer side."""
        off = float(np.linalg.norm(self.principal_px - taken_px))
        sure = self.sigma_px < _UNSURE * longer_px
        return sure and off > _SIGNIFICANT * self.sigma_px and off > _LEAST_OFF * longer_px


def view_middle(
    drawn: Array, along: Array, bundles: Sequence[int], camera: Camera
) -> ViewMiddle | None:
    """The principal point from traced lines.

    Parameters
    ----------
    drawn : (k, 2, 2) array
        The lines' ends, px.
    along : (k, 3) array
        Their directions in space, unit vectors.
    bundles : k numbers
        Lines of one number are parallel.
    camera : Camera
        To begin with.

    Returns
    -------
    ViewMiddle or None
        None where no three bundles of at least two lines are square to each other.
    """
    chosen = _three_square(along, bundles)
    if chosen is None:
        return None
    own = [k for k, number in enumerate(bundles) if number in chosen]
    lines = _Lines(drawn[own], along[own], camera)
    x = np.array([0.0, 0.0, 0.0, np.log(camera.focal_px), *camera.principal_point_px])
    damping = 1e-3
    cost = lines.cost(x)
    for _ in range(60):
        r, J = lines.residuals(x), lines.jacobian(x)
        A = J.T @ J
        step = -np.linalg.solve(A + damping * np.diag(A.diagonal() + 1e-12), J.T @ r)
        new_cost = lines.cost(x + step)
        if new_cost <= cost:
            gain, cost, x, damping = cost - new_cost, new_cost, x + step, max(damping / 10, 1e-12)
            if gain <= 1e-12 * cost + 1e-20:
                break
        else:
            damping *= 10
            if damping > 1e8:
                return None
    J = lines.jacobian(x)
    try:
        covariance = np.linalg.inv(J.T @ J)
    except np.linalg.LinAlgError:
        return None
    sigma = float(np.sqrt(max(0.0, covariance[4, 4], covariance[5, 5])))
    return ViewMiddle(x[4:], sigma, float(np.exp(x[3])))


def _three_square(along: Array, bundles: Sequence[int]) -> tuple[int, int, int] | None:
    """Three bundles, of two lines at least, that are square to each other."""
    several = [n for n in sorted(set(bundles)) if list(bundles).count(n) > 1]
    firsts = {n: along[list(bundles).index(n)] for n in several}
    for i, a in enumerate(several):
        for j, b in enumerate(several[i + 1 :], start=i + 1):
            for c in several[j + 1 :]:
                pairs = ((a, b), (b, c), (a, c))
                if all(abs(float(firsts[m] @ firsts[n])) < _SQUARE for m, n in pairs):
                    return (a, b, c)
    return None


@dataclass(frozen=True, slots=True, eq=False)
class _Lines:
    """Lines and their directions; unknowns: a turn, the log focal length, the principal point."""

    drawn: Array
    along: Array
    camera: Camera

    def residuals(self, x: Array) -> Array:
        """How far each line's ends are from the way to its vanishing point, in standard errors."""
        V = self.along @ (rotation(x[:3]) @ self.camera.rotation_cam_from_world).T
        focal = float(np.exp(x[3]))
        vanishing = focal * V[:, :2] + V[:, 2:] * x[4:]
        middle = self.drawn.mean(axis=1)
        half = (self.drawn[:, 1] - self.drawn[:, 0]) / 2
        # In homogeneous coordinates: a vanishing point may be at infinity.
        way = np.column_stack([vanishing - middle * V[:, 2:], np.zeros(len(V))])
        line = np.column_stack([half, np.zeros(len(V))])
        size = np.maximum(np.linalg.norm(way, axis=1), 1e-300)
        return np.asarray(cross(line, way)[:, 2] / size / (TRACED_SIGMA_PX / np.sqrt(2)))

    def cost(self, x: Array) -> float:
        """The sum of their squares."""
        r = self.residuals(x)
        total = float(r @ r)
        return total if np.isfinite(total) else float("inf")

    def jacobian(self, x: Array) -> Array:
        """By central differences: six numbers, once a solve."""
        columns = []
        for k, step in enumerate(_STEPS):
            shift = np.zeros(6)
            shift[k] = step
            columns.append((self.residuals(x + shift) - self.residuals(x - shift)) / (2 * step))
        return np.column_stack(columns)
