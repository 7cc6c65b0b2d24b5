"""What kerf, play and relief do, in millimetres, and a small test piece to try them with.

Terms
-----
coupon
    A comb of notches, each with its own play engraved beside it, and a piece with one tab as wide
    as a finger. The notch in which the tab sits well says which play to set.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from shapely.geometry import Polygon, box

from ...solver.values import Array
from .finger_joints import least_finger_mm
from .plates import Plate
from .settings import PlateSettings
from .sheets import Sheet, lay_out
from .strokes import text_strokes, text_width_mm

#: Plays on the coupon, as differences from the setting, mm.
COUPON_STEPS_MM = (-0.1, -0.05, 0.0, 0.05, 0.1)
#: Of the pieces, and what must be left of them below a notch.
_BAR_MM, _REST_MM = 14.0, 8.0
_TEXT_MM = 3.0


def effects(settings: PlateSettings) -> tuple[str, ...]:
    """What the settings do to one finger and its notch, one line each."""
    finger, play, kerf = settings.finger_mm, settings.play_mm, settings.kerf_mm
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
    width = max(
        settings.finger_mm,
        least_finger_mm(thickness, settings.beam_mm),
        text_width_mm("+0.05", _TEXT_MM),
    )
    step = 2 * width
    length = step * len(COUPON_STEPS_MM) + width
    bar = _bar_mm(thickness)
    notched = box(0.0, 0.0, length, bar)
    # One tab alone: a row of them would go into no notch but with all the others.
    tab = box(width, bar, 2 * width, bar + thickness)
    tabbed = box(0.0, 0.0, 3 * width, bar).union(tab)
    for n, play in enumerate(coupon_plays(settings)):
        left = width + n * step
        # A finger and its notch share the play as the plates' own do; a slot has all of it.
        notched = notched.difference(
            box(left - play / 2, bar - thickness, left + width + play / 2, bar + 1)
        )
    return _flat("notches", notched, thickness), _flat("tab", tabbed, thickness)


def _bar_mm(thickness: float) -> float:
    return max(_BAR_MM, thickness + _REST_MM)


def coupon_plays(settings: PlateSettings) -> tuple[float, ...]:
    """The play of each notch, mm; a negative one is tight."""
    return tuple(round(settings.play_mm + step, 6) for step in COUPON_STEPS_MM)


def coupon_marks(settings: PlateSettings) -> list[Array]:
    """The plays as strokes below the notches, in the first comb's frame."""
    strokes = []
    plate, bar = coupon(settings)[0], _bar_mm(settings.thickness_mm)
    corners = plate.outline[np.isclose(plate.outline[:, 1], bar - settings.thickness_mm)]
    middles = np.sort(corners[:, 0]).reshape(-1, 2).mean(axis=1)
    for middle, play in zip(middles, coupon_plays(settings), strict=True):
        text = f"{play:+.2f}"
        low = (float(middle) - text_width_mm(text, _TEXT_MM) / 2, 2.0)
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
    outline = np.array(polygon.exterior.coords)[:-1]
    if not polygon.exterior.is_ccw:
        outline = outline[::-1]
    return Plate(id_, (id_,), thickness, outline, (), np.eye(4))
