"""Walls at any angle: the start of the band model.

Terms
-----
wall frame
    Origin in the outer plane, x and y in it, z to the inside; the material lies from z = 0 to
    z = thickness.
outer plane
    The drawn plane where the material lies inside of it, else the drawn plane moved outwards.
opening
    A face left out: a wall without thickness, of which nothing is made. Plates end at it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import manifold3d
import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.model import Model
from ...solver.values import Array
from .enclosed import enclosed
from .errors import FabricationError
from .frame import SNAP_MM, newell
from .offsetting import moved_corners
from .overlays import together
from .polyhedra import refit
from .sides import face_sides
from .walls import tidy


class _CrossingError(FabricationError):
    """A face whose outline crosses itself; its id is the face's."""


@dataclass(frozen=True, slots=True, eq=False)
class SlantedWall:
    """One flat wall: `rings` are its outline (ccw, seen from inside) and holes, (n, 2) each.

    An opening has the thickness 0. The drawn faces lie at z = `drawn_mm`.
    """

    face_ids: tuple[str, ...]
    thickness_mm: float
    world_from_wall: Array
    rings: tuple[Array, ...]
    drawn_mm: float = 0.0

    def in_world(self, points: Array) -> Array:
        """World positions of points (n, 2) of the outer plane."""
        axes = self.world_from_wall[:3, :2]
        return np.asarray(points @ axes.T + self.world_from_wall[:3, 3])

    @property
    def inwards(self) -> Array:
        """Unit normal to the inside."""
        return np.asarray(self.world_from_wall[:3, 2])


def slanted_walls(
    model: Model, side: str
) -> tuple[tuple[SlantedWall, ...], tuple[SlantedWall, ...], manifold3d.Manifold | None]:
    """The walls of a model at any angles, then its openings; partitions; what the faces enclose.

    Raises
    ------
    FabricationError
        Naming faces that are not flat.
    """
    loops = {id_: (face.loop, *face.holes) for id_, face in model.faces.items()}
    vertices = refit(model, loops)
    made = [id_ for id_, face in model.faces.items() if face.included]
    left_out = [id_ for id_, face in model.faces.items() if not face.included]
    placed = {
        id_: tuple(np.array([vertices[v] for v in loop]) for loop in face)
        for id_, face in loops.items()
    }
    sides = face_sides(placed, [*made, *left_out])
    partitions = [id_ for id_ in made if sides[id_] == 0]
    shown = [
        *(id_ for id_ in made if sides[id_] != 0),
        *(id_ for id_ in left_out if sides[id_] != 0),
    ]
    inwards = {id_: sides[id_] * _unit(newell(placed[id_][0])) for id_ in shown}
    share = {"inside": 0.0, "middle": 0.5, "outside": 1.0}[side]
    thickness = {id_: model.faces[id_].thickness_mm if id_ in made else 0.0 for id_ in shown}
    corners = moved_corners(vertices, loops, inwards, {f: share * t for f, t in thickness.items()})
    outer = {id_: tuple(np.vstack(ring) for ring in rings) for id_, rings in corners.items()}
    try:
        walls = [
            wall
            for group in _planes(shown, outer, inwards, thickness)
            for wall in _walls(group, outer, inwards[group[0]], thickness[group[0]], share)
        ]
    except _CrossingError as error:
        turned = _turned_round(model, error.ids[0], placed, corners) if share else ()
        raise _moved_across(error, turned, share * thickness[error.ids[0]]) from None
    walls.sort(key=lambda wall: shown.index(wall.face_ids[0]))
    drawn = enclosed({id_: loops[id_] for id_ in shown}, vertices, sides)
    return _with_common_corners(walls), _partitions(model, partitions, loops, vertices), drawn


def _partitions(
    model: Model,
    partitions: Sequence[str],
    loops: Mapping[str, Sequence[Sequence[str]]],
    vertices: Mapping[str, Array],
) -> tuple[SlantedWall, ...]:
    """Walls with the drawn faces in their middle."""
    normals, rings = {}, {}
    for id_ in partitions:
        rings[id_] = tuple(np.array([vertices[v] for v in loop]) for loop in loops[id_])
        normal = _unit(newell(rings[id_][0]))
        # One sense for parallel ones, so that faces of one plane are found.
        lead = int(np.argmax(np.abs(np.round(normal, 6))))
        normals[id_] = normal if normal[lead] > 0 else -normal
    thickness = {id_: model.faces[id_].thickness_mm for id_ in partitions}
    walls = (
        wall
        for group in _planes(partitions, rings, normals, thickness)
        for wall in _walls(group, rings, normals[group[0]], thickness[group[0]], 0.5)
    )
    return tuple(_sunk(wall) for wall in walls)


def _sunk(wall: SlantedWall) -> SlantedWall:
    """The wall moved down until the drawn faces are in its middle."""
    place = wall.world_from_wall.copy()
    place[:3, 3] -= wall.drawn_mm * wall.inwards
    return replace(wall, world_from_wall=place)


