"""A hollow solid with walls of one thickness, for a 3D printer ([Lau10] 4.4).

Terms
-----
wall
    The material between the drawn faces and their copies, moved by its thickness.
opening
    A face left out: the hollow reaches through it.
window
    An opening that lies in one plane with a wall beside it; it is cut through that wall.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, cast

import numpy as np
from manifold3d import Manifold, OpType

from ...solver.model import Model
from ...solver.values import Array
from .convex_walls import convex_wall, is_convex, solid_mesh
from .errors import FabricationError
from .flat_solids import InvalidSolidError, kernel_solid
from .frame import newell
from .offsetting import mixed_vertices
from .polyhedra import Loop, Polyhedron, area_vector, polyhedron_of
from .settings import ShellSettings
from .sides import face_sides
from .turned import turned_solid
from .wall_distance import ThinWallError, check_planes, check_wall
from .wall_pieces import built_wall

if TYPE_CHECKING:
    import cadquery as cq

_DEFAULTS = ShellSettings()
_EPS = 1e-6
#: So many walls thick, a shape is not too thin for them.
_ROOMY = 8.0
_NEAR_MM = 1e-4
#: Outlines are multiples of this.
_GRID_MM = 1e-7


def shell_solid(model: Model, settings: ShellSettings = _DEFAULTS) -> cq.Shape:
    """The model as one hollow solid.

    Parameters
    ----------
    model : Model
        Its faces must close; those left out are openings. Partitions become walls.
    settings : ShellSettings

    Returns
    -------
    cadquery.Shape
        One valid solid in world mm, its corners sharp, its walls exactly `wall_mm` thick; a little
        thicker right at vertices where edges look outwards and inwards.

    Raises
    ------
    FabricationError
        Where the faces do not close, or the walls are too thick for the object.
    """
    if model.turned:
        return turned_solid(model, settings)
    body = polyhedron_of(model)
    block = _block(body)
    if settings.solid:
        return block
    windows = [id_ for id_ in body.openings if _is_window(body, id_)]
    mouths = [id_ for id_ in body.openings if id_ not in windows]
    wall = settings.wall_mm
    outwards = _outwards(body)
    mixed = _mixed(body, outwards, mouths)
    moves = {"inside": [-wall], "outside": [wall], "middle": [-wall / 2, wall / 2]}[settings.side]
    try:
        # Of itself the kernel fails at mixed vertices.
        parts = [
            built_wall(body, outwards, mouths, move)
            if mixed
            else _hollow_or_built(block, body, outwards, mouths, move)
            for move in moves
        ]
    except (InvalidSolidError, ThinWallError):
        raise
    except FabricationError as error:
        raise _too_thick(body, wall) from error
    # Beyond the wall on both sides, but not further into the hollow than the wall is thick.
    holes = [_thick([body.points(loop) for loop in body.skin[id_]], -wall, wall) for id_ in windows]
    slabs = [_partition(body, loops, wall) for loops in body.partitions.values()]
    solid = _put_together(block, parts, holes, slabs)
    if len(solid.Solids()) != 1 or not solid.isValid():
        # The kernel's booleans fail where many faces nearly meet.
        with suppress(InvalidSolidError):
            solid = kernel_solid(_put_triangles_together(block, parts, holes, slabs))
    return _one_solid(solid, block)


def _put_together(
    block: cq.Shape, parts: Sequence[cq.Shape], holes: Sequence[cq.Shape], slabs: Sequence[cq.Shape]
) -> cq.Shape:
    """Walls without their windows, and with partitions."""
    solid = parts[0].fuse(*parts[1:]) if len(parts) > 1 else parts[0]
    for hole in holes:
        solid = solid.cut(hole)
    # After the windows: a partition that ends at a window's border keeps both of its sides.
    if slabs:
        solid = solid.fuse(*(slab.intersect(block) for slab in slabs))
    return solid.clean() if len(parts) > 1 or holes or slabs else solid


def _put_triangles_together(
    block: cq.Shape, parts: Sequence[cq.Shape], holes: Sequence[cq.Shape], slabs: Sequence[cq.Shape]
) -> Manifold:
    """The same of triangles."""
    made = Manifold.batch_boolean([solid_mesh(part) for part in parts], OpType.Add)
    for hole in holes:
        made -= solid_mesh(hole)
    whole = solid_mesh(block)
    return Manifold.batch_boolean([made, *(solid_mesh(slab) ^ whole for slab in slabs)], OpType.Add)


def _outwards(body: Polyhedron) -> dict[str, Array]:
    """Unit normals of the skin that look away from the object."""
    placed = {id_: tuple(map(body.points, loops)) for id_, loops in body.skin.items()}
    sides = face_sides(placed, list(placed))
    return {id_: -sides[id_] * _normal(loops[0]) for id_, loops in placed.items()}


def _mixed(
    body: Polyhedron, outwards: Mapping[str, Array], mouths: Sequence[str]
) -> dict[str, list[str]]:
    """Vertices where edges look outwards and inwards and the moved planes meet in no point."""
    inwards = {id_: -normal for id_, normal in outwards.items()}
    moves = {id_: 0.0 if id_ in mouths else 1.0 for id_ in body.skin}
    return mixed_vertices(body.vertices_mm, body.skin, inwards, moves)


def _too_thick(body: Polyhedron, wall: float) -> FabricationError:
    """Which part of the shape is too thin for its walls."""
    points = np.array(list(body.vertices_mm.values()))
    heights, opposite = {}, {}
    for id_, loops in body.skin.items():
        normal = _normal(body.points(loops[0]))
        along = (points - body.vertices_mm[loops[0][0]]) @ normal
        sense = 1.0 if along.max() > -along.min() else -1.0
        heights[id_] = float((sense * along).max())
        far = {
            v
            for v, x in zip(body.vertices_mm, sense * along, strict=True)
            if x > heights[id_] - 1e-3
        }
        opposite[id_] = [f for f, other in body.skin.items() if far >= set(other[0])]
    least = min(heights, key=lambda id_: heights[id_])
    if heights[least] > _ROOMY * wall:
        return FabricationError(
            f"no wall of {wall:g} mm can be made", (), "a thinner wall, or the other side"
        )
    return FabricationError(
        f"the wall of {wall:g} mm is too thick: the shape measures {heights[least]:.4g} mm here",
        (least, *opposite[least][:1]),
        "a thinner wall, or the other side",
    )


def _polygon(points: Array, holes: Iterable[Array] = ()) -> cq.Face:
    import cadquery as cq

    def wire(ring: Array) -> cq.Wire:
        return cq.Wire.makePolygon([cq.Vector(*p) for p in ring.tolist()], close=True)

    return cq.Face.makeFromWires(wire(points), [wire(hole) for hole in holes])


def _block(body: Polyhedron) -> cq.Solid:
    """The solid block, faces of one plane made one."""
    import cadquery as cq

    faces = [
        _polygon(body.points(loops[0]), map(body.points, loops[1:])) for loops in body.skin.values()
    ]
    shell = cq.Shell.makeShell(faces)
    block = cq.Solid.makeSolid(shell)
    if block.Volume() < 0:
        block = cq.Solid(block.wrapped.Reversed())
    block = cq.Solid(block.fix().clean().wrapped)
    if block.ShapeType() != "Solid" or not block.isValid() or block.Volume() < _EPS:
        raise FabricationError(
            "the faces enclose no solid", body.skin, "faces that meet in their edges only"
        )
    return block


def _hollow_or_built(
    block: cq.Solid,
    body: Polyhedron,
    outwards: Mapping[str, Array],
    mouths: Sequence[str],
    move: float,
) -> cq.Shape:
    """A convex body's moved half-spaces; else the kernel's walls, and where it fails our slabs."""
    from OCP.Standard import Standard_Failure
    from OCP.StdFail import StdFail_NotDone

    faults = (Standard_Failure, StdFail_NotDone, TypeError, ValueError)
    if is_convex(body, outwards):
        with suppress(FabricationError, *faults):
            return convex_wall(block, body, outwards, mouths, move)
    try:
        wall = _hollow(block, body, mouths, move)
        check_planes(wall, body, outwards, mouths, move)
        check_wall(wall, body, mouths, abs(move))
    except FabricationError as error:
        try:
            return built_wall(body, outwards, mouths, move)
        except (FabricationError, *faults):
            raise error from None
    return wall


def _hollow(block: cq.Solid, body: Polyhedron, mouths: Sequence[str], move: float) -> cq.Shape:
    """The walls between the block's surface and its copy moved by `move` (outwards where > 0)."""
    from OCP.Standard import Standard_Failure
    from OCP.StdFail import StdFail_NotDone

    removed = [_face_at(block, body, id_) for id_ in mouths]
    too_thick = FabricationError(
        f"no wall of {abs(move):g} mm can be made", (), "a thinner wall, or the other side"
    )
    try:
        # "intersection" keeps corners sharp and offsets planes exactly.
        hollow = block.hollow(removed, move, kind="intersection")
    except (Standard_Failure, StdFail_NotDone, ValueError) as error:
        raise too_thick from error
    whole, rest = block.Volume(), hollow.Volume()
    # The kernel may hand the block back unchanged, or turned inside out, and call it valid.
    fits = _EPS < rest < whole - _EPS if move < 0 else rest > _EPS
    if not fits or abs(rest - whole) < _EPS or not hollow.isValid():
        raise too_thick
    return cast("cq.Shape", hollow)


