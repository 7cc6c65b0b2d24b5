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
    """How many freedoms are left, and the vertices that they move."""

    count: int
    loose: tuple[str, ...]


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
        return Freedoms(0, ())
    _, J = full.jacobian(x)
    _, H = full.constraints(x)
    # Constraints weigh as much as the drawing: only whether they act matters here. The gauge is
    # left free, so that the overall size is one of the directions found.
    stacked = np.vstack([J, H, full.idle_directions(x)])
    scale = np.maximum(np.linalg.norm(stacked, axis=0), 1e-12)
    null = _null_space(stacked / scale) / scale
    count = max(0, len(null) - 1)
    loose = _loose(full, x, null, names) if count else ()
    return Freedoms(count, loose)


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


def _loose(full: FullProblem, x: Pose, null: Array, names: list[str]) -> tuple[str, ...]:
    """The vertices that move against the largest part that grows and shrinks as one."""
    X = full.positions(x) @ x.R.T
    middle = X.mean(axis=0)
    # In the camera's frame: own moves, the turn about the middle, and the dolly of a new focal
    # length.
    motion = null[:, 4:][:, full.coordinate] @ x.R.T  # (freedoms, n, 3)
    motion += cross(null[:, None, :3], X - middle)
    motion[..., 2] -= np.exp(x.log_focal) * middle[2] * null[:, 3, None]
    growth = (motion[..., 2] / X[:, 2]).T
    # Freedoms of all sizes count alike.
    U, s, _ = np.linalg.svd(growth, full_matrices=False)
    steps = np.round(U[:, s > NULL_TOLERANCE * max(float(s[0]), 1e-300)], 5)
    _, part, sizes = np.unique(steps, axis=0, return_inverse=True, return_counts=True)
    part = part.reshape(-1)
    # Of equally large parts, the one that was drawn first stands still.
    still = part[int(np.argmax(sizes[part]))]
    return tuple(n for n, p in zip(names, part, strict=True) if p != still)
