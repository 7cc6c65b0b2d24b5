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

from dataclasses import dataclass, replace

import numpy as np

from .editing.substitution import Substitution, substituted
from .geometry import cross
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


@dataclass(frozen=True, slots=True, eq=False)
class SidePlane:
    """The side plane of one axis, the eye being the origin.

    Parameters
    ----------
    origin : (3,) array
        A point of the axis; heights count from it.
    side, up : (3,) arrays
        Unit vectors in the plane, across and along the axis.
    """

    origin: Array
    side: Array
    up: Array

    @classmethod
    def facing(cls, origin: Array, up: Array) -> SidePlane:
        """The plane through an axis that faces the eye."""
        towards = origin - (origin @ up) * up
        normal = towards / max(float(np.linalg.norm(towards)), 1e-300)
        return cls(origin, cross(up, normal), up)

    def met_by(self, rays: Array) -> Array:
        """Where rays (n, 3) from the eye meet it; not finite where one runs along the plane."""
        normal = cross(self.side, self.up)
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(rays * (self.origin @ normal / (rays @ normal))[:, None])

    def local(self, point: Array) -> tuple[float, float]:
        """Distance to the side of the axis, signed, and height of a point."""
        off = point - self.origin
        return float(off @ self.side), float(off @ self.up)

    def at(self, base: Array, x: float, z: float) -> Array:
        """The point so far to the side of and above a point of an axis."""
        return np.asarray(base + x * self.side + z * self.up)
