"""Faces in a sketch's own list: left out, given a thickness, added to as the drawing grows.

Terms
-----
found
    The minimal planar loops of edges of the last solve, see `faces.find_faces`.
listed
    The faces that the sketch itself names. Once it names some, there are no others.
part
    A found loop in the plane and within the outline of a listed face, which later lines divided.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..errors import SketchError
from ..faces import find_faces
from ..geometry import cross
from ..graph import COPY_SIGN, Face, SketchGraph
from ..ids import fresh_id, need
from ..reading.parsing import check_references
from ..solution import Solution, Status
from ..values import Array

#: A vertex within this part of the object's size of a plane or an outline lies in it.
TOLERANCE = 1e-5

Faces = Mapping[str, Face]


@dataclass(frozen=True, slots=True, eq=False)
class Choice:
    """A face of which something is said.

    Parameters
    ----------
    id_ : str
        One of `choices`.
    found : mapping of id to Face
        See `found_faces`.
    vertices_mm : mapping of vertex id to (3,) array
        Where the vertices are that were solved.
    """

    id_: str
    found: Faces
    vertices_mm: Mapping[str, Array]


def found_faces(graph: SketchGraph, solution: Solution) -> dict[str, Face]:
    """All minimal planar loops of the lifted sketch, listed or not; none where it is not solved.

    One that is the mirror image of a listed face is as that one, and has the id of a copy.

    Parameters
    ----------
    graph : SketchGraph
        What was solved.
    solution : Solution
    """
    if solution.status is not Status.CONVERGED:
        return {}
    traced = set(graph.construction)
    drawn = {e: ends for e, ends in solution.edges.items() if e.split("@")[0] not in traced}
    try:
        found = find_faces(solution.vertices_mm, drawn)
    except SketchError:
        # A tangle of lines; the solution says so.
        return {}
    listed = graph.faces
    if listed is None:
        return found
    copies = {_key(f): id_ for id_, f in solution.faces.items() if id_ not in listed}
    ids = {id_: copies.get(_key(face), id_) for id_, face in found.items()}
    return {
        new: solution.faces[new] if COPY_SIGN in new else found[old] for old, new in ids.items()
    }


def choices(graph: SketchGraph, found: Faces) -> dict[str, Face]:
    """The faces of which something can be said, by id: those listed, then those only found.

    Found ones that are not listed get ids that nothing has yet, mirror images those of copies.
    """
    there = {id_: face for id_, face in found.items() if _can_be_listed(graph, face)}
    if graph.faces is None:
        return there
    all_ = dict(graph.faces)
    known = {_key(face) for face in all_.values()}
    for id_, face in there.items():
        if _key(face) not in known:
            all_[id_ if COPY_SIGN in id_ else fresh_id("f", all_)] = face
    return all_


def is_made(graph: SketchGraph, id_: str, found: Faces) -> bool:
    """Whether something is made of a face of `choices`."""
    face = choices(graph, found)[id_]
    known = graph.faces is None or id_ in graph.faces or COPY_SIGN in id_
    return known and face.included


def set_included(graph: SketchGraph, choice: Choice, included: bool) -> SketchGraph:
    """The graph with a face made, or left out; lists all faces where none were listed.

    Raises
    ------
    SketchError
        Where it is no choice.
    """
    return _with_face(graph, choice, lambda face: replace(face, included=included))


def set_thickness(graph: SketchGraph, choice: Choice, thickness_mm: float | None) -> SketchGraph:
    """The graph with a thickness said of a face; None takes it back; lists all faces.

    Raises
    ------
    SketchError
        Where it is no choice, or the thickness is not above 0.
    """
    if thickness_mm is not None and not 0 < thickness_mm < float("inf"):
        raise SketchError(f"a thickness of {thickness_mm:g} mm", (choice.id_,), "one above 0")
    return _with_face(graph, choice, lambda face: replace(face, thickness_mm=thickness_mm))


def with_list(graph: SketchGraph, choice: Choice) -> SketchGraph:
    """The graph with a face listed, and all others where none were listed.

    Raises
    ------
    SketchError
        Where it is no choice.
    """
    if graph.faces is not None and choice.id_ in graph.faces:
        return graph
    return _with_face(graph, choice, lambda face: face)


def with_flat_face(graph: SketchGraph, loop: tuple[str, ...], found: Faces) -> SketchGraph:
    """The graph with a loop listed that was no face, and so made flat; lists all faces.

    Parameters
    ----------
    graph : SketchGraph
    loop : tuple of str
    found : mapping of id to Face
        See `found_faces`.

    Raises
    ------
    SketchError
        Where the loop's vertices are not joined by edges.
    """
    faces = dict(choices(graph, found) if graph.faces is None else graph.faces)
    if frozenset(loop) in {_key(face) for face in faces.values()}:
        return graph
    listed = replace(graph, faces=faces | {fresh_id("f", faces): Face(loop)})
    check_references(listed)
    return listed


def _with_face(graph: SketchGraph, choice: Choice, change: Callable[[Face], Face]) -> SketchGraph:
    """The graph with a face changed and listed.

    A part of a listed face takes the face's place together with its other parts, which keep what
    was said of the whole.
    """
    chosen, id_ = choices(graph, choice.found), choice.id_
    need((id_,), chosen)
    faces = dict(chosen if graph.faces is None else graph.faces)
    if id_ not in faces:
        unlisted = {other: face for other, face in chosen.items() if other not in faces}
        whole = _whole_of(chosen[id_], faces, choice.vertices_mm)
        faces |= {id_: chosen[id_]}
        if whole is not None:
            faces |= _divide((whole, faces[whole]), unlisted, choice)
    faces[id_] = change(faces[id_])
    listed = replace(graph, faces=faces)
    check_references(listed)
    return listed


def with_new_faces(
    before: tuple[SketchGraph, Solution | None], after: tuple[SketchGraph, Solution]
) -> SketchGraph:
    """The graph after an edit, faces that came with it added to its list.

    New is a loop that was not found before the edit; where the sketch was not solved then, one
    with an edge that no listed face has. A part of a listed face is none: the face is as it was.
    One that took in faces which the edit has ended, by removing the edge between them, is left out
    where they all were.

    Parameters
    ----------
    before, after : (SketchGraph, Solution)
        The sketch on both sides of the edit, each with its solution, if there was one before.
    """
    graph, solution = after
    if graph.faces is None:
        return graph
    found = found_faces(graph, solution)
    old, solved = before
    was_solved = solved is not None and solved.status is Status.CONVERGED
    at = {} if solved is None else solved.vertices_mm
    known = set() if solved is None else {_key(f) for f in found_faces(old, solved).values()}
    bounded = {side for face in graph.faces.values() for side in _sides(face)}
    lost = [face for id_, face in (old.faces or {}).items() if id_ not in graph.faces]
    added = {}
    for id_, face in choices(graph, found).items():
        is_new = _key(face) not in known if was_solved else not _sides(face) <= bounded
        if id_ in graph.faces or not is_new:
            continue
        if _whole_of(face, graph.faces, solution.vertices_mm) is None:
            added[id_] = _heir(face, lost, at)
    return replace(graph, faces={**graph.faces, **added}) if added else graph


def _heir(face: Face, lost: list[Face], at: Mapping[str, Array]) -> Face:
    """A face with what was said of those that it took in, as when the edge between them went."""
    there = all(v in at for v in face.loop)
    parts = [old for old in lost if there and set(old.loop) <= at.keys()]
    parts = [old for old in parts if _contains(face, old, at)]
    if not parts:
        return face
    included = any(old.included for old in parts)
    return replace(face, included=included, thickness_mm=parts[0].thickness_mm)


def _key(face: Face) -> frozenset[str]:
    return frozenset(face.loop)


def _sides(face: Face) -> set[frozenset[str]]:
    return {
        frozenset(pair)
        for loop in face.loops
        for pair in zip(loop, (*loop[1:], loop[0]), strict=True)
    }


def _can_be_listed(graph: SketchGraph, face: Face) -> bool:
    return all(v in graph.vertices or graph.is_copy(v) for loop in face.loops for v in loop)


def _whole_of(part: Face, listed: Faces, at: Mapping[str, Array]) -> str | None:
    """The listed face that a loop is a part of, if there is one."""
    for id_, face in listed.items():
        if all(v in at for v in (*face.loop, *part.loop)) and _contains(face, part, at):
            return id_
    return None


def _contains(face: Face, part: Face, at: Mapping[str, Array]) -> bool:
    """Whether all corners of a loop, and the middles of its sides, lie in a face."""
    outline = np.array([at[v] for v in face.loop])
    corners = np.array([at[v] for v in part.loop])
    places = np.vstack([corners, (corners + np.roll(corners, -1, axis=0)) / 2])
    size = float(np.ptp(outline, axis=0).max())
    origin = outline.mean(axis=0)
    normal = sum(
        cross(p - origin, q - origin)
        for p, q in zip(outline, np.roll(outline, -1, axis=0), strict=True)
    )
    length = float(np.linalg.norm(normal))
    if length == 0 or np.abs((places - origin) @ normal).max() > TOLERANCE * size * length:
        return False
    flat = np.delete(np.vstack([outline, places]), int(np.argmax(np.abs(normal))), axis=1)
    n = len(outline)
    return all(_is_in(flat[:n], place, TOLERANCE * size) for place in flat[n:])


def _is_in(outline: Array, place: Array, tolerance: float) -> bool:
    """Whether a place is inside an outline, or on it."""
    inside = False
    for p, q in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        along, offset = q - p, place - p
        part = float(np.clip(offset @ along / max(float(along @ along), 1e-300), 0, 1))
        if np.linalg.norm(offset - part * along) <= tolerance:
            return True
        if (p[1] > place[1]) != (q[1] > place[1]):
            at = p[0] + (place[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
            inside ^= bool(at > place[0])
    return inside


def _divide(listed: tuple[str, Face], unlisted: Faces, choice: Choice) -> dict[str, Face]:
    """The parts of a listed face; one of them, but not the one that is meant, keeps its id."""
    whole, face = listed
    at = choice.vertices_mm
    parts = {id_: part for id_, part in unlisted.items() if _contains(face, part, at)}
    outline = next((f for f in choice.found.values() if _key(f) == _key(face)), None)
    rest = [id_ for id_ in parts if id_ != choice.id_]
    if outline is not None:
        parts[whole] = outline
    elif rest:
        parts[whole] = parts.pop(rest[0])
    included, thickness = face.included, face.thickness_mm
    return {
        id_: replace(part, included=included, thickness_mm=thickness) for id_, part in parts.items()
    }
