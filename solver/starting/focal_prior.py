"""What is expected of the focal length where nobody tells it.

What the drawing says of the focal length is trusted as far as its own misfit allows, taken for the
noise of each drawn number, and no further; an exact drawing is trusted wholly. Where errors go
together, as people's do, that misfit says too little of them: `leaning` looks for these.
"""

from __future__ import annotations

import math

from ..full import DRAWING_SIGMA, FocalPrior, FullProblem, Pose
from ..initial import USUAL_LOG_FOCAL

#: Half the way from a phone's main camera to its twofold zoom.
USUAL_SIGMA = 0.35
USUAL = FocalPrior(USUAL_LOG_FOCAL, USUAL_SIGMA)


def spare_observations(full: FullProblem, x: Pose) -> int:
    """How many drawn numbers there are beyond the freedoms of a shape."""
    rows = 2 * full.n_vertices + 5 * len(full.problem.circles)
    return rows - (4 + full.m - full.n_held(x) - len(full.idle_directions(x)) - 1)


def usual_prior(full: FullProblem, x: Pose, spare: int | None = None) -> FocalPrior | None:
    """The usual focal length, weighed by the misfit at a minimum; None for an exact drawing.

    Parameters
    ----------
    full : FullProblem
    x : Pose
        Its minimum.
    spare : int, optional
        Of `spare_observations`, where it is known.
    """
    spare = spare_observations(full, x) if spare is None else spare
    error = math.sqrt(full.misfit(x) / max(1, spare))
    if error < 1e-9:
        return None
    return FocalPrior(USUAL_LOG_FOCAL, USUAL_SIGMA * DRAWING_SIGMA / error)


def tighter(a: FocalPrior | None, b: FocalPrior | None) -> FocalPrior | None:
    """That which says more."""
    if a is None or b is None:
        return a or b
    return a if a.sigma < b.sigma else b
