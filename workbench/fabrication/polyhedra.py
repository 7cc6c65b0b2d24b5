"""The closed block that a model's faces bound, with exactly flat faces.

Terms
-----
skin
    The faces that bound the block, left out or not; partitions are no part of it. A flat loop of
    edges in which no face was drawn counts as a face left out.
refit
    Faces of a solve are flat to about 1e-4 mm only. Planes are fitted to the faces and the
    vertices put where their planes meet, in turns, until both agree.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import shapely

from ...solver.model import Model, ModelFace
from ...solver.union_find import UnionFind
from ...solver.values import Array
from .enclosed import plane_axes
from .errors import FabricationError
from .frame import SNAP_MM, newell
from .openings import caps
from .overlapping import disjoint
from .sides import face_sides

Loop = tuple[str, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Polyhedron:
    """A closed block and the partitions in it.

    Parameters
    ----------
    vertices_mm : mapping of vertex id to (3,) array
    skin : mapping of face id to loops
        Outer loop and holes as vertex ids, those on their edges included.
    openings : tuple of face ids
        The faces of the skin that are left out.
    partitions : mapping of face id to loops
    """

    vertices_mm: Mapping[str, Array]
    skin: Mapping[str, tuple[Loop, ...]]
    openings: tuple[str, ...]
    partitions: Mapping[str, tuple[Loop, ...]]

    def points(self, loop: Loop) -> Array:
        """Positions of a loop, (n, 3)."""
        return np.array([self.vertices_mm[v] for v in loop])


def polyhedron_of(model: Model) -> Polyhedron:
    """The block of a model.

    Parameters
    ----------
    model : Model

    Returns
    -------
    Polyhedron

    Raises
    ------
    FabricationError
        Where the faces do not close (naming the open edges) or are not flat (naming the faces).
    """
    model = _capped(disjoint(model))
    loops = {id_: (face.loop, *face.holes) for id_, face in model.faces.items()}
    vertices = refit(model, loops)
    placed = {
        id_: tuple(np.array([vertices[v] for v in loop]) for loop in face)
        for id_, face in loops.items()
    }
    sides = face_sides(placed, list(loops))
    partitions = {id_: loops[id_] for id_, side in sides.items() if side == 0}
    skin = {
        id_: tuple(_with_corners(loop, vertices) for loop in face)
        for id_, face in loops.items()
        if id_ not in partitions
    }
    _check_closed(model, skin)
    _check_one(skin)
    openings = tuple(id_ for id_ in skin if not model.faces[id_].included)
    kept = {id_: face for id_, face in partitions.items() if model.faces[id_].included}
    return Polyhedron(vertices, skin, openings, kept)


def _capped(model: Model) -> Model:
    """The model with a face, left out, in each flat loop of edges that lie open; see `openings`."""
    drawn = [(face.loop_mm, *face.holes_mm) for face in model.faces.values()]
    if not drawn:
        return model
    names, points = list(model.vertices_mm), np.array(list(model.vertices_mm.values()))
    faces = dict(model.faces)
    for cap in caps(drawn, float(np.linalg.norm(np.ptp(points, axis=0)))):
        # Partitions that stand around a compartment end in its floor.
        if any(_covers(face, cap) for face in drawn):
            continue
        near = np.linalg.norm(points - cap[:, None], axis=2).argmin(axis=1)
        loop = tuple(names[n] for n in near.tolist())
        faces["-".join(loop)] = ModelFace(loop, points[near], (), (), 0.0, included=False)
    return replace(model, faces=faces)


def _covers(face: Sequence[Array], cap: Array) -> bool:
    """Whether some of a polygon lies in a face of its plane."""
    axes = plane_axes(face[0])
    if np.abs((cap - face[0][0]) @ axes[2]).max() > SNAP_MM:
        return False
    flat = [(ring - face[0][0]) @ axes[:2].T for ring in (*face, cap)]
    spot = shapely.Polygon(flat[-1]).representative_point()
    return bool(shapely.Polygon(flat[0], flat[1:-1]).contains(spot))


def refit(model: Model, loops: Mapping[str, tuple[Loop, ...]]) -> dict[str, Array]:
    """Vertices in the meeting points of the planes fitted to their faces."""
    vertices = {}
    for id_, face in model.faces.items():
        for names, positions in zip(loops[id_], (face.loop_mm, *face.holes_mm), strict=True):
            vertices.update({v: np.array(x) for v, x in zip(names, positions, strict=True)})
    start = dict(vertices)
    faces_at: dict[str, list[str]] = {}
    for id_, face_loops in loops.items():
        for v in {v for loop in face_loops for v in loop}:
            faces_at.setdefault(v, []).append(id_)
    for _ in range(200):
        planes = {id_: _plane(id_, face, vertices) for id_, face in loops.items()}
        off = 0.0
        for v, faces in faces_at.items():
            normals = np.array([planes[f][0] for f in faces])
            gaps = np.array([planes[f][1] for f in faces]) - normals @ vertices[v]
            # The least move into all planes; what they do not say stays.
            vertices[v] = vertices[v] + np.linalg.lstsq(normals, gaps, rcond=1e-6)[0]
            off = max(off, float(np.abs(gaps).max()))
        if off < 1e-10:
            break
    moves = {v: float(np.linalg.norm(vertices[v] - start[v])) for v in vertices}
    moved = {v for v, move in moves.items() if move > 5 * SNAP_MM}
    bent = [id_ for id_, face in loops.items() if moved & {v for loop in face for v in loop}]
    if off > 1e-6 or bent:
        raise FabricationError(
            f"these faces are not flat: corners lie up to {max(moves.values()):.2g} mm off",
            bent or loops,
            "right-angle annotations, or split the faces",
        )
    return vertices


def _plane(id_: str, loops: Iterable[Loop], vertices: Mapping[str, Array]) -> tuple[Array, float]:
    """Unit normal n and distance d of the plane n . x = d that fits best."""
    points = np.array([vertices[v] for loop in loops for v in loop])
    middle = points.mean(axis=0)
    _, spread, axes = np.linalg.svd(points - middle)
    if spread[1] < SNAP_MM:
        raise FabricationError("the face has no area", (id_,), "delete it or draw it again")
    return axes[2], float(axes[2] @ middle)


def _with_corners(loop: Loop, vertices: Mapping[str, Array]) -> Loop:
    """The loop with all vertices that lie on its edges, so that neighbours share them."""
    names = list(vertices)
    points = np.array([vertices[v] for v in names])
    result: list[str] = []
    for v, w in pairwise((*loop, loop[0])):
        a, span = vertices[v], vertices[w] - vertices[v]
        along = (points - a) @ span / (span @ span)
        off = np.linalg.norm(points - a - np.outer(along, span), axis=1)
        on = np.flatnonzero((off < 1e-5) & (along > 1e-9) & (along < 1 - 1e-9))
        between = [names[n] for n in on[np.argsort(along[on], kind="stable")]]
        result += [v, *(name for name in between if name not in (v, w))]
    return tuple(result)


def _check_closed(model: Model, skin: Mapping[str, Sequence[Loop]]) -> None:
    """Every edge of the skin must join exactly two faces."""
    faces_at: dict[frozenset[str], list[str]] = {}
    for id_, loops in skin.items():
        for loop in loops:
            for v, w in pairwise((*loop, loop[0])):
                faces_at.setdefault(frozenset((v, w)), []).append(id_)
    for wrong, what, remedy in (
        (1, "the faces do not close: these edges lie open", "draw the missing face; leave it out"),
        (
            3,
            "more than two outer faces meet in these edges",
            "bodies that share a face, or lie apart",
        ),
    ):
        edges = [e for e, faces in faces_at.items() if min(len(faces), 3) == wrong]
        if edges:
            raise FabricationError(what, _edge_names(edges, model), remedy)
    if len(skin) < 4:
        raise FabricationError("the faces do not enclose anything", skin, "a closed set of faces")


def _check_one(skin: Mapping[str, Sequence[Loop]]) -> None:
    """All faces of the skin must hang together, edge by edge."""
    sets, first = UnionFind(len(skin)), dict[frozenset[str], int]()
    for n, loops in enumerate(skin.values()):
        for loop in loops:
            for ends in pairwise((*loop, loop[0])):
                sets.union(n, first.setdefault(frozenset(ends), n))
    groups: dict[int, list[str]] = {}
    for id_, label in zip(skin, sets.labels(), strict=True):
        groups.setdefault(label, []).append(id_)
    if len(groups) > 1:
        raise FabricationError(
            "these faces are a body of their own, or a hollow within the other one",
            min((len(group), group) for group in groups.values())[1],
            "leave them out, or sketch them on their own",
        )


def _edge_names(edges: Iterable[frozenset[str]], model: Model) -> list[str]:
    names = {frozenset(ends): id_ for id_, ends in model.edges.items()}
    return sorted({names.get(edge) or "-".join(sorted(edge)) for edge in edges})


def area_vector(polyhedron: Polyhedron, face: str) -> Array:
    """Normal times area of a face of the skin, its loop's sense."""
    return newell(polyhedron.points(polyhedron.skin[face][0]))
