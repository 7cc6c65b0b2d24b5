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

import copy
import math
from dataclasses import dataclass

import numpy as np

from .balances import balances_of
from .energies import Linearised
from .energies.circle import Support
from .geometry import rotation
from .initial import LOG_FOCAL_RANGE
from .least_squares import Evaluation, smallest_step
from .problem import Problem
from .projection import N_CAMERA, Seen, Vertices
from .tangents import Circles
from .values import Array, IntArray

#: How well a focal length from EXIF is known.
EXIF_LOG_SIGMA = 0.01
#: A person's drawing error in image units, against which priors are weighed.
DRAWING_SIGMA = 0.005
#: Newton steps onto the constraints: three will do, but where constraints are singular, as at
#: right-angled shapes, each takes only half of the way (with more of them the full step creeps).
MAX_RESTORING = 8
#: So often that again at the end, where what is left of constraints is between these.
MORE_RESTORING, EXACT, ROUGH = 4, 1e-13, 1e-6


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


@dataclass(slots=True, eq=False)
class _Last:
    """What was worked out for the last pose, whatever the prior: it is asked for again."""

    seen: tuple[Pose, Seen] | None = None
    middle: tuple[Pose, Array] | None = None
    rows: tuple[Pose, Array] | None = None
    supports: tuple[Pose, Support] | None = None
    normal: tuple[Pose, Array, Array] | None = None
    constraints: tuple[Pose, Array, Array] | None = None
    n_held: tuple[Pose, int] | None = None


