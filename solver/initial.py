"""The start, without any search: the camera from the drawn directions, then linear depths.

[Lau10] 4.2 finds depths from zero by Nelder-Mead and restarts. Here the edges along the object axes
give the rotation and the focal length first, and then all coordinates follow from one linear
least-squares problem; the role is the paper's: an approximate shape to start the full step from.

Terms
-----
line
    (x, y, 1) x (x', y', 1) of a drawn edge's ends, image units; the plane through the eye and the
    edge has the normal N = (f l0, f l1, l2) in the camera frame.
Necker twin
    The other reading of a drawing, seen from below instead of above.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from .circles import tilted_views
from .geometry import cross
from .problem import Problem
from .values import Array, BoolArray, IntArray

#: Focal lengths beyond these, in image units, are no camera a person holds.
LOG_FOCAL_RANGE = (float(np.log(0.4)), float(np.log(40.0)))
#: Where the formula's view fits the lines to this angle (rad, RMS), no further views are tried.
GOOD_MISFIT = 0.02
#: From so many lines on it pays to weigh each by how well its ends can be drawn.
MANY_LINES = 30
#: Iterations on the lines alone; the full step goes on from there.
REFINEMENTS = 12
#: What most cameras have: about 12 to 110 mm equivalent.
LIKELY_LOG_FOCAL = (float(np.log(0.7)), float(np.log(6.0)))
#: Log focal lengths to begin with: wide, usual, tele.
FOCAL_GUESSES = (float(np.log(1.5)), float(np.log(0.9)), float(np.log(3.5)))
#: Between a phone's main camera (26 mm equivalent) and its twofold zoom (52 mm).
USUAL_LOG_FOCAL = float(np.log(2.05))


@dataclass(frozen=True, slots=True, eq=False)
class Start:
    """A camera to start from: rotation camera from object axes, and log focal length."""

    R: Array
    log_focal: float
    misfit: float


def starts(problem: Problem) -> list[Start]:
    """Cameras that agree with the drawn directions, best first, Necker twins included.

    Where the camera is known, they agree with its upward direction as well.
    """
    found = _starts(problem)
    up, vertical = problem.up_in_cam, problem.structure.vertical
    if up is None or vertical is None:
        return found
    return _distinct([replace(s, R=_upright(s.R, vertical, up)) for s in found])


def _upright(R: Array, vertical: int, up: Array) -> Array:
    """The nearest rotation whose vertical axis points up."""
    if R[:, vertical] @ up < 0:
        # Two axes turn round together: their signs are free.
        signs = np.ones(3)
        signs[[vertical, (vertical + 1) % 3]] = -1.0
        R = R * signs
    axis = cross(R[:, vertical], up)
    sine = float(np.linalg.norm(axis))
    angle = np.arctan2(sine, R[:, vertical] @ up)
    return np.asarray(Rotation.from_rotvec(axis * (angle / max(sine, 1e-300))).as_matrix() @ R)


def _starts(problem: Problem) -> list[Start]:
    axis = problem.structure.edge_axis
    along = axis >= 0
    fixed = problem.log_focal_prior
    if not problem.structure.has_axes:
        tilted = tilted_views(problem.circles) if len(problem.circles) else [np.eye(3)]
        focals = FOCAL_GUESSES if fixed is None else (fixed,)
        return [Start(R, f, 0.0) for R in tilted for f in focals]
    drawn, lengths = _lines(problem, along)
    ref = USUAL_LOG_FOCAL if fixed is None else fixed
    lines, weights, axes = _gathered(drawn, lengths, axis[along], ref)
    if fixed is None and len(set(axes.tolist())) < 3:
        # Two directions tell little of the focal length: the full step finds it, from several.
        views = [_views_at(lines, weights, axes, float(f))[:2] for f in FOCAL_GUESSES]
        return [start for pair in zip(*views, strict=False) for start in pair]
    candidates = _from_mean_directions(problem)
    found = _refine_all(lines, weights, axes, candidates, fixed)
    total = float(np.sum(weights**2))
    if not found or found[0].misfit > GOOD_MISFIT**2 * total:
        candidates += _grid(lines, weights, axes, fixed)
        found = _refine_all(lines, weights, axes, candidates, fixed)
    if len(lengths) > MANY_LINES and found[0].misfit > 1e-12 * total:
        fair = _fair_weights(problem, along, drawn, found[0])
        lines, weights, axes = _gathered(drawn, fair, axis[along], found[0].log_focal)
        candidates = [(start.R, start.log_focal) for start in found]
        found = _refine_all(lines, weights, axes, candidates, fixed)
    if fixed is None and not _likely(found[0].log_focal):
        # Careless lines say "from afar" too easily: begin from usual focal lengths as well.
        usual = [_refine_all(lines, weights, axes, candidates, f)[:2] for f in FOCAL_GUESSES[::2]]
        found = [start for group in [*usual, found[:2]] for start in group]
    return found


def _likely(log_focal: float) -> bool:
    return LIKELY_LOG_FOCAL[0] < log_focal < LIKELY_LOG_FOCAL[1]


def _views_at(lines: Array, weights: Array, axes: IntArray, log_focal: float) -> list[Start]:
    """Views for one focal length."""
    grid = _grid(lines, weights, axes, log_focal)
    return _refine_all(lines, weights, axes, grid, log_focal)


def _refine_all(
    lines: Array,
    weights: Array,
    axes: IntArray,
    candidates: list[tuple[Array, float]],
    fixed: float | None,
) -> list[Start]:
    if not candidates:
        return []
    views = np.array([R for R, _ in candidates])
    log_focals = np.array([f if fixed is None else fixed for _, f in candidates])
    return _distinct(_refine(_Lines(lines, weights, axes), views, log_focals, fixed is not None))


def _distinct(found: list[Start]) -> list[Start]:
    """Best first, each view once."""
    kept: list[Start] = []
    for start in sorted(found, key=lambda s: s.misfit):
        if not any(_same_view(start, other) for other in kept):
            kept.append(start)
    return kept


def _lines(problem: Problem, chosen: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Homogeneous lines (k, 3), and weights (k,): drawn lengths, times how exact the ends are."""
    ends = problem.ends[chosen]
    p, q = problem.points[ends[:, 0]], problem.points[ends[:, 1]]
    ones = np.ones((len(p), 1))
    lines = cross(np.hstack([p, ones]), np.hstack([q, ones]))
    return lines, np.linalg.norm(q - p, axis=1) * problem.weights[ends].min(axis=1)


