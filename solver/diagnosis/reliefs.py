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
from ..least_squares import Evaluation
from ..values import Array
from .definite import Definite
from .suspects import MAX_UNKNOWNS, row_owners, rows_of_owners, softened, unshared

#: How many times stiffer than the drawing conditions are taken to be: digits enough for both.
STIFFER = 1e5
#: A condition of which so much less than all is left to the others moves with them.
FREED = 1e-2
#: What is open is held by so little, in parts of the rest; more where rounding asks for it.
HOLDS = (1e-14, 1e-10)
#: A gain of less than this part of the misfit is none: an F test over some hundred drawn numbers
#: asks for some hundredths. Random vectors by which gains are bounded.
WORTH_ASKING, PROBES = 1e-3, 4

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
    stiffness = STIFFER * float(at.A.diagonal().max() / max(steepest, 1e-300))
    held = _held(at, stiffness)
    if held is None:
        return []
    h = at.h - at.H @ held.solve(at.b + stiffness * (at.h @ at.H))
    springs = Springs(at.H, h, held, stiffness)
    owned = rows_of_owners(row_owners(graph, soft))
    found = of_one_row(owned, springs, WORTH_ASKING * full.misfit(x))
    found += of_several(owned, springs)
    return sorted(found, key=lambda r: -r.gain)


@dataclass(frozen=True, slots=True, eq=False)
class Springs:
    """Conditions as stiff springs in balance with the drawing.

    Parameters
    ----------
    H : (k, n) array
    h : (k,) array
        What is left of the conditions.
    held : Definite
        J^T J + s H^T H.
    stiffness : float
        s.
    """

    H: Array
    h: Array
    held: Definite
    stiffness: float

    def left(self, rows: Array) -> Array:
        """M = I - s H (J^T J + s H^T H)^-1 H^T for some rows: next to 0 what they alone ask for."""
        both = rows @ self.held.solve(rows.T)
        return np.asarray(np.eye(len(rows)) * (1 + 1e-9) - self.stiffness * both)

    def most(self) -> Array:
        """No row alone gains more than this, (k,): M_ii >= (M w)_i^2 / w^T M w for any w."""
        w = np.random.default_rng(0).normal(size=(len(self.h), PROBES))
        Mw = w - self.stiffness * (self.H @ self.held.solve(self.H.T @ w))
        least = Mw**2 / np.maximum(np.einsum("kp,kp->p", w, Mw), 1e-300)
        return np.asarray(self.stiffness * self.h**2 / np.maximum(least.max(axis=1), 1e-300))


def _held(at: Evaluation, stiffness: float) -> Definite | None:
    """What is open stays where it is."""
    A = at.A + stiffness * (at.H.T @ at.H)
    diagonal = A.diagonal().copy()
    for held in HOLDS:
        np.fill_diagonal(A, diagonal * (1 + held))
        factored = Definite.of(A)
        if factored is not None:
            return factored
    return None


def of_one_row(owned: Owned, springs: Springs, enough: float) -> list[Relief]:
    """Of annotations that ask for one condition and may gain enough: most ask for what others ask
    for as well."""
    worth = springs.most() > enough
    ids = [id_ for id_, rows in owned.items() if len(rows) == 1 and worth[rows[0]]]
    rows = [owned[id_][0] for id_ in ids]
    own = springs.H[rows]
    solved = springs.held.solve(own.T)
    left = 1.0 + 1e-9 - springs.stiffness * np.einsum("ij,ji->i", own, solved)
    gains = springs.stiffness * springs.h[rows] ** 2 / np.maximum(left, 1e-9)
    return [
        Relief(id_, gain, int(of_one < FREED))
        for id_, gain, of_one in zip(ids, gains.tolist(), left.tolist(), strict=True)
    ]


def of_several(owned: Owned, springs: Springs) -> list[Relief]:
    """Of annotations that ask for more than one condition."""
    found = []
    for id_, rows in owned.items():
        if len(rows) > 1:
            own, missed, beside = _few_rows(springs.H[rows], springs.h[rows])
            values, vectors = np.linalg.eigh(springs.left(own))
            along = (missed @ vectors) ** 2 / np.maximum(values, 1e-9)
            gain = springs.stiffness * (float(along.sum()) + beside)
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
