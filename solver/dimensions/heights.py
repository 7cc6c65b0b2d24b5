"""Heights above the ground: what lies at one height whatever the drawing, and what drives it.

Terms
-----
level
    The vertices and circles that share one height because the annotations say so.
upright
    A vertex on the ground and one of a level right above it: the length between them is the level's
    height, so that a length said of an edge from one to the other drives the height. Where none is
    drawn there, saying the height adds one, as construction: the sketch's line of dimension.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from ..editing.annotating import need_size, on_ground, set_length
from ..editing.elements import add_edge, toggle_construction
from ..errors import SketchError
from ..graph import SketchGraph
from ..ids import need
from ..revolution import without_profiles
from ..solution import Solution
from ..structure import Structure, build_structure
from .lengths import driving_sizes_mm, set_size, tied_edges


@dataclass(frozen=True, slots=True)
class Level:
    """What lies at one height.

    Parameters
    ----------
    members : tuple of vertex and circle ids
        The first one names the level.
    upright : (vertex id, vertex id) or None
        Between which the height can be said.
    """

    members: tuple[str, ...]
    upright: tuple[str, str] | None


def levels(graph: SketchGraph) -> Mapping[str, Level]:
    """The levels above the ground by their first members; none where nothing stands on the ground.

    What belongs to the profile of a surface of revolution alone is left out: it follows.
    """
    core = without_profiles(graph)
    structure = build_structure(core)
    heights = _height_numbers(core, structure)
    standing = [*on_ground(core), *(r.ground for r in core.revolutions.values())]
    ground = {heights[id_] for id_ in standing if id_ in heights}
    if not ground:
        return MappingProxyType({})
    members: dict[int, list[str]] = {}
    for id_, number in heights.items():
        if number not in ground:
            members.setdefault(number, []).append(id_)
    uprights = _uprights(core, structure, heights, ground)
    return MappingProxyType(
        {ids[0]: Level(tuple(ids), uprights.get(number)) for number, ids in members.items()}
    )


def _height_numbers(graph: SketchGraph, structure: Structure) -> dict[str, int]:
    """The number of the shared height of each vertex and circle."""
    # A vertex may be called what a circle is called; it comes first then.
    ids = dict.fromkeys([*graph.circles, *graph.vertices])
    place = {c: len(graph.vertices) + k for k, c in enumerate(graph.circles)}
    place |= {v: k for k, v in enumerate(graph.vertices)}
    if structure.vertical is None:
        grounded = on_ground(graph)
        return {id_: -1 if id_ in grounded else place[id_] for id_ in ids}
    column = structure.coordinate[:, structure.vertical].tolist()
    return {id_: column[place[id_]] for id_ in ids}


def _uprights(
    graph: SketchGraph, structure: Structure, heights: Mapping[str, int], ground: set[int]
) -> dict[int, tuple[str, str]]:
    """A vertex on the ground and one right above it at each height; joined ones come first."""
    if structure.vertical is None:
        return {}
    across = [axis for axis in range(3) if axis != structure.vertical]
    columns = structure.coordinate[: len(graph.vertices), across].tolist()
    where = {v: (x, y) for v, (x, y) in zip(graph.vertices, columns, strict=True)}
    feet: dict[tuple[int, int], str] = {}
    for v, place in where.items():
        if heights[v] in ground:
            feet.setdefault(place, v)
    above = [(feet[where[v]], v) for v in graph.vertices if where[v] in feet]
    joined = {frozenset(ends) for ends in graph.edges.values()}
    above.sort(key=lambda pair: frozenset(pair) not in joined)
    return {heights[v]: (foot, v) for foot, v in reversed(above) if heights[v] not in ground}


def heights_mm(graph: SketchGraph, solution: Solution) -> Mapping[str, float]:
    """How high each level came out, by its first member."""
    return MappingProxyType({id_: _height_mm(id_, solution) for id_ in levels(graph)})


def _height_mm(id_: str, solution: Solution) -> float:
    points = solution.vertices_mm
    return float(points[id_][2] if id_ in points else solution.circles[id_].center_mm[2])


def driving_heights_mm(graph: SketchGraph) -> Mapping[str, float]:
    """The heights that said lengths drive, by the first member of the level."""
    said = driving_sizes_mm(graph)
    found: dict[str, float] = {}
    for id_, level in levels(graph).items() if said else ():
        for edge in _tied_to(graph, level):
            if edge in said:
                found.setdefault(id_, said[edge])
    return MappingProxyType(found)


def set_height(graph: SketchGraph, id_: str, height_mm: float | None) -> SketchGraph:
    """The graph with a height said of a level, as the length of an upright edge; None frees it.

    Raises
    ------
    SketchError
        Where no vertex of the ground is known to be right below, or the height is not above 0.
    """
    found = levels(graph)
    need((id_,), found)
    said = [edge for edge in _tied_to(graph, found[id_]) if edge in driving_sizes_mm(graph)]
    if height_mm is None:
        for edge in said:
            graph = set_length(graph, edge, None)
        return graph
    if said:
        return set_size(graph, said[0], height_mm)
    need_size("height", height_mm, id_)
    graph, edge = _with_upright(graph, id_, found[id_])
    return set_size(graph, edge, height_mm)


def _with_upright(graph: SketchGraph, id_: str, level: Level) -> tuple[SketchGraph, str]:
    """The graph with an edge from the ground to a level, and that edge."""
    if level.upright is None:
        raise SketchError(
            f"nothing on the ground is known to be right below {id_}",
            (id_,),
            "draw an upright edge from the ground to there",
        )
    larger, edge = add_edge(graph, *level.upright)
    if edge not in graph.edges:
        larger = toggle_construction(larger, (edge,))
    return larger, edge


def _tied_to(graph: SketchGraph, level: Level) -> tuple[str, ...]:
    """The edges that are as long as the level is high."""
    edge = graph.edge_between(*level.upright) if level.upright else None
    return tied_edges(graph, edge) if edge else ()
