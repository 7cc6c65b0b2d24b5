"""Walls: the faces to be made, merged, flat, each with the side on which its material lies.

Terms
-----
wall
    Faces that touch in one plane and have one thickness: what will be one plate.
region
    A wall's polygon in its plane. Its coordinates (u, v) are the frame's axes (k + 1) % 3 and
    (k + 2) % 3, where k is the axis of the wall's normal.
slab
    The region made thick: from `low_mm` to `high_mm` along the axis k.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import Polygon, box

from ...solver.model import Model, ModelFace
from ...solver.values import Array
from .errors import FabricationError, NotRightAngledError
from .frame import AXIS_TOLERANCE, Frame, newell, snapped
from .sides import face_sides

#: Coordinates of regions are multiples of this, mm.
GRID_MM = 1e-6
_ONE_PLACE_MM = 1e-8
#: Shorter sides come from rounding.
_SPECK_MM = 1e-5
#: A notch is made deeper by less than any machine can tell.
_NOTCH_MM = 1e-3


@dataclass(frozen=True, slots=True)
class Wall:
    """One flat wall with material, in the frame.

    Parameters
    ----------
    face_ids : tuple of str
    axis : int
        The frame's axis of its normal.
    drawn_mm : float
        Where the drawn faces lie on that axis.
    low_mm, high_mm : float
        From where to where the material goes.
    side : int
        1 or -1: the object lies up or down the axis; 0: a partition.
    region : Polygon
        Lengthened through the walls that it meets.
    drawn : Polygon
        As it was drawn.
    """

    face_ids: tuple[str, ...]
    axis: int
    drawn_mm: float
    low_mm: float
    high_mm: float
    side: int
    region: Polygon
    drawn: Polygon

    @property
    def thickness_mm(self) -> float:
        """Its thickness."""
        return self.high_mm - self.low_mm

    @property
    def plane_axes(self) -> tuple[int, int]:
        """The frame's axes of its region's coordinates."""
        return (self.axis + 1) % 3, (self.axis + 2) % 3


@dataclass(frozen=True, slots=True, eq=False)
class _FlatFace:
    id: str
    axis: int
    at_mm: float
    thickness_mm: float
    side: int
    region: Polygon


def find_walls(model: Model, frame: Frame, side: str) -> tuple[Wall, ...]:
    """The walls of a right-angled model.

    Parameters
    ----------
    model : Model
    frame : Frame
    side : str
        ``inside``, ``outside`` or ``middle``: where the material of outer walls lies.

    Returns
    -------
    tuple of Wall
        In the order of the model's faces. A wall that is partly a partition and partly an outer
        wall lies as the outer wall does.
    """
    points = snapped(model, frame)
    made = [id_ for id_, face in model.faces.items() if face.included]
    loops = {id_: _loops(face, points) for id_, face in model.faces.items()}
    sides = face_sides(loops, made)
    flats = [_flat_face(id_, model.faces[id_], loops[id_], sides[id_]) for id_ in made]
    walls = [wall for group in _planes(flats, side) for wall in _merged(group, side)]
    first = {id_: i for i, id_ in enumerate(made)}
    walls.sort(key=lambda wall: first[wall.face_ids[0]])
    return tuple(extended(wall, walls) for wall in walls)


def _loops(face: ModelFace, points: Mapping[str, Array]) -> tuple[Array, ...]:
    return tuple(np.array([points[v] for v in loop]) for loop in (face.loop, *face.holes))


def _flat_face(id_: str, face: ModelFace, loops: tuple[Array, ...], side: int) -> _FlatFace:
    normal = newell(loops[0])
    axis = int(np.argmax(np.abs(normal)))
    heights = np.concatenate([loop[:, axis] for loop in loops])
    across = float(np.max(np.abs(np.delete(normal, axis))))
    if np.ptp(heights) > 0 or across > AXIS_TOLERANCE * float(np.linalg.norm(normal)):
        raise NotRightAngledError(
            f"the face is {np.ptp(heights):.2g} mm off its plane",
            (id_,),
            "right-angle annotations, so that it becomes flat",
        )
    if not face.thickness_mm > 0:
        raise FabricationError("the face has no thickness", (id_,), "a thickness above 0 mm")
    flat = [loop[:, [(axis + 1) % 3, (axis + 2) % 3]] for loop in loops]
    region = Polygon(flat[0], flat[1:])
    if not region.is_valid:
        raise FabricationError(
            "the outline crosses itself", (id_,), "draw the face's edges in order, without crossing"
        )
    sense = 1 if normal[axis] > 0 else -1
    return _FlatFace(id_, axis, float(heights[0]), float(face.thickness_mm), sense * side, region)


def _planes(flats: list[_FlatFace], side: str) -> list[list[_FlatFace]]:
    """Faces of one plane and one thickness together.

    Outer faces whose insides lie opposite ways stay apart (their slabs touch in the plane only,
    unless the material lies in the middle);
    a partition that touches outer faces goes with those it touches most.
    """
    groups: dict[tuple[int, float, float], list[_FlatFace]] = {}
    for flat in flats:
        groups.setdefault((flat.axis, flat.at_mm, flat.thickness_mm), []).append(flat)
    result = []
    for group in groups.values():
        if side == "middle" or not {1, -1} <= {flat.side for flat in group}:
            result.append(group)
        else:
            goes_with = _sides_of_partitions(group)
            result += [[f for f in group if goes_with[f.id] == s] for s in (1, -1, 0)]
    return [group for group in result if group]


def _sides_of_partitions(group: list[_FlatFace]) -> dict[str, int]:
    """For each face of a plane, on which side the wall lies of which it is a part."""
    outer = {s: shapely.union_all([f.region for f in group if f.side == s]) for s in (1, -1)}
    goes_with = {flat.id: flat.side for flat in group}
    partitions = [flat for flat in group if flat.side == 0]
    for part in shapely.get_parts(
        shapely.union_all([f.region for f in partitions], grid_size=GRID_MM)
    ):
        touching = {s: part.boundary.intersection(outer[s]).length for s in (1, -1)}
        best = max(touching, key=lambda s: touching[s])
        if touching[best] > 0:
            for flat in partitions:
                if part.covers(flat.region.representative_point()):
                    goes_with[flat.id] = best
    return goes_with


def _merged(group: list[_FlatFace], side: str) -> list[Wall]:
    """One wall for each set of touching faces."""
    union = shapely.union_all([flat.region for flat in group], grid_size=GRID_MM)
    walls = []
    parts = shapely.get_parts(union)
    for part in parts:
        faces = group if len(parts) == 1 else [f for f in group if _is_in(f.region, part)]
        outer = next((f.side for f in faces if f.side), 0)
        low, high = _interval(faces[0].at_mm, faces[0].thickness_mm, outer, side)
        ids = tuple(f.id for f in faces)
        drawn = tidy(part)
        walls.append(Wall(ids, faces[0].axis, faces[0].at_mm, low, high, outer, drawn, drawn))
    return walls


def _is_in(region: Polygon, part: Polygon) -> bool:
    return bool(part.distance(region.representative_point()) < 0.01)


def _interval(at: float, thickness: float, towards: int, side: str) -> tuple[float, float]:
    if towards == 0 or side == "middle":
        low = at - thickness / 2
    else:
        low = at if (towards > 0) == (side == "inside") else at - thickness
    # On the grid like all other coordinates: what the grid rounds is no border of a cell.
    low = round(low, 6)
    return low, round(low + round(thickness, 6), 6)


def tidy(polygon: Polygon) -> Polygon:
    """The same polygon without vertices in the middle of straight lines; ccw, holes cw."""
    # With few rings it is as quick to go through them.
    if len(polygon.interiors) < 3 or not _is_tidy(polygon):
        rings = [_straightened(np.array(ring.coords)[:-1]) for ring in _rings(polygon)]
        polygon = Polygon(rings[0], rings[1:])
    return shapely.geometry.polygon.orient(polygon)


def _is_tidy(polygon: Polygon) -> bool:
    """Whether there is nothing to be left out, looked at for all rings at once."""
    rings = _rings(polygon)
    counts = shapely.get_num_coordinates(rings)
    starts = np.concatenate(([0], np.cumsum(counts - 1)[:-1]))
    points = np.delete(shapely.get_coordinates(rings), np.cumsum(counts) - 1, axis=0)
    last = starts + counts - 2
    previous = np.arange(len(points)) - 1
    previous[starts] = last
    before = points - points[previous]
    following = np.arange(len(points)) + 1
    following[last] = starts
    apart = np.abs(before).max(axis=1) > _ONE_PLACE_MM
    return bool(apart.all() and not _turns_little(before, before[following]).any())


def without_specks(polygon: Polygon) -> Polygon:
    """The same polygon without sides that are nearly nothing; nowhere larger."""
    rings = [_without_specks(np.array(ring.coords)[:-1]) for ring in _rings(polygon)]
    return Polygon(rings[0], rings[1:])


def _without_specks(ring: Array) -> Array:
    """Of such a side that end goes that looks outwards; material is on the left.

    Where both ends look inwards, the sides beside it are lengthened until they meet.
    """
    while len(ring) > 3:
        ahead = np.concatenate((ring[1:], ring[:1])) - ring
        behind = np.concatenate((ahead[-1:], ahead[:-1]))
        convex = behind[:, 0] * ahead[:, 1] - behind[:, 1] * ahead[:, 0] > 0
        short = np.hypot(ahead[:, 0], ahead[:, 1]) < _SPECK_MM
        gone = convex & (short | np.concatenate((short[-1:], short[:-1])))
        if not gone.any():
            return _without_notch_ends(ring, np.flatnonzero(short).tolist())
        ring = np.delete(ring, int(gone.argmax()), axis=0)
    return ring


def _without_notch_ends(ring: Array, short: Sequence[int]) -> Array:
    """The ring whose short sides, at the ground of notches, have become points."""
    for k in reversed(short):
        a, b, c, d = (ring[(k + n) % len(ring)] for n in (-1, 0, 1, 2))
        (x, y), (u, v) = b - a, c - d
        across = x * v - y * u
        if len(ring) == 3 or across == 0:
            continue
        # Counted from b, in lengths of the side before it.
        further = ((c - b)[0] * v - (c - b)[1] * u) / across
        meeting = b + further * (b - a)
        if further >= 0 and np.abs(meeting - b).max() < _NOTCH_MM:
            ring = ring.copy()
            ring[k] = meeting
            ring = np.delete(ring, (k + 1) % len(ring), axis=0)
    return ring


def _rings(polygon: Polygon) -> list[shapely.LinearRing]:
    return [polygon.exterior, *polygon.interiors]


def _straightened(ring: Array) -> Array:
    # Of two points in one place neither would have a turn.
    apart = np.abs(ring - np.concatenate((ring[-1:], ring[:-1]))).max(axis=1) > _ONE_PLACE_MM
    ring = ring[apart]
    straight = _straight(ring)
    while straight.any():
        # Of neighbours one at a time: both ends of a very short side look straight, but where
        # both go, so does the corner that they make.
        first = straight & ~np.concatenate((straight[-1:], straight[:-1]))
        if not first.any():
            break
        ring = ring[~first]
        straight = _straight(ring)
    return ring


def _straight(ring: Array) -> NDArray[np.bool_]:
    before = ring - np.concatenate((ring[-1:], ring[:-1]))
    return _turns_little(before, np.concatenate((before[1:], before[:1])))


def _turns_little(before: Array, after: Array) -> NDArray[np.bool_]:
    turn = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    scale = np.hypot(before[:, 0], before[:, 1]) + np.hypot(after[:, 0], after[:, 1])
    return np.asarray(np.abs(turn) <= 1e-7 * scale)


def extended(wall: Wall, walls: list[Wall]) -> Wall:
    """The wall lengthened through the walls that it meets, so that no corner stays empty.

    Where an edge of the region lies in the plane of another wall and touches it, the region goes
    on to the far side of that wall's slab; between two such edges the corner is filled.
    """
    added: list[Polygon] = []
    for ring in _rings(wall.region):
        reach = _reach(np.array(ring.coords)[:-1], wall, walls)
        for i, pieces in enumerate(reach):
            added += [piece.strip() for piece in pieces]
            following = reach[(i + 1) % len(reach)]
            if pieces and following:
                added += _corner(pieces[-1], following[0])
    if not added:
        return wall
    region = shapely.union_all([wall.region, *added], grid_size=GRID_MM)
    return replace(wall, region=tidy(region))


@dataclass(frozen=True, slots=True, eq=False)
class _Reach:
    """A piece of an edge from `start` to `end`, to be moved by `move`."""

    start: Array
    end: Array
    move: Array

    def strip(self) -> Polygon:
        return Polygon([self.start, self.end, self.end + self.move, self.start + self.move])


def _corner(one: _Reach, two: _Reach) -> list[Polygon]:
    if np.abs(one.end - two.start).max() > GRID_MM or abs(one.move @ two.move) > GRID_MM:
        return []
    if one.move @ (two.end - two.start) > 0:  # a corner that looks inwards needs no filling
        return []
    return [box(*np.sort([one.end, one.end + one.move + two.move], axis=0).ravel())]


def _reach(ring: Array, wall: Wall, walls: list[Wall]) -> list[list[_Reach]]:
    """For each edge of a ring (material on its left) the pieces that must be moved outwards."""
    result = []
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        fixed = np.flatnonzero(np.abs(a - b) < GRID_MM)
        pieces: list[_Reach] = []
        if len(fixed) == 1:
            flat, along = int(fixed[0]), 1 - int(fixed[0])
            outward = np.array([(b - a)[1], -(b - a)[0]])
            sign = 1.0 if outward[flat] > 0 else -1.0
            for low, high, depth in _contacts(wall, walls, flat, a[flat], sign):
                start, end = np.clip([a[along], b[along]], low, high)
                if start != end:
                    ends = np.repeat([[a[flat], a[flat]]], 2, axis=0)
                    ends[:, along] = start, end
                    move = np.zeros(2)
                    move[flat] = sign * depth
                    pieces.append(_Reach(ends[0], ends[1], move))
        pieces.sort(key=lambda piece: float(np.abs(piece.start - a).max()))
        result.append(pieces)
    return result


def _contacts(
    wall: Wall, walls: list[Wall], flat: int, at: float, sign: float
) -> list[tuple[float, float, float]]:
    """Where the line of an edge touches other walls: from, to, and how deep to go on."""
    normal, run = wall.plane_axes[flat], wall.plane_axes[1 - flat]
    found = []
    for other in walls:
        depth = other.high_mm - at if sign > 0 else at - other.low_mm
        if other.axis != normal or abs(other.drawn_mm - at) > GRID_MM or depth <= GRID_MM:
            continue
        u = other.plane_axes[0]
        low, _, high, _ = other.region.bounds if u == run else _turned(other.region.bounds)
        ends = [(low - 1, wall.drawn_mm), (high + 1, wall.drawn_mm)]
        line = shapely.LineString(ends if u == run else [end[::-1] for end in ends])
        for part in shapely.get_parts(other.region.intersection(line)):
            if part.geom_type == "LineString" and not part.is_empty:
                span = part.bounds if u == run else _turned(part.bounds)
                found.append((span[0], span[2], depth))
    return found


def _turned(bounds: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
    return bounds[1], bounds[0], bounds[3], bounds[2]
