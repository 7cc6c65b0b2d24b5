"""Whether walls of prints are as thick as was asked: the kernel's are not always.

Terms
-----
copy
    The faces of a wall that lie on none of the drawn ones: its other surface.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ...solver.values import Array
from .errors import FabricationError
from .frame import newell
from .polyhedra import Polyhedron

if TYPE_CHECKING:
    import cadquery as cq

_NEAR_MM = 1e-4


class ThinWallError(FabricationError):
    """A wall that comes out thinner than asked; its id is the face there."""

    def __init__(self, face: str, least_mm: float, wall_mm: float) -> None:
        super().__init__(
            f"the wall comes out {least_mm:.4g} mm thick here, not {wall_mm:.4g} mm",
            (face,),
            "a thinner wall, or the other side",
        )


def check_wall(wall: cq.Shape, body: Polyhedron, mouths: Sequence[str], wall_mm: float) -> None:
    """Refuse a wall whose copy is anywhere nearer to the drawn faces than asked.

    Where faces are left out, the copy may reach the drawn faces beside them: its corners that lie
    in no plane of theirs are measured then.

    Parameters
    ----------
    wall : cadquery.Shape
    body : Polyhedron
    mouths : sequence of face ids
        They have no copy; the wall's rims lie in their planes.
    wall_mm : float

    Raises
    ------
    ThinWallError
        With the least distance, and the drawn face that it is measured from.
    """
    made = [id_ for id_ in body.skin if id_ not in mouths]
    copy, corners = _copy(wall, body, made, mouths)
    if not made or not copy:
        return
    gaps = {id_: np.hypot(*_off(corners, body, id_)) for id_ in made}
    rim = np.any([np.abs(_off(corners, body, id_)[0]) < _NEAR_MM for id_ in mouths], axis=0)
    nearest = {id_: float(gap[~rim].min(initial=np.inf)) for id_, gap in gaps.items()}
    if not mouths:
        nearest = {id_: min(gap, _gap(body, id_, copy)) for id_, gap in nearest.items()}
    least = min(nearest, key=lambda id_: nearest[id_])
    if nearest[least] < wall_mm - _NEAR_MM:
        raise ThinWallError(least, nearest[least], wall_mm)


def check_planes(
    wall: cq.Shape,
    body: Polyhedron,
    outwards: Mapping[str, Array],
    mouths: Sequence[str],
    move_mm: float,
) -> None:
    """Refuse a wall whose copy has a face in no moved plane of a drawn one.

    Parameters
    ----------
    wall : cadquery.Shape
        Sharp at all edges.
    body : Polyhedron
    outwards : mapping of face id to (3,) array
        Unit normals that look away from the object.
    mouths : sequence of face ids
    move_mm : float
        Outwards where positive.

    Raises
    ------
    ThinWallError
        With the distance from the drawn face whose moved plane is nearest.
    """
    made = [id_ for id_ in body.skin if id_ not in mouths]
    for face in _copy(wall, body, made, mouths)[0]:
        corners = np.array([v.toTuple() for v in face.Vertices()])
        heights = {
            id_: (corners - body.vertices_mm[body.skin[id_][0][0]]) @ outwards[id_] for id_ in made
        }
        errors = {id_: float(np.abs(some - move_mm).max()) for id_, some in heights.items()}
        best = min(errors, key=lambda id_: errors[id_])
        if errors[best] > _NEAR_MM:
            raise ThinWallError(best, float(np.abs(heights[best]).min()), abs(move_mm))


def _copy(
    wall: cq.Shape, body: Polyhedron, made: Sequence[str], mouths: Sequence[str]
) -> tuple[list[cq.Face], Array]:
    """A wall's faces that lie on no drawn one and in no mouth's plane, and their corners."""
    faces = wall.Faces()
    corners = [np.array([v.toTuple() for v in face.Vertices()]) for face in faces]
    ends = np.cumsum([0, *map(len, corners)])
    every = np.vstack(corners)
    drawn = np.zeros(len(faces), dtype=bool)
    for id_ in (*made, *mouths):
        along, beside = _off(every, body, id_)
        flat = np.maximum.reduceat(np.abs(along), ends[:-1]) < _NEAR_MM
        touches = np.minimum.reduceat(beside, ends[:-1]) < _NEAR_MM
        drawn |= flat & (touches | (id_ in mouths))
    rest = np.flatnonzero(~drawn)
    if not len(rest):
        return [], np.empty((0, 3))
    return [faces[n] for n in rest], np.vstack([corners[n] for n in rest])


def _off(points: Array, body: Polyhedron, id_: str) -> tuple[Array, Array]:
    """How far points lie from a face's plane, and in that plane from the face."""
    import shapely

    rings = [body.points(loop) for loop in body.skin[id_]]
    area, along = newell(rings[0]), rings[0][1] - rings[0][0]
    normal, along = area / np.linalg.norm(area), along / np.linalg.norm(along)
    axes = np.array([along, np.cross(normal, along)])
    flat = [(ring - rings[0][0]) @ axes.T for ring in rings]
    spots = shapely.points((points - rings[0][0]) @ axes.T)
    beside = shapely.distance(shapely.Polygon(flat[0], flat[1:]), spots)
    return (points - rings[0][0]) @ normal, np.asarray(beside)


def _gap(body: Polyhedron, id_: str, copy: Sequence[cq.Face]) -> float:
    import cadquery as cq

    rings = [[cq.Vector(*p) for p in body.points(loop).tolist()] for loop in body.skin[id_]]
    wires = [cq.Wire.makePolygon(ring, close=True) for ring in rings]
    drawn = cq.Face.makeFromWires(wires[0], wires[1:])
    return float(drawn.distance(cq.Compound.makeCompound(copy)))