def _fair_weights(problem: Problem, chosen: BoolArray, lines: Array, start: Start) -> Array:
    """Weights by which the residuals are distances of drawn ends from lines to vanishing points.

    Angles alone favour wide lenses where many short lines are drawn carelessly: the first-order
    distance does not.
    """
    ends = problem.ends[chosen]
    f = np.exp(start.log_focal)
    K = np.array([f, f, 1.0])
    vanishing = (K * start.R[:, problem.structure.edge_axis[chosen]].T)[:, None, :]
    slope = vanishing[..., :2] - problem.points[ends] * vanishing[..., 2:]
    per_px = np.sqrt((slope**2).sum(axis=(1, 2)))
    return np.asarray(np.sqrt(2) * np.linalg.norm(lines * K, axis=1) / np.maximum(per_px, 1e-300))


def _gathered(
    lines: Array, weights: Array, axes: IntArray, log_focal: float
) -> tuple[Array, Array, IntArray]:
    """Three lines for all those along one axis, with the same sum of squares for every direction.

    Each line counts by its angle, as a camera of this focal length sees it.
    """
    f = np.exp(log_focal)
    K = np.array([f, f, 1.0])
    normals = lines * K
    size = np.sqrt(np.einsum("mi,mi->m", normals, normals))
    normals = normals * (weights / np.maximum(size, 1e-300))[:, None]
    found: list[tuple[Array, Array, int]] = []
    for k in sorted(set(axes.tolist())):
        own = normals[axes == k]
        squares, directions = np.linalg.eigh(own.T @ own)
        found.append((directions.T / K, np.sqrt(np.maximum(squares, 0.0)), k))
    return (
        np.vstack([own for own, _, _ in found]),
        np.concatenate([w for _, w, _ in found]),
        np.repeat(np.array([k for _, _, k in found], dtype=np.int64), 3),
    )


def _normals(lines: Array, log_focals: Array) -> tuple[Array, Array]:
    """Unit normals (k, m, 3) of the planes through the eye, and derivatives by log focal length."""
    f = np.exp(log_focals)[:, None, None]
    N = lines * np.concatenate([f, f, np.ones_like(f)], axis=2)
    dN = lines * np.concatenate([f, f, np.zeros_like(f)], axis=2)
    length = np.maximum(np.sqrt(np.einsum("kmi,kmi->km", N, N)), 1e-300)[..., None]
    N, dN = N / length, dN / length
    return N, dN - N * np.einsum("kmi,kmi->km", N, dN)[..., None]


