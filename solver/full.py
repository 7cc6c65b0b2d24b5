"""The full step: rotation, focal length and shared coordinates against the drawing ([Lau10] 4.2).

The unknowns are x = (omega, kappa, g): a small turn, the inverse focal length, and the shared
coordinates. The shape turns about its own middle, not about the eye far away. Changing kappa moves
it along the axis of view as well, so that its middle keeps its size in the image (a dolly zoom):
kappa then is the strength of the perspective alone, on which the projection depends almost
linearly, down to kappa = 0 for a view from afar.

The objective is the distance in the image between the projected and the drawn vertices (the paper's
projection term |p - p'|^2); leftover constraints are held exactly.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from .energies.circle import Support, circle_support
from .geometry import cross
from .initial import LOG_FOCAL_RANGE
from .least_squares import Evaluation
from .problem import Problem
from .values import Array

#: How well a focal length from EXIF is known, and the wide prior where nothing else decides.
EXIF_LOG_SIGMA = 0.01
#: A person's drawing error in image units, against which priors are weighed.
DRAWING_SIGMA = 0.005


@dataclass(frozen=True, slots=True, eq=False)
class Pose:
    """A point of the full step.

    Parameters
    ----------
    R : (3, 3) array
        Camera from object axes; the eye is at the origin.
    log_focal : float
    g : (m,) array
        Shared coordinates; their overall size is free.
    """

    R: Array
    log_focal: float
    g: Array


@dataclass(frozen=True, slots=True)
class FocalPrior:
    """What is known of the focal length beforehand, log image units."""

    log_focal: float
    sigma: float


class FullProblem:
    """The Objective of the full step."""

    def __init__(self, problem: Problem, prior: FocalPrior | None) -> None:
        self.problem = problem
        self.prior = prior
        self.coordinate = problem.structure.coordinate
        self.m = problem.structure.n_coordinates
        self.n_vertices = len(problem.points)
        self.up = problem.up_in_cam

    def evaluate(self, x: Pose) -> Evaluation:
        """Residuals and Jacobians over (omega, phi, g)."""
        r, J = self._reprojection(x)
        h, H = self._constraints(x)
        size = float(np.linalg.norm(x.g)) or 1.0
        gauge = np.zeros(4 + self.m)
        gauge[4:] = x.g / size
        turns = self.idle_directions(x)
        return Evaluation(r, J, h, H, np.outer(gauge, gauge) + turns.T @ turns)

    def merit(self, x: Pose, rho: float) -> float:
        """|r|^2 + rho |h|^2."""
        r = self._residual(x)
        total = float(r @ r)
        if rho > 0:
            for block in self.problem.blocks:
                h = block.evaluate(x.g[self.coordinate]).residual
                total += rho * float(h @ h)
            h, _ = self.problem.diameters.evaluate(x.g, self.coordinate)
            total += rho * float(h @ h)
        return total

    def retract(self, x: Pose, step: Array) -> Pose | None:
        """Turn the camera, scale the focal length, move the coordinates."""
        if float(np.abs(step[:3]).max()) > 1.0:
            return None
        turn = step[:3] if self.up is None else (step[:3] @ self.up) * self.up
        old, (low, high) = np.exp(-x.log_focal), np.exp(np.negative(LOG_FOCAL_RANGE[::-1]))
        kappa = float(np.clip(old + np.clip(step[3], -0.4 * old, old), low, high))
        R = Rotation.from_rotvec(turn).as_matrix() @ x.R
        middle = self._middle(x)
        moved_middle = middle * np.array([1.0, 1.0, old / kappa])
        g = x.g + step[4:] + self._shift(R.T @ moved_middle - x.R.T @ middle)
        size = float(np.linalg.norm(g))
        if not 1e-12 < size < 1e12:
            return None
        # The overall size is free; keeping it stops drift.
        g = g * (float(np.linalg.norm(x.g)) / size)
        moved = Pose(R, -float(np.log(kappa)), g)
        if len(self.problem.circles) and not self._circles_visible(moved):
            return None
        depth = moved.g[self.coordinate] @ moved.R[2]
        if len(depth) and float(depth.min()) <= 1e-4 * float(np.abs(depth).mean()):
            return None
        return moved

    def _circles_visible(self, x: Pose) -> bool:
        return self._supports(x).visible and bool((x.g[self.problem.structure.radius] > 0).all())

    def idle_directions(self, x: Pose) -> Array:
        """Directions that change nothing or are not free, (t, 4 + m) rows of unknowns.

        Without object axes the frame is idle: about the vertical where circles show it, else
        wholly. A known camera turns about the upward direction only, and keeps its focal length.
        """
        structure = self.problem.structure
        turns = np.zeros((0, 3))
        if not structure.has_axes:
            vertical = structure.vertical
            turns = np.eye(3) if vertical is None else x.R[:, vertical][None]
        if self.up is not None:
            turns = np.vstack([turns, np.eye(3) - np.outer(self.up, self.up)])
        rows = np.zeros((len(turns) + 1, 4 + self.m))
        rows[:-1, :3] = turns
        rows[-1, 3] = float(self.problem.camera is not None)
        return rows

    def positions(self, x: Pose) -> Array:
        """Vertices, then circles' centres, in object axes, (n + k, 3)."""
        return np.asarray(x.g[self.coordinate])

    def _residual(self, x: Pose) -> Array:
        in_cam = self.positions(x)[: self.n_vertices] @ x.R.T
        projected = np.exp(x.log_focal) * in_cam[:, :2] / in_cam[:, 2:]
        r = (projected - self.problem.points) * self.problem.weights[:, None]
        parts = [r.reshape(-1), self._prior_residual(x)]
        if len(self.problem.circles):
            parts.append(self._circle_residual(self._supports(x)))
        return np.concatenate(parts)

    def _supports(self, x: Pose) -> Support:
        centres = self.positions(x)[self.n_vertices :] @ x.R.T
        radii = x.g[self.problem.structure.radius]
        vertical = self.problem.structure.vertical
        normal = x.R[:, 2 if vertical is None else vertical]
        focal = float(np.exp(x.log_focal))
        return circle_support(centres, radii, normal, focal, self.problem.circles.directions)

    def _circle_residual(self, support: Support) -> Array:
        circles = self.problem.circles
        return np.asarray(((support.h - circles.supports) * circles.weights[:, None]).reshape(-1))

    def _prior_residual(self, x: Pose) -> Array:
        if self.prior is None:
            return np.zeros(0)
        return np.array([DRAWING_SIGMA * (x.log_focal - self.prior.log_focal) / self.prior.sigma])

    def _reprojection(self, x: Pose) -> tuple[Array, Array]:
        in_cam = self.positions(x)[: self.n_vertices] @ x.R.T
        n, f = len(in_cam), float(np.exp(x.log_focal))
        inverse_depth = 1 / in_cam[:, 2]
        projected = f * in_cam[:, :2] * inverse_depth[:, None]
        # d(u, v) / d x_cam
        D = np.zeros((n, 2, 3))
        D[:, 0, 0] = D[:, 1, 1] = f * inverse_depth
        D[:, :, 2] = -projected * inverse_depth[:, None]
        D *= self.problem.weights[:, None, None]
        J = np.zeros((2 * n, 4 + self.m))
        # d x_cam / d omega = -[x_cam - middle]x, so that a row d becomes (x_cam - middle) x d.
        middle = self._middle(x)
        J[:, :3] = cross((in_cam - middle)[:, None, :], D).reshape(-1, 3)
        # d f / d kappa = -f^2, and the middle depth goes with f.
        in_place = -f * projected * self.problem.weights[:, None]
        J[:, 3] = (in_place - f * middle[2] * D[:, :, 2]).reshape(-1)
        by_axis = (D @ x.R).reshape(-1, 3)
        rows = np.arange(2 * n)
        for k in range(3):
            J[rows, 4 + np.repeat(self.coordinate[:n, k], 2)] = by_axis[:, k]
        if self.prior is not None:
            prior_row = np.zeros((1, 4 + self.m))
            prior_row[0, 3] = -f * DRAWING_SIGMA / self.prior.sigma
            J = np.vstack([J, prior_row])
        if len(self.problem.circles):
            J = np.vstack([J, self._circle_jacobian(x)])
        r = self._residual(x)
        if self.up is not None:
            J[:, :3] = np.outer(J[:, :3] @ self.up, self.up)
        if self.problem.camera is not None:
            J[:, 3] = 0.0
        if self._focal_at_limit(x, float(J[:, 3] @ r)):
            J[:, 3] = 0.0
        return r, J

    def _circle_jacobian(self, x: Pose) -> Array:
        structure, support = self.problem.structure, self._supports(x)
        weights = np.repeat(self.problem.circles.weights, support.h.shape[1])
        centres = self.positions(x)[self.n_vertices :] @ x.R.T
        normal = x.R[:, 2 if structure.vertical is None else structure.vertical]
        by_centre, by_normal = support.by_centre, support.by_normal
        J = np.zeros((support.h.size, 4 + self.m))
        middle = self._middle(x)
        turn = cross((centres - middle)[:, None, :], by_centre) + cross(normal, by_normal)
        J[:, :3] = turn.reshape(-1, 3)
        f = np.exp(x.log_focal)
        dolly = middle[2] * by_centre[:, :, 2]
        J[:, 3] = (-f * (support.by_log_focal + dolly)).reshape(-1)
        rows = np.arange(len(J))
        by_axis = (by_centre @ x.R).reshape(-1, 3)
        each = support.h.shape[1]
        for k in range(3):
            columns = 4 + np.repeat(self.coordinate[self.n_vertices :, k], each)
            J[rows, columns] = by_axis[:, k]
        J[rows, 4 + np.repeat(structure.radius, each)] = support.by_radius.reshape(-1)
        return J * weights[:, None]

    def _focal_at_limit(self, x: Pose, slope: float) -> bool:
        """Whether the drawing pulls the focal length beyond what cameras have."""
        low, high = LOG_FOCAL_RANGE
        edge = 1e-9
        return (x.log_focal >= high - edge and slope > 0) or (
            x.log_focal <= low + edge and slope < 0
        )

    def _middle(self, x: Pose) -> Array:
        """The shape's middle in the camera frame."""
        return np.asarray(x.R @ self.positions(x).mean(axis=0))

    def _shift(self, vector: Array) -> Array:
        """The shared coordinates' change when the whole shape moves by a vector in object axes."""
        change = np.zeros(self.m)
        for k in range(3):
            change[self.coordinate[:, k]] = vector[k]
        return change

    def _constraints(self, x: Pose) -> tuple[Array, Array]:
        positions = self.positions(x)
        residuals, jacobians = [np.zeros(0)], [np.zeros((0, 4 + self.m))]
        for block in self.problem.blocks:
            at = block.evaluate(positions)
            H = np.zeros((len(at.residual), 4 + self.m))
            for k in range(3):
                columns = 4 + self.coordinate[at.vertex, k]
                np.add.at(H, (at.row, columns), at.value[:, k])
            residuals.append(at.residual)
            jacobians.append(H)
        if len(self.problem.diameters):
            h, by_g = self.problem.diameters.evaluate(x.g, self.coordinate)
            residuals.append(h)
            jacobians.append(np.hstack([np.zeros((len(h), 4)), by_g]))
        return np.concatenate(residuals), np.vstack(jacobians)

    def restore(self, x: Pose) -> Pose:
        """Move the coordinates onto h = 0: dg = -H^T (H H^T)^+ h."""
        if not self.problem.blocks and not len(self.problem.diameters):
            return x
        h, H = self._constraints(x)
        worst = float(np.abs(h).max(initial=0.0))
        for _ in range(8):
            if worst < 1e-15:
                break
            dg = -np.linalg.lstsq(H[:, 4:], h, rcond=1e-9)[0]
            moved = Pose(x.R, x.log_focal, x.g + dg)
            h, H = self._constraints(moved)
            after = float(np.abs(h).max(initial=0.0))
            if not after < worst:
                break
            x, worst = moved, after
        return x
