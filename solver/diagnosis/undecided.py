"""Whether a drawing and the other annotations speak of an annotation at all."""

from __future__ import annotations

import numpy as np

from ..full import FullProblem, Pose
from ..graph import SketchGraph
from .freedoms import freedoms
from .suspects import row_owners, softened, unshared

#: A move as large as the object's distance that changes what is said by less than this does not
#: bear on it (radians, parts of a length).
NO_CHANGE = 1e-6


def is_undecided(graph: SketchGraph, id_: str, full: FullProblem, x: Pose) -> bool:
    """Whether an annotation fixes what is open without it: then nothing shows it to be false.

    Parameters
    ----------
    graph : SketchGraph
        With the annotation.
    id_ : str
    full : FullProblem
        What was solved without it.
    x : Pose
        Its solution.
    """
    open_ = freedoms(full, x, [*graph.vertices, *graph.circles])
    if not open_.count:
        return False
    soft = softened(graph, full.problem)
    _, H = soft.constraints(unshared(soft, full, x))
    rows = [k for k, owners in enumerate(row_owners(graph, soft)) if id_ in owners]
    moves = np.zeros((len(open_.moves), soft.m))
    moves[:, soft.problem.structure.coordinate] = open_.moves @ x.R
    changes = H[rows][:, -soft.m :] @ moves.T
    return bool(np.abs(changes).max(initial=0.0) > NO_CHANGE)
