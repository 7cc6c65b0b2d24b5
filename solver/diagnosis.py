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

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from .annotations import Annotation
from .full import FullProblem, Pose
from .graph import SketchGraph
from .solution import Residual
from .structure import build_structure
from .values import Array

#: Singular values below this part of the largest are freedoms.
NULL_TOLERANCE = 1e-8
#: Residuals above this are not zero: degrees, or parts of the object's size.
HELD_TOLERANCE = 1e-7


@dataclass(frozen=True, slots=True)
class Freedoms:
    """How many freedoms are left, and the vertices that they move."""

    count: int
    loose: tuple[str, ...]
    focal_sigma: float


def freedoms(full: FullProblem, x: Pose, names: list[str], frozen: int = 0) -> Freedoms:
    """Null space of the reduced Jacobian at a solution.

    Parameters
    ----------
    full : FullProblem
    x : Pose
    names : list of vertex ids
    frozen : int
        Freedoms of the frame that are no freedoms of the shape (3 without object axes).
    """
    at = full.evaluate(x)
    # Constraints weigh as much as the drawing: only whether they act matters here.
    stacked = np.vstack([at.J, at.H, at.G])
    scale = np.maximum(np.linalg.norm(stacked, axis=0), 1e-12)
    stacked = np.vstack(
        [stacked / scale, np.zeros((max(0, -np.subtract(*stacked.shape)), len(scale)))]
    )
    _, s, Vt = np.linalg.svd(stacked, full_matrices=False)
    null = Vt[s <= NULL_TOLERANCE * max(float(s[0]), 1e-300)] / scale
    count = max(0, len(null) - frozen)
    loose: tuple[str, ...] = ()
    if count and len(null):
        moved = null[:, 4:][:, full.coordinate]  # (freedoms, n, 3)
        # Motion along the ray of a vertex is what a freedom of depth looks like.
        size = np.sqrt((moved**2).sum(axis=(0, 2)))
        loose = tuple(
            name for name, m in zip(names, size, strict=True) if m > 1e-3 * float(size.max())
        )
    return Freedoms(count, loose, _focal_sigma(full, x))


def _focal_sigma(full: FullProblem, x: Pose) -> float:
    """Standard error of the log focal length, from the drawing's own misfit."""
    at = full.evaluate(x)
    A = at.J.T @ at.J + at.G + 1e8 * at.H.T @ at.H
    unit = np.zeros(len(A))
    unit[3] = 1.0
    spare = max(1, len(at.r) - (len(A) - np.linalg.matrix_rank(at.H)) + 1)
    noise = max(float(at.r @ at.r) / spare, 1e-14)
    values, vectors = np.linalg.eigh(A)
    share = vectors.T @ unit
    floor = 1e-13 * float(values.max())
    return float(np.sqrt(noise * np.sum(share**2 / np.maximum(values, floor))))


def clashing_annotations(graph: SketchGraph) -> tuple[str, ...]:
    """A smallest set of annotations that cannot all hold, whatever the drawing.

    Each annotation is left out in turn; those without which the rest still clash are dropped.
    """

    def clash(annotations: Iterable[Annotation]) -> bool:
        return build_structure(graph, annotations).contradiction

    return _minimal_subset(dict(graph.annotations), clash)


def _minimal_subset(
    said: dict[str, Annotation], clash: Callable[[Iterable[Annotation]], bool]
) -> tuple[str, ...]:
    kept = dict(said)
    for id_ in said:
        rest = {k: a for k, a in kept.items() if k != id_}
        if clash(rest.values()):
            kept = rest
    return tuple(kept)


def unmet_annotations(residuals: Mapping[str, Residual], size_mm: float) -> tuple[str, ...]:
    """Annotations that do not hold, the worst first."""

    def badness(residual: Residual) -> float:
        return residual.value / (size_mm if residual.unit == "mm" else 57.3)

    bad = {id_: badness(r) for id_, r in residuals.items() if badness(r) > HELD_TOLERANCE}
    return tuple(sorted(bad, key=lambda id_: (-bad[id_], id_)))


def size_of(X: Array) -> float:
    """The object's size: the diagonal of its bounding box, mm."""
    return float(np.linalg.norm(np.ptp(X, axis=0))) if len(X) else 0.0
