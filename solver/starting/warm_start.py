"""A start from a solution that is known already: the last one, while a person edits."""

from __future__ import annotations

import numpy as np

from ..full import Pose
from ..geometry import cross
from ..graph import SketchGraph
from ..problem import Problem
from ..solution import Solution
from ..values import Array


def pose_from(solution: Solution, graph: SketchGraph, problem: Problem) -> Pose | None:
    """The pose of the full step that shows the solution's shape.

    Parameters
    ----------
    solution : Solution
        Of this sketch, or of one that differs little.
    graph : SketchGraph
        The part of the sketch that the problem speaks of.
    problem : Problem

    Returns
    -------
    Pose or None
        None where the solution does not know all of the sketch's vertices and circles.
    """
    camera, known = solution.camera, solution.vertices_mm
    if camera is None or not all(v in known for v in graph.vertices):
        return None
    if not all(c in solution.circles for c in graph.circles):
        return None
    points = [known[v] for v in graph.vertices]
    points += [solution.circles[c].center_mm for c in graph.circles]
    X = np.array(points, dtype=np.float64).reshape(-1, 3)
    rotation = camera.rotation_cam_from_world
    W = _world_from_object(problem, X, rotation)
    if W is None:
        return None
    structure = problem.structure
    c = (X - camera.position_mm) @ W
    R = rotation @ W
    total = np.bincount(structure.coordinate.ravel(), c.ravel(), structure.n_coordinates)
    count = np.bincount(structure.coordinate.ravel(), minlength=structure.n_coordinates)
    g = total / np.maximum(count, 1)
    g[structure.radius] = [solution.circles[c].radius_mm for c in graph.circles]
    depth = float(np.mean(g[structure.coordinate] @ R[2]))
    if not depth > 0:
        return None
    return Pose(R, float(np.log(camera.focal_px / problem.px_per_unit)), g / depth)


def _world_from_object(problem: Problem, X: Array, rotation_cam_from_world: Array) -> Array | None:
    """Columns: the object axes in the world, as the longest edge along each shows them."""
    structure = problem.structure
    if not structure.has_axes:
        return np.eye(3)
    along = X[problem.ends[:, 1]] - X[problem.ends[:, 0]]
    length = np.linalg.norm(along, axis=1)
    axes: dict[int, Array] = {}
    for k in range(3):
        own = np.where(structure.edge_axis == k, length, -1.0)
        longest = int(np.argmax(own))
        if own[longest] > 0:
            axes[k] = along[longest] / length[longest]
    if len(axes) < 2:
        return None
    # Any two tell the third; signs are free, handedness is not.
    first, second = sorted(axes)[:2]
    third = 3 - first - second
    a = axes[first]
    b = axes[second] - (axes[second] @ a) * a
    size = float(np.linalg.norm(b))
    if size < 0.1:
        return None
    W = np.empty((3, 3))
    W[:, first], W[:, second] = a, b / size
    W[:, third] = cross(a, b / size) * (1.0 if (third - second) % 3 == 1 else -1.0)
    return W
