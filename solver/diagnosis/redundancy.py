"""Annotations that follow from the others: normal and harmless, and worth knowing.

In all free positions, an annotation follows from the others where the derivatives of what it asks
for are combinations of the derivatives of what they ask for.
"""

from __future__ import annotations

import numpy as np

from ..full import FullProblem, Pose
from ..graph import SketchGraph
from ..problem import build_problem
from ..revolution import without_profiles
from ..solution import Solution
from ..starting.warm_start import pose_from
from ..structure import build_structure
from ..values import Array
from .suspects import row_owners, softened

#: A part of the span of all rows smaller than this is rounding.
TOLERANCE = 1e-7


def redundant_annotations(graph: SketchGraph, solution: Solution) -> tuple[str, ...]:
    """The annotations without which, each by itself, the others still say the same.

    Parameters
    ----------
    graph : SketchGraph
    solution : Solution
        Of this graph.

    Returns
    -------
    tuple of annotation ids
        In the sketch's order; empty where the solution has no shape.
    """
    core = without_profiles(graph)
    structure = build_structure(core)
    problem = build_problem(core, structure)
    pose = pose_from(solution, core, problem)
    if pose is None or structure.contradiction:
        return ()
    soft = softened(core, problem)
    free = Pose(pose.R, pose.log_focal, _positions(FullProblem(problem, None), pose))
    _, H = soft.constraints(free)
    rows: dict[str, list[int]] = {}
    for i, ids in enumerate(row_owners(core, soft)):
        for id_ in ids:
            rows.setdefault(id_, []).append(i)
    leverage = _leverage(H)
    return tuple(id_ for id_ in core.annotations if _follows(leverage, rows.get(id_, [])))


def _positions(full: FullProblem, pose: Pose) -> Array:
    radii = pose.g[full.problem.structure.radius]
    return np.concatenate([full.positions(pose).reshape(-1), radii])


def _leverage(H: Array) -> Array:
    """The projection onto the span of H's columns, whose unit eigenvectors are indispensable."""
    if not len(H):
        return np.zeros((0, 0))
    U, s, _ = np.linalg.svd(H, full_matrices=False)
    U = U[:, s > TOLERANCE * max(float(s[0]), 1e-300)]
    return np.asarray(U @ U.T)


def _follows(leverage: Array, rows: list[int]) -> bool:
    """Whether no combination of the rows is outside the span of the others."""
    if not rows:
        return False
    largest = float(np.linalg.eigvalsh(leverage[np.ix_(rows, rows)]).max())
    return largest < 1 - TOLERANCE
