"""What an element of a lifted model's shape stands for: from a click in 3D to a dimension."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import pipeline
from .dimension_names import ANGLE, DIAMETER, HEIGHT, LENGTH, Dimension
from .driven import driven_text
from .model_angles import in_order

if TYPE_CHECKING:
    from ...solver.solution import Solution

#: Two places that are nearer than this are one, mm.
_NEAR_MM = 1e-6


def dimension_at(obj: Any, element: str) -> Dimension | None:
    """The dimension that an element of the shape stands for.

    The length of an edge such as ``Edge3``, the diameter of a round one, the height above the
    ground of a vertex such as ``Vertex5``. None for what belongs to the mirrored half, and for
    vertices on the ground.
    """
    solution = pipeline.solution_of(driven_text(obj))
    shape = obj.Shape.getElement(element)
    if element.startswith("Vertex"):
        return _height_at(obj, tuple(shape.Point), solution)
    if element.startswith("Edge"):
        return _size_of(obj, shape, solution)
    return None


def corner_at(obj: Any, elements: tuple[str, ...]) -> Dimension | None:
    """The angle between two edges of the shape, by their names; None where they do not meet."""
    found = [dimension_at(obj, element) for element in elements]
    edges = [one.ids[0] for one in found if one is not None and one.prefix == LENGTH]
    if len(edges) != 2 or len(found) != 2:
        return None
    corners = in_order(pipeline.graph_of(obj.PhotoSketch.Sketch), {(edges[0], edges[1]): 0.0})
    return next((Dimension(ANGLE, corner) for corner in corners), None)


def _height_at(obj: Any, point: Any, solution: Solution) -> Dimension | None:
    from ...solver.dimensions.heights import levels

    for id_, level in levels(pipeline.graph_of(obj.PhotoSketch.Sketch)).items():
        for member in level.members:
            place = solution.vertices_mm.get(member)
            if place is not None and _near([point], [place]):
                return Dimension(HEIGHT, (id_,))
    return None


def _size_of(obj: Any, edge: Any, solution: Solution) -> Dimension | None:
    graph = pipeline.graph_of(obj.PhotoSketch.Sketch)
    ends = [tuple(vertex.Point) for vertex in edge.Vertexes]
    if len(ends) < 2:
        for id_ in graph.circles:
            circle = solution.circles[id_]
            same = abs(edge.Curve.Radius - circle.radius_mm) < _NEAR_MM
            if same and _near([tuple(edge.Curve.Center)], [circle.center_mm]):
                return Dimension(DIAMETER, (id_,))
        return None
    for id_ in graph.edges:
        v, w = (solution.vertices_mm[u] for u in solution.edges[id_])
        if _near(ends, [v, w]) or _near(ends, [w, v]):
            return Dimension(LENGTH, (id_,))
    return None


def _near(points: list[Any], others: list[Any]) -> bool:
    pairs = zip(points, others, strict=True)
    return all(abs(a - b) < _NEAR_MM for p, q in pairs for a, b in zip(p, q, strict=True))