def _inner_point(points: Array) -> Array:
    """A point within a planar polygon of any form."""
    import shapely

    normal = _normal(points)
    along = points[1] - points[0]
    along = along / np.linalg.norm(along)
    axes = np.array([along, np.cross(normal, along)])
    spot = shapely.Polygon((points - points[0]) @ axes.T).representative_point()
    return np.asarray(points[0] + np.array([spot.x, spot.y]) @ axes)


def _normal(points: Array) -> Array:

    area = newell(points)
    return np.asarray(area / np.linalg.norm(area))


def _face_at(block: cq.Solid, body: Polyhedron, id_: str) -> cq.Face:
    """The block's face of which an opening is made."""
    import cadquery as cq

    point = cq.Vertex.makeVertex(*_inner_point(body.points(body.skin[id_][0])).tolist())
    return min(block.Faces(), key=lambda face: float(face.distance(point)))


def _is_window(body: Polyhedron, id_: str) -> bool:
    """Whether a face that is made touches an opening in its own plane."""
    loops, area = body.skin[id_], area_vector(body, id_)
    corners = {v for loop in loops for v in loop}
    plane = area / np.linalg.norm(area)
    at = float(plane @ body.vertices_mm[loops[0][0]])
    for other, other_loops in body.skin.items():
        if other in body.openings:
            continue
        shared = corners & {v for loop in other_loops for v in loop}
        points = np.vstack([body.points(loop) for loop in other_loops])
        if len(shared) > 1 and np.abs(points @ plane - at).max() < 1e-4:
            return True
    return False


