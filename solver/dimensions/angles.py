"""Angles between two edges that meet: measured at the corners of faces; right ones can be said.

Terms
-----
corner
    Two edges that meet in a vertex, in the order of the graph.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from ..annotations import RightAngle
from ..editing.annotating import annotate, without_annotations
from ..errors import SketchError
from ..graph import SketchGraph
from ..ids import need
from ..solution import Solution

Corner = tuple[str, str]
RIGHT_DEG = 90.0


def driving_angles_deg(graph: SketchGraph) -> Mapping[Corner, float]:
    """The angles that are said, which are all right."""
    said = (a for a in graph.annotations.values() if isinstance(a, RightAngle))
    order = {edge: k for k, edge in enumerate(graph.edges)}
    pairs = (sorted(a.between, key=order.__getitem__) for a in said)
    corners: list[Corner] = [(first, second) for first, second in pairs]
    return MappingProxyType(dict.fromkeys(corners, RIGHT_DEG))


def angles_deg(graph: SketchGraph, solution: Solution) -> Mapping[Corner, float]:
    """The angles at the corners of the drawn faces and where one is said, degrees, 0 to 180."""
    corners = list(dict.fromkeys((*_corners_of_faces(graph, solution), *driving_angles_deg(graph))))
    along = [_directions(graph, solution, corner) for corner in corners]
    d, e = np.array(along, dtype=float).reshape(-1, 2, 3).transpose(1, 0, 2)
    across = np.linalg.norm(np.cross(d, e), axis=1)
    measured = np.degrees(np.arctan2(across, np.einsum("ij,ij->i", d, e)))
    return MappingProxyType(dict(zip(corners, measured.tolist(), strict=True)))


def _corners_of_faces(graph: SketchGraph, solution: Solution) -> list[Corner]:
    order = {frozenset(ends): k for k, ends in enumerate(graph.edges.values())}
    names = list(graph.edges)
    found = []
    for face in solution.faces.values():
        for loop in face.loops if face.included else ():
            sides = [order.get(frozenset((loop[k - 1], v))) for k, v in enumerate(loop)]
            for k, side in enumerate(sides):
                before = sides[k - 1]
                # Sides of mirrored copies are not drawn: their corners are those of the original.
                if side is not None and before is not None:
                    found.append((names[min(before, side)], names[max(before, side)]))
    return found


def _directions(graph: SketchGraph, solution: Solution, corner: Corner) -> tuple[object, object]:
    """Where the two edges lead from the vertex in which they meet."""
    at, *_ = set(graph.edges[corner[0]]) & set(graph.edges[corner[1]])
    points = solution.vertices_mm
    ends = (next(v for v in graph.edges[edge] if v != at) for edge in corner)
    first, second = (points[end] - points[at] for end in ends)
    return first, second


def set_angle(graph: SketchGraph, corner: Corner, angle_deg: float | None) -> SketchGraph:
    """The graph with a right angle said of a corner; None takes it back.

    Raises
    ------
    SketchError
        Where the angle is another one, or the edges do not meet.
    """
    need(corner, graph.edges)
    if angle_deg is None:
        return without_annotations(
            graph,
            (
                id_
                for id_, a in graph.annotations.items()
                if isinstance(a, RightAngle) and set(a.between) == set(corner)
            ),
        )
    if abs(angle_deg - RIGHT_DEG) > 1e-9:
        raise SketchError(
            f"an angle of {angle_deg:g} degrees between {corner[0]} and {corner[1]}",
            corner,
            "only right angles can be said; others follow from lengths",
        )
    shared = set(graph.edges[corner[0]]) & set(graph.edges[corner[1]])
    if len(shared) != 1:
        raise SketchError("edges that do not meet make no angle", corner, "two that meet")
    return annotate(graph, RightAngle(shared.pop(), corner))[0]
