"""Where a press lands: on what is drawn near the pointer, or in line with it. Pure, no Qt.

Terms
-----
guide
    A line from the start of what is being drawn, along which the pointer is led.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import Enum
from itertools import combinations
from typing import TYPE_CHECKING

from ...solver.editing.elements import add_vertex, split_crossing, split_edge
from .hit_testing import axis_end_at, edge_at, nearest_on, vertex_at
from .plane import crossing, line_crossing, middle, on_line

if TYPE_CHECKING:
    from ...solver.graph import Point, SketchGraph

#: A guide leads within this many times the reach: less than an element, which lies where it lies.
GUIDE_REACH = 0.6
#: Nearer to the start than this many times the reach, any direction would do.
GUIDE_FROM = 3.0


Meet = Callable[[str, str], bool]


def never(one: str, two: str) -> bool:
    """No edges meet where they cross."""
    return False


def always(one: str, two: str) -> bool:
    """All edges meet where they cross."""
    return True


class SnapKind(Enum):
    """What a position sticks to; the value says it in a word."""

    FREE = ""
    VERTEX = "vertex"
    AXIS_END = "circle"
    EDGE = "edge"
    MIDPOINT = "middle"
    CROSSING = "crossing"
    PARALLEL = "parallel"
    VANISHING = "perspective"
    GRID = "grid"
    PHOTO_EDGE = "photo edge"
    PHOTO_CORNER = "photo corner"


@dataclass(frozen=True, slots=True)
class Snap:
    """A position, and what it sticks to.

    Parameters
    ----------
    kind : SnapKind
    point_px : (u, v)
    target : str or None
        The vertex, circle or edge; for guides the edge that is parallel.
    other : str or None
        The second edge of a crossing.
    guide : two positions, or None
        The line that leads.
    """

    kind: SnapKind
    point_px: Point
    target: str | None = None
    other: str | None = None
    guide: tuple[Point, Point] | None = None


@dataclass(frozen=True, slots=True)
class Lead:
    """What leads a line that is being drawn.

    Parameters
    ----------
    start_px : (u, v)
        Where the line begins.
    vanishing_px : tuple of (u, v)
        Where the object's directions meet in the photo, once that is known.
    """

    start_px: Point
    vanishing_px: tuple[Point, ...] = ()


def snap(
    graph: SketchGraph,
    point_px: Point,
    reach_px: float,
    but: frozenset[str] = frozenset(),
    lead: Lead | None = None,
    meet: Meet = never,
) -> Snap:
    """What a photo position sticks to.

    Vertices come first, then places of their own (axis ends, middles, crossings), then edges,
    then guides.

    Parameters
    ----------
    graph : SketchGraph
    point_px : (u, v)
    reach_px : float
        In photo px.
    but : frozenset of ids
        Vertices and edges that attract nothing.
    lead : Lead or None
        Of a line that is being drawn.
    meet : callable
        Whether two edges that cross in the photo meet in space; most pass each other.
    """
    vertex = vertex_at(graph, point_px, reach_px, but)
    if vertex is not None:
        return Snap(SnapKind.VERTEX, graph.vertices[vertex], vertex)
    places = [
        (math.dist(place.point_px, point_px), k, place)
        for k, place in enumerate(_places(graph, point_px, reach_px, but, meet))
    ]
    if places and min(places)[0] <= reach_px:
        return min(places)[2]
    led = None if lead is None else _led(graph, point_px, reach_px, lead)
    edge = edge_at(graph, point_px, reach_px, but)
    if edge is not None:
        return _on_edge(graph, edge, point_px, reach_px, led)
    return led or Snap(SnapKind.FREE, point_px)


def _places(
    graph: SketchGraph, point_px: Point, reach_px: float, but: frozenset[str], meet: Meet
) -> Iterator[Snap]:
    end = axis_end_at(graph, point_px, reach_px, graph.circles)
    if end is not None:
        circle, axis, k = end
        yield Snap(SnapKind.AXIS_END, getattr(graph.circles[circle], axis)[k], circle)
    near = [
        e
        for e in graph.edges
        if e not in but and math.dist(nearest_on(graph, e, point_px), point_px) <= reach_px
    ]
    lines = {e: tuple(graph.vertices[v] for v in graph.edges[e]) for e in near}
    for edge, ends in lines.items():
        yield Snap(SnapKind.MIDPOINT, middle(ends), edge)
    for one, two in combinations(near, 2):
        place = crossing(*lines[one], *lines[two])
        if place is not None and meet(one, two):
            yield Snap(SnapKind.CROSSING, place, one, two)


def _on_edge(
    graph: SketchGraph, edge: str, point_px: Point, reach_px: float, led: Snap | None
) -> Snap:
    """A place on an edge: where a guide meets it, else the nearest."""
    if led is not None and led.guide is not None:
        ends = (graph.vertices[v] for v in graph.edges[edge])
        met = line_crossing(*ends, *led.guide)
        if met is not None and math.dist(met, point_px) <= reach_px:
            on_it = nearest_on(graph, edge, met)
            if math.dist(on_it, met) < 1e-6:
                return Snap(SnapKind.EDGE, met, edge, guide=(led.guide[0], met))
    return Snap(SnapKind.EDGE, nearest_on(graph, edge, point_px), edge)


def _led(graph: SketchGraph, point_px: Point, reach_px: float, lead: Lead) -> Snap | None:
    """The place on the nearest guide, if one leads here."""
    start = lead.start_px
    if math.dist(start, point_px) < GUIDE_FROM * reach_px:
        return None
    to_vanishing = [(SnapKind.VANISHING, None, far) for far in lead.vanishing_px]
    along = [
        (SnapKind.PARALLEL, edge, (start[0] + q[0] - p[0], start[1] + q[1] - p[1]))
        for edge, (p, q) in _directions(graph).items()
    ]
    # What perspective says comes before what happens to be parallel in the photo.
    for guides in (to_vanishing, along):
        found = []
        for kind, target, far in guides:
            place = on_line(point_px, start, far)
            distance = math.dist(place, point_px)
            if distance <= GUIDE_REACH * reach_px:
                found.append((distance, Snap(kind, place, target, guide=(start, place))))
        if found:
            return min(found, key=lambda item: item[0])[1]
    return None


def _directions(graph: SketchGraph) -> dict[str, tuple[Point, Point]]:
    return {
        e: (graph.vertices[v], graph.vertices[w])
        for e, (v, w) in graph.edges.items()
        if graph.vertices[v] != graph.vertices[w]
    }


def place(graph: SketchGraph, at: Snap) -> tuple[SketchGraph, str]:
    """The graph with a vertex where a snap is, and its id: the one there, or a new one.

    A new one on an edge splits it, at a crossing both. What the snap stuck to may be gone by now.
    """
    if at.kind is SnapKind.VERTEX and at.target in graph.vertices:
        return graph, at.target
    if at.kind in (SnapKind.EDGE, SnapKind.MIDPOINT) and at.target in graph.edges:
        return split_edge(graph, at.target, at.point_px)
    if at.kind is SnapKind.CROSSING and at.target in graph.edges and at.other in graph.edges:
        return split_crossing(graph, at.target, at.other, at.point_px)
    return add_vertex(graph, at.point_px)
