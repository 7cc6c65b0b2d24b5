"""Damped Gauss-Newton with equality constraints by penalty continuation; knows no sketches.

Minimise |r(x)|^2 subject to h(x) = 0, x on a manifold with a retraction. For a rising penalty
weight rho, each step solves the augmented system

    [ A + mu D   H^T     ] [dx]     [ b ]
    [ H         -1/rho I ] [ y] = - [ h ]      A = J^T J + G,  b = J^T r


which is the Gauss-Newton step of |r|^2 + rho |h|^2, but keeps its accuracy at large rho, and does
not mind redundant rows of H. Raising rho is [Lau10]'s falling weight of the projection term, seen
from the other side; the projection term's weight never reaches 0, where nothing would hold the
model up (see CONVENTIONS.md).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Generic, Protocol, TypeVar

import numpy as np
from scipy.linalg.lapack import dgelsy, dposv
from scipy.sparse import bmat, csc_array, identity
from scipy.sparse.linalg import splu

from .values import Array

X = TypeVar("X")

#: The rising weights on the way, and the weight with which constraints are held at the end.
PENALTIES = (1e0, 1e2, 1e4)
LAST_PENALTY = 1e9
#: Where constraints are off by less than this (norm) and can be held to so little, steps along
#: them are sure, and no weight has to rise any more.
NEARLY_HELD, HELD = 1e-2, 1e-9
#: A gain this small against the cost moves the shape by far less than a person can draw.
ENOUGH = 1e-11
FIRST_DAMPING = 1e-8
#: Of a step that are tried.
PARTS = (1.0, 0.5)
#: Up to so many unknowns dense algebra is faster.
MAX_DENSE = 150
#: Rows of constraints that differ by less say the same; columns that LAPACK turns at once.
SAME_ROW, BLOCK = 1e-9, 32
#: Nothing is left to gain below this: every point is met to 1e-13.
EXACT_COST = 1e-26


@dataclass(frozen=True, slots=True, eq=False)
class Evaluation:
    """The normal equations at one point, their gauge fixed, and the constraints.

    Parameters
    ----------
    A : (n, n) array
        J^T J + G.
    b : (n,) array
        J^T r.
    h : (k,) array
    H : (k, n) array
    n_common : int
        So many unknowns, the first, are felt everywhere; the others only by few.
    """

    A: Array
    b: Array
    h: Array
    H: Array
    n_common: int = 0


class Objective(Protocol[X]):
    """A problem to minimise."""

    #: Whether steps along the constraints leave them: those that are linear are never left.
    curved: bool

    def evaluate(self, x: X) -> Evaluation:
        """The normal equations and the constraints."""

    def retract(self, x: X, step: Array) -> X | None:
        """The point a step away, or None where there is none (behind the camera)."""

    def merit(self, x: X, rho: float) -> float:
        """|r|^2 + rho |h|^2 without derivatives."""

    def restore(self, x: X) -> X:
        """The nearest point where h = 0, or as near to 0 as can be."""


@dataclass(frozen=True, slots=True, eq=False)
class Minimum(Generic[X]):
    """Where the minimisation ended, and the damping and the last gain with which it can go on."""

    x: X
    iterations: int
    converged: bool
    cost: float
    damping: float = FIRST_DAMPING
    gain: float = 0.0


def minimise(
    objective: Objective[X],
    x: X,
    *,
    max_iterations: int = 100,
    enough: float = ENOUGH,
    near: bool = False,
    damping: float = FIRST_DAMPING,
    gained: float = 0.0,
    stop: Callable[[], bool] | None = None,
    been: Callable[[X], bool] | None = None,
) -> Minimum[X]:
    """Minimise from x.

    Parameters
    ----------
    objective : Objective
    x : starting point
    max_iterations : int
        In all, over all penalties.
    enough : float
        The work is done when a step gains less than this part of the cost, or when the next one
        will, as fast as gains fall.
    near : bool
        Whether x nearly is the minimum: the rising weights are then left out.
    damping : float
        Of the first step.
    gained : float
        By the step before the first, where it is a continuation; else 0.
    stop : callable, optional
        Asked between iterations; True ends the work.
    been : callable, optional
        Whether the way from a point is known already; it then ends there, at infinite cost.

    Returns
    -------
    Minimum
    """
    # Wild points overflow on the way; each step is judged by a finite merit.
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        phase = _Phase(LAST_PENALTY, max_iterations, enough, True, damping, gained)
        return _minimise(objective, x, () if near else PENALTIES, phase, stop, been)


def _minimise(
    objective: Objective[X],
    x: X,
    penalties: tuple[float, ...],
    last: _Phase,
    stop: Callable[[], bool] | None,
    been: Callable[[X], bool] | None,
) -> Minimum[X]:
    iterations = 0
    for rho in penalties if objective.curved else ():
        held = objective.restore(x) if _off(objective, x) < NEARLY_HELD else x
        if _off(objective, held) < HELD:
            x = held
            break
        # Once nearly held they mostly can be held; where they cannot, the other weights decide.
        nearly = NEARLY_HELD if rho == penalties[0] else 0.0
        reached = _descend(objective, x, _Phase(rho, 6, 1e-4, False, nearly=nearly), stop, been)
        x = reached.x
        iterations += reached.iterations
        if reached.cost == np.inf:
            return replace(reached, iterations=iterations)
    last = replace(last, budget=max(1, last.budget - iterations))
    reached = _descend(objective, x, last, stop, been)
    return replace(reached, iterations=iterations + reached.iterations)


def _off(objective: Objective[X], x: X) -> float:
    """|h|."""
    return math.sqrt(max(0.0, objective.merit(x, 1.0) - objective.merit(x, 0.0)))


@dataclass(frozen=True, slots=True)
class _Phase:
    """One stretch of the descent; it ends, too, where constraints are off by less than `nearly`.

    In the last phase every point is put back onto h = 0 and judged by |r|^2 alone: judged by the
    penalty, long steps along curved constraints would be refused (the Maratos effect).
    """

    rho: float
    budget: int
    enough: float
    last: bool
    damping: float = FIRST_DAMPING
    gained: float = 0.0
    nearly: float = 0.0

    @property
    def judged_by(self) -> float:
        """The weight of the constraints when steps are judged."""
        return 0.0 if self.last else self.rho


def _descend(
    objective: Objective[X],
    x: X,
    phase: _Phase,
    stop: Callable[[], bool] | None,
    been: Callable[[X], bool] | None = None,
) -> Minimum[X]:
    """Levenberg-Marquardt at one penalty weight."""
    mu, before = phase.damping, phase.gained
    if phase.last:
        x = objective.restore(x)
    at = None
    cost = objective.merit(x, phase.judged_by)
    for iteration in range(phase.budget):
        if stop is not None and stop():
            return Minimum(x, iteration, False, cost, mu, before)
        at = at or objective.evaluate(x)
        step = _step(at, phase.rho, mu)
        size = np.inf if step is None else float(np.abs(step).max(initial=0.0))
        moved = None if step is None else _moved(objective, x, step, phase, cost)
        if moved is not None:
            x, gain, part = moved.x, cost - moved.cost, moved.part
            cost, at = moved.cost, None
            if been is not None and been(x):
                return Minimum(x, iteration + 1, False, np.inf)
            mu = max(mu / 10, 1e-12) if part == 1.0 else mu
            # Near a minimum gains fall by the same factor, or faster.
            will_gain, before = gain * min(1.0, gain / max(before, 1e-300)), gain
            if size < 1e-12 or will_gain <= phase.enough * cost:
                return Minimum(x, iteration + 1, True, cost, mu, gain)
            if phase.nearly and _off(objective, x) < phase.nearly:
                return Minimum(x, iteration + 1, False, cost, mu, gain)
        else:
            if size < 1e-9:
                return Minimum(x, iteration + 1, True, cost, mu, before)
            mu = max(mu * 10, 1e-6)
            if mu > 1e8:
                return Minimum(x, iteration + 1, False, cost, mu, before)
    return Minimum(x, phase.budget, False, cost, mu, before)


@dataclass(frozen=True, slots=True, eq=False)
class _Moved(Generic[X]):
    """Where a part of a step leads to, and the cost there."""

    x: X
    cost: float
    part: float


def _moved(
    objective: Objective[X], x: X, step: Array, phase: _Phase, cost: float
) -> _Moved[X] | None:
    """Where the step, or else half of it, costs no more.

    Halving is cheaper than another damping, which has to grow from almost nothing.
    """
    for part in PARTS:
        moved = objective.retract(x, part * step)
        if moved is not None and phase.last:
            moved = objective.restore(moved)
        if moved is None:
            continue
        new_cost = objective.merit(moved, phase.judged_by)
        if new_cost <= cost * (1 + 1e-14) + 1e-32:
            return _Moved(moved, new_cost, part)
    return None


def _step(at: Evaluation, rho: float, mu: float) -> Array | None:
    A, n = at.A.copy(), len(at.A)
    diagonal = A.ravel()[:: n + 1]
    diagonal += mu * (diagonal + 1e-3 * max(1.0, float(diagonal.max()))) + 1e-15
    try:
        step = _constrained_step(A, at, rho) if len(at.h) else _free_step(A, at)
    except (np.linalg.LinAlgError, RuntimeError):
        return None
    return step if bool(np.isfinite(step).all()) else None


def _free_step(A: Array, at: Evaluation) -> Array:
    if len(A) > MAX_DENSE:
        return _solve(A, -at.b, at.n_common)
    # The plain routine: a small system is solved sooner than checked.
    _, step, failed = dposv(A, at.b)
    return np.asarray(-step) if not failed else np.asarray(-np.linalg.solve(A, at.b))


def _constrained_step(A: Array, at: Evaluation, rho: float) -> Array:
    n = len(A)
    h, H = _few_rows(at.h, at.H)
    k = len(h)
    system = np.zeros((n + k, n + k))
    system[:n, :n] = A
    system[:n, n:] = H.T
    system[n:, :n] = H
    system.ravel()[n * (n + k + 1) :: n + k + 1] = -1 / rho
    return _solve(system, -np.concatenate([at.b, h]), at.n_common)[:n]


def _solve(system: Array, right: Array, n_common: int) -> Array:
    """Dense, or for many unknowns sparse behind those first ones that everything depends on."""
    if len(system) <= MAX_DENSE or not bool(np.isfinite(system).all()):
        return np.asarray(np.linalg.solve(system, right))
    c = n_common
    factored = splu(csc_array(system[c:, c:]), permc_spec="MMD_AT_PLUS_A")
    behind = factored.solve(np.column_stack([system[c:, :c], right[c:]]))
    spread, rest = behind[:, :c], behind[:, c]
    # The Schur complement of what is behind.
    first = np.linalg.solve(
        system[:c, :c] - system[:c, c:] @ spread, right[:c] - system[:c, c:] @ rest
    )
    return np.concatenate([first, rest - spread @ first])


def _few_rows(h: Array, H: Array) -> tuple[Array, Array]:
    """No more rows than unknowns that say the same: with H = Q R, R and Q^T h."""
    if len(h) <= H.shape[1] or not bool(np.isfinite(H).all()):
        return h, H
    # As one more column, h becomes Q^T h, and Q is not needed.
    n = H.shape[1]
    R = np.asarray(np.linalg.qr(np.column_stack([H, h]), mode="r"))
    return R[:n, n], R[:n, :n]


def smallest_step(h: Array, H: Array) -> Array:
    """The smallest step that takes h to 0, or as near to 0 as can be: -H^+ h."""
    k, n = H.shape
    if n <= MAX_DENSE:
        return _smallest_dense_step(h, H)
    if k > n:
        # So many rows leave nothing that is sparse.
        return _smallest_dense_step(*_few_rows(h, H))
    # Rows that say the same are told apart by a little slack; repeated steps do the rest.
    rows = csc_array(H)
    slack = 1e-12 * float(np.abs(H).max(initial=1.0)) ** 2
    system = bmat([[identity(n), rows.T], [rows, -slack * identity(k)]], format="csc")
    solved = splu(system).solve(np.concatenate([np.zeros(n), -h]))
    return np.asarray(solved[:n])


def _smallest_dense_step(h: Array, H: Array) -> Array:
    """By QR with pivots, which takes a third of the time of singular values."""
    k, n = H.shape
    right = np.zeros((max(k, n), 1))
    right[:k, 0] = h
    room = min(k, n) + 2 * n + BLOCK * (n + 1)
    _, step, _, _, _ = dgelsy(H, right, np.zeros(n, dtype=np.int32), SAME_ROW, room)
    return np.asarray(-step[:n, 0])
