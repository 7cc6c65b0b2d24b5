"""Unions and hulls of bodies that share faces, by manifold3d and Qhull."""

from __future__ import annotations

from collections.abc import Iterable

import manifold3d
import numpy as np
from manifold3d import Manifold, OpType

from ...solver.values import Array

#: By how much of itself a body may stick out of a union: rounding.
_SAME = 1e-7


def united(bodies: Iterable[Manifold]) -> Manifold:
    """All that is in any body.

    Where many faces lie in one plane but for rounding, 1 of 100 unions loses a piece of some
    100 mm3 without a word: what is missing is added once more.
    """
    every = list(bodies)
    union = Manifold.batch_boolean(every, OpType.Add)
    for body in every:
        if (body - union).volume() > _SAME * body.volume():
            union += body
    return union


def hull(points: Array) -> Manifold:
    """The convex hull of points (n, 3), empty where they lie in one plane.

    Qhull's: manifold3d's own may pass through itself where many points nearly lie in a plane.
    """
    from scipy.spatial import ConvexHull, QhullError

    try:
        found = ConvexHull(points)
    except QhullError:
        return Manifold()
    a, b, c = points[found.simplices].swapaxes(0, 1)
    inwards = np.einsum("ij,ij->i", np.cross(b - a, c - a), found.equations[:, :3]) < 0
    triangles = np.where(inwards[:, None], found.simplices[:, ::-1], found.simplices)
    return Manifold(manifold3d.Mesh64(np.asarray(points), triangles.astype(np.uint64)))
