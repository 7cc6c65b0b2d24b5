"""A solve begun from the result of another one, whose axes and unknowns may be different."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..full import FullProblem, Pose
from ..problem import Problem
from ..values import Array


@dataclass(frozen=True, slots=True, eq=False)
class KnownShape:
    """A shape that was found, without the unknowns it was found in.

    Parameters
    ----------
    in_cam : (n + k, 3) array
        Vertices and circles' centres in the camera frame, of free size.
    radii : (k,) array
    log_focal : float
    up_in_cam : (3,) array or None
        Along the vertical, up or down, where there is one: circles are square to it.
    """

    in_cam: Array
    radii: Array
    log_focal: float
    up_in_cam: Array | None

    @classmethod
    def at(cls, full: FullProblem, x: Pose) -> KnownShape:
        """The shape of a pose."""
        structure = full.problem.structure
        up = None if structure.vertical is None else x.R[:, structure.vertical]
        return cls(full.positions(x) @ x.R.T, x.g[structure.radius], x.log_focal, up)


def pose_near(problem: Problem, known: KnownShape) -> Pose:
    """The point of a problem that is nearest to a known shape."""
    structure = problem.structure
    R = _axes_in_cam(problem, known)
    coordinate = structure.coordinate.reshape(-1)
    g = np.zeros(structure.n_coordinates)
    counts = np.bincount(coordinate, minlength=len(g))
    sums = np.bincount(coordinate, (known.in_cam @ R).reshape(-1), minlength=len(g))
    g[counts > 0] = sums[counts > 0] / counts[counts > 0]
    g[structure.radius] = known.radii
    return Pose(R, known.log_focal, g)


def pose_in(problem: Problem, full: FullProblem, x: Pose) -> Pose:
    """A pose of one problem in the unknowns of another one of the same drawing."""
    if np.array_equal(problem.structure.coordinate, full.problem.structure.coordinate):
        return x
    return pose_near(problem, KnownShape.at(full, x))


def _axes_in_cam(problem: Problem, known: KnownShape) -> Array:
    """The rotation whose columns run along the edges of each axis."""
    D = np.zeros((3, 3))
    delta = known.in_cam[problem.ends[:, 1]] - known.in_cam[problem.ends[:, 0]]
    for k in range(3):
        along = delta[problem.structure.edge_axis == k]
        if len(along):
            # The direction in which most of them run, whichever way round each was drawn.
            D[:, k] = np.linalg.svd(along, full_matrices=False)[2][0]
    vertical = problem.structure.vertical
    if vertical is not None and known.up_in_cam is not None and not D[:, vertical].any():
        D[:, vertical] = known.up_in_cam
    bare = np.flatnonzero(~D.any(axis=0))
    if len(bare) == 2:
        # About the only axis that is known any turn will do.
        (k,) = {0, 1, 2} - set(bare.tolist())
        level = np.eye(3)[int(np.argmin(np.abs(D[:, k])))]
        D[:, bare[0]] = np.cross(D[:, k], level)
        D[:, bare[0]] /= np.linalg.norm(D[:, bare[0]])
        bare = bare[1:]
    if len(bare) == 1:
        i, j = (k for k in range(3) if k != bare[0])
        D[:, bare[0]] = np.cross(D[:, i], D[:, j])
    U, _, Vt = np.linalg.svd(D if len(bare) < 3 else np.eye(3))
    R: Array = U @ Vt
    if np.linalg.det(R) < 0:
        # An axis' sign is free.
        R = R @ np.diag([1.0, 1.0, -1.0])
    return R
