"""The geometric constraints of [Lau10] 4.2, as printed: angles in degrees, squared.

Terms
-----
vec
    The vector of a line, one endpoint subtracted from the other.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..values import Array

IntArray = NDArray[np.int64]

#: [Lau10] 4.2: "The weights are 0.5, 10, and 10, respectively."
RIGHT_ANGLE_WEIGHT, EQUAL_LENGTH_WEIGHT, PARALLEL_WEIGHT = 0.5, 10.0, 10.0
_TINY = 1e-12


def angle_deg(u: Array, v: Array) -> Array:
    """Angles between vectors (k, 3), degrees, (k,); 90 where one has no length."""
    lengths = np.sqrt(np.einsum("ij,ij->i", u, u) * np.einsum("ij,ij->i", v, v))
    cosine = np.einsum("ij,ij->i", u, v) / np.maximum(lengths, _TINY)
    return np.asarray(np.degrees(np.arccos(np.minimum(np.maximum(cosine, -1.0), 1.0))))


def right_angle_energy(u: Array, v: Array) -> float:
    """Sum over i of (angle e_i - 90 degrees)^2."""
    off = angle_deg(u, v) - 90.0
    return float(off @ off)


def equal_length_energy(vec: Array, next_vec: Array) -> float:
    """Sum over s and i of (len(vec_i) - len(vec_i+1))^2, square drawing units."""
    off = np.linalg.norm(vec, axis=1) - np.linalg.norm(next_vec, axis=1)
    return float(off @ off)


def parallel_energy_as_printed(vec: Array, next_vec: Array) -> float:
    """Sum over s and i of 1 / (angle(vec_i, vec_i+1) - 90 degrees)^2, as [Lau10] prints it.

    For parallel lines it is 1 / 8100, its smallest value and not zero; at right angles it has a
    pole. Within 80 degrees of parallel it stays below 0.01, so that beside the other terms it
    only forbids right angles. The methods use `parallel_energy`.
    """
    off = angle_deg(vec, next_vec) - 90.0
    return float(np.sum(1.0 / np.maximum(off**2, _TINY)))


def parallel_energy(vec: Array, next_vec: Array) -> float:
    """Sum over s and i of (angle to being parallel)^2, square degrees: the reading chosen.

    90 - abs(angle - 90) is 0 for parallel lines of either sense and grows where the printed term
    grows; squared, it is of the kind of the right angles' term.
    """
    off = 90.0 - np.abs(angle_deg(vec, next_vec) - 90.0)
    return float(off @ off)


@dataclass(frozen=True, slots=True, eq=False)
class GeometricConstraints:
    """The weighted sum of the geometric energies of one sketch.

    Parameters
    ----------
    right_angles, equal_lengths, parallels : (k, 4) int arrays
        Two lines a row, as vertices (from, to, from, to).
    on_face : (k, 4) int array
        Three corners of a face, then a vertex that lies in it.
    """

    right_angles: IntArray
    equal_lengths: IntArray
    parallels: IntArray
    on_face: IntArray

    def energy(self, X: Array) -> float:
        """The energy of the vertices X (n, 3), drawing units."""
        total = 0.0
        if len(self.right_angles):
            total += RIGHT_ANGLE_WEIGHT * right_angle_energy(*_lines(X, self.right_angles))
        if len(self.equal_lengths):
            total += EQUAL_LENGTH_WEIGHT * equal_length_energy(*_lines(X, self.equal_lengths))
        if len(self.parallels):
            total += PARALLEL_WEIGHT * parallel_energy(*_lines(X, self.parallels))
        if len(self.on_face):
            # Not in the paper: the line from the face to the vertex is square to its normal.
            a, b, c, d = (X[i] for i in self.on_face.T)
            total += RIGHT_ANGLE_WEIGHT * right_angle_energy(np.cross(b - a, c - b), d - b)
        return total


def _lines(X: Array, rows: IntArray) -> tuple[Array, Array]:
    corners = X[rows]
    return corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 2]
