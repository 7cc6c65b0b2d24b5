"""How sure the result is: standard errors from the final Jacobian."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..full import DRAWING_SIGMA, FullProblem, Pose
from ..geometry import diagonal
from ..projection import N_CAMERA
from ..values import Array, IntArray
from .definite import safe_inverse
from .freedoms import NULL_TOLERANCE

#: How people draw (RMS of a vertex, in parts of the drawing's diagonal), and for how many observed
#: numbers that knowledge counts beside the misfit of the drawing at hand.
USUAL_SIGMA, USUAL_COUNT = 0.01, 6
#: The result is unsure where sizes are less certain than this (RMS over the edges).
UNSURE_SIZE_SIGMA = 0.1


def focal_sigma(full: FullProblem, x: Pose) -> float:
    """Standard error of the log focal length, from the drawing's own misfit."""
    at = full.evaluate(x)
    squares, n_residuals = full.merit(x, 0.0), full.n_residuals
    inverse = None if len(at.h) else safe_inverse(at.A)
    if inverse is not None:
        noise = max(squares / max(1, n_residuals - len(at.A) + 1), 1e-14)
        return float(np.exp(x.log_focal) * np.sqrt(noise * inverse[3, 3]))
    # In the directions that keep the constraints: weighing these against the drawing instead would
    # drown what little a view from afar says of its focal length.
    N = tangent(at.H)
    A = N.T @ at.A @ N
    spare = max(1, n_residuals - N.shape[1] + 1)
    noise = max(squares / spare, 1e-14)
    values, vectors = np.linalg.eigh(A)
    share = vectors.T @ N[3]
    floor = 1e-13 * float(values.max())
    if float(np.sum(share[values <= floor] ** 2)) > 1e-6:
        return float("inf")
    variance = noise * float(np.sum(share**2 / np.maximum(values, floor)))
    # d log f = -f d kappa
    return float(np.exp(x.log_focal) * np.sqrt(variance))


@dataclass(frozen=True, slots=True, eq=False)
class StandardErrors:
    """How sure a result is.

    Parameters
    ----------
    lengths : (m,) array
        Of the edges' lengths relative to the mean of all, in parts.
    log_focal : float
        As far as the drawing alone tells it, whatever was expected beforehand.
    """

    lengths: Array
    log_focal: float


def standard_errors(full: FullProblem, x: Pose) -> StandardErrors:
    """Standard errors at a solution.

    The error of a drawn position is taken to be what people usually have, corrected by the misfit
    of this drawing: with s0 for how people draw, counted nu times,
    s^2 = (nu s0^2 + |r|^2) / (nu + spare). The covariance of the unknowns is s^2 (J^T J)^-1 in the
    directions that keep the constraints.
    """
    ends = full.problem.ends
    if not len(ends):
        return StandardErrors(np.zeros(0), 0.0)
    at = full.evaluate(x)
    inverse = None if len(at.h) else safe_inverse(at.A)
    if inverse is not None:
        n_free, spread = len(at.A), _relative_spread(full, x, inverse)
        cofactor = float(inverse[3, 3])
    else:
        N = tangent(at.H)
        n_free = N.shape[1]
        spread, cofactor = _spread_on_constraints(full, x, at.A, N)
    points = np.vstack([full.problem.points, full.problem.circles.centres])
    usual = (USUAL_SIGMA * diagonal(points)) ** 2 / 2
    spare = max(0, 2 * full.n_vertices - n_free + 1)
    misfit = full.merit(x, 0.0)
    variance = (USUAL_COUNT * usual + misfit) / (USUAL_COUNT + spare)
    log_focal = float(np.sqrt(variance * _of_the_drawing_alone(full, x, cofactor)))
    return StandardErrors(np.asarray(np.sqrt(variance * spread)), log_focal)


def _of_the_drawing_alone(full: FullProblem, x: Pose, cofactor: float) -> float:
    """The variance of the log focal length for unit noise, without what was expected of it.

    At the focal length that the drawing alone would have: what was expected draws it nearer, where
    the same error of its inverse is a smaller part of it.
    """
    # d log f = -f d kappa
    variance = float(np.exp(2 * x.log_focal)) * cofactor
    if full.prior is None:
        return variance
    expected = variance * (DRAWING_SIGMA / full.prior.sigma) ** 2
    left = 1 - expected
    inverse = left - expected * (x.log_focal - full.prior.log_focal)
    return variance * left / inverse**2 if min(left, inverse) > 1e-9 else float("inf")


