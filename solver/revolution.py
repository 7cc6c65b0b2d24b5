"""Surfaces of revolution: the profile's vertices in space ([Lau10] 3.1, Figure 3).

Terms
-----
axis
    The vertical line through the centres of the ground, the bottom and the top circle.
profile
    The drawn side, from the bottom to the top circle; each of its vertices stands for a circle.
side plane
    The vertical plane through the axis that faces the camera; the profile lies in it, as the ends
    of the drawn ellipses' major axes do when seen from afar.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .editing.substitution import Substitution, substituted
from .graph import SketchGraph
from .values import Array


def profile_vertices(graph: SketchGraph) -> tuple[str, ...]:
    """Vertices that belong to profiles only: no other edge ends there, no annotation names them."""
    named = {v for r in graph.revolutions.values() for v in r.profile}
    sides = {
        frozenset(pair)
        for r in graph.revolutions.values()
        for pair in zip(r.profile, r.profile[1:], strict=False)
    }
    others = {v for ends in graph.edges.values() if frozenset(ends) not in sides for v in ends}
    return tuple(v for v in graph.vertices if v in named - others)


def without_profiles(graph: SketchGraph) -> SketchGraph:
    """The graph that is solved first: profiles follow from the circles afterwards.

    What annotations and faces say of the profiles' own vertices and edges is left out with them.
    """
    if not graph.revolutions:
        return graph
    profile = profile_vertices(graph)
    if not profile:
        return graph
    straight = replace(graph, revolutions={})
    core = substituted(straight, Substitution(vertices=dict.fromkeys(profile)))
    return replace(core, revolutions=graph.revolutions)


def in_side_plane(rays: Array, axis_point: Array, up: Array) -> Array:
    """Where rays from the origin meet the side plane.

    Parameters
    ----------
    rays : (n, 3) array
    axis_point : (3,) array
        Any point of the axis, the eye being the origin.
    up : (3,) array
        Direction of the axis.

    Returns
    -------
    (n, 3) array
        Not finite where a ray runs along the plane.
    """
    towards = axis_point - (axis_point @ up) * up
    normal = towards / max(float(np.linalg.norm(towards)), 1e-300)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(rays * (axis_point @ normal / (rays @ normal))[:, None])
