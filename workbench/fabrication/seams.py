"""Where walls at any angle meet: seams and corners.

Terms
-----
seam
    An edge in which exactly two walls meet, or a wall and an opening.
corner
    A point in which walls meet.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ...solver.model import Model
from ...solver.values import Array
from .errors import FabricationError
from .frame import SNAP_MM
from .slanted_walls import SlantedWall

EdgeKey = tuple[int, int, int]  # wall, ring, edge


@dataclass(frozen=True, slots=True)
class Seam:
    """Where an edge of one wall meets an edge of another.

    Parameters
    ----------
    other : int
        The other wall's number.
    other_edge : tuple of (ring, edge)
        Its edge there; it runs the other way.
    theta_rad : float
        Interior dihedral angle.
    """

    other: int
    other_edge: tuple[int, int]
    theta_rad: float


Seams = dict[EdgeKey, Seam]


def find_seams(walls: Sequence[SlantedWall], names: EdgeNames) -> Seams:
    """The seams by (wall, ring, edge); edges that are not in it lie free.

    Parameters
    ----------
    walls : sequence of SlantedWall
    names : EdgeNames
        For an error.

    Raises
    ------
    FabricationError
        Where three or more walls meet in one edge.
    """
    places = _Places()
    users: dict[frozenset[int], list[tuple[int, int, int]]] = {}
    for w, wall in enumerate(walls):
        for r, ring in enumerate(wall.rings):
            keys = [places.number(point) for point in wall.in_world(ring)]
            for e, ends in enumerate(pairwise([*keys, keys[0]])):
                users.setdefault(frozenset(ends), []).append((w, r, e))
    seams = {}
    for places_of_ends, edges in users.items():
        if len(places_of_ends) < 2:  # all in one place: too short for a joint
            continue
        made = [edge for edge in edges if walls[edge[0]].thickness_mm > 0]
        edges = made if len(made) > 1 else edges
        if len(made) > 2:
            meeting = [walls[w] for w, _, _ in made]
            raise FabricationError(
                f"{len(made)} plates meet in one edge, and joints are of two",
                (*(wall.face_ids[0] for wall in meeting), *names.shared(meeting[0], meeting[1])),
                "leave one of the faces out",
            )
        if len(edges) == 2 and made:
            one, two = edges
            theta = _theta(walls[one[0]], one[1:], walls[two[0]], two[1:])
            seams[one] = Seam(two[0], two[1:], theta)
            seams[two] = Seam(one[0], one[1:], theta)
    return seams


@dataclass(frozen=True, slots=True, eq=False)
class Corner:
    """A point in which walls meet: their numbers, and their edges there."""

    point: Array
    walls: tuple[int, ...]
    edges: tuple[tuple[int, int, int], ...]


def find_corners(walls: Sequence[SlantedWall]) -> list[Corner]:
    """All corners of the walls."""
    places = _Places()
    found: dict[int, list[tuple[int, int, int]]] = {}
    for w, wall in enumerate(walls):
        for r, ring in enumerate(wall.rings):
            for e, point in enumerate(wall.in_world(ring)):
                key = places.number(point)
                # The edge that begins here and the one that ends here.
                found.setdefault(key, []).extend(((w, r, e), (w, r, (e - 1) % len(ring))))
    corners = []
    for key, edges in found.items():
        numbers = tuple(dict.fromkeys(w for w, _, _ in edges))
        corners.append(Corner(places.points[key], numbers, tuple(edges)))
    return corners


class EdgeNames:
    """Which of the sketch's edges lie on a line in which two walls meet.

    Parameters
    ----------
    model : Model
    """

    def __init__(self, model: Model) -> None:
        self.model = model

    def on(self, one: SlantedWall, two: SlantedWall, ends: Array) -> tuple[str, ...]:
        """The ids of edges along a line from one world point to another, (2, 3)."""
        vertices = self._vertices(one) & self._vertices(two)
        start, length = ends[0], float(np.linalg.norm(ends[1] - ends[0]))
        way = (ends[1] - ends[0]) / length
        found = []
        for id_, (v, w) in self.model.edges.items():
            points = np.array([self.model.vertices_mm[v], self.model.vertices_mm[w]]) - start
            low, high = sorted((points @ way).tolist())
            off = points - np.outer(points @ way, way)
            # Where material lies outside, seams lie beyond the drawn edges, but along them.
            near = np.abs(off).max() < SNAP_MM or {v, w} <= vertices
            straight = np.linalg.norm(off[1] - off[0]) < 1e-3 * max(high - low, SNAP_MM)
            if near and straight and min(high, length) - max(low, 0.0) > SNAP_MM:
                found.append(id_)
        return tuple(found)

    def between(
        self,
        partition: SlantedWall,
        carrier: SlantedWall,
        edge: tuple[Array, Array],
        span: tuple[float, float],
    ) -> tuple[str, ...]:
        """The same for a stretch of a partition's edge (its start and direction)."""
        start, along = edge
        flat = np.array([start + s * along for s in span])
        return self.on(
            partition, carrier, partition.in_world(flat) + partition.drawn_mm * partition.inwards
        )

    def shared(self, one: SlantedWall, two: SlantedWall) -> tuple[str, ...]:
        """The ids of the edges that the faces of two walls have in common."""
        vertices = self._vertices(one) & self._vertices(two)
        return tuple(id_ for id_, ends in self.model.edges.items() if {*ends} <= vertices)

    def _vertices(self, wall: SlantedWall) -> set[str]:
        faces = (self.model.faces[id_] for id_ in wall.face_ids)
        return {v for face in faces for loop in (face.loop, *face.holes) for v in loop}


class _Places:
    """Points by number; what lies closer than the snap has one number."""

    def __init__(self) -> None:
        self.points: list[Array] = []

    def number(self, point: Array) -> int:
        """The number of a point, a new one where it is new."""
        if self.points:
            gaps = np.abs(np.array(self.points) - point).max(axis=1)
            nearest = int(gaps.argmin())
            if gaps[nearest] < SNAP_MM:
                return nearest
        self.points.append(point)
        return len(self.points) - 1


def edge_frame(wall: SlantedWall, ring: int, edge: int) -> tuple[Array, Array, Array, float]:
    """Start, direction, direction into the wall, and length of an edge, in the wall's plane."""
    points = wall.rings[ring]
    start, end = points[edge], points[(edge + 1) % len(points)]
    length = float(np.linalg.norm(end - start))
    along = (end - start) / length
    return start, along, np.array([-along[1], along[0]]), length


def _theta(one: SlantedWall, e: tuple[int, int], two: SlantedWall, f: tuple[int, int]) -> float:
    """Interior dihedral angle between two walls at their common edge, rad."""
    into_one = one.world_from_wall[:3, :2] @ edge_frame(one, *e)[2]
    into_two = two.world_from_wall[:3, :2] @ edge_frame(two, *f)[2]
    angle = math.acos(float(np.clip(into_one @ into_two, -1.0, 1.0)))
    return angle if into_two @ one.inwards > 0 else 2 * math.pi - angle
