"""Edits of what is said of a sketch: each gives a new valid graph, the old one stays."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from ..annotations import (
    Annotation,
    EqualLength,
    Ground,
    Length,
    Parallel,
    RightAngle,
    SymmetryPlane,
)
from ..errors import SketchError
from ..graph import SketchGraph
from ..ids import fresh_id, need
from ..reading.parsing import check_references


def annotate(graph: SketchGraph, annotation: Annotation) -> tuple[SketchGraph, str]:
    """The graph with one more annotation, and its id; the old one where the same is said already.

    Raises
    ------
    SketchError
        Where it names what is not there, or makes no sense.
    """
    for id_, said in graph.annotations.items():
        if _same(said, annotation):
            return graph, id_
    id_ = fresh_id("a", graph.annotations)
    larger = replace(graph, annotations={**graph.annotations, id_: annotation})
    check_references(larger)
    return larger, id_


def _same(a: Annotation, b: Annotation) -> bool:
    """Whether two annotations say the same; edges may be named in any order."""
    if isinstance(a, RightAngle) and isinstance(b, RightAngle):
        return a.at == b.at and set(a.between) == set(b.between)
    if isinstance(a, Parallel | EqualLength) and isinstance(b, type(a)):
        return set(a.edges) == set(b.edges)
    if isinstance(a, SymmetryPlane) and isinstance(b, SymmetryPlane):
        return set(a.midpoints_of) == set(b.midpoints_of)
    return a == b


def set_group(
    graph: SketchGraph,
    kind: type[Parallel] | type[EqualLength],
    edges: Iterable[str],
    id_: str | None,
) -> SketchGraph:
    """The graph with a group of parallel or equally long edges.

    Parameters
    ----------
    graph : SketchGraph
    kind : Parallel or EqualLength
    edges : iterable of edge ids
        Fewer than two are no group: the annotation goes.
    id_ : str or None
        The group that is changed; None makes a new one.
    """
    members = tuple(dict.fromkeys(edges))
    if len(members) < 2:
        return graph if id_ is None else without_annotations(graph, (id_,))
    if id_ is None:
        return annotate(graph, kind(members))[0]
    changed = replace(graph, annotations={**graph.annotations, id_: kind(members)})
    check_references(changed)
    return changed


def set_length(graph: SketchGraph, edge: str, length_mm: float | None) -> SketchGraph:
    """The graph with a length said of an edge; None takes it back.

    Raises
    ------
    SketchError
        Where the length is not above 0, or the edge is not there.
    """
    need((edge,), graph.edges)
    said = [i for i, a in graph.annotations.items() if isinstance(a, Length) and a.edge == edge]
    if length_mm is None:
        return without_annotations(graph, said)
    need_size("length", length_mm, edge)
    return say_once(graph, said, Length(edge, float(length_mm)))


def need_size(what: str, size_mm: float, element: str) -> None:
    """Refuse a size that is none.

    Raises
    ------
    SketchError
        Where it is not above 0, or infinite.
    """
    if not 0 < size_mm < float("inf"):
        raise SketchError(f"a {what} of {size_mm:g} mm", (element,), f"a {what} above 0")


def say_once(graph: SketchGraph, said: list[str], annotation: Annotation) -> SketchGraph:
    """The graph with an annotation in the place of the first one that said the like, else added."""
    if said:
        return replace(graph, annotations={**graph.annotations, said[0]: annotation})
    return annotate(graph, annotation)[0]


def on_ground(graph: SketchGraph) -> frozenset[str]:
    """The vertices that are said to stand on the ground."""
    return frozenset(
        v for a in graph.annotations.values() if isinstance(a, Ground) for v in a.vertices
    )


def toggle_ground(graph: SketchGraph, vertices: Iterable[str]) -> SketchGraph:
    """The graph with vertices put on the ground, or taken off it where all of them were on it.

    Raises
    ------
    SketchReferenceError
        Where one is not there.
    """
    named = tuple(dict.fromkeys(vertices))
    need(named, graph.vertices)
    grounds = {id_: a for id_, a in graph.annotations.items() if isinstance(a, Ground)}
    on_it = on_ground(graph)
    if on_it.issuperset(named):
        left = {id_: tuple(v for v in a.vertices if v not in named) for id_, a in grounds.items()}
    elif grounds:
        first = next(iter(grounds))
        new = tuple(v for v in named if v not in on_it)
        left = {first: (*grounds[first].vertices, *new)}
    else:
        return annotate(graph, Ground(named))[0]
    changed = {id_: Ground(vs) for id_, vs in left.items() if vs}
    smaller = without_annotations(graph, (id_ for id_, vs in left.items() if not vs))
    return replace(smaller, annotations={**smaller.annotations, **changed})


def without_annotations(graph: SketchGraph, ids: Iterable[str]) -> SketchGraph:
    """The graph without some annotations; ids that are not there are no mistake."""
    gone = set(ids)
    left = {id_: a for id_, a in graph.annotations.items() if id_ not in gone}
    return replace(graph, annotations=left)
