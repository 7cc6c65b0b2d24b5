"""What the lifted shape makes evident and nobody has said yet: pure, no Qt.

Only suggested, never taken silently: real walls have 89 degrees.

Terms
-----
nearly
    True within a hand's error, and not to the last digits: what holds exactly follows from what
    is said already, and saying it again would tell the solver nothing.
flat
    A loop that looks like a face and is none: taken, it is one, and the solver makes it flat.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import combinations, pairwise, product
from typing import TYPE_CHECKING

import numpy as np

from ...solver.annotations import Annotation, Ground, Parallel, RightAngle
from ...solver.editing.annotating import annotate, toggle_ground
from ...solver.editing.listing import with_flat_face
from ...solver.editing.nearly_flat import nearly_flat
from .loops import quads

if TYPE_CHECKING:
    from ...solver.graph import Face, SketchGraph
    from ...solver.solution import Solution

#: Between these an angle is nearly what it should be, degrees.
NEARLY_DEG = (1e-3, 4.0)
#: Between these parts of the object's size a vertex is nearly on the ground.
NEARLY_ON_GROUND = (1e-6, 0.015)
#: More would cover the drawing; the surest come first.
MOST = 12


@dataclass(frozen=True, slots=True)
class Flat:
    """That a loop is a face.

    Parameters
    ----------
    loop : tuple of str
        Its vertices, around.
    found : mapping of id to Face
        The faces that there are without it.
    """

    loop: tuple[str, ...]
    found: Mapping[str, Face] = field(compare=False, repr=False)


Suggestion = Annotation | Flat


def evident(graph: SketchGraph, solution: Solution) -> tuple[Suggestion, ...]:
    """What the lift suggests to say.

    Parameters
    ----------
    graph : SketchGraph
        What was solved.
    solution : Solution
        Nothing is evident where annotations disagree.
    """
    if solution.status.value not in ("converged", "underdetermined"):
        return ()
    if not solution.vertices_mm or not all(v in solution.vertices_mm for v in graph.vertices):
        return ()
    right = sorted(_right_angles(graph, solution), key=lambda found: found[0])
    found: list[Suggestion] = [annotation for _, annotation in right]
    # A rectangle's right angles say its parallels as well.
    square = {e for a in found if isinstance(a, RightAngle) for e in a.between}
    square |= {e for a in graph.annotations_of("right_angle").values() for e in a.between}
    parallel = sorted(_parallels(graph, solution, square), key=lambda found: found[0])
    groups = _joined(annotation for _, annotation in parallel)
    found = [*_ground(graph, solution), *found, *groups]
    named = {e for a in found if isinstance(a, RightAngle | Parallel) for e in edges_of(a)}
    found += _flats(graph, solution, named)
    return tuple(found[:MOST])


def edges_of(annotation: RightAngle | Parallel) -> tuple[str, ...]:
    """The edges that an annotation is about."""
    return annotation.between if isinstance(annotation, RightAngle) else annotation.edges


def _flats(graph: SketchGraph, solution: Solution, named: set[str]) -> Iterator[Flat]:
    """Loops that are no faces; not those of which edges, with what else is suggested, may be."""
    for one in nearly_flat(graph, solution):
        sides = pairwise((*one.loop, one.loop[0]))
        if named.isdisjoint(filter(None, (graph.edge_between(*side) for side in sides))):
            yield Flat(one.loop, solution.faces)


def _right_angles(graph: SketchGraph, solution: Solution) -> Iterator[tuple[float, Annotation]]:
    said = {(a.at, frozenset(a.between)) for a in graph.annotations_of("right_angle").values()}
    at: dict[str, list[str]] = {v: [] for v in graph.vertices}
    for edge, ends in graph.edges.items():
        for v in ends:
            at[v].append(edge)
    for v, edges in at.items():
        for one, two in combinations(_straight_on(graph, solution, edges), 2):
            off = abs(_angle_deg(graph, solution, one[0], two[0]) - 90.0)
            pairs = (frozenset(pair) for pair in product(one, two))
            if _is_nearly(off) and not any((v, pair) in said for pair in pairs):
                yield off, RightAngle(v, (one[0], two[0]))


def _straight_on(graph: SketchGraph, solution: Solution, edges: list[str]) -> list[list[str]]:
    """Edges of one vertex, pieces of one line together: what is said of one is said of both."""
    lines: list[list[str]] = []
    for edge in edges:
        angles = ((_angle_deg(graph, solution, line[0], edge), line) for line in lines)
        # Of edges that point the same way round the angle is 0.
        along = (line for angle, line in angles if min(angle, 180.0 - angle) < NEARLY_DEG[0])
        line = next(along, None)
        if line is None:
            lines.append([edge])
        else:
            line.append(edge)
    return lines


def _parallels(
    graph: SketchGraph, solution: Solution, square: set[str]
) -> Iterator[tuple[float, Annotation]]:
    """Opposite sides of quadrilaterals, each pair once."""
    groups = [set(a.edges) for a in graph.annotations_of("parallel").values()]
    seen: set[frozenset[str]] = set()
    for quad in quads(graph):
        first = [graph.edge_between(*side[:2]) for side in quad.sides]
        for k in (0, 1):
            pair = tuple(e for e in (first[k], first[k + 2]) if e)
            key = frozenset(pair)
            if len(key) < 2 or key in seen or key <= square or any(key <= g for g in groups):
                continue
            seen.add(key)
            angle = _angle_deg(graph, solution, *pair)
            off = min(angle, 180.0 - angle)
            if _is_nearly(off):
                yield off, Parallel(pair)


def _joined(parallels: Iterable[Annotation]) -> list[Annotation]:
    """Pairs with an edge in common as one group."""
    groups: list[tuple[str, ...]] = []
    for pair in (a.edges for a in parallels):
        touching = [g for g in groups if set(g) & set(pair)]
        groups = [g for g in groups if g not in touching]
        groups.append(tuple(dict.fromkeys(e for g in (*touching, pair) for e in g)))
    return [Parallel(group) for group in groups]


def _ground(graph: SketchGraph, solution: Solution) -> Iterator[Annotation]:
    heights = {v: float(solution.vertices_mm[v][2]) for v in graph.vertices}
    points = np.array([solution.vertices_mm[v] for v in graph.vertices])
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    said = {v for a in graph.annotations_of("ground").values() for v in a.vertices}
    if said:
        least, most = (part * size for part in NEARLY_ON_GROUND)
        low = [v for v, z in heights.items() if v not in said and least < abs(z) < most]
    else:
        lowest = min(heights.values())
        low = [v for v, z in heights.items() if z - lowest < NEARLY_ON_GROUND[1] * size]
        low = low if len(low) > 2 else []
    if low:
        yield Ground(tuple(low))


def _angle_deg(graph: SketchGraph, solution: Solution, a: str, b: str) -> float:
    (a1, a2), (b1, b2) = graph.edges[a], graph.edges[b]
    x = solution.vertices_mm
    u, v = x[a2] - x[a1], x[b2] - x[b1]
    if a1 != b1 and a2 == b2:
        u, v = -u, -v
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(u, v)), u @ v)))


def _is_nearly(off_deg: float) -> bool:
    return NEARLY_DEG[0] < off_deg < NEARLY_DEG[1]


def taken(graph: SketchGraph, suggestions: Iterable[Suggestion]) -> SketchGraph:
    """The graph with what was suggested said."""
    for suggestion in suggestions:
        if isinstance(suggestion, Flat):
            graph = with_flat_face(graph, suggestion.loop, suggestion.found)
        elif isinstance(suggestion, Ground):
            on_it = {v for a in graph.annotations_of("ground").values() for v in a.vertices}
            new = [v for v in suggestion.vertices if v not in on_it]
            graph = toggle_ground(graph, new) if new else graph
        else:
            graph = annotate(graph, suggestion)[0]
    return graph


def still_open(graph: SketchGraph, suggestions: Iterable[Suggestion]) -> tuple[Suggestion, ...]:
    """The suggestions whose vertices and edges are all there, and that nobody has said since."""
    known = [s for s in suggestions if _is_there(graph, s)]
    return tuple(s for s in known if taken(graph, (s,)) is not graph)


def _is_there(graph: SketchGraph, suggestion: Suggestion) -> bool:
    if isinstance(suggestion, Flat):
        loops = [suggestion.loop, *(f.loop for f in suggestion.found.values())]
        sides = [side for loop in loops for side in pairwise((*loop, loop[0]))]
        return all(any(map(graph.is_copy, side)) or graph.edge_between(*side) for side in sides)
    if isinstance(suggestion, Ground):
        return graph.vertices.keys() >= set(suggestion.vertices)
    return graph.edges.keys() >= set(edges_of(suggestion))
