"""Lipson's method as [Lau10] describes it: the yardstick of its Figure 8.

"Lipson's original method [LS96] takes a complete sketch as input, and performs one optimization
with three dimensions per vertex." ([Lau10] 4.2)

The reading: one Nelder-Mead search over all three coordinates of every vertex and the camera, from
the drawing at depth 0, minimising the same energies as `lau2010` with the projection term's first
weight. No depths beforehand, no restarts, no reduced dimensions; the finished shape is moved onto
the ground ([Lau10] 3.2). This is not a re-implementation of all regularities of [LS96].

[LS96] Lipson, Shpitalni: Optimization-based reconstruction of a 3D object from a single freehand
line drawing. Computer-Aided Design 28, 8 (1996).
"""

from __future__ import annotations

import numpy as np

from ..graph import SketchGraph
from ..solution import Solution
from ..values import Array, Progress, Stop
from .common import (
    Limits,
    Reference,
    Watch,
    camera_steps,
    nelder_mead,
    view_along_z,
    watched_by,
)
from .drawing import Drawing
from .lau2010 import PROJECTION_WEIGHTS, STEP
from .placing import run


def solve(
    graph: SketchGraph,
    *,
    limits: Limits | None = None,
    stop: Stop | None = None,
    progress: Progress | None = None,
) -> Solution:
    """Lift a sketch graph in one optimisation with three dimensions per vertex.

    Parameters
    ----------
    graph : SketchGraph
    limits : Limits, optional
        Where the search ends.
    stop : callable, optional
        Asked every few evaluations; True ends the solve at once, with what there is.
    progress : callable, optional
        Told how far the solve is (0 to 1) and what is being done.

    Returns
    -------
    Solution
        ``converged`` where every annotation holds within 1 degree and 1 % of the size.
    """
    limits = limits or Limits()
    watch = watched_by(stop, progress).part(0.0, 1.0, "one optimization")
    return run("lipson1996", graph, lambda drawing: optimization(drawing, limits, watch))


def optimization(drawing: Drawing, limits: Limits, watch: Watch) -> Reference:
    """The one optimisation: 3 n unknowns and the camera's seven."""
    n = len(drawing.p)
    view = view_along_z(drawing.focal)
    weight = PROJECTION_WEIGHTS[0]

    def energy(x: Array) -> float:
        X = x[:-7].reshape(-1, 3)
        projection = view.moved(x[-7:]).projection_energy(X, drawing.p)
        return drawing.constraints.energy(X) + weight * projection

    flat = np.column_stack([drawing.p, np.zeros(n)]).reshape(-1)
    x0 = np.concatenate([flat, np.zeros(7)])
    step = np.concatenate([np.full(3 * n, STEP), camera_steps(drawing)])
    found = nelder_mead(energy, x0, step, limits, watch)
    return Reference(found.x[:-7].reshape(-1, 3), view.moved(found.x[-7:]), found.evaluations)
