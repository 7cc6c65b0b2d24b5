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

from collections.abc import Iterator
from functools import lru_cache

import numpy as np

from ..effort import counting
from ..problem import Problem
from ..structure import Structure
from ..topology import MAX_KEPT
from ..values import Array, Stop

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
    found = sorted(search.descents(), key=lambda f: f[0])
    kept: list[Array] = []
    for cost, t in found:
        lift = search.at(t)
        if cost > WORSE * found[0][0] + NEARLY_MET:
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
    g[structure.radius] = 1.0
    squares = np.linalg.eigvalsh(_ray_form(structure, g)[: len(g), : len(g)])
    open_ = int(np.count_nonzero(squares < 1e-11 * max(float(squares[-1]), 1e-300)))
    # Radii have no part in the rays.
    return open_ - len(structure.radius)


def _ray_form(structure: Structure, g: Array) -> Array:
    """The quadratic form sum |c x r|^2 / |c|^2 of moves off the rays through the points of g."""
    coordinate, m = structure.coordinate, structure.n_coordinates
    c = g[coordinate]
    rays = c / np.maximum(np.linalg.norm(c, axis=1, keepdims=True), 1e-300)
    P = np.eye(3) - rays[:, :, None] * rays[:, None, :]
    places = coordinate[:, :, None] * m + coordinate[:, None, :]
    A = np.bincount(places.ravel(), P.ravel(), m * m)
    return np.asarray(A.astype(np.float64).reshape(m, m))


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
    """Levenberg-Marquardt on the leftover constraints over the floats alone."""

    def __init__(self, problem: Problem, R: Array, g: Array, N: Array, stop: Stop | None) -> None:
        self.stop = counting(stop, N.shape[1])
        self.blocks = problem.blocks
        self.coordinate = problem.structure.coordinate
        self.forward = R[2]
        self.g, self.N = g, N
        self.moves = N[self.coordinate]  # (n, 3, floats)

    def at(self, t: Array) -> Array:
        return np.asarray(self.g + self.N @ t)

    def is_ahead(self, g: Array) -> bool:
        depth = g[self.coordinate] @ self.forward
        return bool(depth.min() > MIN_DEPTH * np.abs(depth).mean())

    def beginnings(self) -> list[Array]:
        """Where to begin: the linear lift, and random depths; for one float, all its valleys."""
        count = self.N.shape[1]
        if count == 1:
            line = np.linspace(-GRID_REACH, GRID_REACH, N_GRID)
            costs = self.costs(line)
            padded = np.array([np.inf, *costs, np.inf])
            valleys = (padded[1:-1] <= padded[:-2]) & (padded[1:-1] <= padded[2:])
            return [np.array([t]) for t in line[valleys & np.isfinite(costs)]] or [np.zeros(1)]
        rng = np.random.default_rng(0)
        n_starts = min(MAX_SEARCHES, STARTS_PER_FLOAT * count)
        return [np.zeros(count), *(SPREAD * rng.normal(size=(n_starts, count)))]

    def descents(self) -> Iterator[tuple[float, Array]]:
        """Where the beginnings lead to, until it is enough; the first one always."""
        for k, t in enumerate(self.beginnings()):
            if k and self.stop():
                return
            yield self.descend(t)

    def costs(self, line: Array) -> Array:
        """Of one float at all places of a line; infinite where something is behind the eye."""
        shapes = (self.g + np.outer(line, self.N[:, 0]))[:, self.coordinate]
        depths = shapes @ self.forward
        ahead = depths.min(axis=1) > MIN_DEPTH * np.abs(depths).mean(axis=1)
        total = np.sum([block.squares(shapes) for block in self.blocks], axis=0)
        return np.where(ahead, total, np.inf)

    def linearised(self, t: Array) -> tuple[Array, Array]:
        X = self.at(t)[self.coordinate]
        residuals, jacobians = [], []
        for block in self.blocks:
            at = block.evaluate(X)
            H = np.zeros((len(at.residual), len(t)))
            np.add.at(H, at.row, np.einsum("ti,tif->tf", at.value, self.moves[at.vertex]))
            residuals.append(at.residual)
            jacobians.append(H)
        return np.concatenate(residuals), np.vstack(jacobians)

    def descend(self, t: Array) -> tuple[float, Array]:
        """The cost reached and where; infinite where it leads behind the eye."""
        if not self.is_ahead(self.at(t)):
            t = 0.3 * t
        h, H = self.linearised(t)
        cost, damping = float(h @ h), 1e-2
        for _ in range(MAX_ITERATIONS):
            if self.stop():
                break
            A = H.T @ H
            A[np.diag_indices(len(A))] += damping * float(np.trace(A)) / len(A) + 1e-12
            moved = t - np.linalg.solve(A, H.T @ h)
            if self.is_ahead(self.at(moved)):
                new_h, new_H = self.linearised(moved)
                new_cost = float(new_h @ new_h)
                if new_cost < cost:
                    gain, cost = cost - new_cost, new_cost
                    t, h, H = moved, new_h, new_H
                    damping = max(damping / 10, 1e-9)
                    if gain < 1e-3 * cost or cost < 1e-14:
                        break
                    continue
            damping *= 10
            if damping > 1e4:
                break
        return (cost if self.is_ahead(self.at(t)) else np.inf), t