@dataclass(frozen=True, slots=True, eq=False)
class _Lines:
    """Lines (m, 3), their weights (m,) and the axis (m,) along which each runs."""

    lines: Array
    weights: Array
    axes: IntArray

    def residuals(self, R: Array, log_focals: Array) -> Array:
        """w_e N_e . D_e for k cameras, (k, m)."""
        N, _ = _normals(self.lines, log_focals)
        return np.asarray(self.weights * np.einsum("kmi,kim->km", N, R[:, :, self.axes]))

    def linearised(self, R: Array, log_focals: Array) -> tuple[Array, Array]:
        """Residuals (k, m), and derivatives (k, m, 4) by a turn and by the log focal length."""
        N, dN = _normals(self.lines, log_focals)
        D = np.swapaxes(R[:, :, self.axes], 1, 2)
        r = self.weights * np.einsum("kmi,kmi->km", N, D)
        by_focal = np.einsum("kmi,kmi->km", dN, D)[..., None]
        J = np.concatenate([cross(D, N), by_focal], axis=2)
        return r, J * self.weights[:, None]


def _refine(drawn: _Lines, R: Array, log_focals: Array, focal_known: bool) -> list[Start]:
    """Levenberg-Marquardt on r_e = w_e N_e . D_e for all cameras at once."""
    damping = np.full(len(R), 1e-3)
    cost = (drawn.residuals(R, log_focals) ** 2).sum(axis=1)
    for iteration in range(REFINEMENTS):
        r, J = drawn.linearised(R, log_focals)
        if focal_known:
            J[..., 3] = 0.0
        A = np.einsum("kmi,kmj->kij", J, J)
        diagonal = np.einsum("kii->ki", A)
        A = A + (damping[:, None] * (diagonal + 1e-9))[..., None] * np.eye(4)
        A[:, 3, 3] += float(focal_known)
        step = -np.linalg.solve(A, np.einsum("kmi,km->ki", J, r)[..., None])[..., 0]
        new_R = Rotation.from_rotvec(step[:, :3]).as_matrix() @ R
        new_log = np.clip(log_focals + np.clip(step[:, 3], -0.7, 0.7), *LOG_FOCAL_RANGE)
        new_cost = (drawn.residuals(new_R, new_log) ** 2).sum(axis=1)
        better = new_cost <= cost
        settled = ~better | (cost - new_cost <= 1e-10 * cost + 1e-30)
        settled &= better | (damping > 1.0)
        R = np.where(better[:, None, None], new_R, R)
        log_focals = np.where(better, new_log, log_focals)
        cost = np.where(better, new_cost, cost)
        damping = np.where(better, np.maximum(damping / 10, 1e-12), damping * 10)
        # The full step goes on from here: enough when the best view stands still.
        best = int(np.argmin(cost))
        if bool(settled.all()) or (iteration >= 5 and bool(settled[best])):
            break
    return [Start(*found) for found in zip(R, log_focals.tolist(), cost.tolist(), strict=True)]


def _same_view(a: Start, b: Start) -> bool:
    """Equal up to the axes' signs, which drawn lines cannot tell."""
    alignment = np.abs(np.einsum("ij,ij->j", a.R, b.R))
    return bool((alignment > 0.9999).all() and abs(a.log_focal - b.log_focal) < 1e-2)


def _from_mean_directions(problem: Problem) -> list[tuple[Array, float]]:
    """Three axes, as if seen from far: t1^2 = -c12 c13 / c23, two signs, the Necker twins."""
    axis = problem.structure.edge_axis
    delta = problem.points[problem.ends[:, 1]] - problem.points[problem.ends[:, 0]]
    means = []
    for k in range(3):
        d = delta[axis == k]
        if len(d) == 0:
            return []
        d = d * np.sign(d @ d[int(np.argmax(np.linalg.norm(d, axis=1)))])[:, None]
        means.append(d.sum(axis=0))
    d1, d2, d3 = (m / max(float(np.linalg.norm(m)), 1e-300) for m in means)
    # Signs that make as many of the three products negative as can be.
    if d1 @ d2 > 0:
        d2 = -d2
    if d1 @ d3 > 0:
        d3 = -d3
    c12, c13, c23 = d1 @ d2, d1 @ d3, d2 @ d3
    if max(c12, c13, c23) > -1e-6:
        return []
    t = np.sqrt(np.array([c12 * c13 / -c23, c12 * c23 / -c13, c13 * c23 / -c12]))
    log_focal = problem.log_focal_prior
    guesses = [USUAL_LOG_FOCAL, float(np.log(4.0))] if log_focal is None else [log_focal]
    found = []
    for sign in (1.0, -1.0):
        D = np.column_stack([np.append(d, sign * x) for d, x in zip((d1, d2, d3), t, strict=True)])
        found += [(_nearest_rotation(D / np.linalg.norm(D, axis=0)), g) for g in guesses]
    return found