class FullProblem:
    """The Objective of the full step."""

    def __init__(self, problem: Problem, prior: FocalPrior | None) -> None:
        self.problem = problem
        self.prior = prior
        self.coordinate = problem.structure.coordinate
        self.m = problem.structure.n_coordinates
        self.n_vertices = len(problem.points)
        self.up = problem.up_in_cam
        self.curved = bool(problem.blocks) or len(problem.diameters) + len(problem.rims) > 0
        self._balances = balances_of(problem.structure)
        self.constrained = self.curved or len(self._balances) > 0
        self.vertices = Vertices(problem)
        self._axis_of = _axis_of(self.coordinate, self.m)
        self.circles = Circles(problem) if len(problem.circles) else None
        self._none_idle = problem.structure.has_axes and problem.camera is None
        self._block_places: dict[int, IntArray] = {}
        self._last = _Last()
        self._last_evaluation: tuple[Pose, Evaluation] | None = None

    def with_prior(self, prior: FocalPrior | None) -> FullProblem:
        """The same with another prior."""
        other = copy.copy(self)
        other.prior = prior
        other._last_evaluation = None
        return other

    def evaluate(self, x: Pose) -> Evaluation:
        """The normal equations over (omega, kappa, g), and the constraints."""
        if self._last_evaluation is None or self._last_evaluation[0] is not x:
            self._last_evaluation = (x, self._evaluate(x))
        return self._last_evaluation[1]

    def _evaluate(self, x: Pose) -> Evaluation:
        A, b = (kept.copy() for kept in self._of_drawing(x))
        if self.prior is not None:
            slope, r = self._prior_slope(x, self.prior), self._prior_residual(x, self.prior)
            A[3, 3] += slope * slope
            b[3] += slope * r
        if self.up is not None:
            along = np.outer(self.up, self.up)
            A[:3], b[:3] = along @ A[:3], along @ b[:3]
            A[:, :3] = A[:, :3] @ along
        if self.problem.camera is not None or self._focal_at_limit(x, float(b[3])):
            A[3], A[:, 3], b[3] = 0.0, 0.0, 0.0
        # The overall size is free: it is held by one coordinate, which keeps the matrix sparse.
        held = N_CAMERA + int(np.abs(x.g).argmax())
        A[held, held] += 1.0
        idle = self.idle_directions(x)
        if len(idle):
            A += idle.T @ idle
        h, H = self.constraints(x)
        return Evaluation(A, b, h, H, n_common=N_CAMERA)

    def _of_drawing(self, x: Pose) -> tuple[Array, Array]:
        """J^T J and J^T r of what is drawn; the last ones are kept, whatever the prior."""
        if self._last.normal is None or self._last.normal[0] is not x:
            A, b = self.vertices.normal_equations(self.rows_of_vertices(x))
            if self.circles is not None:
                J, r = self._of_circles(self.circles, x)
                A += J.T @ J
                b += J.T @ r
            self._last.normal = (x, A, b)
        return self._last.normal[1:]

    def jacobian(self, x: Pose) -> tuple[Array, Array]:
        """Residuals and their derivatives over (omega, kappa, g), where nothing is held."""
        rows = self.rows_of_vertices(x)
        residuals, parts = [rows[0]], [self.vertices.dense(rows)]
        if self.prior is not None:
            row = np.zeros((1, N_CAMERA + self.m))
            row[0, 3] = self._prior_slope(x, self.prior)
            residuals.append(np.array([self._prior_residual(x, self.prior)]))
            parts.append(row)
        if self.circles is not None:
            J, r = self._of_circles(self.circles, x)
            residuals.append(r)
            parts.append(J)
        return np.concatenate(residuals), np.vstack(parts)

    def rows_of_vertices(self, x: Pose) -> Array:
        """Of what is drawn of the vertices (`projection`); the last ones are kept."""
        if self._last.rows is None or self._last.rows[0] is not x:
            rows = self.vertices.rows(self._seen(x), x.R, x.log_focal, self._middle(x))
            self._last.rows = (x, rows)
        return self._last.rows[1]

    def misfit(self, x: Pose) -> float:
        """|r|^2 of the drawing alone."""
        r = self._seen(x).r
        total = float(r @ r)
        if self.circles is not None:
            r = self.circles.residual(self._supports(self.circles, x))
            total += float(r @ r)
        return total

    @property
    def n_residuals(self) -> int:
        """Length of r."""
        return 2 * self.n_vertices + (self.prior is not None) + self.problem.circles.supports.size

    def merit(self, x: Pose, rho: float) -> float:
        """|r|^2 + rho |h|^2, the prior among r."""
        total = self.misfit(x)
        if self.prior is not None:
            total += self._prior_residual(x, self.prior) ** 2
        if rho > 0 and self.constrained:
            h, _ = self.constraints(x)
            total += rho * float(h @ h)
        return total

    def retract(self, x: Pose, step: Array) -> Pose | None:
        """Turn the camera, scale the focal length, move the coordinates."""
        turn = step[:3]
        if float(np.abs(turn).max()) > 1.0:
            return None
        if self.up is not None:
            turn = (turn @ self.up) * self.up
        old = math.exp(-x.log_focal)
        low, high = (math.exp(-limit) for limit in reversed(LOG_FOCAL_RANGE))
        kappa = min(max(old + min(max(float(step[3]), -0.4 * old), old), low), high)
        R = rotation(turn) @ x.R
        middle = self._middle(x)
        away = middle.copy()
        away[2] *= old / kappa
        # The last one is for radii, which stay as the shape moves.
        shift = np.zeros(4)
        shift[:3] = away @ R - middle @ x.R
        g = x.g + step[N_CAMERA:] + shift[self._axis_of]
        if len(self._balances):
            g = self._balances.held @ g
        size = math.sqrt(float(g @ g))
        if not 1e-12 < size < 1e12:
            return None
        # The overall size is free; keeping it stops drift.
        g = g * (math.sqrt(float(x.g @ x.g)) / size)
        moved = Pose(R, -math.log(kappa), g)
        if self.circles is not None and not self._are_visible(self.circles, moved):
            return None
        depth = self._depths(moved)
        if len(depth) and float(depth.min()) <= 1e-4 * float(np.abs(depth).mean()):
            return None
        return moved

    def _depths(self, x: Pose) -> Array:
        """Of vertices and circles' centres."""
        if self.circles is None:
            return np.asarray(self._seen(x).in_cam[2])
        return np.asarray(self.positions(x) @ x.R[2])

    def _are_visible(self, circles: Circles, x: Pose) -> bool:
        radii = x.g[self.problem.structure.radius]
        return self._supports(circles, x).visible and float(radii.min()) > 0

    def idle_directions(self, x: Pose) -> Array:
        """Directions that change nothing or are not free, (t, 4 + m) rows of unknowns.

        Without object axes the frame is idle: about the vertical where circles show it, else
        wholly. A known camera turns about the upward direction only, and keeps its focal length.
        """
        if self._none_idle:
            return np.zeros((0, N_CAMERA + self.m))
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

    def shape(self, x: Pose) -> Array:
        """Vertices and circles' centres in the camera frame, of unit size: a reading's likeness."""
        in_cam = self.positions(x) @ x.R.T
        return np.asarray(in_cam / max(math.sqrt(float(np.vdot(in_cam, in_cam))), 1e-300))

    def _seen(self, x: Pose) -> Seen:
        """The view of a pose; the last one is kept, for it is asked for again."""
        if self._last.seen is None or self._last.seen[0] is not x:
            self._last.seen = (x, self.vertices.seen(x.R, x.log_focal, x.g))
        return self._last.seen[1]

    def _supports(self, circles: Circles, x: Pose) -> Support:
        """The circles of a pose; the last ones are kept, for they are asked for again."""
        if self._last.supports is None or self._last.supports[0] is not x:
            self._last.supports = (x, circles.seen(x.R, x.log_focal, x.g))
        return self._last.supports[1]

    def _of_circles(self, circles: Circles, x: Pose) -> tuple[Array, Array]:
        """Their rows of the Jacobian, and their residuals."""
        support = self._supports(circles, x)
        J = circles.jacobian(support, x.R, x.log_focal, self._middle(x))
        return J, circles.residual(support)

    def _prior_residual(self, x: Pose, prior: FocalPrior) -> float:
        return DRAWING_SIGMA * (x.log_focal - prior.log_focal) / prior.sigma

    def _prior_slope(self, x: Pose, prior: FocalPrior) -> float:
        """The derivative of its residual by kappa."""
        return -math.exp(x.log_focal) * DRAWING_SIGMA / prior.sigma

    def _focal_at_limit(self, x: Pose, slope: float) -> bool:
        """Whether the drawing pulls the focal length beyond what cameras have."""
        low, high = LOG_FOCAL_RANGE
        edge = 1e-9
        return (x.log_focal >= high - edge and slope > 0) or (
            x.log_focal <= low + edge and slope < 0
        )

    def _middle(self, x: Pose) -> Array:
        """The shape's middle in the camera frame; the last one is kept."""
        if self._last.middle is None or self._last.middle[0] is not x:
            if self.circles is None:
                middle = self._seen(x).in_cam.sum(axis=1) / self.n_vertices
            else:
                middle = x.R @ (self.positions(x).sum(axis=0) / len(self.coordinate))
            self._last.middle = (x, middle)
        return self._last.middle[1]

    def constraints(self, x: Pose) -> tuple[Array, Array]:
        """Leftover constraints h and their derivatives H over (omega, kappa, g)."""
        if not self.constrained:
            return np.zeros(0), np.zeros((0, N_CAMERA + self.m))
        if self._last.constraints is None or self._last.constraints[0] is not x:
            self._last.constraints = (x, *self._constraints(x))
        return self._last.constraints[1:]

    def _constraints(self, x: Pose) -> tuple[Array, Array]:
        positions = self.positions(x)
        residuals, jacobians = [], []
        M = N_CAMERA + self.m
        for k, block in enumerate(self.problem.blocks):
            at = block.evaluate(positions)
            size = len(at.residual)
            summed = np.bincount(self._places_of(k, at), at.value.ravel(), size * M)
            residuals.append(at.residual)
            jacobians.append(summed.astype(np.float64, copy=False).reshape(size, M))
        if len(self.problem.diameters):
            h, by_g = self.problem.diameters.evaluate(x.g, self.coordinate)
            residuals.append(h)
            jacobians.append(np.hstack([np.zeros((len(h), N_CAMERA)), by_g]))
        if len(self.problem.rims):
            h, by_g = self.problem.rims.evaluate(x.g)
            residuals.append(h)
            jacobians.append(np.hstack([np.zeros((len(h), N_CAMERA)), by_g]))
        if len(self._balances):
            rows = self._balances.rows
            residuals.append(rows @ x.g)
            jacobians.append(np.hstack([np.zeros((len(rows), N_CAMERA)), rows]))
        if len(residuals) == 1:
            return residuals[0], jacobians[0]
        return np.concatenate(residuals), np.vstack(jacobians)

    def n_held(self, x: Pose) -> int:
        """How many freedoms the constraints take, the rank of H; the last one is kept."""
        if self._last.n_held is None or self._last.n_held[0] is not x:
            _, H = self.constraints(x)
            self._last.n_held = (x, int(np.linalg.matrix_rank(H)) if H.size else 0)
        return self._last.n_held[1]

    def _places_of(self, block: int, at: Linearised) -> IntArray:
        """Where a block's derivatives belong in its rows of H: the same for all positions."""
        if block not in self._block_places:
            columns = N_CAMERA + self.coordinate[at.vertex]
            places = at.row[:, None] * (N_CAMERA + self.m) + columns
            self._block_places[block] = places.ravel()
        return self._block_places[block]

    def restore(self, x: Pose) -> Pose:
        """Move the coordinates onto h = 0: dg = -H^T (H H^T)^+ h."""
        if len(self._balances):
            g = self._balances.hold(x.g)
            x = x if g is x.g else Pose(x.R, x.log_focal, g)
        if not self.curved:
            return x
        h, H = self.constraints(x)
        worst = float(np.abs(h).max(initial=0.0))
        for _ in range(MAX_RESTORING):
            if worst < EXACT:
                break
            dg = smallest_step(h, H[:, N_CAMERA:])
            moved = Pose(x.R, x.log_focal, x.g + dg)
            h, H = self.constraints(moved)
            after = float(np.abs(h).max(initial=0.0))
            if not after < worst:
                break
            x, worst = moved, after
        return x


def held_at_last(full: FullProblem, x: Pose) -> Pose:
    """The pose with constraints that hold roughly held to the last digits.

    Singular ones come nearer by half at each step, of which a descent takes few.
    """
    for _ in range(MORE_RESTORING):
        h, _ = full.constraints(x)
        if not EXACT < float(np.abs(h).max(initial=0.0)) < ROUGH:
            break
        x = full.restore(x)
    return x


def _axis_of(coordinate: IntArray, n_coordinates: int) -> IntArray:
    """The axis along which each shared coordinate runs, 3 for radii, (m,)."""
    axis_of = np.full(n_coordinates, 3)
    axis_of[coordinate] = np.arange(3)
    return axis_of
