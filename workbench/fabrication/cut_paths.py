"""Where the beam goes: the only place that knows the kerf.

Terms
-----
kerf
    Full width that the beam removes.
cut path
    The middle of the beam: outlines moved outwards by kerf / 2, holes inwards, so that what is
    left has the finished size. Corners are mitred.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import Polygon

from ...solver.values import Array
from .narrow_places import TooNarrowError, narrow_place, room_mm
from .overlays import sides_mm
from .plates import Plate, from_least
from .relief import relieved

#: How far a mitre may reach, in half kerfs; sharper corners are cut off.
MITRE_LIMIT = 5.0
#: Shorter segments are left out, mm.
LEAST_SEGMENT_MM = 0.05
#: What may stay uncut in a notch's corner, in squares of half a kerf: a round beam leaves 0.2.
_LOST_SHARE = 2.0
_SHARPEST = 20.0
#: A tip further away than this many short sides is left out.
_FAR_TIP = 20


@dataclass(frozen=True, slots=True, eq=False)
class CutPath:
    """The closed paths of one plate, in the plate frame.

    Parameters
    ----------
    plate_id : str
    thickness_mm : float
    outer : (k, 2) array
        mm, counter-clockwise, not closed by a repeated point.
    inner : tuple of (k, 2) arrays
        mm, clockwise.
    """

    plate_id: str
    thickness_mm: float
    outer: Array
    inner: tuple[Array, ...]


def cut_path(plate: Plate, kerf_mm: float, relief: str = "none", tool_mm: float = 0.0) -> CutPath:
    """The path of the beam around a plate.

    Parameters
    ----------
    plate : Plate
    kerf_mm : float
        0 gives the finished outline itself.
    relief, tool_mm
        At corners that look inwards; see `relieved`.

    Returns
    -------
    CutPath

    Raises
    ------
    TooNarrowError
        Naming the plate, where a notch or hole is narrower than the kerf.
    """
    rings = [plate.outline, *plate.holes]
    if relief != "none":
        rings = relieved(plate, relief, tool_mm)
    paths = [_path(plate, ring, kerf_mm, hole=n > 0) for n, ring in enumerate(rings)]
    return CutPath(plate.id, plate.thickness_mm, paths[0], tuple(paths[1:]))


def _path(plate: Plate, ring: Array, kerf: float, *, hole: bool) -> Array:
    """One ring's path; material lies on the left of both."""
    path = _path_or_none(ring, kerf, hole=hole)
    if path is None:
        raise _too_narrow(plate, ring, kerf, hole=hole)
    return path


def _path_or_none(ring: Array, kerf: float, *, hole: bool) -> Array | None:
    if kerf == 0:
        return _without_short(ring)
    slot = _narrowed(ring, kerf) if hole and len(ring) == 4 else None
    if slot is not None:
        return slot
    moved = _mitred(ring, kerf / 2)
    if moved is None:
        moved = _moved(ring[::-1] if hole else ring, -kerf / 2 if hole else kerf / 2)
        moved = moved[::-1] if moved is not None and hole else moved
    if moved is None:
        return None
    points = np.round(_without_short(moved), 6) + 0.0
    return from_least(points)


def _too_narrow(plate: Plate, ring: Array, kerf: float, *, hole: bool) -> TooNarrowError:
    """Why a ring has no path, and where."""
    if hole:
        height, width = sides_mm(Polygon(ring))
        what = f"a hole of {width:.4g} x {height:.4g} mm is narrower than the kerf of {kerf:g} mm"
        spot = np.array(Polygon(ring).representative_point().coords[0])
        return TooNarrowError(what, plate, spot, "a smaller kerf, or wider fingers")
    room = room_mm(lambda beam: _path_or_none(ring, beam, hole=False) is not None, kerf)
    return TooNarrowError(
        f"a notch that a beam of {room:g} mm just gets into is narrower than the kerf of "
        f"{kerf:g} mm",
        plate,
        narrow_place(Polygon(ring), min(kerf, room + 0.05)),
        "a smaller kerf, or wider fingers",
    )


def _narrowed(ring: Array, kerf: float) -> Array | None:
    """An upright rectangular hole's path, most are; None where it is another, or too narrow."""
    (x, y), (across, up) = ring.min(axis=0).tolist(), ring.max(axis=0).tolist()
    straight = ring.tolist() == [[x, y], [x, up], [across, up], [across, y]]
    if not straight or min(across - x, up - y) < kerf + LEAST_SEGMENT_MM:
        return None
    x, y, across, up = x + kerf / 2, y + kerf / 2, across - kerf / 2, up - kerf / 2
    return np.round([[x, y], [x, up], [across, up], [across, y]], 6) + 0.0


