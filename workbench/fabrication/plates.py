"""Plates: the flat parts to be cut, in finished size, and where each belongs in the world.

Terms
-----
plate frame
    Origin at the least corner of the plate's outline, x and y in its plane, the material between
    z = 0 and z = thickness. Of outer walls z looks to the inside of the object; y looks upwards
    where the plate stands.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.model import Model
from ...solver.values import Array, frozen_array
from .clear_slots import lost_tabs
from .cut_up import CutUpError
from .errors import FabricationError, NotRightAngledError
from .finger_joints import share_out
from .frame import Frame, find_frame, leaning_openings, snapped
from .joints import Joint, JointPlan
from .outlines import cut_outlines
from .overlapping import disjoint
from .settings import PlateSettings
from .walls import Wall, find_walls

_DEFAULTS = PlateSettings()


@dataclass(frozen=True, slots=True, eq=False)
class Plate:
    """One flat part.

    Parameters
    ----------
    id : str
        The id of the first face that it is made of.
    face_ids : tuple of str
    thickness_mm : float
    outline : (k, 2) array
        mm, finished size (before kerf), in the plate frame, counter-clockwise, not closed by a
        repeated point.
    holes : tuple of (k, 2) arrays
        mm, clockwise.
    world_from_plate : (4, 4) array
    """

    id: str
    face_ids: tuple[str, ...]
    thickness_mm: float
    outline: Array
    holes: tuple[Array, ...]
    world_from_plate: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "outline", frozen_array(self.outline, (-1, 2)))
        holes = tuple(frozen_array(hole, (-1, 2)) for hole in self.holes)
        object.__setattr__(self, "holes", holes)
        object.__setattr__(self, "world_from_plate", frozen_array(self.world_from_plate, (4, 4)))

    @property
    def polygon(self) -> Polygon:
        """Outline and holes as one shapely polygon."""
        return Polygon(self.outline, self.holes)

    @property
    def size_mm(self) -> tuple[float, float]:
        """Width and height of the outline."""
        width, height = np.ptp(self.outline, axis=0)
        return float(width), float(height)

    @property
    def corners_mm(self) -> Array:
        """Those of the outline on both of its faces, in the world: (2 k, 3)."""
        rotation, origin = self.world_from_plate[:3, :3], self.world_from_plate[:3, 3]
        lower = self.outline @ rotation[:, :2].T + origin
        return np.vstack([lower, lower + self.thickness_mm * rotation[:, 2]])


def make_plates(model: Model, settings: PlateSettings = _DEFAULTS) -> tuple[Plate, ...]:
    """Plates of a model that fit together: the plates of `joined_plates`."""
    return joined_plates(model, settings).plates


@dataclass(frozen=True, slots=True, eq=False)
class Joined:
    """Plates, the joints between them, and by the faces around it what stays empty, mm3."""

    plates: tuple[Plate, ...]
    joints: tuple[Joint, ...]
    empty_mm3: Mapping[tuple[str, ...], float] = field(default_factory=dict)


def joined_plates(model: Model, settings: PlateSettings = _DEFAULTS) -> Joined:
    """Plates of a model that fit together, and how.

    Faces left out are open sides. Faces that touch in one plane and have one thickness become
    one plate. Put together, the plates overlap nowhere. Where all faces stand at right angles
    (in any direction) the walls are filled wholly, play aside (the cell model); at other angles
    the square cut of the beam leaves a little void (the band model).

    Parameters
    ----------
    model : Model
    settings : PlateSettings

    Returns
    -------
    Joined
        The plates in the order of the model's faces.

    Raises
    ------
    FabricationError
        Naming the faces that are not flat or too close together, or the joint that cannot be.
    """
    model = disjoint(model)
    faces = {id_: face for id_, face in model.faces.items() if face.included}
    if not faces and model.turned:
        raise FabricationError(
            "a surface of revolution has no flat face to make a plate of",
            model.turned,
            "a print: a shelled solid, --print",
        )
    if not faces:
        raise FabricationError("no face to make a plate of", (), "include a face")
    plan = JointPlan(settings.finger_mm, settings.play_mm, settings.joints)
    empty: Mapping[tuple[str, ...], float] = {}
    try:
        frame = find_frame(faces)
        walls = find_walls(model, frame, settings.side)
    except NotRightAngledError:
        plates = _slanted_plates(model, settings, plan)
    else:
        _check_apart(walls)
        pieces = share_out(walls, settings, plan, _edges(model, frame))
        try:
            outlines, empty, pieces = cut_outlines(walls, pieces)
        except CutUpError as error:
            raise error.blaming(plan) from None
        for joint, reason in lost_tabs(plan.joints, walls, pieces):
            plan.butt_after_all(joint, reason)
        plates = tuple(
            _plate(wall, outline, frame) for wall, outline in zip(walls, outlines, strict=True)
        )
        leaning = leaning_openings(model, frame)
        if leaning:
            plates = _behind_openings(model, frame, leaning, walls, plates, settings.side)
        place = frame.world_from_frame()
        plan.joints = [_in_world(joint, place) for joint in plan.joints]
    plan.check_used()
    return Joined(plates, tuple(plan.joints), empty)


def _behind_openings(
    model: Model,
    frame: Frame,
    openings: Sequence[str],
    walls: Sequence[Wall],
    plates: Sequence[Plate],
    side: str,
) -> tuple[Plate, ...]:
    """Plates that stick out of no leaning opening."""
    from .slanted_openings import behind_openings
    from .slanted_walls import SlantedWall

    placed = [
        SlantedWall(p.face_ids, p.thickness_mm, p.world_from_plate, (p.outline, *p.holes))
        for p in plates
    ]
    outlines = behind_openings(model, frame, openings, walls, placed, side)
    result = []
    for plate, outline in zip(plates, outlines, strict=True):
        if outline.equals(plate.polygon):
            result.append(plate)
            continue
        whole = max(shapely.get_parts(outline), key=lambda part: part.area)
        rings = [np.array(r.coords)[:-1] for r in (whole.exterior, *whole.interiors)]
        place = np.array(plate.world_from_plate)
        result.append(_placed(plate.face_ids, plate.thickness_mm, rings, place))
    return tuple(result)


def _in_world(joint: Joint, place: Array) -> Joint:
    x, y, z = (place[:3, :3] @ joint.meeting.middle_mm + place[:3, 3]).tolist()
    return replace(joint, meeting=replace(joint.meeting, middle_mm=(x, y, z)))


def _edges(model: Model, frame: Frame) -> dict[str, tuple[Array, Array]]:
    """The ends of the model's edges in the frame."""
    points = snapped(model, frame)
    return {
        id_: (points[v], points[w])
        for id_, (v, w) in model.edges.items()
        if v in points and w in points
    }


