"""What each annotation keeps a shape from: how much nearer to the drawing it would come without.

The test of Lagrange multipliers, as statisticians know it: at a shape that all annotations hold
for, one linearisation tells for each of them what is gained where it alone is left out, and the
shape gives way as far as the others let it.

Terms
-----
relief
    By how much the sum of squares falls without an annotation.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..full import FullProblem, Pose
from ..graph import SketchGraph
from ..values import Array
from .definite import safe_inverse
from .suspects import MAX_UNKNOWNS, row_owners, rows_of_owners, softened, unshared

#: How many times stiffer than the drawing conditions are taken to be: digits enough for both.
STIFFER = 1e5
#: A condition of which so much less than all is left to the others moves with them.
FREED = 1e-2
#: What is open is held by so little, in parts of the rest; more where rounding asks for it.
HOLDS = (1e-14, 1e-10)

Owned = Mapping[str, list[int]]


@dataclass(frozen=True, slots=True)
class Relief:
    """What leaving one annotation out would gain.

    Parameters
    ----------
    id : str
    gain : float
        The fall of the sum of squares, image units.
    freed : int
        Conditions that nothing else asks for.
    """

    id: str
    gain: float
    freed: int


def reliefs(graph: SketchGraph, full: FullProblem, x: Pose) -> list[Relief]:
    """The reliefs of all annotations that bring any, the largest first; none of large sketches.

    Parameters
    ----------
    graph : SketchGraph
    full : FullProblem
        What was solved.
    x : Pose
        A shape that all annotations hold for.
    """
    if 3 * (len(full.problem.points) + len(full.problem.circles)) > MAX_UNKNOWNS:
        return []
    soft = softened(graph, full.problem).with_prior(full.prior)
    at = soft.evaluate(unshared(soft, full, x))
    if not len(at.h):
        return []
    steepest = np.einsum("ij,ij->j", at.H, at.H).max()
    stiffness = STIFFER * float(np.diag(at.A).max() / max(steepest, 1e-300))
    inverse = _inverse(at.A + stiffness * (at.H.T @ at.H))
    if inverse is None:
        return []
    h = at.h - at.H @ (inverse @ (at.b + stiffness * (at.H.T @ at.h)))
    owned = rows_of_owners(row_owners(graph, soft))
    found = _of_one_row(owned, at.H, inverse, h, stiffness)
    found += _of_several(owned, at.H, inverse, h, stiffness)
    return sorted(found, key=lambda r: -r.gain)


def _inverse(A: Array) -> Array | None:
    """What is open stays where it is."""
    for held in HOLDS:
        inverse = safe_inverse(A + held * np.diag(np.diag(A)))
        if inverse is not None:
            return inverse
    return None


def _of_one_row(owned: Owned, H: Array, inverse: Array, h: Array, stiffness: float) -> list[Relief]:
    ids = [id_ for id_, rows in owned.items() if len(rows) == 1]
    rows = [owned[id_][0] for id_ in ids]
    left = 1.0 + 1e-9 - stiffness * np.einsum("ij,ij->i", H[rows] @ inverse, H[rows])
    gains = stiffness * h[rows] ** 2 / np.maximum(left, 1e-9)
    return [
        Relief(id_, gain, int(of_one < FREED))
        for id_, gain, of_one in zip(ids, gains.tolist(), left.tolist(), strict=True)
    ]


def _of_several(owned: Owned, H: Array, inverse: Array, h: Array, stiffness: float) -> list[Relief]:
    found = []
    for id_, rows in owned.items():
        if len(rows) > 1:
            own, missed, beside = _few_rows(H[rows], h[rows])
            left = np.eye(len(own)) * (1 + 1e-9) - stiffness * (own @ inverse @ own.T)
            values, vectors = np.linalg.eigh(left)
            along = (missed @ vectors) ** 2 / np.maximum(values, 1e-9)
            gain = stiffness * (float(along.sum()) + beside)
            found.append(Relief(id_, gain, int((values < FREED).sum())))
    return found


def _few_rows(H: Array, h: Array) -> tuple[Array, Array, float]:
    """No more rows than unknowns that say the same, and the square of what of h none of them has.

    With H = Q R: R, Q^T h and the rest of |h|^2. One vertex on a face of a tangle has thousands.
    """
    n = H.shape[1]
    if len(h) <= n + 1:
        return H, h, 0.0
    R = np.asarray(np.linalg.qr(np.column_stack([H, h]), mode="r"))
    return R[:n, :n], R[:n, n], float(R[n, n] ** 2)