def _planes(
    shown: Sequence[str],
    rings: Mapping[str, Sequence[Array]],
    inwards: Mapping[str, Array],
    thickness: Mapping[str, float],
) -> list[list[str]]:
    """Faces of one plane, sense and thickness together."""
    groups: list[list[str]] = []
    for id_ in shown:
        for group in groups:
            if thickness[group[0]] == thickness[id_] and _coplanar(
                rings[group[0]][0][0], inwards[group[0]], rings[id_][0][0], inwards[id_]
            ):
                group.append(id_)
                break
        else:
            groups.append([id_])
    return groups


def _unit(vector: Array) -> Array:
    return np.asarray(vector / np.linalg.norm(vector))


def _coplanar(p: Array, n: Array, q: Array, m: Array) -> bool:
    return bool(n @ m > 1 - 1e-9) and abs(float(n @ (q - p))) < SNAP_MM / 10


def _walls(
    group: Sequence[str],
    placed: Mapping[str, Sequence[Array]],
    inwards: Array,
    thickness: float,
    share: float,
) -> list[SlantedWall]:
    """One wall for each set of touching faces of one plane, a share of it above the drawn one.

    The rings of outer walls have moved outwards by that share already.
    """
    origin = placed[group[0]][0][0]
    up = np.array([0.0, 0.0, 1.0]) if abs(inwards[2]) < 0.9 else np.array([0.0, 1.0, 0.0])
    y = _unit(up - inwards * (up @ inwards))
    place = np.eye(4)
    place[:3, :3] = np.array([np.cross(y, inwards), y, inwards]).T
    place[:3, 3] = origin
    polygons = {}
    for id_ in group:
        rings = [(ring - origin) @ place[:3, :2] for ring in placed[id_]]
        polygons[id_] = Polygon(rings[0], rings[1:])
        if not polygons[id_].is_valid:
            raise _CrossingError(
                "the outline crosses itself", (id_,), "draw the face's edges in order"
            )
    union = together(polygons.values())
    walls = []
    for part in shapely.get_parts(union):
        ids = [f for f in group if part.buffer(0.01).contains(polygons[f].representative_point())]
        polygon = tidy(part)
        outline = [np.array(r.coords)[:-1] for r in (polygon.exterior, *polygon.interiors)]
        walls.append(
            SlantedWall(tuple(ids), float(thickness), place, tuple(outline), share * thickness)
        )
    return walls


def _turned_round(
    model: Model,
    face: str,
    drawn: Mapping[str, Sequence[Array]],
    moved: Mapping[str, Sequence[Sequence[Array]]],
) -> tuple[tuple[str, float], ...]:
    """The edges that run the other way after a face was moved outwards, and how long they are."""
    names = {frozenset(ends): id_ for id_, ends in model.edges.items()}
    found = []
    loops = (model.faces[face].loop, *model.faces[face].holes)
    for loop, ring, chains in zip(loops, drawn[face], moved[face], strict=True):
        for n in range(len(loop)):
            m = (n + 1) % len(loop)
            edge = ring[m] - ring[n]
            if (chains[m][0] - chains[n][-1]) @ edge < 0:
                id_ = names.get(frozenset((loop[n], loop[m])), f"{loop[n]}-{loop[m]}")
                found.append((id_, float(np.linalg.norm(edge))))
    return tuple(found)


def _moved_across(
    error: _CrossingError, turned: Sequence[tuple[str, float]], move_mm: float
) -> FabricationError:
    """Why a face's outline crosses itself: as drawn, or because its edges are too short."""
    if not turned:
        return error
    shortest = min(length for _, length in turned)
    return FabricationError(
        f"for material outside of the face or in its middle, its outline moves by {move_mm:.4g} mm "
        f"and crosses itself: an edge of {shortest:.1f} mm would run the other way",
        (*error.ids, *(id_ for id_, _ in turned)),
        "side inside, or thinner plates",
    )


def _with_common_corners(walls: Sequence[SlantedWall]) -> tuple[SlantedWall, ...]:
    """The walls with each other's corners on their edges, so that seams are whole edges."""
    if not walls:
        return ()
    corners = np.vstack([wall.in_world(ring) for wall in walls for ring in wall.rings])
    result = []
    for wall in walls:
        local = (corners - wall.world_from_wall[:3, 3]) @ wall.world_from_wall[:3, :3]
        flat = local[np.abs(local[:, 2]) < 1e-4][:, :2]
        rings = tuple(_split(ring, flat) for ring in wall.rings)
        result.append(replace(wall, rings=rings))
    return tuple(result)


def _split(ring: Array, corners: Array) -> Array:
    points: list[Array] = []
    for a, b in pairwise([*ring, ring[0]]):
        length = float(np.linalg.norm(b - a))
        along = (corners - a) @ (b - a) / length
        off = np.abs((corners - a) @ np.array([-(b - a)[1], (b - a)[0]])) / length
        within = (off < 1e-4) & (along > 1e-3) & (along < length - 1e-3)
        inner = along[within][np.unique(np.round(along[within], 3), return_index=True)[1]]
        points += [a, *(a + (b - a) * s / length for s in inner)]
    return np.array(points)
