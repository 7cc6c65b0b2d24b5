"""The start, without any search: the camera from the drawn directions, then linear depths.

[Lau10] 4.2 finds depths from zero by Nelder-Mead and restarts. Here the edges along the object axes
give the rotation and the focal length first, and then all coordinates follow from one linear
least-squares problem; the role is the paper's: an approximate shape to start the full step from.

Terms
-----
Necker twin
    The other reading of a drawing, seen from below instead of above.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from .balances import balances_of
from .circles import tilted_views
from .geometry import cross
from .problem import Problem
from .starting.drawn_lines import Agreement, DrawnLines, Pencils, drawn_lines, gathered, turns
from .values import Array, BoolArray

#: Focal lengths in image units: from as wide as cameras are to drawings without any perspective.
LOG_FOCAL_RANGE = (float(np.log(0.4)), float(np.log(1e5)))
#: Where the formula's view fits the lines to this angle (rad, RMS), no further views are tried.
GOOD_MISFIT = 0.02
#: Where the formula's view fits them to this, it is good enough to weigh each of many lines by.
FAIR_MISFIT = 0.04
#: Where it fits them to this, the full step goes on from it at once.
TELLING_MISFIT = 0.08
#: From so many lines on it pays to weigh each by how well its ends can be drawn.
MANY_LINES = 30
#: Iterations on the lines alone; the full step goes on from there. So few are enough to weigh each
#: of many lines by.
REFINEMENTS, FEW_REFINEMENTS = 12, 2
#: A gain of so little, in parts of the misfit, is none: the full step goes on from here.
SETTLED = 1e-3
#: How much more it weighs that two edges are cut by one plane of symmetry than that a ray is met.
BALANCE = 1e2
#: Lines meet a camera exactly within this angle (rad, RMS).
EXACT_MISFIT = 1e-7
#: So few lines may meet some camera exactly by chance.
ENOUGH_LINES = 6
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


def views(problem: Problem) -> Iterator[Start]:
    """As `starts`; where the vanishing points tell a camera that agrees well with all lines, it
    comes first, and the others are worked out only if they are asked for."""
    if not problem.structure.has_axes:
        yield from starts(problem)
        return
    lines = _lines_of(problem)
    first = _told_at_once(problem, lines)
    if first is not None:
        yield first
    yield from _upright_ones(problem, _from_lines(problem, lines))


def starts(problem: Problem) -> list[Start]:
    """Cameras that agree with the drawn directions, best first, Necker twins included.

    Where the camera is known, they agree with its upward direction as well.
    """
    if problem.structure.has_axes:
        return _upright_ones(problem, _from_lines(problem, _lines_of(problem)))
    fixed = problem.log_focal_prior
    tilted = tilted_views(problem.circles) if len(problem.circles) else [np.eye(3)]
    focals = FOCAL_GUESSES if fixed is None else (fixed,)
    return _upright_ones(problem, [Start(R, f, 0.0) for R in tilted for f in focals])


@dataclass(frozen=True, slots=True, eq=False)
class _Lines:
    """What is drawn along the axes, and the camera that its vanishing points tell, if they do."""

    drawn: DrawnLines
    pencils: Pencils
    told: Start | None


def _lines_of(problem: Problem) -> _Lines:
    drawn, fixed = drawn_lines(problem), problem.log_focal_prior
    pencils = gathered(drawn, drawn.lengths(), USUAL_LOG_FOCAL if fixed is None else fixed)
    return _Lines(drawn, pencils, _from_vanishing_points(pencils, fixed))


def _upright_ones(problem: Problem, found: list[Start]) -> list[Start]:
    up, vertical = problem.up_in_cam, problem.structure.vertical
    if up is None or vertical is None:
        return found
    return _distinct([replace(s, R=_upright(s.R, vertical, up)) for s in found])


def _told_at_once(problem: Problem, lines: _Lines) -> Start | None:
    """The camera that the vanishing points tell, where it meets all of enough lines well."""
    pencils, told = lines.pencils, lines.told
    enough = len(lines.drawn) >= max(ENOUGH_LINES, len(pencils.directions) + 3)
    if told is None or not enough or problem.camera is not None:
        return None
    limit = TELLING_MISFIT if _likely(told.log_focal) else EXACT_MISFIT
    return None if told.misfit > limit**2 * pencils.total else told


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


def _from_lines(problem: Problem, lines: _Lines) -> list[Start]:
    drawn, pencils, told, fixed = lines.drawn, lines.pencils, lines.told, problem.log_focal_prior
    if fixed is None and len(pencils.directions) < 3:
        # Two directions tell little of the focal length: the full step finds it, from several.
        likely = [told.log_focal] if told is not None and _likely(told.log_focal) else []
        at_each = _views_at(pencils, (*likely, *FOCAL_GUESSES))
        return [start for pair in zip(*at_each, strict=False) for start in pair]
    candidates = [] if told is None else [(told.R, told.log_focal)]
    good, fair = (limit**2 * pencils.total for limit in (GOOD_MISFIT, FAIR_MISFIT))
    if told is not None and told.misfit <= fair and len(drawn) > MANY_LINES:
        found = [told]
    else:
        candidates += _from_mean_directions(problem)
        few = FEW_REFINEMENTS if len(drawn) > MANY_LINES else REFINEMENTS
        found = _refine_all(pencils, candidates, fixed, few)
        if not found or found[0].misfit > good:
            candidates += _grid(pencils, fixed)
            found = _refine_all(pencils, candidates, fixed)
        candidates = [(start.R, start.log_focal) for start in found]
    if len(drawn) > MANY_LINES and found[0].misfit > EXACT_MISFIT**2 * pencils.total:
        weights = drawn.fair_weights(found[0].R, found[0].log_focal)
        pencils = gathered(drawn, weights, found[0].log_focal)
        found = _refine_all(pencils, candidates, fixed)
    if fixed is None and not _likely(found[0].log_focal):
        # Careless lines say "from afar" too easily: begin from usual focal lengths as well.
        usual = [_refine_all(pencils, candidates, f)[:2] for f in FOCAL_GUESSES[::2]]
        found = [start for group in [*usual, found[:2]] for start in group]
    return found


def _likely(log_focal: float) -> bool:
    return LIKELY_LOG_FOCAL[0] < log_focal < LIKELY_LOG_FOCAL[1]


def _views_at(pencils: Pencils, log_focals: tuple[float, ...]) -> list[list[Start]]:
    """The two best views for each of some focal lengths."""
    grids = [_grid(pencils, f) for f in log_focals]
    found = iter(_refine(pencils, [view for grid in grids for view in grid], True))
    return [_distinct([next(found) for _ in grid])[:2] for grid in grids]


def _refine_all(
    pencils: Pencils,
    candidates: list[tuple[Array, float]],
    fixed: float | None,
    iterations: int = REFINEMENTS,
) -> list[Start]:
    if not candidates:
        return []
    if fixed is not None:
        candidates = [(R, fixed) for R, _ in candidates]
    return _distinct(_refine(pencils, candidates, fixed is not None, iterations))


def _distinct(found: list[Start]) -> list[Start]:
    """Best first, each view once."""
    found = sorted(found, key=lambda s: s.misfit)
    if len(found) < 2:
        return found
    alike = _same_views(np.array([s.R for s in found]), np.array([s.log_focal for s in found]))
    kept: list[int] = []
    for k in range(len(found)):
        if not alike[k, kept].any():
            kept.append(k)
    return [found[k] for k in kept]


def _refine(
    pencils: Pencils,
    candidates: list[tuple[Array, float]],
    focal_known: bool,
    iterations: int = REFINEMENTS,
) -> list[Start]:
    """Levenberg-Marquardt on r_e = w_e N_e . D_e for all cameras at once."""
    R = np.array([view for view, _ in candidates])
    log_focals = np.array([f for _, f in candidates])
    drawn = Agreement(pencils)
    low, high = LOG_FOCAL_RANGE
    damping = np.full(len(R), 1e-3)
    forms = drawn.forms(R, log_focals)
    for iteration in range(iterations):
        step = _damped_steps(forms, damping, focal_known)
        new_R = R @ turns(step[:, :3])
        change = np.minimum(np.maximum(step[:, 3], -0.7), 0.7)
        new_log = np.minimum(np.maximum(log_focals + change, low), high)
        new_forms = drawn.forms(new_R, new_log)
        cost, new_cost = forms[:, 4, 4], new_forms[:, 4, 4]
        better = new_cost <= cost
        settled = ~better | (cost - new_cost <= SETTLED * cost + 1e-30)
        if better.all():
            R, log_focals, forms = new_R, new_log, new_forms
            damping = np.maximum(damping / 10, 1e-12)
        else:
            settled &= better | (damping > 1.0)
            chosen = better[:, None, None]
            R, forms = np.where(chosen, new_R, R), np.where(chosen, new_forms, forms)
            log_focals = np.where(better, new_log, log_focals)
            damping = np.where(better, np.maximum(damping / 10, 1e-12), damping * 10)
        # The full step goes on from here: enough when the best view stands still.
        best = int(forms[:, 4, 4].argmin())
        if bool(settled.all()) or (iteration >= 1 and bool(settled[best])):
            break
    cost = forms[:, 4, 4]
    return [Start(*found) for found in zip(R, log_focals.tolist(), cost.tolist(), strict=True)]


def _damped_steps(forms: Array, damping: Array, focal_known: bool) -> Array:
    """Of several cameras, (k, 4)."""
    A, b = forms[:, :4, :4].copy(), forms[:, :4, 4:]
    if focal_known:
        A[:, 3], A[:, :, 3], A[:, 3, 3] = 0.0, 0.0, 1.0
        b = b * _TURN_ALONE
    A.reshape(-1, 16)[:, ::5] += damping[:, None] * (A.reshape(-1, 16)[:, ::5] + 1e-9)
    return np.asarray(-np.linalg.solve(A, b)[..., 0], dtype=np.float64)


_TURN_ALONE = np.array([[1.0], [1.0], [1.0], [0.0]])


def _same_views(R: Array, log_focals: Array) -> BoolArray:
    """Which of k views are equal up to the axes' signs, which drawn lines cannot tell, (k, k)."""
    alignment = np.abs(np.einsum("aij,bij->abj", R, R)).min(axis=2)
    near = np.abs(log_focals[:, None] - log_focals) < 1e-2
    return np.asarray((alignment > 0.9999) & near)


