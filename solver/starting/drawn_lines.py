"""The lines that a drawing has along the object axes, and how well cameras agree with them.

Terms
-----
line
    (x, y, 1) x (x', y', 1) of two points, image units; the plane through the eye and the line has
    the normal N = (f l0, f l1, l2) in the camera frame.
pencil
    All lines along one object axis; they meet in its vanishing point. Three lines stand for them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ..geometry import GENERATORS
from ..merging import numbered
from ..problem import Problem
from ..structure import Structure
from ..topology import MAX_KEPT
from ..values import Array, IntArray

#: From so many edges on all vertices that lie on one line tell its direction together: the edges
#: are short then, and each by itself is drawn carelessly.
MANY_EDGES = 30


@dataclass(frozen=True, slots=True, eq=False)
class DrawnLines:
    """Lines along the object axes, ordered by axis.

    Parameters
    ----------
    p, q : (k, 2) arrays
        Two points of each, image units: an edge's ends.
    strength : (k,) array
        How much more a line is to be trusted than one that is drawn by two imagined vertices.
    axes : (k,) int array
    """

    p: Array
    q: Array
    strength: Array
    axes: IntArray

    def __len__(self) -> int:
        return len(self.axes)

    def homogeneous(self) -> Array:
        """The lines, (k, 3)."""
        (x, y), (u, v) = self.p.T, self.q.T
        return np.stack([y - v, u - x, x * v - y * u], axis=-1)

    def lengths(self) -> Array:
        """Drawn lengths, times the strength."""
        d = self.q - self.p
        return np.asarray(np.hypot(d[:, 0], d[:, 1]) * self.strength)

    def fair_weights(self, R: Array, log_focal: float) -> Array:
        """Weights by which residuals are distances of drawn ends from lines to vanishing points.

        Angles alone favour wide lenses where many short lines are drawn carelessly: the first-order
        distance does not.
        """
        f = np.exp(log_focal)
        K = np.array([f, f, 1.0])
        vanishing = (K * R[:, self.axes].T)[:, None, :]
        slope = vanishing[..., :2] - np.stack([self.p, self.q], axis=1) * vanishing[..., 2:]
        per_px = np.sqrt((slope**2).sum(axis=(1, 2)))
        size = np.linalg.norm(self.homogeneous() * K, axis=1)
        return np.asarray(np.sqrt(2) * size * self.strength / np.maximum(per_px, 1e-300))


def drawn_lines(problem: Problem) -> DrawnLines:
    """The drawn lines of a problem along its object axes."""
    layout = _layout(problem.structure, len(problem.points))
    if len(layout.edges) > MANY_EDGES:
        return _fitted(problem, layout)
    ends = problem.ends[layout.edges]
    p, q = problem.points[ends[:, 0]], problem.points[ends[:, 1]]
    return DrawnLines(p, q, problem.weights[ends].min(axis=1), layout.edge_axes)


@dataclass(frozen=True, slots=True, eq=False)
class _Layout:
    """Edges along the axes, and the vertices that share a line: pairs of (line, vertex)."""

    edges: IntArray
    edge_axes: IntArray
    line: IntArray
    vertex: IntArray
    line_axes: IntArray


@lru_cache(maxsize=MAX_KEPT)
def _layout(structure: Structure, n_vertices: int) -> _Layout:
    along = np.flatnonzero(structure.edge_axis >= 0)
    order = along[np.argsort(structure.edge_axis[along], kind="stable")]
    lines, vertices, axes, n_lines = [], [], [], 0
    shared, m = structure.coordinate[:n_vertices], structure.n_coordinates
    for k in np.flatnonzero(np.bincount(structure.edge_axis[along])).tolist():
        _, line = numbered(shared[:, (k + 1) % 3] * m + shared[:, (k + 2) % 3], m * m)
        count = np.bincount(line)
        several = np.cumsum(count > 1) - 1
        chosen = np.flatnonzero(count[line] > 1)
        lines.append(n_lines + several[line[chosen]])
        vertices.append(chosen)
        n = int(np.count_nonzero(count > 1))
        axes += [k] * n
        n_lines += n
    return _Layout(
        order,
        structure.edge_axis[order],
        np.concatenate(lines) if lines else np.zeros(0, dtype=np.int64),
        np.concatenate(vertices) if vertices else np.zeros(0, dtype=np.int64),
        np.array(axes, dtype=np.int64),
    )


def _fitted(problem: Problem, layout: _Layout) -> DrawnLines:
    """Lines through all vertices that share two coordinates, by total least squares.

    The two points are where two vertices would have to be drawn that spread as far; the strength is
    that of their number.
    """
    at, of, n = problem.points[layout.vertex], layout.line, len(layout.line_axes)
    w = problem.weights[layout.vertex] ** 2
    total = np.bincount(of, w, n)
    middle = np.stack([np.bincount(of, w * at[:, k], n) for k in (0, 1)], axis=1) / total[:, None]
    dx, dy = (at - middle[of]).T
    xx, yy, xy = (np.bincount(of, w * d, n) for d in (dx * dx, dy * dy, dx * dy))
    angle = np.arctan2(2 * xy, xx - yy) / 2
    spread = (xx + yy + np.hypot(xx - yy, 2 * xy)) / 2 / total
    half = np.stack([np.cos(angle), np.sin(angle)], axis=1) * np.sqrt(spread)[:, None]
    return DrawnLines(middle - half, middle + half, np.sqrt(total / 2), layout.line_axes)


@dataclass(frozen=True, slots=True, eq=False)
class Pencils:
    """Three lines for each axis along which lines run, and their weights.

    They have the same sum of squares as all of them for every direction, each counted by its angle
    as a camera of one focal length sees it.

    Parameters
    ----------
    lines : (3 a, 3) array
    weights : (3 a,) array
    axes : (3 a,) int array
    directions : (a, 3) array
        Towards the vanishing points, in the frame of that camera.
    sure : bool
        Whether each direction follows from lines that are not all one.
    log_focal : float
        Of that camera.
    """

    lines: Array
    weights: Array
    axes: IntArray
    directions: Array
    sure: bool
    log_focal: float

    @property
    def total(self) -> float:
        """The sum of the squared weights."""
        return float(self.weights @ self.weights)


def gathered(drawn: DrawnLines, weights: Array, log_focal: float) -> Pencils:
    """The pencils of drawn lines."""
    f = float(np.exp(log_focal))
    K = np.array([f, f, 1.0])
    normals = drawn.homogeneous() * K
    size = np.sqrt(np.einsum("mi,mi->m", normals, normals))
    normals = normals * (weights / np.maximum(size, 1e-300))[:, None]
    first = np.searchsorted(drawn.axes, np.arange(4)).tolist()
    present = [k for k in range(3) if first[k + 1] > first[k]]
    own = [normals[first[k] : first[k + 1]] for k in present]
    squares, vectors = np.linalg.eigh(np.array([rows.T @ rows for rows in own]))
    vectors = np.swapaxes(vectors, 1, 2)
    return Pencils(
        (vectors / K).reshape(-1, 3),
        np.sqrt(np.maximum(squares, 0.0)).reshape(-1),
        np.repeat(np.array(present, dtype=np.int64), 3),
        vectors[:, 0],
        bool((squares[:, 1] > 1e-9 * squares[:, 2]).all()),
        log_focal,
    )


#: For each axis a, with n the normal in the axes: n . (omega x a) by omega, and twice n . a.
_BY_NORMAL = np.array([[*GENERATORS[a].reshape(3, 3), *np.eye(3)[[a, a]]] for a in range(3)])


class Agreement:
    """The residuals r_e = w_e N_e . D_e of several cameras at once."""

    def __init__(self, pencils: Pencils) -> None:
        self.lines = pencils.lines
        self.weights = pencils.weights
        self.axes = pencils.axes
        self._level = self.lines[:, 0] ** 2 + self.lines[:, 1] ** 2
        self._upright = self.lines[:, 2] ** 2
        self._by_normal = _BY_NORMAL[self.axes]

    def forms(self, R: Array, log_focals: Array) -> Array:
        """J^T J, J^T r and r^T r of k cameras, (k, 5, 5): [J, r]^T [J, r].

        J has the derivatives by a turn of the object axes, R exp([turn]x), and by the log focal
        length.
        """
        f = np.exp(log_focals)[:, None]
        level = f * f * self._level
        size = np.maximum(level + self._upright, 1e-300)
        N = np.empty((len(R), len(self.axes), 3))
        np.multiply(self.lines[:, :2], f[..., None], out=N[..., :2])
        N[..., 2] = self.lines[:, 2]
        N *= (self.weights / np.sqrt(size))[..., None]
        both = np.einsum("mij,kmj->kmi", self._by_normal, N @ R)
        # N grows by its level part, and is then shortened to its length again.
        by_focal = both[..., 3]
        by_focal *= 1.0 - level / size
        by_focal -= N[..., 2] * R[:, 2].take(self.axes, axis=1)
        return np.asarray(both.transpose(0, 2, 1) @ both)

    def costs(self, R: Array, log_focal: float) -> Array:
        """Sums of squares for k rotations at one focal length."""
        f = float(np.exp(log_focal))
        N = self.lines * np.array([f, f, 1.0])
        N *= (self.weights / np.sqrt(np.einsum("mi,mi->m", N, N)))[:, None]
        r = np.einsum("mi,kim->km", N, R[:, :, self.axes])
        return np.asarray(np.einsum("km,km->k", r, r))


def turns(vectors: Array) -> Array:
    """Rotations (k, 3, 3) by about so much (k, 3), by Cayley's formula: exact ones, to 2nd order.

    C = I + 2 (S + S S) / (1 + |a|^2), S = [a]x, a half the rotation vector.
    """
    a = vectors / 2
    S = (a @ GENERATORS).reshape(-1, 3, 3)
    factor = 2.0 / (1.0 + np.einsum("ki,ki->k", a, a))
    return np.asarray(np.eye(3) + factor[:, None, None] * (S + S @ S))
