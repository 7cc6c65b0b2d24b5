"""Cameras that the drawn lines allow nearly as well: turned as far as they are unsure of the view.

Lines seen from their own level, or few of them, leave the camera loose in one direction. Along it
the shape may have several valleys, and the best camera for the lines may begin in a wrong one.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from scipy.spatial.transform import Rotation

from ..problem import Problem
from ..values import Array
from .drawn_lines import Agreement, drawn_lines, gathered

#: Standard errors along the loosest direction: what lies between leads to the same valleys.
STEPS = (1.0, -1.0, 2.0, -2.0)
#: Nothing is known of a view beyond so much (rad).
MAX_TURN = 0.8


def turned_views(problem: Problem, R: Array, log_focal: float) -> Iterator[tuple[Array, float]]:
    """Rotations and log focal lengths about a camera that meets the drawn lines best."""
    drawn = drawn_lines(problem)
    free = 4 if problem.log_focal_prior is None else 3
    spare = len(drawn) - free
    if spare < 1:
        return
    form = Agreement(gathered(drawn, drawn.lengths(), log_focal)).forms(
        R[None], np.array([log_focal])
    )[0]
    squares, directions = np.linalg.eigh(form[:free, :free])
    sigma = np.sqrt(form[4, 4] / spare / max(float(squares[0]), 1e-300))
    loosest = np.append(directions[:, 0], 0.0)[:4] * min(sigma, MAX_TURN / max(STEPS))
    for k in STEPS:
        turn = Rotation.from_rotvec(k * loosest[:3]).as_matrix()
        yield np.asarray(R @ turn), log_focal + k * float(loosest[3])
