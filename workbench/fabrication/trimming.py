"""Plates at any angles, kept out of one another where more than two meet in a point.

Terms
-----
shadow
    What must be cut from a plate to be rid of a part of its body: the cut is square to it.
"""

from __future__ import annotations

from collections.abc import Sequence

import manifold3d
import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.union_find import UnionFind
from ...solver.values import Array
from .errors import FabricationError
from .joints import JointPlan
from .overlays import without
from .prisms import prism
from .seams import Corner, Seams, edge_frame, find_corners
from .slanted_walls import SlantedWall

#: Plates may share so little, mm3: rounding.
OVERLAP_MM3 = 1e-6
#: Plates may lie so far on the wrong side of the drawn faces.
_TOUCH_MM, _LEAST_WRONG_MM3 = 1e-3, 1e-4
#: A plate that takes less than this part of what another takes is not named beside it.
_LEAST_TAKEN = 0.1


def plate_body(wall: SlantedWall, outline: Polygon) -> manifold3d.Manifold:
    """A wall's plate in the world."""
    return prism(outline, 0.0, wall.thickness_mm).transform(wall.world_from_wall[:3])


def pointed(
    walls: Sequence[SlantedWall], seams: Seams, outlines: Sequence[Polygon]
) -> list[Polygon]:
    """The outlines without what sticks out where more than three plates come to a point.

    A plate keeps behind its neighbours by its tips; behind the others it is kept here. Corners
    nearer to one another than plates are thick count as one.
    """
    result = list(outlines)
    all_convex = all(seam.theta_rad < np.pi for seam in seams.values())
    for corners in _clusters(find_corners(walls), walls):
        numbers = dict.fromkeys(w for corner in corners for w in corner.walls)
        edges = [edge for corner in corners for edge in corner.edges]
        convex = all(seams[e].theta_rad < np.pi for e in edges if e in seams)
        if len(numbers) < 4 or not convex:
            continue
        lengths = sorted(edge_frame(walls[w], r, e)[3] for w, r, e in edges)
        long = [length for length in lengths if length > _short(walls)] or lengths[-1:]
        reach = 4 * lengths[-1] if all_convex else long[0] / 2
        for w in numbers:
            for other in numbers:
                outside = _outside(walls[other], corners[0].point, reach)
                shared = plate_body(walls[w], result[w]) ^ outside
                if w != other and shared.volume() > OVERLAP_MM3:
                    result[w] = without(result[w], shadow_of(walls[w], shared))
    return result


def on_its_side(
    walls: Sequence[SlantedWall],
    outlines: Sequence[Polygon],
    drawn: manifold3d.Manifold | None,
    side: str,
) -> list[Polygon]:
    """The outlines without what would lie on the wrong side of the drawn faces.

    That can be where edges that look outwards and inwards meet in one vertex.
    """
    result = list(outlines)
    if drawn is None or side == "middle":
        return result
    for n, wall in enumerate(walls):
        # Smaller by a little, for it touches the drawn faces.
        core = result[n].buffer(-_TOUCH_MM, join_style="mitre")
        body = prism(core, _TOUCH_MM, wall.thickness_mm - _TOUCH_MM)
        body = body.transform(wall.world_from_wall[:3])
        wrong = body - drawn if side == "inside" else body ^ drawn
        if wrong.volume() > _LEAST_WRONG_MM3:
            lost = shadow_of(wall, wrong).buffer(_TOUCH_MM, join_style="mitre")
            result[n] = without(result[n], lost)
    return result


def _short(walls: Sequence[SlantedWall]) -> float:
    """Corners nearer to one another than this count as one, mm."""
    return 2 * max(wall.thickness_mm for wall in walls)


def _clusters(corners: Sequence[Corner], walls: Sequence[SlantedWall]) -> list[list[Corner]]:
    points = np.array([corner.point for corner in corners])
    sets = UnionFind(len(corners))
    for k, point in enumerate(points):
        near = np.linalg.norm(points[:k] - point, axis=1) < _short(walls)
        for other in np.flatnonzero(near).tolist():
            if {*corners[k].walls} & {*corners[other].walls}:
                sets.union(k, other)
    groups: dict[int, list[Corner]] = {}
    for corner, label in zip(corners, sets.labels(), strict=True):
        groups.setdefault(label, []).append(corner)
    return list(groups.values())


def _outside(wall: SlantedWall, point: Array, reach: float) -> manifold3d.Manifold:
    """What lies beyond a wall's outer plane, near a point."""
    cube = manifold3d.Manifold.cube([2 * reach] * 3, center=True).translate(point)
    return cube.trim_by_plane(-wall.inwards, float(-wall.inwards @ wall.world_from_wall[:3, 3]))


def shadow_of(wall: SlantedWall, solid: manifold3d.Manifold) -> Polygon:
    """What must be cut from a wall to be rid of a part of its body: the cut is square to it."""
    back = np.linalg.inv(wall.world_from_wall)[:3]
    return _polygon(solid.transform(back).project()).buffer(1e-4, join_style="mitre")


