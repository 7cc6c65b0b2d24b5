"""Outlines without what no beam can cut and nobody can hold.

Terms
-----
sliver
    Material much thinner than the plate, as it stays between two cuts that nearly meet.
slit
    A gap narrower than the beam. The slot for a thin plate is none.
"""

from __future__ import annotations

import shapely

from .overlays import without

#: A slit is made wider than the beam by so much, mm.
SLIT_SPARE_MM = 0.05
#: Slivers are narrower than this part of the thickness, and than this, mm.
SLIVER_SHARE, SLIVER_MM = 0.3, 1.0
#: Corners sharper than about 6 degrees count as slivers or slits.
_MITRE = 20.0
_LEAST_MM2 = 1e-3
_ROUNDING_MM = 1e-4
#: The mouth of a slit that was made wider may have become narrow.
_ROUNDS = 4


def without_slivers(
    outline: shapely.Geometry, thickness_mm: float, beam_mm: float, thinnest_mm: float
) -> shapely.Geometry:
    """The outline less its slivers and what makes slits as wide as a beam.

    Parameters
    ----------
    outline : shapely Polygon or MultiPolygon
    thickness_mm, beam_mm : float
    thinnest_mm : float
        Of all plates: no slot is narrower.

    Returns
    -------
    shapely.Geometry
        Nothing is ever added, and all other borders stay to the last digit.
    """
    half = min(beam_mm + SLIT_SPARE_MM, thinnest_mm - _ROUNDING_MM) / 2
    for _ in range(_ROUNDS):
        slits = _parts(_there_and_back(outline, half).difference(outline), half**2 / 4)
        if not slits:
            break
        room = shapely.union_all(slits).buffer(1.05 * half, join_style="mitre")
        outline = without(outline, room)
    half = min(SLIVER_SHARE * thickness_mm, SLIVER_MM) / 2
    # Wider by a little: what the way there and back rounds is no sliver.
    kept = _there_and_back(outline, -half).buffer(1e-4, join_style="mitre", mitre_limit=_MITRE)
    slivers = _parts(outline.difference(kept), _LEAST_MM2)
    if slivers:
        lost = shapely.union_all(slivers).buffer(1e-4, join_style="mitre")
        outline = without(outline, lost)
    return outline


def _there_and_back(area: shapely.Geometry, distance: float) -> shapely.Geometry:
    for step in (distance, -distance):
        area = area.buffer(step, join_style="mitre", mitre_limit=_MITRE)
    return area


def _parts(area: shapely.Geometry, least: float) -> list[shapely.Geometry]:
    return [part for part in shapely.get_parts(area) if part.area > least]