def _nearest_rotation(D: Array) -> Array:
    U, _, Vt = np.linalg.svd(D)
    R: Array = U @ Vt
    if np.linalg.det(R) < 0:
        # An axis' sign is free: turn the third round.
        R = R @ np.diag([1.0, 1.0, -1.0])
    return R


def _grid(
    lines: Array, weights: Array, axes: IntArray, fixed: float | None
) -> list[tuple[Array, float]]:
    """The best few of a fixed set of views, for drawings that the formula does not read."""
    focals = FOCAL_GUESSES if fixed is None else (fixed,)
    scored = []
    drawn = _Lines(lines, weights, axes)
    for log_focal in focals:
        r = drawn.residuals(VIEWS, np.array([log_focal]))
        cost = (r**2).sum(axis=1)
        for i in _apart(np.argsort(cost)[:40]):
            scored.append((float(cost[i]), i, float(log_focal)))
    scored.sort()
    return [(VIEWS[i], log_focal) for _, i, log_focal in scored[:9]]


def _apart(best: NDArray[np.int64]) -> list[int]:
    """Of the best views, at most four that differ by more than about 25 degrees."""
    alike = _alike()
    kept: list[int] = []
    for i in best.tolist():
        if not alike[i, kept].any():
            kept.append(i)
        if len(kept) == 4:
            break
    return kept


@lru_cache(maxsize=1)
def _alike() -> BoolArray:
    """Which of the fixed views are within about 25 degrees of each other, up to axes' signs."""
    cosines = np.abs(np.einsum("aij,bij->abj", VIEWS, VIEWS))
    return np.asarray(cosines.min(axis=2) > 0.9)


def _fixed_views() -> Array:
    """Rotations spread over all views, about 20 degrees apart (modulo the axes' signs)."""
    rotations = Rotation.random(500, random_state=7).as_matrix()
    return np.asarray(rotations, dtype=float)


VIEWS = _fixed_views()


def lift_linear(problem: Problem, R: Array, log_focal: float, pull: float) -> Array:
    """All shared coordinates from a known camera, by one linear least-squares problem.

    Each vertex c_i, in object axes with the eye at the origin, lies on its ray r_i: c_i x r_i = 0.
    A weak pull of every depth towards 1 sets the scale and places parts that float.

    Returns
    -------
    (g,) array
        The shared coordinates, in units of the mean depth.
    """
    seen = np.vstack([problem.points, problem.circles.centres])
    rays = _rays(seen, log_focal) @ R
    coordinate = problem.structure.coordinate
    m = problem.structure.n_coordinates
    # |c x r|^2 = c^T (I - r r^T) c, and |pull (forward . c - 1)|^2
    forward = R[2]
    P = np.eye(3) - rays[:, :, None] * rays[:, None, :] + pull**2 * np.outer(forward, forward)
    places = coordinate[:, :, None] * m + coordinate[:, None, :]
    A = np.bincount(places.ravel(), P.ravel(), m * m).astype(float).reshape(m, m)
    along = np.broadcast_to(pull**2 * forward, coordinate.shape)
    b_vector = np.bincount(coordinate.ravel(), along.ravel(), m).astype(float)
    A[np.diag_indices(m)] += 1e-14
    g = np.asarray(np.linalg.solve(A, b_vector), dtype=np.float64)
    depths = (g[coordinate] @ forward)[len(problem.points) :]
    majors = np.linalg.norm(problem.circles.semi_axes, axis=2).max(axis=1, initial=0.0)
    g[problem.structure.radius] = np.abs(depths) * majors / np.exp(log_focal)
    depth = g[coordinate] @ forward
    mean = float(np.mean(np.abs(depth))) if len(depth) else 1.0
    return g / mean if mean > 1e-12 else g


def _rays(points: Array, log_focal: float) -> Array:
    """Unit rays in the camera frame, (n, 3)."""
    rays = np.hstack([points / np.exp(log_focal), np.ones((len(points), 1))])
    return np.asarray(rays / np.linalg.norm(rays, axis=1, keepdims=True))
