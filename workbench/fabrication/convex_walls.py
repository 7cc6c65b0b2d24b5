"""Walls of convex prints: what lies between two sets of half-spaces.

Terms
-----
half-space
    What lies behind a face's plane. A convex body is what all of its faces' half-spaces share, and
    so is its copy with the planes moved, however many of them meet in a vertex.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from manifold3d import Manifold

from ...solver.values import Array
from .polyhedra import Polyhedron

#: How far a corner may lie before a plane that it is behind, in parts of the body's size.
_FLAT = 1e-6
#: Half the size of the cube that is cut, in parts of the body's size.
_FAR = 100.0


def is_convex(body: Polyhedron, outwards: Mapping[str, Array]) -> bool:
    """Whether all of a body lies behind each of its faces."""
    points = np.array([body.vertices_mm[v] for loops in body.skin.values() for v in loops[0]])
    limit = _FLAT * float(np.ptp(points, axis=0).max())
    return all(
        float(((points - body.vertices_mm[loops[0][0]]) @ outwards[id_]).max()) < limit
        for id_, loops in body.skin.items()
    )


def convex_wall(
    body: Polyhedron,
    outwards: Mapping[str, Array],
    mouths: Sequence[str],
    low_mm: float,
    high_mm: float,
) -> Manifold:
    """The wall of a convex body between two copies of its faces.

    Parameters
    ----------
    body : Polyhedron
    outwards : mapping of face id to (3,) array
        Unit normals that look away from the object.
    mouths : sequence of face ids
        The wall ends in their planes.
    low_mm, high_mm : float
        How far the copies lie from the faces; outwards where positive.

    Returns
    -------
    manifold3d.Manifold
    """
    made = [id_ for id_ in body.skin if id_ not in mouths]
    outer = _behind(body, outwards, dict.fromkeys(made, high_mm) | dict.fromkeys(mouths, 0.0))
    # The hollow goes on through mouths, so that no film stays over them.
    return outer - _behind(body, outwards, dict.fromkeys(made, low_mm))


def _behind(
    body: Polyhedron, outwards: Mapping[str, Array], moves_mm: Mapping[str, float]
) -> Manifold:
    """What lies behind all moved planes."""
    points = np.array([body.vertices_mm[v] for loops in body.skin.values() for v in loops[0]])
    size = 2 * _FAR * float(np.ptp(points, axis=0).max())
    kept = Manifold.cube([size] * 3, center=True).translate(points.mean(axis=0).tolist())
    for id_, move in moves_mm.items():
        limit = float(outwards[id_] @ body.vertices_mm[body.skin[id_][0][0]]) + move
        kept = kept.trim_by_plane((-outwards[id_]).tolist(), -limit)
    return kept
