"""A solve begun from the result of another one, whose axes and unknowns may be different."""

from __future__ import annotations

import numpy as np

from ..full import Pose
from ..problem import Problem
from ..values import Array


def pose_near(problem: Problem, in_cam: Array, radii: Array, log_focal: float) -> Pose:
    """The point of a problem that is nearest to given positions.

    Parameters
    ----------
    problem : Problem
    in_cam : (n + k, 3) array
        Vertices and circles' centres in the camera frame, of free size.
    radii : (k,) array
    log_focal : float
    """
    structure = problem.structure
    R = _axes_in_cam(problem, in_cam)
    coordinate = structure.coordinate.reshape(-1)
    g = np.zeros(structure.n_coordinates)
    counts = np.bincount(coordinate, minlength=len(g))
    sums = np.bincount(coordinate, (in_cam @ R).reshape(-1), minlength=len(g))
    g[counts > 0] = sums[counts > 0] / counts[counts > 0]
    g[structure.radius] = radii
    return Pose(R, log_focal, g)


def _axes_in_cam(problem: Problem, in_cam: Array) -> Array:
    """The rotation whose columns run along the edges of each axis."""
    D = np.zeros((3, 3))
    delta = in_cam[problem.ends[:, 1]] - in_cam[problem.ends[:, 0]]
    for k in range(3):
        along = delta[problem.structure.edge_axis == k]
        if len(along):
            # The direction in which most of them run, whichever way round each was drawn.
            D[:, k] = np.linalg.svd(along, full_matrices=False)[2][0]
    bare = np.flatnonzero(~D.any(axis=0))
    if len(bare) == 1:
        i, j = (k for k in range(3) if k != bare[0])
        D[:, bare[0]] = np.cross(D[:, i], D[:, j])
    U, _, Vt = np.linalg.svd(D if len(bare) < 2 else np.eye(3))
    R: Array = U @ Vt
    if np.linalg.det(R) < 0:
        # An axis' sign is free.
        R = R @ np.diag([1.0, 1.0, -1.0])
    return R
