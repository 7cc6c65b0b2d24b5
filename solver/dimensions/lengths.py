"""The sizes of a sketch as numbers to read and to set: lengths of edges, diameters of circles.

Terms
-----
dimension
    The length of an edge or the diameter of a circle, known by that element's id.
driving
    Said by an annotation. The other dimensions follow from the drawing and from these.
tied
    Dimensions that are equal whatever the drawing, because the annotations say so: opposite sides
    of a rectangle, edges marked as equally long.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from ..annotations import Diameter, EqualLength, Length
from ..editing.annotating import set_length
from ..editing.rounds import set_diameter
from ..graph import SketchGraph
from ..solution import Solution
from ..structure import Structure, build_structure
from ..union_find import UnionFind


def driving_sizes_mm(graph: SketchGraph) -> Mapping[str, float]:
    """What is said of edges and circles, by their ids."""
    said: dict[str, float] = {}
    for annotation in graph.annotations.values():
        if isinstance(annotation, Length):
            said[annotation.edge] = annotation.length_mm
        elif isinstance(annotation, Diameter):
            said[annotation.circle] = annotation.diameter_mm
    return MappingProxyType(said)


def sizes_mm(solution: Solution) -> Mapping[str, float]:
    """What all edges and circles measure in 3D, by their ids."""
    points = solution.vertices_mm
    measured = {
        id_: float(np.linalg.norm(points[w] - points[v])) for id_, (v, w) in solution.edges.items()
    }
    measured |= {id_: 2.0 * circle.radius_mm for id_, circle in solution.circles.items()}
    return MappingProxyType(measured)


def tied_edges(graph: SketchGraph, edge: str) -> tuple[str, ...]:
    """The edges that are as long as this one whatever the drawing, itself included."""
    numbers = {id_: i for i, id_ in enumerate(graph.edges)}
    sets = UnionFind(len(numbers))
    for annotation in graph.annotations.values():
        if isinstance(annotation, EqualLength):
            for other in annotation.edges[1:]:
                sets.union(numbers[annotation.edges[0]], numbers[other])
    first: dict[tuple[tuple[int, int] | None, ...], int] = {}
    for number, spans in enumerate(_spans(graph, build_structure(graph))):
        sets.union(first.setdefault(spans, number), number)
    found = sets.find(numbers[edge])
    return tuple(id_ for id_, number in numbers.items() if sets.find(number) == found)


def _spans(graph: SketchGraph, structure: Structure) -> list[tuple[tuple[int, int] | None, ...]]:
    """The shared coordinates between which each edge runs, along each axis; None where equal."""
    index = {v: i for i, v in enumerate(graph.vertices)}
    spans = []
    for v, w in graph.edges.values():
        pairs = zip(structure.coordinate[index[v]], structure.coordinate[index[w]], strict=True)
        spans.append(tuple(None if a == b else (min(a, b), max(a, b)) for a, b in pairs))
    return spans


def set_size(graph: SketchGraph, id_: str, size_mm: float | None) -> SketchGraph:
    """The graph with a size said of an edge or a circle; None takes it back.

    What is said of edges tied to it changes with it: else the two would disagree.

    Raises
    ------
    SketchError
        Where the size is not above 0, or the element is not there.
    """
    if id_ in graph.circles:
        return set_diameter(graph, id_, size_mm)
    changed = set_length(graph, id_, size_mm)
    if size_mm is None:
        return changed
    said = driving_sizes_mm(graph)
    for other in tied_edges(graph, id_):
        if other != id_ and other in said:
            changed = set_length(changed, other, size_mm)
    return changed