def trimmed_at_openings(
    walls: Sequence[SlantedWall],
    openings: Sequence[SlantedWall],
    outlines: Sequence[Polygon],
    first: int,
) -> list[Polygon]:
    """The outlines of partitions (from number `first` on) that do not stick out of openings."""
    result = list(outlines)
    for n in range(first, len(walls)):
        for opening in openings:
            body = plate_body(walls[n], result[n])
            beyond = body.trim_by_plane(
                -opening.inwards, float(-opening.inwards @ opening.world_from_wall[:3, 3])
            )
            region = plate_body(
                SlantedWall((), 2 * walls[n].thickness_mm, _behind(opening, walls[n]), ()),
                Polygon(opening.rings[0]).buffer(walls[n].thickness_mm, join_style="mitre"),
            )
            shared = beyond ^ region
            if shared.volume() > OVERLAP_MM3:
                result[n] = without(result[n], shadow_of(walls[n], shared))
    return result


def _behind(opening: SlantedWall, wall: SlantedWall) -> Array:
    """The frame of the space just outside of an opening."""
    place = opening.world_from_wall.copy()
    place[:3, 3] -= 2 * wall.thickness_mm * opening.inwards
    return place


def trimmed(
    walls: Sequence[SlantedWall], outlines: Sequence[Polygon], plan: JointPlan
) -> list[Polygon]:
    """The outlines without what overlaps a lower plate: the shadow of it, square to the sheet.

    Where it would be a hole in the higher plate, the lower one ends on it and is cut instead.
    """
    result = list(outlines)
    bodies = [plate_body(wall, outline) for wall, outline in zip(walls, result, strict=True)]
    for high in range(len(walls)):
        for low in range(high):
            shared = bodies[low] ^ bodies[high]
            if shared.volume() <= OVERLAP_MM3:
                continue
            ends, passes = high, low
            if _well_inside(walls[high], shared) and not _well_inside(walls[low], shared):
                ends, passes = low, high
            shadow = shadow_of(walls[ends], shared)
            share = shadow.area / max(result[ends].area, OVERLAP_MM3)
            if share > 0.5:
                one, two = walls[passes], walls[ends]
                ids = (one.face_ids[0], two.face_ids[0])
                raise FabricationError(
                    f"the plates would lie in one another: {ids[0]} takes {share:.0%} of "
                    f"{ids[1]}, with {one.thickness_mm:g} and {two.thickness_mm:g} mm",
                    (*ids, *plan.edges_between(ids)),
                    "thinner plates",
                )
            result[ends] = without(result[ends], shadow)
            bodies[ends] = plate_body(walls[ends], result[ends])
    return result


def _well_inside(wall: SlantedWall, solid: manifold3d.Manifold) -> bool:
    """Whether a part of a wall's body is nowhere nearer to its border than the wall is thick."""
    core = Polygon(wall.rings[0]).buffer(-wall.thickness_mm, join_style="mitre")
    return bool(core.contains(shadow_of(wall, solid)))


def takers_of(
    n: int, area: shapely.Geometry, walls: Sequence[SlantedWall], outlines: Sequence[Polygon]
) -> list[int]:
    """The one or two plates with most of the space where a part of another would be."""
    place = prism(area, 0.0, walls[n].thickness_mm).transform(walls[n].world_from_wall[:3])
    taken = {
        w: (place ^ plate_body(wall, outlines[w])).volume()
        for w, wall in enumerate(walls)
        if w != n and not outlines[w].is_empty
    }
    most = sorted(taken, key=lambda w: -taken[w])[:2]
    return [w for w in most if taken[w] > max(_LEAST_TAKEN * taken[most[0]], _LEAST_WRONG_MM3)]


def without_pinholes(
    walls: Sequence[SlantedWall], outlines: Sequence[Polygon], slotted: Sequence[Polygon]
) -> list[Polygon]:
    """The outlines without the thin rims around holes that trimming left near a border.

    What another plate's corner takes of a plate opens through the border then. Holes that were
    drawn, and slots, stay.

    Parameters
    ----------
    walls : sequence of SlantedWall
    outlines : sequence of Polygon
    slotted : sequence of Polygon
        With the slots cut and nothing trimmed.
    """
    result = list(outlines)
    for n, (wall, outline) in enumerate(zip(walls, outlines, strict=True)):
        for part in shapely.get_parts(outline):
            border = part.exterior
            for ring in part.interiors:
                hole = Polygon(ring)
                trimmed_off = hole.intersection(slotted[n]).area > 0.5 * hole.area
                if trimmed_off and border.distance(ring) < wall.thickness_mm:
                    result[n] = result[n].difference(_rim(part, hole, wall.thickness_mm))
    return result


def _rim(part: Polygon, hole: Polygon, thickness: float) -> Polygon:
    """What is thinner than a thickness around a hole."""
    half = 0.51 * thickness
    kept = part.buffer(-half, join_style="mitre").buffer(half, join_style="mitre")
    around = hole.buffer(1.1 * thickness, join_style="mitre")
    return around.difference(kept)


def _polygon(section: manifold3d.CrossSection) -> Polygon:
    rings = [Polygon(ring) for ring in section.to_polygons() if len(ring) > 2]
    return shapely.union_all([ring.buffer(0) for ring in rings])
