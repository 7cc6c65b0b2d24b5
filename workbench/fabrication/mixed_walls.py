"""Walls around vertices where some edges look outwards and others inwards.

The kernel's own offset gives up there, or falls. Here the wall is the union of one slab a face.

Terms
-----
slab
    A face, its moved copy and what lies between. Beside an edge it ends in the plane in which both
    neighbours' slabs end.
core
    What slabs leave open at a vertex whose moved planes meet in no point, for each slab ends in
    its own corner there: the hull of the vertex and these corners, and near it all that is within
    one thickness of its faces (prisms) and edges that look away (kites). So the wall is nowhere
    thinner than asked, and thicker there only.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import manifold3d
import numpy as np

from ...solver.values import Array
from .errors import FabricationError
from .frame import newell
from .meshes import welded
from .offsetting import moved_corners
from .polyhedra import Polyhedron

if TYPE_CHECKING:
    import cadquery as cq

#: The kernel's wall may differ from that of the same meshes by so much of the block's volume.
_SAME = 1e-6
_ONE_POINT_MM = 1e-6
_LEAST_MM3 = 1e-6

#: The kernel takes what is so nearly flat for flat.
_FLAT_MM = 1e-6
#: Outer ring and holes, (n, 3) each.
Rings = Sequence[Array]


class NoWallAroundError(FabricationError):
    """A vertex around which no wall can be made; its ids are faces there."""

    def __init__(self, vertex: str, faces: Iterable[str], wall_mm: float) -> None:
        super().__init__(
            f"no wall of {wall_mm:g} mm can be made around {vertex}, where edges look outwards and "
            "inwards",
            faces,
            "a solid print, no face left out, or plates",
        )


def mixed_wall(
    block: cq.Shape,
    body: Polyhedron,
    outwards: Mapping[str, Array],
    mouths: Sequence[str],
    move_mm: float,
) -> cq.Shape:
    """The wall between a block's faces and their copies.

    Parameters
    ----------
    block : cadquery.Shape
    body : Polyhedron
    outwards : mapping of face id to (3,) array
        Unit normals that look away from the object.
    mouths : sequence of face ids
        They get no slab.
    move_mm : float
        Outwards where positive.

    Returns
    -------
    cadquery.Shape

    Raises
    ------
    FabricationError
        Where the slabs bound no solid: the wall is too thick for the shape.
    NoWallAroundError
        Where a side of a slab is not flat: its moved edge goes another way than the drawn one.
    """
    sense = 1.0 if move_mm > 0 else -1.0
    inwards = {id_: -sense * normal for id_, normal in outwards.items()}
    moves = {id_: 0.0 if id_ in mouths else abs(move_mm) for id_ in body.skin}
    moved = moved_corners(body.vertices_mm, body.skin, inwards, moves)
    parts: list[cq.Shape] = [solid_of(polygons) for polygons in _slabs(body, moved, moves)]
    for v, corners in _open_vertices(body, moved, moves).items():
        parts += _core(v, corners, body, {f: -inwards[f] * moves[f] for f in moves if moves[f]})
    whole, every = solid_mesh(block), [solid_mesh(part) for part in parts]
    wanted = manifold3d.Manifold.batch_boolean(every, manifold3d.OpType.Add)
    wall = parts[0].fuse(*parts[1:])
    wall = wall.cut(block) if move_mm > 0 else wall.intersect(block)
    wanted = wanted - whole if move_mm > 0 else wanted ^ whole
    wall = wall.clean()
    if not wall.isValid() or abs(wall.Volume() - wanted.volume()) > _SAME * whole.volume():
        raise FabricationError(
            f"no wall of {abs(move_mm):g} mm can be made", (), "a thinner wall, or the other side"
        )
    return wall


def _slabs(
    body: Polyhedron, moved: Mapping[str, Sequence[list[Array]]], moves: Mapping[str, float]
) -> Iterator[list[Rings]]:
    """The polygons around each slab."""
    for id_, loops in body.skin.items():
        if not moves[id_]:
            continue
        polygons: list[Rings] = [
            [body.points(loop) for loop in loops],
            [np.vstack(chains) for chains in moved[id_]],
        ]
        for loop, chains in zip(loops, moved[id_], strict=True):
            for n, v in enumerate(loop):
                here, there = body.vertices_mm[v], body.vertices_mm[loop[(n + 1) % len(loop)]]
                chain, after = chains[n], chains[(n + 1) % len(loop)]
                side = np.array([here, there, after[0], chain[-1]])
                if not _is_flat(side):
                    raise NoWallAroundError(v, (id_,), moves[id_])
                polygons.append([side])
                polygons += [
                    [np.array([here, chain[k + 1], chain[k]])] for k in range(len(chain) - 1)
                ]
        yield polygons


def _is_flat(side: Array) -> bool:
    normal = np.cross(side[2] - side[0], side[3] - side[1])
    across = abs(float((side[1] - side[0]) @ normal)) / max(float(np.linalg.norm(normal)), 1e-12)
    return across < _FLAT_MM


def _open_vertices(
    body: Polyhedron, moved: Mapping[str, Sequence[list[Array]]], moves: Mapping[str, float]
) -> dict[str, Array]:
    """The vertices with a core, and the corners that slabs have there."""
    corners: dict[str, list[Array]] = {}
    for id_, loops in body.skin.items():
        for loop, chains in zip(loops, moved[id_], strict=True):
            for v, chain in zip(loop, chains, strict=True):
                if moves[id_]:
                    corners.setdefault(v, []).extend(chain)
    every = {v: np.array(some) for v, some in corners.items()}
    return {v: some for v, some in every.items() if np.ptp(some, axis=0).max() > _ONE_POINT_MM}


def _core(
    v: str, corners: Array, body: Polyhedron, moves: Mapping[str, Array]
) -> Iterator[cq.Shape]:
    """What belongs to a vertex's core; `moves` say where its faces go."""
    import cadquery as cq
    from scipy.spatial import ConvexHull, QhullError

    at = body.vertices_mm[v]
    points = np.vstack([at, corners])
    try:
        hull = ConvexHull(points)
    except QhullError:  # they lie in one plane: the hull holds nothing
        hull = None
    if hull is not None and hull.volume > _LEAST_MM3:
        yield solid_of([[points[triangle]] for triangle in hull.simplices])
    reach = float(np.linalg.norm(corners - at, axis=1).max())
    near = cq.Solid.makeBox(2 * reach, 2 * reach, 2 * reach, cq.Vector(*(at - reach).tolist()))
    beside: dict[str, list[tuple[Array, Array]]] = {}
    for id_, move in moves.items():
        for n, loop in enumerate(body.skin[id_]):
            if v not in loop:
                continue
            rings = [body.points(ring) for ring in body.skin[id_]]
            yield _pushed(rings, move).intersect(near)
            normal = newell(body.points(loop)) * (-1.0 if n else 1.0)
            k = loop.index(v)
            for w, sense in ((loop[k - 1], -1.0), (loop[(k + 1) % len(loop)], 1.0)):
                along = sense * (body.vertices_mm[w] - at)
                beside.setdefault(w, []).append((move, np.cross(normal, along)))
    for w, faces in beside.items():
        if len(faces) == 2 and faces[0][0] @ faces[1][1] < 0:
            (one, _), (two, _) = faces
            tip = (one + two) / (1 + one @ two / (one @ one))
            kite = np.array([at, at + one, at + tip, at + two])
            yield _pushed([kite], body.vertices_mm[w] - at).intersect(near)


def _pushed(rings: Rings, way: Array) -> cq.Solid:
    """The solid that a polygon leaves on its way."""
    import cadquery as cq

    wires = [_wire(ring) for ring in rings]
    return cq.Solid.extrudeLinear(wires[0], wires[1:], cq.Vector(*way.tolist()))


def _wire(ring: Array) -> cq.Wire:
    import cadquery as cq

    return cq.Wire.makePolygon([cq.Vector(*p) for p in ring.tolist()], close=True)


def solid_of(polygons: Sequence[Rings]) -> cq.Solid:
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
