"""The other reading of a drawing: near and far exchanged (Necker reversal).

Seen from afar, a shape and its mirror image in depth look the same. The ground and a strong
perspective tell them apart; where neither does, both are offered.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .full import FullProblem, Pose
from .graph import SketchGraph
from .least_squares import minimise
from .lifting import MAX_ITERATIONS, Lifted, spare_numbers
from .starting.near_and_far import near_and_far_exchanged
from .values import Stop
from .world import camera_above_ground, ground_indices

#: Twice the log of the odds from which on one reading is the drawing's: about 60 to 1.
DECIDES = 8.0


def twin_of(graph: SketchGraph, lifted: Lifted, stop: Stop | None = None) -> Lifted | None:
    """The reading with near and far exchanged; None where the drawing leads back to the first."""
    full, x = lifted.full, lifted.minimum.x
    if lifted.problem.camera is not None:
        return None
    begun = near_and_far_exchanged(full, x)
    minimum = minimise(full, begun, max_iterations=40, stop=stop)
    minimum = minimise(full, minimum.x, max_iterations=MAX_ITERATIONS, near=True, stop=stop)
    if not np.isfinite(minimum.cost) or _same_view(minimum.x, x):
        return None
    above = camera_above_ground(graph, lifted.problem, minimum.x)
    return replace(lifted, minimum=minimum, above=above)


def fits_as_well(graph: SketchGraph, twin: Lifted, lifted: Lifted, stop: Stop) -> bool:
    """Whether nothing decides between two readings."""
    if ground_indices(graph) and not twin.above:
        return False
    first, second = (np.log(_misfit(reading, stop) + 1e-24) for reading in (lifted, twin))
    return spare_numbers(lifted.full) * float(second - first) < DECIDES


def _misfit(lifted: Lifted, stop: Stop) -> float:
    """Without what is expected of the focal length, which is no reason to trust a perspective."""
    if lifted.full.prior is None or lifted.problem.log_focal_prior is not None:
        return lifted.minimum.cost
    free = FullProblem(lifted.problem, None)
    x = lifted.minimum.x
    return minimise(free, x, max_iterations=MAX_ITERATIONS, near=True, stop=stop).cost


def _same_view(a: Pose, b: Pose) -> bool:
    """Equal up to the object axes' signs."""
    return bool((np.abs(np.einsum("ij,ij->j", a.R, b.R)) > 0.999).all())
