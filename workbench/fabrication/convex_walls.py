"""Walls of convex prints where the kernel makes none: half-spaces, moved and intersected.

Terms
-----
half-space
    What lies behind a face's plane. A convex body is what all of its faces' half-spaces share, and
    so is its copy with the planes moved, however many of them meet in a vertex.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import manifold3d
import numpy as np

from ...solver.values import Array
from .errors import FabricationError
from .meshes import welded
from .polyhedra import Polyhedron

if TYPE_CHECKING:
    import cadquery as cq

_NEAR_MM = 1e-6
_FLAT_MM = 1e-5
_SAME = 1e-6


def is_convex(body: Polyhedron, outwards: Mapping[str, Array]) -> bool:
    """Whether all of a body lies behind each of its faces."""
    points = np.array([body.vertices_mm[v] for loops in body.skin.values() for v in loops[0]])
    limit = 1e-6 * float(np.ptp(points, axis=0).max())
    return all(
        float(((points - body.vertices_mm[loops[0][0]]) @ outwards[id_]).max()) < limit
        for id_, loops in body.skin.items()
    )


def convex_wall(
    block: cq.Shape,
    body: Polyhedron,
    outwards: Mapping[str, Array],
    mouths: Sequence[str],
    move_mm: float,
) -> cq.Shape:
    """The wall between a convex block's faces and their copies.

    Parameters
    ----------
    block : cadquery.Shape
    body : Polyhedron
    outwards : mapping of face id to (3,) array
        Unit normals that look away from the object.
    mouths : sequence of face ids
        The wall ends in their planes.
    move_mm : float
        Outwards where positive.

    Returns
    -------
    cadquery.Shape

    Raises
    ------
    FabricationError
        Where nothing is left between the moved planes.
    """
    far = 10 * abs(move_mm)
    planes = []
    for id_, loops in body.skin.items():
        # An opening goes on through its plane; outside of the faces the wall ends there.
        own = (far if move_mm < 0 else 0.0) if id_ in mouths else move_mm
        limit = float(outwards[id_] @ body.vertices_mm[loops[0][0]]) + own
        planes.append([*outwards[id_].tolist(), -limit])
    copy = _shared(np.array(planes), abs(move_mm))
    wall = copy.cut(block) if move_mm > 0 else block.cut(copy)
    whole, other = solid_mesh(block), solid_mesh(copy)
    wanted = (other - whole if move_mm > 0 else whole - other).volume()
    wall = wall.clean()
    if not wall.isValid() or abs(wall.Volume() - wanted) > _SAME * whole.volume():
        raise _no_wall(abs(move_mm))
    return wall


def _no_wall(wall_mm: float) -> FabricationError:
    return FabricationError(
        f"no wall of {wall_mm:g} mm can be made", (), "a thinner wall, or the other side"
    )


def _shared(planes: Array, wall_mm: float) -> cq.Solid:
    """The solid behind all planes (normals, and minus their limits)."""
    from scipy.optimize import linprog
    from scipy.spatial import ConvexHull, HalfspaceIntersection

    # The middle of the largest ball that they leave room for.
    ball = linprog(
        [0.0, 0.0, 0.0, -1.0],
        A_ub=np.column_stack([planes[:, :3], np.ones(len(planes))]),
        b_ub=-planes[:, 3],
        bounds=[(None, None)] * 3 + [(0.0, None)],
    )
    if ball.status != 0 or ball.x[3] < _NEAR_MM:
        raise _no_wall(wall_mm)
    points: list[Array] = []
    for point in HalfspaceIntersection(planes, ball.x[:3]).intersections:
        if not points or np.linalg.norm(np.array(points) - point, axis=1).min() > _NEAR_MM:
            points.append(point)
    corners = np.array(points)
    hull = ConvexHull(corners)
    solid = solid_of([[ring] for ring in _rings(corners, planes)])
    if solid.isValid() and abs(solid.Volume() - hull.volume) < _SAME * hull.volume:
        return solid
    return solid_of([[corners[triangle]] for triangle in hull.simplices])


def _rings(corners: Array, planes: Array) -> Iterator[Array]:
    """The corners in each plane, in order around its face."""
    found = set()
    for plane in planes:
        normal = plane[:3]
        here = np.flatnonzero(np.abs(corners @ normal + plane[3]) < _FLAT_MM)
        # Faces in one plane have one ring.
        if len(here) < 3 or tuple(here) in found:
            continue
        found.add(tuple(here))
        arms = corners[here] - corners[here].mean(axis=0)
        across = np.cross(normal, arms[0])
        turns = np.arctan2(arms @ across, arms @ arms[0])
        yield corners[here[np.argsort(turns)]]


def _wire(ring: Array) -> cq.Wire:
    import cadquery as cq

    return cq.Wire.makePolygon([cq.Vector(*p) for p in ring.tolist()], close=True)


def solid_of(polygons: Sequence[Sequence[Array]]) -> cq.Solid:
    """The solid that polygons bound, each an outer ring and holes."""
    import cadquery as cq

    faces = [cq.Face.makeFromWires(_wire(a), [*map(_wire, holes)]) for a, *holes in polygons]
    shell = cq.Shell.makeShell(faces)
    solid = cq.Solid.makeSolid(shell).fix()
    return cq.Solid(solid.wrapped.Reversed()) if solid.Volume() < 0 else cq.Solid(solid.wrapped)


def solid_mesh(solid: cq.Shape) -> manifold3d.Manifold:
    """A solid of flat faces as a mesh for booleans."""
    raw, faces = solid.tessellate(0.1, 0.1)
    mesh = welded([v.toTuple() for v in raw], faces)
    return manifold3d.Manifold(
        manifold3d.Mesh64(mesh.vertices_mm, mesh.triangles.astype(np.uint64))
    )
