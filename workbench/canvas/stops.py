"""Where the keyboard's cursor stops: the places that a tool would be pointed at. Pure, no Qt."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from itertools import chain, pairwise
from typing import TYPE_CHECKING

from .loops import quads
from .plane import Point, direction, middle
from .selection import Selection
from .solved import outline

if TYPE_CHECKING:
    from ...solver.graph import Face, SketchGraph


def vertices(graph: SketchGraph) -> list[Point]:
    """All vertices."""
    return list(graph.vertices.values())


def edges(graph: SketchGraph) -> list[Point]:
    """The middles of all edges."""
    return [middle([graph.vertices[v] for v in ends]) for ends in graph.edges.values()]


def circles(graph: SketchGraph) -> list[Point]:
    """The ends of the axes of all circles."""
    return [place for drawn in graph.circles.values() for place in (*drawn.a, *drawn.b)]


def loops(graph: SketchGraph) -> list[Point]:
    """The middles of all quadrilaterals."""
    return [middle([graph.vertices[v] for v in quad.outline]) for quad in quads(graph)]


def faces(at: Mapping[str, Point], there: Mapping[str, Face]) -> list[Point]:
    """The middles of some faces, by the places of their vertices."""
    return [middle(outline(at, face.loop)) for face in there.values()]


def corners(graph: SketchGraph, away_px: float) -> list[Point]:
    """A place in each angle between two neighbouring edges, so far from their vertex."""
    return list(chain.from_iterable(_angles(graph, v, away_px) for v in graph.vertices))


def _angles(graph: SketchGraph, vertex: str, away_px: float) -> Iterator[Point]:
    here = graph.vertices[vertex]
    ends = [w if v == vertex else v for v, w in graph.edges.values() if vertex in (v, w)]
    turned = sorted(direction(here, graph.vertices[w]) for w in ends)
    if len(turned) < 2:
        return
    for a, b in pairwise([*turned, turned[0] + 2 * math.pi]):
        if b - a < math.pi:
            between = (a + b) / 2
            yield (here[0] + away_px * math.cos(between), here[1] + away_px * math.sin(between))


def everything(graph: SketchGraph) -> list[Selection]:
    """All that can be selected, one by one."""
    kinds: dict[str, Iterable[str]] = {
        "vertices": graph.vertices,
        "edges": graph.edges,
        "circles": graph.circles,
        "annotations": graph.annotations,
    }
    return [Selection(**{kind: frozenset((id_,))}) for kind, ids in kinds.items() for id_ in ids]


def place_of(graph: SketchGraph, chosen: Selection) -> Point | None:
    """Where something that is selected lies, the middle of what it names."""
    named = chosen.with_targets(graph)
    ends = [v for e in named.edges for v in graph.edges[e]]
    places = [graph.vertices[v] for v in (*named.vertices, *ends)]
    places += [p for c in named.circles for p in graph.circles[c].a]
    return middle(places) if places else None