def _spread_on_constraints(full: FullProblem, x: Pose, A: Array, N: Array) -> tuple[Array, float]:
    """Variances of the relative log lengths and of kappa for unit noise, moving along N."""
    values, vectors = np.linalg.eigh(N.T @ A @ N)
    kept = values > 1e-13 * float(values.max())
    share = N[3] @ vectors
    told = float(np.sum(share[~kept] ** 2)) < 1e-6
    cofactor = float(np.sum(share[kept] ** 2 / values[kept])) if told else float("inf")
    by_length = _by_log_length(full, x) @ N @ vectors
    by_length -= by_length.mean(axis=0)
    if float(np.abs(by_length[:, ~kept]).max(initial=0.0)) > 1e-6 * float(np.abs(by_length).max()):
        return np.full(len(by_length), np.inf), cofactor
    return np.asarray((by_length[:, kept] ** 2 / values[kept]).sum(axis=1)), cofactor


def _relative_spread(full: FullProblem, x: Pose, inverse: Array) -> Array:
    """The same by the inverse of A, each edge speaking of two to six coordinates only."""
    m = len(full.problem.ends)
    own, shared, mean = np.empty(m), np.empty(m), np.zeros(len(inverse))
    groups = list(_slopes(full, x))
    for _, columns, slopes in groups:
        mean += np.bincount(columns.ravel(), slopes.ravel(), len(inverse)) / m
    towards = inverse @ mean
    for edges, columns, slopes in groups:
        places = (len(inverse) * columns)[:, :, None] + columns[:, None]
        own[edges] = np.einsum("ei,eij,ej->e", slopes, inverse.ravel().take(places), slopes)
        shared[edges] = np.einsum("ei,ei->e", slopes, towards[columns])
    return np.asarray(np.maximum(own - 2 * shared + float(mean @ towards), 0.0))


def _slopes(full: FullProblem, x: Pose) -> Iterator[tuple[IntArray, IntArray, Array]]:
    """Edges, and the derivatives of their log lengths by coordinates of both ends: columns, slopes.

    An edge along an axis speaks of one coordinate of each end, the others of all three.
    """
    structure, ends = full.problem.structure, full.problem.ends
    along = structure.edge_axis >= 0
    edges, others = np.flatnonzero(along), np.flatnonzero(~along)
    for chosen, axes in ((edges, structure.edge_axis[edges][:, None]), (others, np.arange(3))):
        if not len(chosen):
            continue
        to, of = (full.coordinate[ends[chosen, k][:, None], axes] for k in (1, 0))
        u = x.g[to] - x.g[of]
        u = u / np.maximum(np.einsum("ei,ei->e", u, u), 1e-300)[:, None]
        yield chosen, N_CAMERA + np.hstack([to, of]), np.hstack([u, -u])


def _by_log_length(full: FullProblem, x: Pose) -> Array:
    """Derivatives of the logarithms of the edges' lengths by (omega, kappa, g), (m, 4 + g)."""
    M = N_CAMERA + full.m
    D = np.zeros(len(full.problem.ends) * M)
    for edges, columns, slopes in _slopes(full, x):
        places = edges[:, None] * M + columns
        D += np.bincount(places.ravel(), slopes.ravel(), len(D))
    return np.asarray(D.reshape(-1, M))


def tangent(H: Array) -> Array:
    """Orthonormal columns that span the null space of H."""
    if not len(H):
        return np.eye(H.shape[1])
    if len(H) > H.shape[1]:
        # The triangular factor has the same null space, and no long columns of U.
        H = np.asarray(np.linalg.qr(H, mode="r"))
    _, s, Vt = np.linalg.svd(H)
    rank = int(np.count_nonzero(s > NULL_TOLERANCE * max(float(s[0]), 1e-300)))
    return np.asarray(Vt[rank:].T)