def _after(ring: Array) -> Array:
    """For each corner the next one."""
    return np.concatenate((ring[1:], ring[:1]))


def _mitred(ring: Array, distance: float) -> Array | None:
    """The ring moved to its right, corner by corner; None where a side would vanish."""
    ahead = _after(ring) - ring
    ways = ahead / np.hypot(ahead[:, 0], ahead[:, 1])[:, None]
    normals = np.column_stack([ways[:, 1], -ways[:, 0]])
    before, ways_before = (np.concatenate((a[-1:], a[:-1])) for a in (normals, ways))
    # cos2 is the squared cosine of half the turn; the mitre is 1 / cos of the distance long.
    cos2 = (1 + (normals * before).sum(axis=1)) / 2
    turn = ways_before[:, 0] * ways[:, 1] - ways_before[:, 1] * ways[:, 0]
    blunt = (turn < 0) | (cos2 * MITRE_LIMIT**2 >= 1)
    if (cos2[blunt] < 1e-12).any():
        return None
    if blunt.all():
        moved = ring + distance * (normals + before) / (2 * cos2)[:, None]
        keeps = ((_after(moved) - moved) * ways).sum(axis=1) > 0
        return moved if keeps.all() and shapely.LinearRing(moved).is_simple else None
    # Where the mitre would be too long, it is cut off square to its own direction.
    reach = MITRE_LIMIT * distance
    points: list[Array] = []
    for n, corner in enumerate(ring):
        if blunt[n]:
            points.append(corner + distance * (normals[n] + before[n]) / (2 * cos2[n]))
            continue
        half = np.sqrt(max(cos2[n], 0.0))
        along = (reach - distance * half) / np.sqrt(1 - half**2)
        points.append(corner + distance * before[n] + along * ways_before[n])
        points.append(corner + distance * normals[n] - along * ways[n])
    moved = np.array(points)
    return moved if shapely.LinearRing(moved).is_simple and _keeps(moved, ring, blunt) else None


def _keeps(moved: Array, ring: Array, blunt: NDArray[np.bool_]) -> bool:
    """Whether all sides of a ring go the same way after it was moved."""
    last = np.cumsum(np.where(blunt, 1, 2)) - 1
    first = np.where(blunt, last, last - 1)
    ahead = _after(ring) - ring
    return bool(((moved[np.roll(first, -1)] - moved[last]) * ahead).sum(axis=1).min() > 0)


def _moved(ring: Array, distance: float) -> Array | None:
    """A counter-clockwise ring moved outwards (distance > 0) or inwards.

    None where it falls into several, or where notches or arms vanish: when it is moved back, they
    are missing.
    """
    polygon = Polygon(ring)
    there = polygon.buffer(distance, join_style="mitre", mitre_limit=MITRE_LIMIT)
    # No beam reaches the end of a sharp notch; only what is narrow all along is missing.
    back = there.buffer(-distance, join_style="mitre", mitre_limit=_SHARPEST)
    lost = back.difference(polygon) if distance > 0 else polygon.difference(back)
    if there.geom_type != "Polygon" or there.is_empty or there.interiors:
        return None
    if max(part.area for part in shapely.get_parts(lost)) > _LOST_SHARE * distance**2:
        return None
    return np.array(shapely.geometry.polygon.orient(there).exterior.coords)[:-1]


def _without_short(ring: Array) -> Array:
    """The ring without sides that are too short, its other sides where they were.

    A short side gives way to the point in which its neighbours meet; of a step the corner goes
    that looks inwards, so that nothing of the part is lost.
    """
    points = ring
    for _ in range(len(ring)):
        ahead = _after(points) - points
        lengths = np.hypot(ahead[:, 0], ahead[:, 1])
        n = int(lengths.argmin())
        if lengths[n] >= LEAST_SEGMENT_MM or len(points) < 4:
            break
        count = len(points)
        m, before, after = (n + 1) % count, ahead[n - 1], ahead[(n + 1) % count]
        cross = float(before[0] * after[1] - before[1] * after[0])
        tip = None
        if abs(cross) > 1e-9 * lengths[n - 1] * lengths[m]:
            share = float(ahead[n][0] * after[1] - ahead[n][1] * after[0]) / cross
            met = points[n] + share * before
            # Neither neighbour may turn back for it.
            on = float((met - points[m]) @ after) / float(after @ after)
            tip = met if share > -0.5 and on < 0.5 else None
        if tip is not None and np.hypot(*(tip - points[n])) < _FAR_TIP * LEAST_SEGMENT_MM:
            points = points.copy()
            points[n] = tip
            points = np.delete(points, m, axis=0)
        else:
            inwards = float(before[0] * ahead[n][1] - before[1] * ahead[n][0]) < 0
            points = np.delete(points, n if inwards else m, axis=0)
    return points
