"""The study's part on surfaces of revolution."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...solver import solve
from ...solver.solution import Solution
from ...solver.synthetic import Turned, photograph_turned, random_lid
from ...solver.values import Array

RIGHT = 0.03
#: What is drawn how: name, noise, and whether the focal length is known.
TURNED_CASES = (
    ("lid, exact", 0.0, False),
    ("lid, 0.5 % noise", 0.005, False),
    ("lid, 0.5 % noise, EXIF", 0.005, True),
)


def turned_errors(noise: float, focal_known: bool, runs: int) -> Array:
    """The worst error of all radii and heights, in parts of the widest diameter, (runs,)."""
    errors = []
    for run in range(runs):
        rng = np.random.default_rng([run, 99])
        lid = random_lid(rng)
        graph, _ = photograph_turned(lid, rng, noise=noise, focal_known=focal_known)
        errors.append(_worst(lid, solve(graph)))
    return np.array(errors)


def _worst(lid: Turned, solution: Solution) -> float:
    if len(solution.circles) < len(lid.circles):
        return float("inf")
    found = [(c.radius_mm, c.center_mm[2]) for c in solution.circles.values()]
    off = np.abs(np.array(found) - np.array(lid.circles)).max()
    return float(off / (2 * lid.circles[0][0]))


def turned_lines(runs: int) -> Iterator[str]:
    """One line a case."""
    for name, noise, known in TURNED_CASES:
        errors = turned_errors(noise, known, runs)
        yield (
            f"{name}: {100 * np.mean(errors < RIGHT):.1f} % of {runs} with all radii and heights "
            f"within 3 % of the widest, median {100 * np.median(errors):.2g} %, worst "
            f"{100 * errors.max():.2g} %"
        )
