"""What kerf, play and relief do, in millimetres, and a small test piece to try them with.

Terms
-----
coupon
    A comb of notches, each over a slot, with its own play engraved below, and a piece with one tab
    as wide as a finger. The notch and the slot in which the tab sits well say which play to set:
    a notch tries the width of fingers, a slot the thickness of the stock too.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from shapely.geometry import Polygon, box
from shapely.geometry.polygon import orient

from ...solver.values import Array
from .finger_joints import least_finger_mm
from .plates import Plate
from .settings import PlateSettings
from .sheets import Sheet, lay_out
from .strokes import text_strokes, text_width_mm

#: Plays on the coupon, as differences from the setting, mm.
COUPON_STEPS_MM = (-0.1, -0.05, 0.0, 0.05, 0.1)
#: Height of the piece with the tab without it.
_BAR_MM = 14.0
#: Of letters, and what is clear around them.
_TEXT_MM, _CLEAR_MM = 3.0, 2.0
#: A slot is wider than the beam or cutter by this.
_SPARE_MM = 0.05


def effects(settings: PlateSettings) -> tuple[str, ...]:
    """What the settings do to one finger and its notch, one line each."""
    play, kerf = settings.play_mm, settings.kerf_mm
    finger = _finger_mm(settings)
    return (
        f"finger at a corner: {finger - play / 2:g} mm wide, "
        f"its cut path {finger - play / 2 + kerf:g} mm",
        f"notch at a corner: {finger + play / 2:g} mm wide, "
        f"its cut path {finger + play / 2 - kerf:g} mm",
        f"tab: {finger:g} mm wide, its cut path {finger + kerf:g} mm",
        f"slot: {finger + play:g} x {settings.thickness_mm + play:g} mm, "
        f"its cut path {finger + play - kerf:g} x {settings.thickness_mm + play - kerf:g} mm",
        *cutting_effects(settings),
    )


def _finger_mm(settings: PlateSettings) -> float:
    """The width that is aimed at: no finger is made so narrow that it would not hold."""
    return max(settings.finger_mm, least_finger_mm(settings.thickness_mm, settings.beam_mm))


def cutting_effects(settings: PlateSettings) -> tuple[str, ...]:
    """What kerf, play and relief come to, one line each."""
    play, kerf = settings.play_mm, settings.kerf_mm
    lines = [
        f"kerf {kerf:g} mm: paths lie {kerf / 2:g} mm outside of outlines and inside of holes"
        if kerf
        else "kerf 0 mm: paths are the finished sizes; whoever cuts has to allow for the beam",
        f"play {play:g} mm: between a finger and its notch, a tab and its slot, there are "
        f"{play / 2:g} mm on each side",
    ]
    if settings.relief != "none":
        reach = settings.tool_mm / 2
        over = reach * (1 if settings.relief == "tbone" else 1 - 2**-0.5)
        shape = {"dogbone": "dog bone", "tbone": "T-bone"}[settings.relief]
        lines.append(
            f"{shape} for a cutter of {settings.tool_mm:g} mm: cuts {over:.2f} mm beyond the sides "
            f"of inner corners"
        )
    return tuple(lines)


def coupon(settings: PlateSettings) -> tuple[Plate, ...]:
    """The two pieces of the fit test.

    Parameters
    ----------
    settings : PlateSettings
        Thickness, fingers and play are used here; kerf and relief when it is cut.

    Returns
    -------
    tuple of Plate
        ``notches`` and ``tab``, with the sizes they have when finished.
    """
    thickness = settings.thickness_mm
    width = max(_finger_mm(settings), text_width_mm("+0.05", _TEXT_MM))
    step = 2 * width
    length = step * len(COUPON_STEPS_MM) + width
    slot, ground = _heights(settings)
    notched = box(0.0, 0.0, length, ground + thickness)
    # One tab alone: a row of them would go into no notch but with all the others.
    tab = box(width, _BAR_MM, 2 * width, _BAR_MM + thickness)
    tabbed = box(0.0, 0.0, 3 * width, _BAR_MM).union(tab)
    for n, play in enumerate(coupon_plays(settings)):
        left = width + n * step
        # A finger and its notch share the play as the plates' own do; a slot has all of it.
        low, high = left - play / 2, left + width + play / 2
        notched = notched.difference(box(low, ground, high, ground + thickness + 1))
        if thickness + play > max(settings.kerf_mm, _cutter_mm(settings)) + _SPARE_MM:
            notched = notched.difference(box(low, slot, high, slot + thickness + play))
    return _flat("notches", notched, thickness), _flat("tab", tabbed, thickness)


def _heights(settings: PlateSettings) -> tuple[float, float]:
    """Where slots begin, and the ground of notches, in the comb: one thickness from borders."""
    thickness, relief = settings.thickness_mm, _cutter_mm(settings) / 2
    slot = max(_TEXT_MM + 2 * _CLEAR_MM, thickness) + relief
    top = slot + thickness + coupon_plays(settings)[-1]
    return slot, top + max(thickness, _CLEAR_MM) + 2 * relief


def _cutter_mm(settings: PlateSettings) -> float:
    return settings.tool_mm if settings.relief != "none" else 0.0


def coupon_plays(settings: PlateSettings) -> tuple[float, ...]:
    """The play of each notch, mm; a negative one is tight."""
    return tuple(round(settings.play_mm + step, 6) for step in COUPON_STEPS_MM)


def coupon_marks(settings: PlateSettings) -> list[Array]:
    """The plays as strokes below the notches, in the first comb's frame."""
    strokes = []
    plate, (_, ground) = coupon(settings)[0], _heights(settings)
    corners = plate.outline[np.isclose(plate.outline[:, 1], ground)]
    middles = np.sort(corners[:, 0]).reshape(-1, 2).mean(axis=1)
    for middle, play in zip(middles, coupon_plays(settings), strict=True):
        text = f"{play:+.2f}"
        low = (float(middle) - text_width_mm(text, _TEXT_MM) / 2, _CLEAR_MM)
        strokes += text_strokes(text, low, _TEXT_MM)
    return strokes


def coupon_settings(settings: PlateSettings) -> PlateSettings:
    """The settings with which a coupon is laid out: one piece above the other, on a small sheet."""
    width, height = np.max([np.ptp(p.outline, axis=0) for p in coupon(settings)], axis=0).tolist()
    rim = 2 * settings.margin_mm + settings.kerf_mm + settings.tool_mm + 1.0
    sheet = (width + rim, 2 * (height + settings.kerf_mm + 1.0) + settings.spacing_mm + rim)
    return replace(settings, sheet_mm=sheet, grain="y", joints=())


def coupon_sheets(settings: PlateSettings) -> tuple[Sheet, ...]:
    """The coupon laid out, its plays engraved."""
    marks = {"notches": coupon_marks(settings)}
    return lay_out(coupon(settings), coupon_settings(settings), marks)


def _flat(id_: str, polygon: Polygon, thickness: float) -> Plate:
    turned = orient(polygon)
    outline, *holes = (np.array(r.coords)[:-1] for r in (turned.exterior, *turned.interiors))
    return Plate(id_, (id_,), thickness, outline, tuple(holes), np.eye(4))