def _from_mean_directions(problem: Problem) -> list[tuple[Array, float]]:
    """Three axes, as if seen from far: t1^2 = -c12 c13 / c23, two signs, the Necker twins."""
    axis = problem.structure.edge_axis
    delta = problem.points[problem.ends[:, 1]] - problem.points[problem.ends[:, 0]]
    length = np.hypot(delta[:, 0], delta[:, 1])
    means = []
    for k in range(3):
        own = np.flatnonzero(axis == k)
        if not len(own):
            return []
        d = delta[own]
        # Turned to the side of the longest one.
        means.append(np.sign(d @ d[int(length[own].argmax())]) @ d)
    d1, d2, d3 = (m / max(math.hypot(*m.tolist()), 1e-300) for m in means)
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
    level = np.array([d1, d2, d3]).T
    D = np.array([np.vstack([level, sign * t]) for sign in (1.0, -1.0)])
    both = _nearest_rotations(D / np.linalg.norm(D, axis=1, keepdims=True))
    return [(R, guess) for R in both for guess in guesses]


def _from_vanishing_points(pencils: Pencils, fixed: float | None) -> Start | None:
    """Axes towards the vanishing points, which tell the focal length by being perpendicular.

    With q = (f0 / f)^2, f0 the pencils' focal length, q (x_i x_j + y_i y_j) + z_i z_j = 0 for each
    two of them.
    """
    D = pencils.directions
    if not pencils.sure or len(D) < 2:
        return None
    pairs = [(i, j) for j in range(len(D)) for i in range(j)]
    level = np.array([D[i, :2] @ D[j, :2] for i, j in pairs])
    deep = np.array([D[i, 2] * D[j, 2] for i, j in pairs])
    q = 1.0
    if fixed is None:
        q = -float(level @ deep) / max(float(level @ level), 1e-300)
        if not q > 0:
            return None
    log_focal = pencils.log_focal - float(np.log(q)) / 2
    if not LOG_FOCAL_RANGE[0] < log_focal < LOG_FOCAL_RANGE[1]:
        return None
    axes = np.zeros((3, 3))
    axes[:, pencils.axes[::3]] = (D * np.array([np.sqrt(q), np.sqrt(q), 1.0])).T
    if len(D) == 2:
        missing = 3 - int(pencils.axes[0]) - int(pencils.axes[3])
        axes[:, missing] = cross(axes[:, (missing + 1) % 3], axes[:, (missing + 2) % 3])
    axes /= np.maximum(np.sqrt((axes**2).sum(axis=0)), 1e-300)
    R = _nearest_rotations(axes[None])[0]
    return Start(R, log_focal, float(Agreement(pencils).costs(R[None], log_focal)[0]))


