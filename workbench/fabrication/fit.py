"""Does it fit? The new object's parts against the existing things, in numbers.

Terms
-----
overlap
    What a part and a thing share; there both cannot be.
missing
    How far the thing reaches into the part, mm: for a plate the least way out of it, along its
    normal or in its plane; for a print the width of the overlap, which is at least so much. Of
    flat things it is how far the part reaches through them.
clearance
    The shortest distance between a thing and the object.
room
    For each way, how far the thing could move before it touches the object.
lift
    What stood on the ground before the object came stands on its lowest part afterwards, so much
    higher. Everything else is measured there.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import manifold3d
import numpy as np
import shapely
from shapely.geometry import MultiPoint, Polygon

from ...solver.values import Array
from .booleans import hull, united
from .overlays import sides_mm
from .parts_in_space import Part, corners, in_words, whole
from .plates import Plate
from .prisms import prism
from .things import FLAT_MM, Thing

#: Nearer than this is touching, and less overlap is none, mm.
TOUCH_MM = 0.05
#: No floor is thicker; what reaches higher into a thing is not what it stands on, mm.
LIFT_MM = 25.0
#: No floor is thinner.
FLOOR_STEP_MM = 0.4
#: Further than this nobody is in the way, mm.
FAR_MM = 1000.0
_STEP_MM = 0.02


@dataclass(frozen=True, slots=True, eq=False)
class Overlap:
    """What a part and a thing share.

    Parameters
    ----------
    part_id : str
    volume_mm3 : float
    missing_mm : float
        See the module's terms.
    body : Manifold
        For the eye.
    """

    part_id: str
    volume_mm3: float
    missing_mm: float
    body: manifold3d.Manifold


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """How one thing fits.

    Parameters
    ----------
    thing : Thing
    overlaps : tuple of Overlap
        The worst first; none where it fits.
    clearance_mm : float or None
        None where nothing is near, or it does not fit.
    nearest : str
        The part that is nearest.
    room_mm : mapping of way to mm or None
        None where the way is free. Empty where it does not fit.
    lift_mm : float
    """

    thing: Thing
    overlaps: tuple[Overlap, ...]
    clearance_mm: float | None = None
    nearest: str = ""
    room_mm: Mapping[str, float | None] = field(default_factory=dict)
    lift_mm: float = 0.0

    @property
    def fits(self) -> bool:
        """Whether it overlaps nothing."""
        return not self.overlaps

    @property
    def words(self) -> str:
        """One line about it."""
        name, pixel = self.thing.name, self.thing.pixel_mm
        if self.lift_mm:
            name += f" (which will stand {self.lift_mm:.1f} mm higher)"
        exact = f"; one pixel of the photo is {pixel:.2f} mm there" if pixel else ""
        if self.thing.kind == "mark":
            return f"{name}: lies on the ground, nothing runs into it"
        if self.overlaps:
            said = ", ".join(f"{o.missing_mm:.1f} mm into {o.part_id}" for o in self.overlaps)
            return f"{name}: does not fit, it reaches {said}{exact}"
        near = "nothing near"
        if self.clearance_mm is not None:
            near = f"{self.clearance_mm:.1f} mm from {self.nearest}"
            if self.clearance_mm < TOUCH_MM:
                near = f"touches {self.nearest}"
        room = f"; room: {in_words(self.room_mm)}" if self.room_mm else ""
        return f"{name}: fits, {near}{room}{exact}"


def fit_of(
    parts: Sequence[Part], things: Iterable[Thing], ways: Mapping[str, Array]
) -> tuple[Fit, ...]:
    """How each thing fits.

    Parameters
    ----------
    parts : sequence of Part
    things : iterable of Thing
    ways : mapping of name to unit vector
        Along which room is looked for.

    Returns
    -------
    tuple of Fit
        In the things' order.
    """
    things = tuple(things)
    every = whole(parts) if things else manifold3d.Manifold()
    return tuple(_fit(parts, every, thing, ways) for thing in things)


def _fit(
    parts: Sequence[Part], every: manifold3d.Manifold, thing: Thing, ways: Mapping[str, Array]
) -> Fit:
    if thing.kind == "mark":
        return Fit(thing, ())
    found = _overlaps(parts, thing)
    lift = _lift(found, thing)
    if lift:
        thing = _raised(thing, lift)
        found = _overlaps(parts, thing)
    if found:
        return Fit(thing, found, lift_mm=lift)
    gaps = {part.id: _gap(part, thing) for part in parts}
    nearest = min(gaps, key=lambda id_: gaps[id_])
    if gaps[nearest] >= FAR_MM:
        return Fit(thing, ())
    room = {way: _room(every, thing, direction) for way, direction in ways.items()}
    return Fit(thing, (), gaps[nearest], nearest, room, lift)


def _overlaps(parts: Sequence[Part], thing: Thing) -> tuple[Overlap, ...]:
    """What parts share with a thing, the worst first."""
    found = [o for part in parts if (o := _overlap(part, thing)) is not None]
    return tuple(sorted(found, key=lambda o: -o.missing_mm))


def _raised(thing: Thing, lift: float) -> Thing:
    move = np.array([0.0, 0.0, lift])
    bodies = tuple(body.translate(move) for body in thing.bodies)
    return replace(thing, bodies=bodies, points_mm=thing.points_mm + move)


def _lift(overlaps: Iterable[Overlap], thing: Thing) -> float:
    """How much higher a thing will stand: on what lies under most of it."""
    if thing.kind not in ("block", "cylinder"):
        return 0.0
    ground = float(thing.points_mm[:, 2].min())
    foot = sum(body.slice(ground + TOUCH_MM).area() for body in thing.bodies)
    return max([0.0, *(_floor(overlap.body, ground, foot / 2) for overlap in overlaps)])


def _floor(shared: manifold3d.Manifold, ground: float, least_mm2: float) -> float:
    """Up to where, above the ground, an overlap is as large as a floor; 0 where it is none."""
    # A turned thing's underside need not be quite on the ground.
    heights: list[float] = np.arange(TOUCH_MM / 2, LIFT_MM, FLOOR_STEP_MM).tolist()
    solid = [z for z in heights if shared.slice(ground + z).area() >= least_mm2]
    if not solid or shared.slice(ground + LIFT_MM).area() >= least_mm2:
        return 0.0
    low, high = solid[-1], solid[-1] + FLOOR_STEP_MM
    while high - low > 1e-4:
        middle = (low + high) / 2
        if shared.slice(ground + middle).area() < least_mm2:
            high = middle
        else:
            low = middle
    return high


def _gap(part: Part, thing: Thing) -> float:
    return float(min(part.body.min_gap(body, FAR_MM) for body in thing.bodies))


def _overlap(part: Part, thing: Thing) -> Overlap | None:
    body = united(part.body ^ body for body in thing.bodies)
    if body.is_empty() or body.volume() <= 0:
        return None
    if thing.kind == "surface":
        missing = max(_beyond(part, sheet) for sheet in thing.bodies)
    elif part.plate is not None:
        missing = max(_into_plate(part.plate, one, body) for one in thing.bodies)
    else:
        missing = max(_width(corners([one])) for one in body.decompose())
    return Overlap(part.id, body.volume(), missing, body) if missing > TOUCH_MM else None


def _beyond(part: Part, sheet: manifold3d.Manifold) -> float:
    """How far a part reaches through a flat thing: on the side on which less of it is.

    A lone line is in nobody's way; it only has its clearance.
    """
    points = corners([sheet])
    middle = points.mean(axis=0)
    _, _, axes = np.linalg.svd(points - middle, full_matrices=False)
    if np.ptp((points - middle) @ axes[1]) < 4 * FLAT_MM:
        return 0.0
    normal = axes[2]
    tall = np.eye(3) + (2 * FAR_MM / FLAT_MM - 1) * np.outer(normal, normal)
    column = sheet.transform(np.column_stack([tall, middle - tall @ middle]))
    heights = (corners([part.body ^ column]) - middle) @ normal
    return float(min(heights.max(), -heights.min())) if len(heights) else 0.0


def _into_plate(plate: Plate, thing: manifold3d.Manifold, shared: manifold3d.Manifold) -> float:
    """The least way of a thing out of a plate."""
    plate_from_world = np.linalg.inv(plate.world_from_plate)[:3]
    # Only what is above or below the plate counts, not what stands beside it.
    far = FAR_MM + plate.thickness_mm
    column = prism(Polygon(plate.outline), -far, far)
    near = corners([thing.transform(plate_from_world) ^ column])
    flat = corners([shared.transform(plate_from_world)])[:, :2]
    if not len(near) or not len(flat):
        return 0.0
    out = min(plate.thickness_mm - near[:, 2].min(), near[:, 2].max())
    rectangle = shapely.minimum_rotated_rectangle(MultiPoint(flat))
    if rectangle.geom_type != "Polygon":
        return 0.0
    return float(min(out, sides_mm(rectangle)[0]))


def _width(points: Array) -> float:
    """The least distance of two parallel planes that take in all points, one along a facet."""
    around = hull(points)
    if around.is_empty():
        return 0.0
    mesh = around.to_mesh64()
    a, b, c = (mesh.vert_properties[:, :3][mesh.tri_verts[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    sizes = np.linalg.norm(normals, axis=1)
    normals = normals[sizes > 1e-9] / sizes[sizes > 1e-9, None]
    heights = np.unique(np.round(normals, 6), axis=0) @ mesh.vert_properties[:, :3].T
    return float(np.ptp(heights, axis=1).min())


def _room(every: manifold3d.Manifold, thing: Thing, way: Array) -> float | None:
    """How far a thing can move along a way; None where nothing stops it."""
    slim = [_slimmer(body) for body in thing.bodies]
    # What it touches all around it shares a trace with, and is free to leave.
    least = 1e-6 + 1.01 * _swept(every, slim, 0 * way)
    if _swept(every, slim, way * FAR_MM) <= least:
        return None
    free, hit = 0.0, FAR_MM
    while hit - free > _STEP_MM:
        middle = (free + hit) / 2
        if _swept(every, slim, way * middle) > least:
            hit = middle
        else:
            free = middle
    return free


def _slimmer(body: manifold3d.Manifold) -> Array:
    """The corners of a body, a little nearer to its middle: what only touches is free to move."""
    points = corners([body])
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    half = max(float(np.ptp(points, axis=0).max()) / 2, TOUCH_MM)
    return np.asarray(middle + (points - middle) * (1 - TOUCH_MM / 2 / half))


def _swept(every: manifold3d.Manifold, slim: Iterable[Array], move: Array) -> float:
    """How much of the object the hulls of something run into, swept along a move, mm3."""
    hulls = (manifold3d.Manifold.hull_points(np.vstack([p, p + move])) for p in slim)
    return float(sum((every ^ hull).volume() for hull in hulls))
