"""Angles said to the solver beside the sketch, whose file says right angles only.

A said angle becomes one more annotation of the graph while it is solved, by the id
``angle e1 e2``: so freedoms, residuals, redundancy and blame count it like all others. It is a
wish, as sizes are: one of 90 degrees too, where a sketch's right angle is what the drawing shows.

Terms
-----
corner
    Two edges that meet in a vertex.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from .annotations import Angle, Annotation
from .errors import SketchError
from .graph import SketchGraph
from .ids import need
from .revolution import without_profiles

Corner = tuple[str, str]
RIGHT_DEG = 90.0
#: Flatter corners are straight on or folded up, as far as anybody can draw or make them.
FLATTEST_DEG = 0.1
#: Angles that differ by less are the same, typed in other units.
SAME_ANGLE_DEG = 1e-9


def with_angles(graph: SketchGraph, angles_deg: Mapping[Corner, float] | None) -> SketchGraph:
    """The graph with angles said of corners, as the solver takes it; it cannot be saved so.

    Parameters
    ----------
    graph : SketchGraph
    angles_deg : mapping of (edge id, edge id) to float, or None
        Degrees, above 0 and below 180.

    Raises
    ------
    SketchError
        Where edges are not there or do not meet, or an angle cannot be.
    """
    if not angles_deg:
        return graph
    annotations: dict[str, Annotation] = dict(graph.annotations)
    for corner, angle_deg in angles_deg.items():
        at = need_angle(graph, corner, angle_deg)
        # No id of a sketch has spaces.
        annotations[angle_id(corner)] = Angle(at, corner, angle_deg)
    return replace(graph, annotations=annotations)


def angle_id(corner: Corner) -> str:
    """The name by which a said angle is told: ``angle e1 e2``."""
    return f"angle {corner[0]} {corner[1]}"


def need_angle(graph: SketchGraph, corner: Corner, angle_deg: float) -> str:
    """The vertex of a corner of which an angle can be said.

    Raises
    ------
    SketchError
        Where the edges are not there, do not meet or follow circles, or the angle cannot be.
    """
    need(corner, graph.edges)
    if graph.revolutions and not set(corner) <= without_profiles(graph).edges.keys():
        raise SketchError(
            "the side of a surface of revolution takes no angles",
            corner,
            "lengths of its edges, or diameters",
        )
    shared = set(graph.edges[corner[0]]) & set(graph.edges[corner[1]])
    if len(shared) != 1:
        raise SketchError("edges that do not meet make no angle", corner, "two that meet")
    if not FLATTEST_DEG <= angle_deg <= 180.0 - FLATTEST_DEG or not math.isfinite(angle_deg):
        raise SketchError(
            f"an angle of {angle_deg:g} degrees between {corner[0]} and {corner[1]}",
            corner,
            f"between {FLATTEST_DEG:g} and {180.0 - FLATTEST_DEG:g} degrees: edges at 0 or 180 "
            "degrees lie on one line",
        )
    return shared.pop()