def _nearest_rotations(D: Array) -> Array:
    """The nearest rotation of each matrix (k, 3, 3)."""
    U, _, Vt = np.linalg.svd(D)
    R = np.asarray(U @ Vt)
    # An axis' sign is free: turn the third round.
    R[np.linalg.det(R) < 0, :, 2] *= -1.0
    return R


def _grid(pencils: Pencils, fixed: float | None) -> list[tuple[Array, float]]:
    """The best few of a fixed set of views, for drawings that the formula does not read."""
    focals = FOCAL_GUESSES if fixed is None else (fixed,)
    scored = []
    drawn = Agreement(pencils)
    for log_focal in focals:
        cost = drawn.costs(VIEWS, log_focal)
        for i in _apart(np.argsort(cost)[:40]):
            scored.append((float(cost[i]), i, float(log_focal)))
    scored.sort()
    return [(VIEWS[i], log_focal) for _, i, log_focal in scored[:9]]


def _apart(best: NDArray[np.int64]) -> list[int]:
    """Of the best views, at most four that differ by more than about 25 degrees."""
    alike = _alike()
    kept: list[int] = []
    near: set[int] = set()
    for i in best.tolist():
        if i not in near:
            kept.append(i)
            near |= alike[i]
        if len(kept) == 4:
            break
    return kept


