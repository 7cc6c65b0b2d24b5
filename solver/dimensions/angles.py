"""Angles between two edges that meet: measured at the corners of faces, and said.

Right ones are annotations of the sketch; others are said beside it (`said_angles`).

Terms
-----
corner
    Two edges that meet in a vertex, in the order of the graph.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType

import numpy as np

from ..annotations import RightAngle
from ..diagnosis.clashes import disagree, find_clash
from ..editing.annotating import annotate, without_annotations
from ..errors import SketchError
from ..graph import SketchGraph
from ..ids import need
from ..revolution import without_profiles
from ..said_angles import RIGHT_DEG, SAME_ANGLE_DEG, Corner, angle_id, need_angle, with_angles
from ..solution import Solution
from ..structure import build_structure
from ..topology import topology_of


def driving_angles_deg(graph: SketchGraph) -> Mapping[Corner, float]:
    """The angles that are said, which are all right."""
    said = (a for a in graph.annotations.values() if isinstance(a, RightAngle))
    order = {edge: k for k, edge in enumerate(graph.edges)}
    pairs = (sorted(a.between, key=order.__getitem__) for a in said)
    corners: list[Corner] = [(first, second) for first, second in pairs]
    return MappingProxyType(dict.fromkeys(corners, RIGHT_DEG))


def angles_deg(
    graph: SketchGraph, solution: Solution, more: Iterable[Corner] = ()
) -> Mapping[Corner, float]:
    """The angles at the corners of the drawn faces and where one is said, degrees, 0 to 180.

    Parameters
    ----------
    graph : SketchGraph
    solution : Solution
    more : iterable of (edge id, edge id)
        Other corners to measure, in the order of the graph.
    """
    corners = list(
        dict.fromkeys((*_corners_of_faces(graph, solution), *driving_angles_deg(graph), *more))
    )
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
    at = need_angle(graph, corner, angle_deg)
    if abs(angle_deg - RIGHT_DEG) > SAME_ANGLE_DEG:
        raise SketchError(
            f"an angle of {angle_deg:g} degrees between {corner[0]} and {corner[1]}",
            corner,
            "only right angles stand in a sketch; others are said of the model",
        )
    return annotate(graph, RightAngle(at, corner))[0]


def with_angle(
    graph: SketchGraph, said: Mapping[Corner, float], corner: Corner, angle_deg: float
) -> dict[Corner, float]:
    """Angles said beside a sketch, with one more or another value of one.

    What is said of corners between the same directions goes: these change together, and two
    numbers for one angle would disagree.

    Parameters
    ----------
    graph : SketchGraph
    said : mapping of (edge id, edge id) to float
    corner : (edge id, edge id)
    angle_deg : float

    Raises
    ------
    SketchError
        Where the angle cannot be, whatever the drawing: it names what it contradicts.
    """
    need_angle(graph, corner, angle_deg)
    together = _directions_of(graph, corner)
    found = {c: a for c, a in said.items() if _directions_of(graph, c) != together}
    found[corner] = angle_deg
    core, before = (without_profiles(with_angles(graph, angles)) for angles in (found, said))
    if disagree(core) and not disagree(before):
        raise SketchError(
            f"an angle of {angle_deg:g} degrees between {corner[0]} and {corner[1]} cannot hold "
            "beside what else is said",
            dict.fromkeys((angle_id(corner), *find_clash(core).ids)),
            "take one of the others away first",
        )
    return found


def _directions_of(graph: SketchGraph, corner: Corner) -> frozenset[int]:
    """The classes of directions of two edges."""
    topology = topology_of(graph)
    class_of = build_structure(graph).directions.class_of
    return frozenset(int(class_of[topology.edges[edge]]) for edge in corner)
