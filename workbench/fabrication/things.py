"""Existing things: what was traced on the photo (construction geometry), as bodies in 3D.

Terms
-----
thing
    Traced edges that hang together, traced circles on one axis, or a traced surface of revolution.
kind
    ``block`` (faces that close, or that bound a convex body), ``cylinder`` (circles one above the
    other; a single one stands on the ground), ``surface`` (faces that bound nothing, and lone
    lines) or ``mark`` (all of it on the ground: a sheet of paper, a table's edge).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import manifold3d
import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.camera import Camera
from ...solver.faces import find_faces
from ...solver.graph import Face, Revolution, SketchGraph
from ...solver.model import turned_profile
from ...solver.solution import Solution
from ...solver.union_find import UnionFind
from ...solver.values import Array
from .booleans import hull
from .enclosed import enclosed, plane_axes
from .sides import face_sides

#: What lies no higher is on the ground, mm.
GROUND_MM = 1.0
#: Flat things and lines are taken so thick, mm.
FLAT_MM = 0.01
#: Circles belong together whose centres lie apart by less than this part of the larger radius.
_ONE_AXIS = 0.1
_CORNERS = 128


@dataclass(frozen=True, slots=True, eq=False)
class Thing:
    """One existing thing in the world.

    Parameters
    ----------
    id : str
        Of its first edge, circle or revolution.
    kind : str
        ``block``, ``cylinder``, ``surface`` or ``mark``.
    bodies : tuple of Manifold
        That together are the thing; empty for marks.
    points_mm : (n, 3) array
        Its corners.
    pixel_mm : float
        How much one pixel of the photo is there; 0 where no camera is known.
    """

    id: str
    kind: str
    bodies: tuple[manifold3d.Manifold, ...]
    points_mm: Array
    pixel_mm: float = 0.0

    @property
    def name(self) -> str:
        """What it is called: its kind and its id."""
        return f"{self.kind} {self.id}"


def existing_things(graph: SketchGraph, solution: Solution) -> tuple[Thing, ...]:
    """All traced things of a solved sketch.

    Parameters
    ----------
    graph : SketchGraph
    solution : Solution
        Converged.

    Returns
    -------
    tuple of Thing
        Blocks, surfaces and marks, then cylinders.
    """
    traced = set(graph.construction)
    # A mirrored edge `e7@a5` is construction where `e7` is.
    edges = {e: ends for e, ends in solution.edges.items() if e.split("@")[0] in traced}
    turned = graph.traced_revolutions
    used = {c for r in turned.values() for c in (r.ground, r.bottom, r.top)}
    used |= {v for r in turned.values() for v in r.profile}
    circles = [c for c in solution.circles if c.split("@")[0] in traced and c not in used]
    things = [_of_edges(part, solution) for part in _connected(edges) if not used & _ends(part)]
    things += [_of_revolution(id_, r, solution) for id_, r in turned.items()]
    things += [_of_circles(group, solution) for group in _stacks(circles, solution)]
    return tuple(things)


def _ends(edges: Mapping[str, tuple[str, str]]) -> set[str]:
    return {v for ends in edges.values() for v in ends}


def _connected(edges: Mapping[str, tuple[str, str]]) -> list[dict[str, tuple[str, str]]]:
    """The edges that hang together."""
    names = sorted(_ends(edges))
    number = {name: k for k, name in enumerate(names)}
    sets = UnionFind(len(names))
    for v, w in edges.values():
        sets.union(number[v], number[w])
    labels = sets.labels()
    parts: dict[int, dict[str, tuple[str, str]]] = {}
    for id_, ends in edges.items():
        parts.setdefault(int(labels[number[ends[0]]]), {})[id_] = ends
    return list(parts.values())


def _pixel_mm(points: Array, camera: Camera | None) -> float:
    if camera is None:
        return 0.0
    away = camera.rotation_cam_from_world @ points.mean(axis=0)
    depth = float((away + camera.translation_cam_from_world_mm)[2])
    return float(max(depth, 0.0) / camera.focal_px)


def _of_edges(edges: Mapping[str, tuple[str, str]], solution: Solution) -> Thing:
    """The thing that connected edges draw."""
    vertices = {v: np.asarray(solution.vertices_mm[v]) for v in sorted(_ends(edges))}
    points, first = np.array(list(vertices.values())), next(iter(edges))
    pixel = _pixel_mm(points, solution.camera)
    if points[:, 2].max() <= GROUND_MM:
        return Thing(first, "mark", (), points, pixel)
    faces = find_faces(vertices, edges)
    body = _closed(faces, vertices) or _convex(faces, vertices)
    if body is not None:
        return Thing(first, "block", (body,), points, pixel)
    held = {frozenset(p) for f in faces.values() for loop in f.loops for p in _pairs(loop)}
    bodies = [_flat([_points(loop, vertices) for loop in f.loops]) for f in faces.values()]
    bodies += [
        _line(vertices[v], vertices[w]) for v, w in edges.values() if frozenset((v, w)) not in held
    ]
    return Thing(first, "surface", tuple(bodies), points, pixel)


def _pairs(loop: Sequence[str]) -> Iterable[tuple[str, str]]:
    return pairwise((*loop, loop[0]))


def _points(loop: Sequence[str], vertices: Mapping[str, Array]) -> Array:
    return np.array([vertices[v] for v in loop])


def _closed(faces: Mapping[str, Face], vertices: Mapping[str, Array]) -> manifold3d.Manifold | None:
    """The body that faces enclose, where they close."""
    placed = {id_: tuple(_points(loop, vertices) for loop in f.loops) for id_, f in faces.items()}
    sides = face_sides(placed, list(placed)) if len(faces) > 3 else {}
    return enclosed({id_: face.loops for id_, face in faces.items()}, vertices, sides)


def _convex(faces: Mapping[str, Face], vertices: Mapping[str, Array]) -> manifold3d.Manifold | None:
    """The convex body on whose surface all corners and faces lie: unseen sides are not drawn."""
    points = np.array(list(vertices.values()))
    corner = _hidden_corner(faces, vertices)
    if corner is not None:
        points = np.vstack([points, corner])
    around = hull(points)
    size = float(np.ptp(points, axis=0).max())
    if len(faces) < 2 or around.is_empty() or around.volume() < 1e-6 * size**3:
        return None
    for face in faces.values():
        loop = _points(face.loop, vertices)
        heights = (points - loop[0]) @ plane_axes(loop)[2]
        if heights.min() < -1e-3 * size and heights.max() > 1e-3 * size:
            return None
    # A corner within the body would be a dent.
    for k in range(len(points)):
        rest = hull(np.delete(points, k, axis=0))
        if rest.volume() > around.volume() * (1 - 1e-9):
            return None
    return around


def _hidden_corner(faces: Mapping[str, Face], vertices: Mapping[str, Array]) -> Array | None:
    """The eighth corner of a box of which the three visible faces were traced."""
    if len(vertices) != 7 or len(faces) != 3 or any(len(f.loop) != 4 for f in faces.values()):
        return None
    common = set.intersection(*(set(f.loop) for f in faces.values()))
    if len(common) != 1:
        return None
    top = common.pop()
    beside = {v for f in faces.values() for pair in _pairs(f.loop) if top in pair for v in pair}
    beside.discard(top)
    return np.asarray(sum(vertices[v] for v in beside) - 2 * vertices[top])


def _flat(loops: Sequence[Array]) -> manifold3d.Manifold:
    """A face as a thin plate."""
    axes = plane_axes(loops[0])
    section = manifold3d.CrossSection(
        [(loop - loops[0][0]) @ axes[:2].T for loop in loops], manifold3d.FillRule.EvenOdd
    )
    place = np.column_stack([axes.T, loops[0][0] - FLAT_MM / 2 * axes[2]])
    return manifold3d.Manifold.extrude(section, FLAT_MM).transform(place)


def _line(start: Array, end: Array) -> manifold3d.Manifold:
    """An edge as a thin rod."""
    around = np.vstack([np.eye(3), -np.eye(3)]) * FLAT_MM / 2
    return hull(np.vstack([start + around, end + around]))


def _stacks(circles: Sequence[str], solution: Solution) -> list[list[str]]:
    """Circles one above the other, the lowest first."""
    stacks: list[list[str]] = []
    for id_ in sorted(circles, key=lambda c: float(solution.circles[c].center_mm[2])):
        circle = solution.circles[id_]
        for stack in stacks:
            below = solution.circles[stack[-1]]
            off = float(np.linalg.norm(circle.center_mm[:2] - below.center_mm[:2]))
            higher = circle.center_mm[2] - below.center_mm[2] > GROUND_MM
            if higher and off < _ONE_AXIS * max(circle.radius_mm, below.radius_mm):
                stack.append(id_)
                break
        else:
            stacks.append([id_])
    return stacks


def _ring(centre: Array, radius: float, height: float) -> Array:
    turns = np.linspace(0, 2 * np.pi, _CORNERS, endpoint=False)
    x, y = centre[0] + radius * np.cos(turns), centre[1] + radius * np.sin(turns)
    return np.array([x, y, np.full(_CORNERS, height)]).T


def _of_circles(circles: Sequence[str], solution: Solution) -> Thing:
    solved = [solution.circles[c] for c in circles]
    rings = [_ring(c.center_mm, c.radius_mm, float(c.center_mm[2])) for c in solved]
    pixel = _pixel_mm(np.vstack(rings), solution.camera)
    if len(rings) == 1 and rings[0][0, 2] <= GROUND_MM:
        return Thing(circles[0], "mark", (), rings[0], pixel)
    if len(rings) == 1:
        rings.insert(0, rings[0] * (1.0, 1.0, 0.0))
    return Thing(circles[0], "cylinder", _between(rings), np.vstack(rings), pixel)


def _between(rings: Sequence[Array]) -> tuple[manifold3d.Manifold, ...]:
    return tuple(hull(np.vstack(pair)) for pair in pairwise(rings))


def _of_revolution(id_: str, revolution: Revolution, solution: Solution) -> Thing:
    turned = turned_profile(revolution, solution)
    rows = turned.profile_rz_mm
    outline = Polygon([(0.0, rows[0, 1]), *rows.tolist(), (0.0, rows[-1, 1])]).buffer(0)
    sections = manifold3d.CrossSection(
        [np.array(part.exterior.coords)[:-1] for part in shapely.get_parts(outline)],
        manifold3d.FillRule.EvenOdd,
    )
    body = manifold3d.Manifold.revolve(sections, _CORNERS)
    x, y = turned.axis_mm.tolist()
    points = np.vstack([_ring(turned.axis_mm, r, z) for r, z in rows.tolist()])
    pixel = _pixel_mm(points, solution.camera)
    return Thing(id_, "cylinder", (body.translate((x, y, 0.0)),), points, pixel)
