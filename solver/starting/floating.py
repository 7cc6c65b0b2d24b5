"""Parts that float: their depths as the leftover constraints ask, from several starts.

The linear lift places what shares coordinates. A tray's rim, joined to its bottom by slanted edges
alone, may lie anywhere along its rays, and so may every vertex of a sketch without right angles.
Equal lengths decide, but they do so with several local minima: this is where [Lau10] 4.2 restarts
from random depths, and so does this, over the few depths that are open.

Terms
-----
float
    A direction in the shared coordinates along which the picture stays as it is, by the structure
    alone; the overall size is one of them.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from ..balances import balances_of
from ..effort import counting
from ..problem import Problem
from ..structure import Structure
from ..topology import MAX_KEPT
from ..values import Array, BoolArray, Stop

#: Beyond so many coordinates nothing is searched.
MAX_SEARCHED = 300
#: Random starts for each float, and at most; spread of the depths, parts of the mean depth.
STARTS_PER_FLOAT = 4
MAX_SEARCHES = 24
SPREAD = 0.3
MAX_ITERATIONS = 25
#: One float alone is looked at everywhere: nearer and farther by so many mean depths.
GRID_REACH = 0.7
N_GRID = 41
SPREAD_REACH = 0.6
N_SPREAD = 7
#: Constraints times floats in one table, which bounds the memory.
TABLE = 50_000
#: Lifts that are carried on, and how much worse than the best they may meet the constraints.
MAX_LIFTS = 3
WORSE = 30.0
NEARLY_MET = 1e-2
#: Depths below this part of the mean are too near to be meant.
MIN_DEPTH = 0.2


def lifts(problem: Problem, R: Array, g: Array, stop: Stop | None = None) -> list[Array]:
    """Shared coordinates to begin from, best first.

    Parameters
    ----------
    problem : Problem
    R : (3, 3) array
        Camera from object axes.
    g : (m,) array
        The linear lift, in units of the mean depth.
    stop : callable, optional
        Asked at each step; True ends the search with the best so far.
    """
    if not floats_matter(problem):
        return [g]
    structure = problem.structure
    count = n_floats(structure)
    search = _Search(problem, R, g, _floats(structure, g, count), stop)
    cost, ends = search.descents()
    kept: list[Array] = []
    for k in np.argsort(cost, kind="stable"):
        lift = search.at(ends[k])
        if cost[k] > WORSE * cost.min() + NEARLY_MET:
            break
        if search.is_ahead(lift) and not any(same_lift(lift, other) for other in kept):
            kept.append(lift)
    return kept[:MAX_LIFTS] or [g]


def floats_matter(problem: Problem) -> bool:
    """Whether parts float whose depths the leftover constraints may tell."""
    structure = problem.structure
    if not problem.blocks or structure.n_coordinates > MAX_SEARCHED:
        return False
    return n_floats(structure) >= 2


def depths_along(problem: Problem, R: Array, g: Array) -> list[Array]:
    """Lifts under a good camera with one float nearer and farther, in this order; else none.

    A valley of the constraints alone may vanish beside a neighbour that the drawing tells apart:
    such a float is begun from depths all along.
    """
    if n_floats(problem.structure) != 2:
        return []
    search = _Search(problem, R, g, _floats(problem.structure, g, 2), None)
    spread = [search.at(np.array([t])) for t in np.linspace(-SPREAD_REACH, SPREAD_REACH, N_SPREAD)]
    return [lift for lift in spread if search.is_ahead(lift)]


def same_lift(a: Array, b: Array) -> bool:
    """Equal up to the overall size."""
    cosine = float(a @ b) / float(np.linalg.norm(a) * np.linalg.norm(b))
    return cosine > 1 - 1e-5


@lru_cache(maxsize=MAX_KEPT)
def n_floats(structure: Structure) -> int:
    """How many directions any drawing leaves open, the overall size included.

    Counted on a random shape with this structure.
    """
    rng = np.random.default_rng(1)
    g = rng.uniform(-1.0, 1.0, structure.n_coordinates) + 4.0
    if len(structure.balances):
        g = balances_of(structure).hold(g)
    g[structure.radius] = 1.0
    squares = np.linalg.eigvalsh(_ray_form(structure, g)[: len(g), : len(g)])
    open_ = int(np.count_nonzero(squares < 1e-11 * max(float(squares[-1]), 1e-300)))
    # Radii have no part in the rays.
    return open_ - len(structure.radius)


def _ray_form(structure: Structure, g: Array) -> Array:
    """The quadratic form sum |c x r|^2 / |c|^2 of moves off the rays through the points of g.

    With what moves put out of balance.
    """
    coordinate, m = structure.coordinate, structure.n_coordinates
    c = g[coordinate]
    rays = c / np.maximum(np.linalg.norm(c, axis=1, keepdims=True), 1e-300)
    P = np.eye(3) - rays[:, :, None] * rays[:, None, :]
    places = coordinate[:, :, None] * m + coordinate[:, None, :]
    A = np.bincount(places.ravel(), P.ravel(), m * m).astype(np.float64).reshape(m, m)
    if len(structure.balances):
        L = balances_of(structure).rows
        A += L.T @ L
    return np.asarray(A)


def _floats(structure: Structure, g: Array, count: int) -> Array:
    """Columns (m, count - 1): moves along the rays by one mean depth at most; size apart."""
    used = np.setdiff1d(np.arange(structure.n_coordinates), structure.radius)
    _, vectors = np.linalg.eigh(_ray_form(structure, g)[np.ix_(used, used)])
    open_ = vectors[:, :count]
    # Growing as a whole changes nothing: leave it out.
    growth = (open_.T @ g[used])[:, None]
    others = np.linalg.svd(growth)[0][:, 1:]
    N = np.zeros((structure.n_coordinates, count - 1))
    N[used] = open_ @ others
    moved = np.linalg.norm(N[structure.coordinate], axis=1)
    return np.asarray(N / np.maximum(moved.max(axis=0), 1e-300))


class _Search:
    """Levenberg-Marquardt on the leftover constraints over the floats alone, all starts at once."""

    def __init__(self, problem: Problem, R: Array, g: Array, N: Array, stop: Stop | None) -> None:
        self.stop = stop
        self.blocks = problem.blocks
        self.coordinate = problem.structure.coordinate
        self.forward = R[2]
        self.g, self.N = g, N
        self.moves = N[self.coordinate]  # (n, 3, floats)

    def at(self, t: Array) -> Array:
        """The shared coordinates at one place or several, (..., floats)."""
        return np.asarray(self.g + t @ self.N.T)

    def is_ahead(self, g: Array) -> BoolArray:
        """Whether all is before the eye, of one lift or several, (..., m)."""
        depth = g[..., self.coordinate] @ self.forward
        return np.asarray(depth.min(axis=-1) > MIN_DEPTH * np.abs(depth).mean(axis=-1))

    def beginnings(self) -> Array:
        """Where to begin: the linear lift, and random depths; for one float, all its valleys."""
        count = self.N.shape[1]
        if count == 1:
            line = np.linspace(-GRID_REACH, GRID_REACH, N_GRID)[:, None]
            h, _ = self.linearised(line)
            costs = np.where(self.is_ahead(self.at(line)), np.einsum("kr,kr->k", h, h), np.inf)
            padded = np.array([np.inf, *costs, np.inf])
            valleys = (padded[1:-1] <= padded[:-2]) & (padded[1:-1] <= padded[2:])
            found = line[valleys & np.isfinite(costs)]
            return found if len(found) else np.zeros((1, 1))
        rng = np.random.default_rng(0)
        n_starts = min(MAX_SEARCHES, STARTS_PER_FLOAT * count)
        return np.vstack([np.zeros(count), SPREAD * rng.normal(size=(n_starts, count))])

    def descents(self) -> tuple[Array, Array]:
        """What the beginnings lead to, (k,), and where, (k, floats); infinite behind the eye."""
        T = self.beginnings()
        rows = sum(len(block.items) for block in self.blocks)
        some = max(1, TABLE // (rows * T.shape[1]))
        costs, ends = self.descend(T[:some])
        for k in range(some, len(T), some):
            if self.stop is not None and self.stop():
                break
            more = self.descend(T[k : k + some])
            costs, ends = np.concatenate([costs, more[0]]), np.vstack([ends, more[1]])
        return np.where(self.is_ahead(self.at(ends)), costs, np.inf), ends

    def linearised(self, T: Array) -> tuple[Array, Array]:
        """Residuals (k, r) at several places (k, floats), and their derivatives (k, r, floats)."""
        count = T.shape[1]
        shapes = self.at(T)[:, self.coordinate]
        residuals, jacobians = [], []
        for block in self.blocks:
            at = block.evaluate_all(shapes)
            moves = self.moves[at.vertex % shapes.shape[1]]
            values = np.einsum("ti,tif->tf", at.value, moves)
            places = at.row[:, None] * count + np.arange(count)
            H = np.bincount(places.ravel(), values.ravel(), len(at.residual) * count)
            residuals.append(at.residual.reshape(len(T), -1))
            jacobians.append(H.reshape(len(T), -1, count))
        return np.hstack(residuals), np.hstack(jacobians)

    def descend(self, T: Array) -> tuple[Array, Array]:
        """What several places (k, floats) lead to, (k,), and where."""
        stop = counting(self.stop, math.ceil(T.shape[1] * math.sqrt(len(T))))
        ends = np.where(self.is_ahead(self.at(T))[:, None], T, 0.3 * T)
        going = np.arange(len(ends))
        T = ends.copy()
        h, H = self.linearised(T)
        cost, damping = np.einsum("kr,kr->k", h, h), np.full(len(T), 1e-2)
        costs = cost.copy()
        for _ in range(MAX_ITERATIONS):
            if stop() or not len(going):
                break
            moved = T - _steps(h, H, damping)
            new_h, new_H = self.linearised(moved)
            new_cost = np.einsum("kr,kr->k", new_h, new_h)
            gains = self.is_ahead(self.at(moved)) & (new_cost < cost)
            small = gains & ((cost - new_cost < 1e-3 * new_cost) | (new_cost < 1e-14))
            damping = np.where(gains, np.maximum(damping / 10, 1e-9), 10 * damping)
            T[gains], h[gains], H[gains] = moved[gains], new_h[gains], new_H[gains]
            cost = np.where(gains, new_cost, cost)
            ends[going], costs[going] = T, cost
            on = ~small & (damping <= 1e4)
            going, T, h, H = going[on], T[on], h[on], H[on]
            cost, damping = cost[on], damping[on]
        return costs, ends


def _steps(h: Array, H: Array, damping: Array) -> Array:
    """Damped Gauss-Newton steps of several searches, (k, floats)."""
    across = H.transpose(0, 2, 1)
    A = across @ H
    count = A.shape[1]
    diagonal = np.arange(count)
    trace = A[:, diagonal, diagonal].sum(axis=1)
    A[:, diagonal, diagonal] += (damping * trace / count + 1e-12)[:, None]
    return np.asarray(np.linalg.solve(A, across @ h[:, :, None])[:, :, 0])
