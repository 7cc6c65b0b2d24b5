"""Hollow solids of revolution: the wall's section in 2D, turned once ([Lau10] 4.4).

Terms
-----
section
    The wall cut by a half-plane through the axis: radius to the right, height upwards.
body
    What the profile encloses together with the axis, the ends closed.
open end
    A circle where the hollow comes out; the other end gets a wall.

Offsetting the section and turning it once is exact; shelling the turned solid in the kernel fails
for a third of ordinary profiles.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import shapely

from ...solver.model import Model, Turned
from ...solver.values import Array
from .errors import FabricationError
from .settings import ShellSettings

if TYPE_CHECKING:
    import cadquery as cq

_MITRE_LIMIT = 5.0
_SNAP_MM = 1e-6


def turned_solid(model: Model, settings: ShellSettings) -> cq.Shape:
    """The model's surfaces of revolution as hollow solids.

    Parameters
    ----------
    model : Model
        With surfaces of revolution and no faces besides.
    settings : ShellSettings

    Returns
    -------
    cadquery.Shape
        One solid for each surface of revolution, in world mm.

    Raises
    ------
    FabricationError
        Where a profile crosses itself or the axis, or the wall is too thick for it.
    """
    import cadquery as cq

    made = [id_ for id_, face in model.faces.items() if face.included]
    if made:
        raise FabricationError(
            "flat faces beside a surface of revolution cannot be printed as one",
            made,
            "leave them out, or sketch them on their own",
        )
    solids = [
        _turn(turned, wall_section(id_, turned, settings)) for id_, turned in model.turned.items()
    ]
    return solids[0] if len(solids) == 1 else cq.Compound.makeCompound(solids)


def wall_section(id_: str, turned: Turned, settings: ShellSettings) -> shapely.Polygon:
    """The wall's section.

    Parameters
    ----------
    id_ : str
        For errors.
    turned : Turned
    settings : ShellSettings

    Returns
    -------
    shapely.Polygon
        Radius and height, mm; radius >= 0.
    """
    profile = turned.profile_rz_mm
    body = _body(id_, profile)
    if settings.solid:
        far = float(np.abs(profile).max()) + 1.0
        return shapely.Polygon(body.intersection(shapely.box(0.0, -far, far, far)))
    bottom_open, top_open = _open_ends(profile, settings.open_end)
    reach = 4 * settings.wall_mm
    extended = _extended(profile, bottom_open, top_open, reach)
    wall, side = settings.wall_mm, settings.side
    inner = {"inside": -wall, "outside": 0.0, "middle": -wall / 2}[side]
    outer = inner + wall
    section = _offset(extended, outer).difference(_offset(extended, inner))
    # Walls end where the profile ends: nothing sticks out of an open end.
    heights = [-np.inf, np.inf]
    if bottom_open:
        heights[0] = float(profile[0, 1])
    if top_open:
        heights[1] = float(profile[-1, 1])
    far = float(np.abs(profile).max()) + 10 * reach
    low, high = (float(np.clip(h, -far, far)) for h in heights)
    section = section.intersection(shapely.box(0.0, min(low, high), far, max(low, high)))
    section = shapely.set_precision(section, _SNAP_MM)
    parts = [p for p in getattr(section, "geoms", [section]) if p.area > _SNAP_MM]
    emptied = side == "outside" or _offset(body, inner).area > _SNAP_MM
    if len(parts) != 1 or not emptied:
        raise FabricationError(
            f"the wall of {wall:g} mm is too thick for this profile", (id_,), "a thinner wall"
        )
    return shapely.Polygon(parts[0])


def _body(id_: str, profile: Array) -> shapely.Polygon:
    """The enclosed area with its mirror image, so that offsets do not start at the axis."""
    body = _mirrored(profile)
    if (profile[:, 0] < -_SNAP_MM).any() or not body.is_valid or body.area < _SNAP_MM:
        raise FabricationError(
            "the profile crosses itself or the axis",
            (id_,),
            "a side that runs from circle to circle",
        )
    return body


def _mirrored(profile: Array) -> shapely.Polygon:
    return shapely.Polygon(np.vstack([profile, profile[::-1] * [-1.0, 1.0]]))


def _open_ends(profile: Array, choice: str) -> tuple[bool, bool]:
    if choice == "wider":
        bottom_wider = bool(profile[0, 0] >= profile[-1, 0])
        return bottom_wider, not bottom_wider
    return choice in ("bottom", "both"), choice in ("top", "both")


def _extended(profile: Array, bottom_open: bool, top_open: bool, reach: float) -> shapely.Polygon:
    """The body carried on beyond its open ends, so that no wall closes them."""
    rows = [*profile]
    if bottom_open:
        rows.insert(0, _beyond(profile[0], profile[1], reach))
    if top_open:
        rows.append(_beyond(profile[-1], profile[-2], reach))
    extended = _mirrored(np.array(rows))
    return extended if extended.is_valid else _mirrored(profile)


def _beyond(end: Array, before: Array, reach: float) -> Array:
    """The profile's last stretch carried on, but never across the axis."""
    way = (end - before) / max(float(np.linalg.norm(end - before)), 1e-12)
    if way[0] < 0:
        reach = min(reach, 0.9 * float(end[0]) / -float(way[0]))
    return np.asarray(end + reach * way)


def _offset(area: shapely.Polygon, distance: float) -> shapely.Geometry:
    return area.buffer(distance, join_style="mitre", mitre_limit=_MITRE_LIMIT)


def _turn(turned: Turned, section: shapely.Polygon) -> cq.Shape:
    import cadquery as cq

    def wire(ring: shapely.LinearRing) -> cq.Wire:
        return cq.Wire.makePolygon([cq.Vector(r, 0, z) for r, z in ring.coords[:-1]], close=True)

    holes = [wire(ring) for ring in section.interiors]
    solid = cq.Solid.revolve(
        wire(section.exterior), holes, 360.0, cq.Vector(0, 0, 0), cq.Vector(0, 0, 1)
    )
    x, y = turned.axis_mm.tolist()
    return solid.translate(cq.Vector(x, y, 0))
