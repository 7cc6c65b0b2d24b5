"""How many numbers each vertex still needs, as in [Lau10] Figure 5, for our own reduction.

Terms
-----
before
    Three numbers for each vertex and four for each circle (x, y, z, r).
after
    The distinct shared coordinates: each is counted at the first vertex or circle, in the sketch's
    order, that has it, so that a vertex whose place follows from others counts 0.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from .graph import SketchGraph
from .revolution import without_profiles
from .structure import build_structure
from .values import frozen_mapping


@dataclass(frozen=True, slots=True)
class ParameterCounts:
    """The numbers at the vertices in [Lau10] Figure 5, and their sums.

    Parameters
    ----------
    of_vertex : mapping of vertex id to 0 ... 3
    of_circle : mapping of circle id to 1 ... 4
    before, after : int
        Sums without and with the annotations.
    """

    of_vertex: Mapping[str, int]
    of_circle: Mapping[str, int]
    before: int
    after: int


def parameter_counts(graph: SketchGraph) -> ParameterCounts:
    """Count the numbers that the annotations leave to be found.

    Vertices of profiles follow from the circles and the drawing, and count 0. Neither the camera
    (three numbers for its rotation and one for its focal length) nor the overall size is counted.

    Parameters
    ----------
    graph : SketchGraph
    """
    core = without_profiles(graph)
    coordinate = build_structure(core).coordinate
    _, first = np.unique(coordinate.reshape(-1), return_index=True)
    own = np.bincount(first // 3, minlength=len(coordinate)).tolist()
    of_vertex = dict.fromkeys(graph.vertices, 0)
    of_vertex |= dict(zip(core.vertices, own, strict=False))
    circles = own[len(core.vertices) :]
    # The radius is a circle's own.
    of_circle = {c: count + 1 for c, count in zip(core.circles, circles, strict=True)}
    return ParameterCounts(
        frozen_mapping(of_vertex),
        frozen_mapping(of_circle),
        before=3 * len(of_vertex) + 4 * len(of_circle),
        after=sum(of_vertex.values()) + sum(of_circle.values()),
    )