def _slanted_plates(model: Model, settings: PlateSettings, plan: JointPlan) -> tuple[Plate, ...]:
    from .bands import band_outlines

    walls, outlines = band_outlines(model, settings, plan)
    plates = []
    for wall, outline in zip(walls, outlines, strict=True):
        rings = [np.array(ring.coords)[:-1] for ring in (outline.exterior, *outline.interiors)]
        plates.append(
            _placed(
                wall.face_ids, wall.thickness_mm, rings, np.array(wall.world_from_wall), digits=9
            )
        )
    return tuple(plates)


def _check_apart(walls: Iterable[Wall]) -> None:
    """Refuse parallel walls that lie in one another."""
    known: list[Wall] = []
    for wall in walls:
        for other in known:
            if other.axis != wall.axis or other.drawn_mm == wall.drawn_mm:
                continue
            deep = min(wall.high_mm, other.high_mm) - max(wall.low_mm, other.low_mm)
            if deep > 1e-6 and wall.region.intersection(other.region).area > 1e-6:
                gap = abs(wall.drawn_mm - other.drawn_mm)
                raise FabricationError(
                    f"the plates would lie in one another: their faces are {gap:.4g} mm apart, "
                    f"and they are {other.thickness_mm:g} and {wall.thickness_mm:g} mm thick",
                    (other.face_ids[0], wall.face_ids[0]),
                    "thinner plates",
                )
        known.append(wall)


def _plate(wall: Wall, outline: Polygon, frame: Frame) -> Plate:
    """The plate of a wall: its own frame, and its rings in it."""
    axes = np.eye(3)
    z = axes[wall.axis] * (1.0 if wall.side >= 0 else -1.0)
    up = 2 if wall.axis != 2 else 1
    x = np.cross(axes[up], z)
    rows = np.array([x, axes[up], z])  # plate axes, in the frame
    rings = [np.array(ring.coords)[:-1] for ring in (outline.exterior, *outline.interiors)]
    flat = [_in_frame(ring, wall) @ rows.T for ring in rings]
    low = min(wall.low_mm * rows[2, wall.axis], wall.high_mm * rows[2, wall.axis])
    place = np.eye(4)
    place[:3, :3] = rows.T
    place[:3, 3] = rows.T @ np.array([0.0, 0.0, low])
    return _placed(
        wall.face_ids,
        wall.thickness_mm,
        [points[:, :2] for points in flat],
        frame.world_from_frame() @ place,
    )


def _placed(
    face_ids: tuple[str, ...],
    thickness: float,
    rings: list[Array],
    place: Array,
    *,
    digits: int = 6,
) -> Plate:
    """A plate whose origin is moved to the least corner of its outline."""
    least = rings[0].min(axis=0)
    shift = np.eye(4)
    shift[:2, 3] = least
    ordered = [
        _wound(np.round(ring - least, digits) + 0.0, ccw=n == 0) for n, ring in enumerate(rings)
    ]
    holes = sorted(ordered[1:], key=lambda ring: tuple(ring[0]))
    return Plate(
        face_ids[0], face_ids, round(thickness, 9), ordered[0], tuple(holes), place @ shift
    )


def _in_frame(ring: Array, wall: Wall) -> Array:
    u, v = wall.plane_axes
    points = np.zeros((len(ring), 3))
    points[:, u], points[:, v] = ring.T
    return points


def _wound(ring: Array, *, ccw: bool) -> Array:
    """The ring in the wanted sense, beginning at its least point."""
    (x, y), (u, v) = ring.T, np.concatenate((ring[1:], ring[:1])).T
    turned = ring if (float(x @ v - u @ y) > 0) == ccw else ring[::-1]
    return from_least(turned)


def from_least(ring: Array) -> Array:
    """The same ring, beginning at its least point."""
    first = int(np.lexsort((ring[:, 1], ring[:, 0]))[0])
    return np.concatenate((ring[first:], ring[:first]))
