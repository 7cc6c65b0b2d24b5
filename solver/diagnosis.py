"""What is left open, and what disagrees.

Terms
-----
freedom
    A direction in the unknowns that neither the drawing nor a constraint feels; the overall size is
    not counted.
conflict
    Annotations that cannot all hold.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from .annotations import targets_of
from .full import FullProblem, Pose
from .graph import SketchGraph
from .solution import Residual, Residuals
from .structure import build_structure
from .values import Array

#: Up to so many unknowns the null space is taken from the Jacobian itself.
MAX_SVD = 300
#: Singular values below this part of the largest are freedoms.
NULL_TOLERANCE = 1e-8
#: Looking for a smaller clash ends after this time; what is found by then is a clash all the same.
MAX_SEARCH_S = 2.0
#: Residuals above this are not zero: degrees, or parts of the object's size.
HELD_TOLERANCE = 1e-7


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
    X = full.positions(x)
    motion = null[:, 4:][:, full.coordinate]  # (freedoms, n, 3)
    growth = np.einsum("fnk,nk->nf", motion, X) / np.maximum((X**2).sum(axis=1), 1e-300)[:, None]
    steps = np.round(growth / max(float(np.abs(growth).max(initial=0.0)), 1e-300), 5)
    _, part, sizes = np.unique(steps, axis=0, return_inverse=True, return_counts=True)
    part = part.reshape(-1)
    return tuple(n for n, p in zip(names, part, strict=True) if p != int(np.argmax(sizes)))


def focal_sigma(full: FullProblem, x: Pose) -> float:
    """Standard error of the log focal length, from the drawing's own misfit."""
    at = full.evaluate(x)
    r, _ = full.jacobian(x)
    # In the directions that keep the constraints: weighing these against the drawing instead would
    # drown what little a view from afar says of its focal length.
    N = _tangent(at.H)
    A = N.T @ at.A @ N
    spare = max(1, len(r) - N.shape[1] + 1)
    noise = max(float(r @ r) / spare, 1e-14)
    values, vectors = np.linalg.eigh(A)
    share = vectors.T @ N[3]
    floor = 1e-13 * float(values.max())
    if float(np.sum(share[values <= floor] ** 2)) > 1e-6:
        return float("inf")
    variance = noise * float(np.sum(share**2 / np.maximum(values, floor)))
    # d log f = -f d kappa
    return float(np.exp(x.log_focal) * np.sqrt(variance))


def _tangent(H: Array) -> Array:
    """Orthonormal columns that span the null space of H."""
    if not len(H):
        return np.eye(H.shape[1])
    _, s, Vt = np.linalg.svd(H)
    rank = int(np.count_nonzero(s > NULL_TOLERANCE * max(float(s[0]), 1e-300)))
    return np.asarray(Vt[rank:].T)


def clashing_annotations(graph: SketchGraph) -> tuple[str, ...]:
    """A small set of annotations that cannot all hold, whatever the drawing, culprits first.

    A culprit is one without which all the others agree. What clashes with it is found by leaving
    out the rest one by one, those farthest from it first, so that the reason stays near at hand.
    """

    deadline = time.perf_counter() + MAX_SEARCH_S

    def clash(kept: Iterable[str]) -> bool:
        annotations = {id_: graph.annotations[id_] for id_ in kept}
        return build_structure(graph, annotations).contradiction

    said = list(graph.annotations)
    culprits = []
    for id_ in said:
        if time.perf_counter() < deadline and not clash(k for k in said if k != id_):
            culprits.append(id_)
    for culprit in culprits[-1:]:
        for other in said:
            if time.perf_counter() > deadline:
                break
            if other != culprit and clash((culprit, other)):
                return (culprit, other)
    near = _elements_near(graph, culprits[-1:])
    order = sorted(said, key=lambda id_: (len(_elements(graph, id_) & near), said.index(id_)))
    kept = list(said)
    for id_ in order:
        rest = [k for k in kept if k != id_]
        if time.perf_counter() > deadline:
            break
        if clash(rest):
            kept = rest
    return tuple(sorted(kept, key=lambda id_: (id_ not in culprits, said.index(id_))))


def _elements(graph: SketchGraph, id_: str) -> set[str]:
    """The vertices that an annotation speaks of."""
    named = targets_of(graph.annotations[id_])
    ends = {v for e in named.get("edge", ()) for v in graph.edges[e]}
    return ends | set(named.get("vertex", ()))


def _elements_near(graph: SketchGraph, ids: Iterable[str]) -> set[str]:
    return {v for id_ in ids for v in _elements(graph, id_)}


def unmet_annotations(residuals: Mapping[str, Residual], size_mm: float) -> tuple[str, ...]:
    """Annotations that do not hold, the worst first."""

    def badness(residual: Residual) -> float:
        return residual.value / (size_mm if residual.unit == "mm" else 57.3)

    if isinstance(residuals, Residuals):
        # Most hold to the last digits: look at the others only.
        residuals = residuals.above(HELD_TOLERANCE * min(size_mm, 57.3))
    bad = {id_: badness(r) for id_, r in residuals.items() if badness(r) > HELD_TOLERANCE}
    return tuple(sorted(bad, key=lambda id_: (-bad[id_], id_)))


def size_of(X: Array) -> float:
    """The object's size: the diagonal of its bounding box, mm."""
    return float(np.linalg.norm(np.ptp(X, axis=0))) if len(X) else 0.0
