"""The projected vertices and their part of the normal equations ([Lau10] 4.2, projection term).

Each drawn vertex speaks of seven unknowns only: the turn, kappa and its own three coordinates. Its
part of J^T J is a block of 7 x 7, and the whole is their sum in the right places.

A sketch has few vertices and a solve many steps: what counts is the number of calls to numpy. So
rows lie in one array, places are worked out once for a structure, and nothing is looked at twice.

Terms
-----
rows
    Derivatives of the residuals, one row of the array for each of the seven unknowns.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .problem import Problem
from .structure import Structure
from .topology import MAX_KEPT
from .values import Array, IntArray

#: Unknowns that all vertices share: three of the turn, and kappa.
N_CAMERA = 4


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """The vertices as a camera sees them.

    Parameters
    ----------
    in_cam : (3, n) array
        Vertices in the camera frame.
    projected : (2, n) array
        Image units.
    r : (2 n,) array
        Weighed residuals: along x, then along y.
    """

    in_cam: Array
    projected: Array
    r: Array


@dataclass(frozen=True, slots=True, eq=False)
class _Layout:
    """Where the vertices' numbers belong; M counts all unknowns.

    Parameters
    ----------
    coordinate : (3, n) int array
        Shared coordinates of the vertices.
    places : (8 * 3 * n,) int array
        Of the products of (r, turn, kappa, x, y, z) with (x, y, z), in a table of (1 + M) x M.
    """

    coordinate: IntArray
    places: IntArray


@lru_cache(maxsize=MAX_KEPT)
def _layout(structure: Structure, n_vertices: int) -> _Layout:
    coordinate = np.ascontiguousarray(structure.coordinate[:n_vertices].T)
    columns = N_CAMERA + coordinate
    M = N_CAMERA + structure.n_coordinates
    # The residuals' row is the first, the camera's four follow.
    first = np.broadcast_to(np.arange(1 + N_CAMERA)[:, None], (1 + N_CAMERA, n_vertices))
    rows = np.vstack([first, 1 + columns])
    places = rows[:, None] * M + columns[None]
    return _Layout(coordinate, places.ravel())


class Vertices:
    """The vertices of a problem."""

    def __init__(self, problem: Problem) -> None:
        self.n = len(problem.points)
        self.M = N_CAMERA + problem.structure.n_coordinates
        self._layout = _layout(problem.structure, self.n)
        self._points = np.ascontiguousarray(problem.points.T)
        self._weights: Array | None = problem.weights
        if bool((problem.weights == 1.0).all()):
            self._weights = None

    def seen(self, R: Array, log_focal: float, g: Array) -> Seen:
        """The view of one pose."""
        in_cam = R @ g[self._layout.coordinate]
        projected = in_cam[:2] * (math.exp(log_focal) / in_cam[2])
        r = projected - self._points
        if self._weights is not None:
            r *= self._weights
        return Seen(in_cam, projected, r.ravel())

    def rows(self, seen: Seen, R: Array, log_focal: float, middle: Array) -> Array:
        """Derivatives of r by (omega, kappa, x, y, z) below r itself, (8, 2 n).

        Parameters
        ----------
        seen : Seen
        R, log_focal : of the same pose
        middle : (3,) array
            In the camera frame: what the turn is about.
        """
        n = self.n
        f = math.exp(log_focal)
        per_depth = 1.0 / seen.in_cam[2]
        if self._weights is not None:
            per_depth *= self._weights
        scale = f * per_depth
        slope = seen.projected * per_depth
        away = seen.in_cam - middle[:, None]
        rows = np.empty((8, 2, n))
        rows[0] = seen.r.reshape(2, n)
        # d x_cam / d omega = -[x_cam - middle]x, so that a row d becomes (x_cam - middle) x d.
        np.multiply(slope, -away[1], out=rows[1])
        np.multiply(slope, away[0], out=rows[2])
        away *= scale
        rows[1, 1] -= away[2]
        rows[2, 0] += away[2]
        np.negative(away[1], out=rows[3, 0])
        rows[3, 1] = away[0]
        # d f / d kappa = -f^2, and the middle depth goes with f.
        np.multiply(slope, middle[2] * f - f * seen.in_cam[2], out=rows[4])
        # d(u, v) / d x_cam, turned into the object axes.
        np.multiply(R[:2].T[:, :, None], scale, out=rows[5:])
        rows[5:] -= R[2][:, None, None] * slope
        return rows.reshape(8, 2 * n)

    def normal_equations(self, rows: Array) -> tuple[Array, Array]:
        """J^T J (M, M) and J^T r (M,) of the rows."""
        M, n = self.M, self.n
        if not n:
            return np.zeros((M, M)), np.zeros(M)
        products = rows[:, None] * rows[None, 5:]
        products = products[..., :n] + products[..., n:]
        summed = np.bincount(self._layout.places, products.ravel(), (1 + M) * M)
        table: Array = summed.astype(np.float64, copy=False).reshape(1 + M, M)
        camera = rows[:5] @ rows[1:5].T
        table[:5, :N_CAMERA] = camera
        table[5:, :N_CAMERA] = table[1:5, N_CAMERA:].T
        return table[1:], table[0]

    def dense(self, rows: Array) -> Array:
        """The rows as a Jacobian over all unknowns, (2 n, M)."""
        J = np.zeros((2 * self.n, self.M))
        J[:, :N_CAMERA] = rows[1:5].T
        at = np.arange(2 * self.n)
        columns = N_CAMERA + self._layout.coordinate
        for k in range(3):
            J[at, np.concatenate([columns[k], columns[k]])] = rows[5 + k]
        return J
