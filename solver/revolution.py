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
    """The graph that is solved first: profiles follow from the circles afterwards."""
    if not graph.revolutions:
        return graph
    profile = set(profile_vertices(graph))
    if not profile:
        return graph
    edges = {e: ends for e, ends in graph.edges.items() if not profile & set(ends)}
    return replace(
        graph,
        vertices={v: p for v, p in graph.vertices.items() if v not in profile},
        edges=edges,
        annotations={
            id_: a
            for id_, a in graph.annotations.items()
            if getattr(a, "edge", None) not in graph.edges or getattr(a, "edge", None) in edges
        },
        construction=tuple(c for c in graph.construction if c in edges or c in graph.circles),
    )


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