@lru_cache(maxsize=1)
def _alike() -> list[frozenset[int]]:
    """Of each fixed view those within about 25 degrees of it, up to the axes' signs."""
    cosines = np.abs(np.einsum("aij,bij->abj", VIEWS, VIEWS))
    return [frozenset(np.flatnonzero(row).tolist()) for row in cosines.min(axis=2) > 0.9]


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
    rays = _rays_in_axes(problem, R, log_focal)
    coordinate = problem.structure.coordinate
    m = problem.structure.n_coordinates
    # |c x r|^2 = c^T (I - r r^T) c, and |pull (forward . c - 1)|^2
    forward = R[2]
    P = np.eye(3) - rays[:, :, None] * rays[:, None, :] + pull**2 * np.outer(forward, forward)
    places = coordinate[:, :, None] * m + coordinate[:, None, :]
    A = np.bincount(places.ravel(), P.ravel(), m * m).astype(float).reshape(m, m)
    along = np.broadcast_to(pull**2 * forward, coordinate.shape)
    b_vector = np.bincount(coordinate.ravel(), along.ravel(), m).astype(float)
    if len(problem.structure.balances):
        L = BALANCE * balances_of(problem.structure).rows
        A += L.T @ L
    A[np.diag_indices(m)] += 1e-14
    g = np.asarray(np.linalg.solve(A, b_vector), dtype=np.float64)
    depths = (g[coordinate] @ forward)[len(problem.points) :]
    majors = np.linalg.norm(problem.circles.semi_axes, axis=2).max(axis=1, initial=0.0)
    g[problem.structure.radius] = np.abs(depths) * majors / np.exp(log_focal)
    depth = g[coordinate] @ forward
    mean = float(np.mean(np.abs(depth))) if len(depth) else 1.0
    return g / mean if mean > 1e-12 else g


def miss_of_rays(problem: Problem, R: Array, log_focal: float, g: Array) -> float:
    """How far a lift is off the rays that it was drawn along, RMS, rad."""
    rays = _rays_in_axes(problem, R, log_focal)
    c = g[problem.structure.coordinate]
    off = np.linalg.norm(cross(c, rays), axis=1) / np.maximum(np.linalg.norm(c, axis=1), 1e-300)
    return float(np.sqrt(np.mean(off**2)))


def _rays_in_axes(problem: Problem, R: Array, log_focal: float) -> Array:
    """Of all vertices and circles' middles, in the object's axes."""
    seen = np.vstack([problem.points, problem.circles.centres])
    return np.asarray(_rays(seen, log_focal) @ R)


def _rays(points: Array, log_focal: float) -> Array:
    """Unit rays in the camera frame, (n, 3)."""
    rays = np.hstack([points / np.exp(log_focal), np.ones((len(points), 1))])
    return np.asarray(rays / np.linalg.norm(rays, axis=1, keepdims=True))
