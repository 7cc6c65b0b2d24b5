"""The projected circles and their part of the normal equations, as `projection` has the vertices'.

Each circle speaks of eight unknowns only: the turn, kappa, its own centre and its radius.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .energies.circle import Support, circle_support
from .geometry import cross_columns
from .problem import Problem
from .projection import N_CAMERA
from .structure import Structure
from .topology import MAX_KEPT
from .values import Array, IntArray


@dataclass(frozen=True, slots=True, eq=False)
class _Layout:
    """Where the circles' numbers belong; M counts all unknowns.

    Parameters
    ----------
    coordinate : (3, k) int array
        Of the centres.
    places : (8, k * j) int array
        Of the derivatives by (turn, kappa, x, y, z, radius), in a Jacobian of k j rows and M.
    """

    coordinate: IntArray
    places: IntArray


@lru_cache(maxsize=MAX_KEPT)
def _layout(structure: Structure, n_vertices: int, n_tangents: int) -> _Layout:
    coordinate = np.ascontiguousarray(structure.coordinate[n_vertices:].T)
    k, M = coordinate.shape[1], N_CAMERA + structure.n_coordinates
    camera = np.broadcast_to(np.arange(N_CAMERA)[:, None], (N_CAMERA, k))
    columns = np.vstack([camera, N_CAMERA + coordinate, N_CAMERA + structure.radius[None]])
    rows = np.arange(k * n_tangents) * M
    return _Layout(coordinate, rows + np.repeat(columns, n_tangents, axis=1))


class Circles:
    """The circles of a problem."""

    def __init__(self, problem: Problem) -> None:
        drawn, structure = problem.circles, problem.structure
        self.M = N_CAMERA + structure.n_coordinates
        self._layout = _layout(structure, len(problem.points), drawn.supports.shape[1])
        self._radius = structure.radius
        self._upward = 2 if structure.vertical is None else structure.vertical
        self._directions = np.ascontiguousarray(drawn.directions.transpose(2, 0, 1))
        self._weights = drawn.weights[:, None]
        self._supports = drawn.supports

    def seen(self, R: Array, log_focal: float, g: Array) -> Support:
        """The view of one pose."""
        centres = R @ g[self._layout.coordinate]
        p = math.exp(log_focal) * self._directions
        return circle_support(centres, g[self._radius], R[:, self._upward], p)

    def residual(self, support: Support) -> Array:
        """Of all tangents, (k j,)."""
        return np.asarray(((support.h - self._supports) * self._weights).ravel())

    def jacobian(self, support: Support, R: Array, log_focal: float, middle: Array) -> Array:
        """Derivatives of the residual by all unknowns, (k j, M).

        Parameters
        ----------
        support : Support
        R, log_focal : of the same pose
        middle : (3,) array
            In the camera frame: what the turn is about.
        """
        at = support.slopes()
        rows = np.empty((8, *support.h.shape))
        away = support.C - middle[:, None, None]
        normal = R[:, self._upward][:, None, None]
        rows[:3] = cross_columns(away, at.by_centre) + cross_columns(normal, at.by_normal)
        # kappa is the inverse focal length, and the middle's depth goes with it.
        dolly = at.by_log_focal + float(middle[2]) * at.by_centre[2]
        np.multiply(dolly, -math.exp(log_focal), out=rows[3])
        rows[4:7] = np.tensordot(R.T, at.by_centre, 1)
        rows[7] = at.by_radius
        rows *= self._weights
        J = np.zeros((self._supports.size, self.M))
        J.ravel()[self._layout.places] = rows.reshape(8, -1)
        return J