def _partition(body: Polyhedron, loops: Sequence[Loop], wall: float) -> cq.Solid:
    """A partition's wall, long enough to reach the block's surface where it leans on it."""
    import shapely

    rings = [body.points(loop) for loop in loops]
    normal = _normal(rings[0])
    along = (rings[0][1] - rings[0][0]) / np.linalg.norm(rings[0][1] - rings[0][0])
    axes = np.array([along, np.cross(normal, along)])
    flat = [(ring - rings[0][0]) @ axes.T for ring in rings]
    outer = shapely.Polygon(flat[0])
    grown = outer.buffer(wall, join_style="mitre")
    for n in range(len(rings[0])):
        ends = [n - 1, n]
        if not _on_skin(body, rings[0][ends]):
            side = shapely.LineString(flat[0][ends]).buffer(wall, cap_style="square")
            grown = grown.difference(side.difference(outer))
    # Rounding may leave a side that goes out and back: of such a wire the kernel makes no solid.
    parts = shapely.get_parts(shapely.set_precision(grown, _GRID_MM))
    part = max(parts, key=lambda one: one.area)
    ring = shapely.get_coordinates(part.exterior)[:-1] @ axes + rings[0][0]
    return _thick([ring, *rings[1:]], -wall / 2, wall / 2)


def _on_skin(body: Polyhedron, ends: Array) -> bool:
    """Whether an edge lies on the block's surface."""
    import shapely

    for loops in body.skin.values():
        rings = [body.points(loop) for loop in loops]
        normal = _normal(rings[0])
        if np.abs((ends - rings[0][0]) @ normal).max() > _NEAR_MM:
            continue
        along = (rings[0][1] - rings[0][0]) / np.linalg.norm(rings[0][1] - rings[0][0])
        axes = np.array([along, np.cross(normal, along)])
        flat = [(ring - rings[0][0]) @ axes.T for ring in rings]
        middle = (ends.mean(axis=0) - rings[0][0]) @ axes.T
        if shapely.Polygon(flat[0], flat[1:]).distance(shapely.Point(middle)) < _NEAR_MM:
            return True
    return False


def _thick(rings: Sequence[Array], low: float, high: float) -> cq.Solid:
    """A polygon made thick, from `low` to `high` along its normal."""
    import cadquery as cq

    normal = _normal(rings[0])
    start, way = normal * low, normal * (high - low)
    face = _polygon(rings[0] + start, [ring + start for ring in rings[1:]])
    return cq.Solid.extrudeLinear(face, cq.Vector(*way.tolist()))


def _one_solid(shape: cq.Shape, block: cq.Solid) -> cq.Shape:
    solids = shape.Solids()
    if len(solids) != 1 or not solids[0].isValid():
        raise FabricationError(
            f"the walls make {len(solids)} solids instead of one",
            (),
            "a thinner wall, or partitions that stand at right angles to the walls they meet",
        )
    if solids[0].Volume() < _EPS * block.Volume():
        raise FabricationError("nothing is left of the walls", (), "a thicker wall")
    return solids[0]
