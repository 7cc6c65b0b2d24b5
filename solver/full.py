"""The full step: rotation, focal length and shared coordinates against the drawing ([Lau10] 4.2).

The unknowns are x = (omega, kappa, g): a small turn, the inverse focal length, and the shared
coordinates. The shape turns about its own middle, not about the eye far away. Changing kappa moves
it along the axis of view as well, so that its middle keeps its size in the image (a dolly zoom):
kappa then is the strength of the perspective alone, on which the projection depends almost
linearly, down to kappa = 0 for a view from afar.

Each drawn vertex speaks of seven unknowns only: the turn, kappa and its own three coordinates. Its
part of J^T J is a block of 7 x 7, and the whole is their sum in the right places.

The objective is the distance in the image between the projected and the drawn vertices (the paper's
projection term |p - p'|^2); leftover constraints are held exactly.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .energies.circle import Support, circle_support
from .geometry import cross, rotation
from .initial import LOG_FOCAL_RANGE
from .least_squares import Evaluation, smallest_step
from .problem import Problem
from .values import Array, IntArray

#: How well a focal length from EXIF is known.
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


@dataclass(frozen=True, slots=True, eq=False)
class _Seen:
    """The vertices as the camera of a pose sees them."""

    pose: Pose
    in_cam: Array
    projected: Array
    r: Array


@dataclass(frozen=True, slots=True, eq=False)
class _Rows:
    """Rows of a Jacobian that are zero but for few columns: values (t, w), columns (t, w)."""

    values: Array
    columns: IntArray


class FullProblem:
    """The Objective of the full step."""

    def __init__(self, problem: Problem, prior: FocalPrior | None) -> None:
        self.problem = problem
        self.prior = prior
        self.coordinate = problem.structure.coordinate
        self.m = problem.structure.n_coordinates
        self.n_vertices = len(problem.points)
        self.up = problem.up_in_cam
        self.constrained = bool(problem.blocks) or len(problem.diameters) > 0
        self._camera_columns = np.arange(4)
        self._columns = self._with_camera(self.coordinate[: self.n_vertices])
        self._places = self._columns[:, :, None] * (4 + self.m) + self._columns[:, None, :]
        self._last: _Seen | None = None

    def _with_camera(self, columns: IntArray) -> IntArray:
        """Columns of the unknowns: omega and kappa, then shared coordinates."""
        camera = np.broadcast_to(self._camera_columns, (len(columns), 4))
        return np.hstack([camera, 4 + columns])

    def evaluate(self, x: Pose) -> Evaluation:
        """The normal equations over (omega, kappa, g), and the constraints."""
        seen = self._seen(x)
        M = 4 + self.m
        B = self._vertex_blocks(seen)
        turned = np.swapaxes(B, 1, 2)
        A = _sum_at(self._places, turned @ B, M * M).reshape(M, M)
        b = _sum_at(self._columns, turned @ seen.r[..., None], M)
        for rows, r in self._further_rows(x):
            J = self._dense(rows)
            A += J.T @ J
            b += J.T @ r
        if self.up is not None:
            along = np.outer(self.up, self.up)
            A[:3], b[:3] = along @ A[:3], along @ b[:3]
            A[:, :3] = A[:, :3] @ along
        if self.problem.camera is not None or self._focal_at_limit(x, float(b[3])):
            A[3], A[:, 3], b[3] = 0.0, 0.0, 0.0
        # The overall size is free: it is held by one coordinate, which keeps the matrix sparse.
        held = 4 + int(np.argmax(np.abs(x.g)))
        A[held, held] += 1.0
        idle = self.idle_directions(x)
        if len(idle):
            A += idle.T @ idle
        h, H = self.constraints(x)
        return Evaluation(A, b, h, H, n_common=4)

    def jacobian(self, x: Pose) -> tuple[Array, Array]:
        """Residuals and their derivatives over (omega, kappa, g), where nothing is held."""
        seen = self._seen(x)
        columns = np.repeat(self._columns, 2, axis=0)
        vertices = _Rows(self._vertex_blocks(seen).reshape(-1, 7), columns)
        parts = [(vertices, seen.r.reshape(-1)), *self._further_rows(x)]
        J = np.vstack([self._dense(rows) for rows, _ in parts])
        return np.concatenate([r for _, r in parts]), J

    def _dense(self, rows: _Rows) -> Array:
        J = np.zeros((len(rows.values), 4 + self.m))
        J[np.arange(len(J))[:, None], rows.columns] = rows.values
        return J

    def merit(self, x: Pose, rho: float) -> float:
        """|r|^2 + rho |h|^2."""
        seen = self._seen(x).r.reshape(-1)
        total = float(seen @ seen)
        if self.prior is not None:
            total += self._prior_residual(x, self.prior) ** 2
        if len(self.problem.circles):
            r = self._circle_residual(self._supports(x))
            total += float(r @ r)
        if rho > 0:
            for block in self.problem.blocks:
                h = block.evaluate(x.g[self.coordinate]).residual
                total += rho * float(h @ h)
            if len(self.problem.diameters):
                h, _ = self.problem.diameters.evaluate(x.g, self.coordinate)
                total += rho * float(h @ h)
        return total

    def retract(self, x: Pose, step: Array) -> Pose | None:
        """Turn the camera, scale the focal length, move the coordinates."""
        if float(np.abs(step[:3]).max()) > 1.0:
            return None
        turn = step[:3] if self.up is None else (step[:3] @ self.up) * self.up
        old, (low, high) = np.exp(-x.log_focal), np.exp(np.negative(LOG_FOCAL_RANGE[::-1]))
        kappa = min(max(old + min(max(float(step[3]), -0.4 * old), old), low), high)
        R = rotation(turn) @ x.R
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
        known = self.problem.camera is not None
        rows = np.zeros((len(turns) + known, 4 + self.m))
        rows[: len(turns), :3] = turns
        rows[len(turns) :, 3] = 1.0
        return rows

    def positions(self, x: Pose) -> Array:
        """Vertices, then circles' centres, in object axes, (n + k, 3)."""
        return np.asarray(x.g[self.coordinate])

    def _seen(self, x: Pose) -> _Seen:
        """The view of a pose; the last one is kept, for it is asked for twice."""
        if self._last is None or self._last.pose is not x:
            in_cam = self.positions(x)[: self.n_vertices] @ x.R.T
            projected = np.exp(x.log_focal) * in_cam[:, :2] / in_cam[:, 2:]
            r = (projected - self.problem.points) * self.problem.weights[:, None]
            self._last = _Seen(x, in_cam, projected, r)
        return self._last

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

    def _prior_residual(self, x: Pose, prior: FocalPrior) -> float:
        return DRAWING_SIGMA * (x.log_focal - prior.log_focal) / prior.sigma

    def _vertex_blocks(self, seen: _Seen) -> Array:
        """Derivatives of r by (omega, kappa, x, y, z) of each vertex, (n, 2, 7)."""
        x, in_cam, projected = seen.pose, seen.in_cam, seen.projected
        f = float(np.exp(x.log_focal))
        weights = self.problem.weights[:, None]
        # d(u, v) / d x_cam
        D = np.zeros((len(in_cam), 2, 3))
        inverse_depth = 1 / in_cam[:, 2]
        D[:, 0, 0] = D[:, 1, 1] = f * inverse_depth
        D[:, :, 2] = -projected * inverse_depth[:, None]
        D *= weights[..., None]
        B = np.empty((len(in_cam), 2, 7))
        # d x_cam / d omega = -[x_cam - middle]x, so that a row d becomes (x_cam - middle) x d.
        middle = self._middle(x)
        B[:, :, :3] = cross((in_cam - middle)[:, None, :], D)
        # d f / d kappa = -f^2, and the middle depth goes with f.
        B[:, :, 3] = -f * (projected * weights + middle[2] * D[:, :, 2])
        B[:, :, 4:] = D @ x.R
        return B

    def _further_rows(self, x: Pose) -> list[tuple[_Rows, Array]]:
        """What is not of vertices: the focal length's prior, and circles."""
        found = []
        if self.prior is not None:
            slope = -float(np.exp(x.log_focal)) * DRAWING_SIGMA / self.prior.sigma
            row = _Rows(np.array([[slope]]), np.array([[3]]))
            found.append((row, np.array([self._prior_residual(x, self.prior)])))
        if len(self.problem.circles):
            support = self._supports(x)
            found.append((self._circle_rows(x, support), self._circle_residual(support)))
        return found

    def _circle_rows(self, x: Pose, support: Support) -> _Rows:
        structure = self.problem.structure
        centres = self.positions(x)[self.n_vertices :] @ x.R.T
        normal = x.R[:, 2 if structure.vertical is None else structure.vertical]
        by_centre, by_normal = support.by_centre, support.by_normal
        B = np.empty((*support.h.shape, 8))
        middle = self._middle(x)
        B[..., :3] = cross((centres - middle)[:, None, :], by_centre) + cross(normal, by_normal)
        dolly = middle[2] * by_centre[:, :, 2]
        B[..., 3] = -np.exp(x.log_focal) * (support.by_log_focal + dolly)
        B[..., 4:7] = by_centre @ x.R
        B[..., 7] = support.by_radius
        B *= self.problem.circles.weights[:, None, None]
        own = np.column_stack([self.coordinate[self.n_vertices :], structure.radius])
        columns = np.repeat(self._with_camera(own), support.h.shape[1], axis=0)
        return _Rows(B.reshape(-1, 8), columns)

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

    def constraints(self, x: Pose) -> tuple[Array, Array]:
        """Leftover constraints h and their derivatives H over (omega, kappa, g)."""
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
        if not self.constrained:
            return x
        h, H = self.constraints(x)
        worst = float(np.abs(h).max(initial=0.0))
        for _ in range(8):
            if worst < 1e-15:
                break
            dg = smallest_step(h, H[:, 4:])
            moved = Pose(x.R, x.log_focal, x.g + dg)
            h, H = self.constraints(moved)
            after = float(np.abs(h).max(initial=0.0))
            if not after < worst:
                break
            x, worst = moved, after
        return x


def _sum_at(places: IntArray, values: Array, size: int) -> Array:
    """Values summed at their places, (size,)."""
    return np.asarray(np.bincount(places.ravel(), values.ravel(), size), dtype=np.float64)
