"""A hollow solid with walls of one thickness, for a 3D printer ([Lau10] 4.4).

Terms
-----
wall
    The material between the drawn faces and their copies, moved by its thickness.
opening
    A face left out: the hollow reaches through it.
window
    An opening that lies in one plane with a wall beside it; it is cut through that wall.
mouth
    Any other opening: the walls around it end there.

bead
    What joins walls that would touch in an edge only, which is no solid.

Walls of convex bodies lie between two sets of half-spaces, others are put together from pieces.
Both are made of triangles, and become faces of the kernel's at the end: its own thick solids crash
at some vertices, and fill a hollow or come out thinner than asked at others (`measured.md`).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from manifold3d import Manifold

from ...solver.model import Model
from ...solver.values import Array
from .booleans import hull, united
from .convex_walls import convex_wall, is_convex
from .enclosed import enclosed
from .errors import FabricationError
from .flat_solids import PartedError, TouchingError, kernel_solid
from .frame import newell
from .polyhedra import Polyhedron, polyhedron_of
from .settings import ShellSettings
from .sides import face_sides
from .turned import turned_solid
from .wall_pieces import built_wall
from .wall_slabs import is_window, partition_slab, window_slab

if TYPE_CHECKING:
    import cadquery as cq

_DEFAULTS = ShellSettings()
#: A smaller part of the block is no hollow.
_LEAST = 1e-6
#: Half the width of a bead, in walls: the print is there no thicker than elsewhere.
_BEAD = 0.25
#: So many walls thick, a shape is not too thin for them.
_ROOMY = 8.0


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
        Where the faces do not close, the walls are too thick for the object, or openings leave
        nothing or several parts of them.
    """
    if model.turned:
        return turned_solid(model, settings)
    body = polyhedron_of(model)
    placed = {id_: tuple(map(body.points, loops)) for id_, loops in body.skin.items()}
    sides = face_sides(placed, list(placed))
    block = enclosed(body.skin, body.vertices_mm, sides)
    if block is None:
        raise FabricationError(
            "the faces enclose no solid", body.skin, "faces that meet in their edges only"
        )
    outwards = {id_: -sides[id_] * _normal(loops[0]) for id_, loops in placed.items()}
    if settings.solid:
        return kernel_solid(block)
    if not body.partitions and len(body.openings) == len(body.skin):
        raise FabricationError("no face to make anything of", body.openings, "include a face")
    return _one_solid(_walls(body, block, outwards, settings), body, block, settings)


def _walls(
    body: Polyhedron, block: Manifold, outwards: Mapping[str, Array], settings: ShellSettings
) -> Manifold:
    """All walls, without their windows and with partitions."""
    windows = [id_ for id_ in body.openings if is_window(body, id_)]
    mouths = [id_ for id_ in body.openings if id_ not in windows]
    wall = settings.wall_mm
    high = {"inside": 0.0, "outside": wall, "middle": wall / 2}[settings.side]
    if is_convex(body, outwards):
        # Exact whatever meets in a vertex, and whole where openings part its faces.
        made = convex_wall(body, outwards, mouths, high - wall, high)
    else:
        made = built_wall(body, block, outwards, mouths, high - wall, high)
    if high < wall and (block - made).volume() < _LEAST * block.volume():
        raise _too_thick(body, wall)
    # Beyond the wall on both sides, but not further into the hollow than the wall is thick.
    for id_ in windows:
        made -= window_slab(body, id_, wall)
    # After the windows: a partition that ends at a window's border keeps both of its sides.
    slabs = [partition_slab(body, loops, wall) for loops in body.partitions.values()]
    return united([made, *(slab ^ block for slab in slabs)])


def _one_solid(
    walls: Manifold, body: Polyhedron, block: Manifold, settings: ShellSettings
) -> cq.Solid:
    """Walls as a solid; where they would touch in an edge only a bead joins them."""
    try:
        return kernel_solid(walls)
    except TouchingError as error:
        edges = error.edges_mm
    except PartedError as error:
        ids = [_face_of(body, corners) for corners in error.parts_mm]
        raise PartedError(error.parts_mm, ids) from error
    beads = united(_bead(edge, _BEAD * settings.wall_mm) for edge in edges)
    if settings.side == "inside":
        beads ^= block
    if settings.side == "outside" and not body.partitions:
        beads -= block
    try:
        return kernel_solid(united([walls, beads]))
    except TouchingError as error:
        names = list(body.vertices_mm)
        points = np.array(list(body.vertices_mm.values()))
        middles = error.edges_mm.mean(axis=1)
        near = np.linalg.norm(points - middles[:, None], axis=2).argmin(axis=1)
        ids = list(dict.fromkeys(names[n] for n in near))
        raise TouchingError(error.edges_mm, ids) from error


def _bead(edge: Array, radius: float) -> Manifold:
    """What lies around an edge."""
    way = (edge[1] - edge[0]) / np.linalg.norm(edge[1] - edge[0])
    across = np.linalg.svd(way[None])[2][1:]
    turns = np.arange(8) * np.pi / 4
    ring = radius * np.column_stack([np.cos(turns), np.sin(turns)]) @ across
    ends = [edge[0] - radius * way, edge[1] + radius * way]
    return hull(np.vstack([ring + end for end in ends]))


def _face_of(body: Polyhedron, corners: Array) -> str:
    """The face that is made of which walls with some corners are."""

    def off(id_: str) -> float:
        points = np.vstack([body.points(loop) for loop in body.skin[id_]])
        return float(np.linalg.norm(points[:, None] - corners, axis=2).min(axis=1).max())

    return min((id_ for id_ in body.skin if id_ not in body.openings), key=off)


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


def _normal(points: Array) -> Array:
    area = newell(points)
    return np.asarray(area / np.linalg.norm(area))
