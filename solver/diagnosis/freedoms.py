"""What is left open.

Terms
-----
freedom
    A direction in the unknowns that neither the drawing nor a constraint feels; the overall size is
    not counted.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..full import FullProblem, Pose
from ..geometry import cross
from ..values import Array
from .definite import safe_inverse

#: Up to so many unknowns the null space is taken from the Jacobian itself.
MAX_SVD = 300
#: Singular values below this part of the largest are freedoms.
NULL_TOLERANCE = 1e-8


@dataclass(frozen=True, slots=True)
class Freedoms:
    """How many freedoms are left, and the vertices that they move.

    Parameters
    ----------
    count : int
    loose : tuple of ids
        Vertices and circles that move against the largest part that moves as one.
    moves : (f, n, 3) array
        Moves of all points in the camera's frame that span the freedoms and the overall size, as
        large as the object's distance.
    """

    count: int
    loose: tuple[str, ...]
    moves: Array

    @classmethod
    def none(cls) -> Freedoms:
        """Nothing is left open."""
        return cls(0, (), np.zeros((0, 0, 3)))


def freedoms(full: FullProblem, x: Pose, names: list[str]) -> Freedoms:
    """Null space of the reduced Jacobian at a solution.

    Parameters
    ----------
    full : FullProblem
    x : Pose
    names : list of ids
        Of the vertices, then of the circles.
    """
    at = full.evaluate(x)
    if safe_inverse(at.A + at.H.T @ at.H if len(at.h) else at.A) is not None:
        # Nothing but the overall size, which is held there, can be free.
        return Freedoms.none()
    _, J = full.jacobian(x)
    _, H = full.constraints(x)
    # Constraints weigh as much as the drawing: only whether they act matters here. The gauge is
    # left free, so that the overall size is one of the directions found.
    stacked = np.vstack([J, H, full.idle_directions(x)])
    scale = np.maximum(np.linalg.norm(stacked, axis=0), 1e-12)
    null = _null_space(stacked / scale) / scale
    count = max(0, len(null) - 1)
    if not count:
        return Freedoms.none()
    moves = _moves(full, x, null)
    return Freedoms(count, _loose(full, x, moves, names), moves)


def _null_space(A: Array) -> Array:
    """Rows that span the null space of A."""
    rows, columns = A.shape
    if columns <= MAX_SVD:
        if rows > columns:
            # The triangular factor has the same singular values and null space.
            A = np.asarray(np.linalg.qr(A, mode="r"), dtype=np.float64)
            rows = columns
        padded = np.vstack([A, np.zeros((max(0, columns - rows), columns))])
        _, s, Vt = np.linalg.svd(padded, full_matrices=False)
        return np.asarray(Vt[s <= NULL_TOLERANCE * max(float(s[0]), 1e-300)])
    # Squaring halves the digits, so that the tolerance is coarser.
    values, vectors = np.linalg.eigh(A.T @ A)
    return np.asarray(vectors[:, values <= 1e-13 * max(float(values[-1]), 1e-300)].T)


def _moves(full: FullProblem, x: Pose, null: Array) -> Array:
    """Moves (f, n, 3) in the camera's frame: own ones, the turn about the middle, and the dolly."""
    X = full.positions(x) @ x.R.T
    middle = X.mean(axis=0)
    moves = null[:, 4:][:, full.coordinate] @ x.R.T + cross(null[:, None, :3], X - middle)
    moves[..., 2] -= np.exp(x.log_focal) * middle[2] * null[:, 3, None]
    size = np.abs(moves).max(axis=(1, 2), initial=1e-300) / float(np.abs(X[:, 2]).max())
    return np.asarray(moves / size[:, None, None])


def _loose(full: FullProblem, x: Pose, moves: Array, names: list[str]) -> tuple[str, ...]:
    """The vertices that move against the largest part that grows and shrinks as one."""
    depth = full.positions(x) @ x.R[2]
    growth = (moves[..., 2] / depth).T
    # Freedoms of all sizes count alike.
    U, s, _ = np.linalg.svd(growth, full_matrices=False)
    steps = np.round(U[:, s > NULL_TOLERANCE * max(float(s[0]), 1e-300)], 5)
    _, part, sizes = np.unique(steps, axis=0, return_inverse=True, return_counts=True)
    part = part.reshape(-1)
    # Of equally large parts, the one that was drawn first stands still.
    still = part[int(np.argmax(sizes[part]))]
    return tuple(n for n, p in zip(names, part, strict=True) if p != still)
