"""Damped Gauss-Newton with equality constraints by penalty continuation; knows no sketches.

Minimise |r(x)|^2 subject to h(x) = 0, x on a manifold with a retraction. For a rising penalty
weight rho, each step solves the augmented system

    [ J^T J + G + mu D   H^T      ] [dx]     [ J^T r ]
    [ H                 -1/rho  I ] [ y] = - [ h     ]

which is the Gauss-Newton step of |r|^2 + rho |h|^2, but keeps its accuracy at large rho, and does
not mind redundant rows of H. Raising rho is [Lau10]'s falling weight of the projection term, seen
from the other side; the projection term's weight never reaches 0, where nothing would hold the
model up (see CONVENTIONS.md).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

import numpy as np

from .values import Array

X = TypeVar("X")

PENALTIES = (1e0, 1e2, 1e4, 1e6, 1e8)


@dataclass(frozen=True, slots=True, eq=False)
class Evaluation:
    """Objective residuals r, J and constraint residuals h, H at one point; G fixes the gauge."""

    r: Array
    J: Array
    h: Array
    H: Array
    G: Array

    def merit(self, rho: float) -> float:
        """|r|^2 + rho |h|^2."""
        return float(self.r @ self.r + rho * (self.h @ self.h))


class Objective(Protocol[X]):
    """A problem to minimise."""

    def evaluate(self, x: X) -> Evaluation:
        """Residuals and Jacobians."""

    def retract(self, x: X, step: Array) -> X | None:
        """The point a step away, or None where there is none (behind the camera)."""

    def merit(self, x: X, rho: float) -> float:
        """|r|^2 + rho |h|^2 without derivatives."""


@dataclass(frozen=True, slots=True, eq=False)
class Minimum(Generic[X]):
    """Where the minimisation ended."""

    x: X
    iterations: int
    converged: bool
    cost: float


def minimise(
    objective: Objective[X],
    x: X,
    *,
    max_iterations: int = 100,
    stop: Callable[[], bool] | None = None,
) -> Minimum[X]:
    """Minimise from x.

    Parameters
    ----------
    objective : Objective
    x : starting point
    max_iterations : int
        In all, over all penalties.
    stop : callable, optional
        Asked between iterations; True ends the work.

    Returns
    -------
    Minimum
    """
    iterations = 0
    converged = False
    constrained = objective.evaluate(x).h.size > 0
    for rho in PENALTIES if constrained else PENALTIES[:1]:
        last = rho == PENALTIES[-1] or not constrained
        budget = max_iterations - iterations if last else 6
        x, used, converged = _minimise_at(objective, x, rho, min(budget, 40), last, stop)
        iterations += used
        if iterations >= max_iterations or (stop is not None and stop()):
            break
    return Minimum(x, iterations, converged, objective.merit(x, 0.0))


def _minimise_at(
    objective: Objective[X],
    x: X,
    rho: float,
    budget: int,
    last: bool,
    stop: Callable[[], bool] | None,
) -> tuple[X, int, bool]:
    """Levenberg-Marquardt at one penalty weight."""
    mu = 1e-8
    at = objective.evaluate(x)
    cost = at.merit(rho)
    for iteration in range(budget):
        if stop is not None and stop():
            return x, iteration, False
        step = _step(at, rho, mu)
        moved = None if step is None else objective.retract(x, step)
        new_cost = np.inf if moved is None else objective.merit(moved, rho)
        if moved is not None and step is not None and new_cost <= cost * (1 + 1e-14) + 1e-32:
            gain, size = cost - new_cost, float(np.abs(step).max(initial=0.0))
            x, cost = moved, new_cost
            at = objective.evaluate(x)
            mu = max(mu / 10, 1e-12)
            if size < 1e-13 or gain <= (1e-15 if last else 1e-4) * cost:
                return x, iteration + 1, True
        else:
            if step is not None and float(np.abs(step).max(initial=0.0)) < 1e-11:
                return x, iteration + 1, True
            mu = max(mu * 10, 1e-6)
            if mu > 1e8:
                return x, iteration + 1, False
    return x, budget, False


def _step(at: Evaluation, rho: float, mu: float) -> Array | None:
    A = at.J.T @ at.J + at.G
    diagonal = np.diag(A).copy()
    A[np.diag_indices(len(A))] += mu * (diagonal + 1e-3 * float(diagonal.max(initial=1.0))) + 1e-15
    n, k = len(A), len(at.h)
    system = np.zeros((n + k, n + k))
    system[:n, :n] = A
    system[:n, n:] = at.H.T
    system[n:, :n] = at.H
    system[n:, n:] = -np.eye(k) / rho
    right = -np.concatenate([at.J.T @ at.r, at.h])
    try:
        solved = np.linalg.solve(system, right)
    except np.linalg.LinAlgError:
        return None
    step: Array = solved[:n]
    return step if bool(np.isfinite(step).all()) else None
