"""Vertices on faces that are found in 3D only: lifted without, then once more with these faces.

Where a sketch lists no faces, an `on_face` annotation names one of those that the solve finds. The
first pass leaves such annotations out and finds the faces; the next one lists the named faces, so
that what is said of them holds exactly. New faces may come of it, which others may name in turn.
A face keeps its id from pass to pass by the vertices of its loop.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

from .errors import SketchError
from .faces import find_faces
from .graph import Face, SketchGraph
from .ids import fresh_id
from .solution import Solution, Status
from .topology import topology_of

#: Faces found by one pass, named in the next one, and so on: so many times.
MAX_PASSES = 4

Faces = Mapping[str, Face]


def listing_named_faces(graph: SketchGraph, found: Faces) -> SketchGraph:
    """The graph with those found faces listed on which annotations put a vertex.

    The graph itself where it lists faces, or names none that can be listed: a sketch cannot name
    mirrored vertices.
    """
    if graph.faces is not None:
        return graph
    named = [a.face for _, a in topology_of(graph).by_kind["on_face"]]
    faces = {
        f: Face(found[f].loop)
        for f in dict.fromkeys(named)
        if f in found and all(v in graph.vertices for v in found[f].loop)
    }
    return replace(graph, faces=faces) if faces else graph


def solve_on_found_faces(graph: SketchGraph, lift: Callable[[SketchGraph], Solution]) -> Solution:
    """Lift a graph in as many passes as its annotations on found faces need.

    Parameters
    ----------
    graph : SketchGraph
    lift : callable
        One pass.
    """
    solution = lift(graph)
    said = topology_of(graph).by_kind["on_face"]
    if graph.faces is not None or not said:
        return solution
    listed = graph
    for _ in range(MAX_PASSES):
        more = listing_named_faces(graph, solution.faces)
        if more.faces is None or more.faces == listed.faces:
            break
        listed = more
        lifted = lift(listed)
        solution = replace(lifted, faces=_with_ids_of(solution.faces, _found(graph, lifted)))
    missing = [id_ for id_, a in said if a.face not in (listed.faces or {})]
    message = solution.message
    if missing and solution.vertices_mm:
        some = ", ".join(missing[:4])
        solution = _conflicting(solution, missing)
        words = f"No face was found for {some}: choose another one."
        message = words if message == "Solved." else f"{words} {message}"
    return replace(solution, sketch=graph, message=message)


def _conflicting(solution: Solution, ids: list[str]) -> Solution:
    """What names a face that is not there does not hold."""
    if solution.status is not Status.CONVERGED:
        return solution
    conflicts = (*ids, *solution.report.conflicts)
    report = replace(solution.report, conflicts=conflicts)
    return replace(solution, status=Status.CONFLICTING, report=report)


def _found(graph: SketchGraph, solution: Solution) -> Faces:
    traced = set(graph.construction)
    drawn = {e: ends for e, ends in solution.edges.items() if e.split("@")[0] not in traced}
    try:
        return find_faces(solution.vertices_mm, drawn)
    except SketchError:
        # The pass before found some: those that are listed stay.
        return solution.faces


def _with_ids_of(before: Faces, after: Faces) -> Faces:
    """Faces by the ids that they had, new ones by new ids, in the order in which they are found."""
    known: dict[frozenset[str], str] = {}
    for id_, face in before.items():
        known.setdefault(frozenset(face.loop), id_)
    ids = _ids([frozenset(face.loop) for face in after.values()], known, list(before))
    return dict(zip(ids, after.values(), strict=True))


def _ids(
    loops: Iterable[frozenset[str]], known: dict[frozenset[str], str], taken: list[str]
) -> list[str]:
    ids = []
    for loop in loops:
        id_ = known.pop(loop, None)
        if id_ is None:
            id_ = fresh_id("f", taken)
            taken.append(id_)
        ids.append(id_)
    return ids
