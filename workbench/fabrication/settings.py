"""What a person may choose about plates, sheets and walls, checked when it is said.

Terms
-----
side
    Where the material lies: ``inside`` (the drawn faces are the outside of the object),
    ``outside`` (they are its inner surface) or ``middle``. Partitions are always in the middle.
finger
    Target width of a finger; the true width divides the edge into an odd number of equal parts.
play
    Clearance: how much wider a slot or notch is than the finger that goes into it.
kerf
    Full width that the beam removes. Only the cut paths know it; plates have finished sizes.
relief
    What a round cutter must take away at corners that look inwards, so that a square one fits: a
    ``dogbone`` (over the corner) or a ``tbone`` (along the longer side). A beam needs none.
grain
    Where the direction that is up in the world lies on the sheet: along ``x`` or ``y``, or
    ``free``.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from numbers import Real

from .errors import SettingsError
from .joints import HOW_TO_SAY, JointChoice

SIDES = ("inside", "outside", "middle")
RELIEFS = ("none", "dogbone", "tbone")
GRAINS = ("free", "x", "y")
OPEN_ENDS = ("wider", "bottom", "top", "both", "none")

#: Lasers cut no wider than this; fingers and slits of plates are made for it, mm.
USUAL_BEAM_MM = 0.5
#: Pages on which a PDF can be tiled.
PAGES_MM = {"A4": (210.0, 297.0), "A3": (297.0, 420.0), "letter": (215.9, 279.4)}
#: Sheets that shops and schools have, mm; the smallest that takes every plate is the default.
USUAL_SHEETS_MM = (
    (600.0, 400.0),
    (900.0, 600.0),
    (1200.0, 800.0),
    (1500.0, 1000.0),
    (2500.0, 1250.0),
)


@dataclass(frozen=True, slots=True)
class PlateSettings:
    """Choices for plates and their sheets, all in mm.

    Parameters
    ----------
    thickness_mm : float
        For faces that name no thickness of their own (the model is built with it).
    side : str
        ``inside``, ``outside`` or ``middle``.
    finger_mm : float
        Target width of fingers.
    play_mm : float
        How much wider slots and notches are than fingers.
    kerf_mm : float
        Width of the beam; 0 where the shop allows for it itself.
    sheet_mm : (width, height) or None
        None takes the smallest usual sheet that holds every plate.
    margin_mm, spacing_mm : float
        Kept free along the sheet's border, and between two plates.
    relief : str
        ``none``, ``dogbone`` or ``tbone``.
    tool_mm : float
        Diameter of the round cutter, for the relief.
    grain : str
        ``free``, ``x`` or ``y``.
    joints : tuple of JointChoice
        What is wanted of single joints; all others are decided by `JointPlan`.

    Raises
    ------
    SettingsError
        Where a number is out of range.
    """

    thickness_mm: float = 3.0
    side: str = "inside"
    finger_mm: float = 12.0
    play_mm: float = 0.0
    kerf_mm: float = 0.0
    sheet_mm: tuple[float, float] | None = None
    margin_mm: float = 5.0
    spacing_mm: float = 3.0
    relief: str = "none"
    tool_mm: float = 3.0
    grain: str = "free"
    joints: tuple[JointChoice, ...] = ()

    def __post_init__(self) -> None:
        check_side(self.side)
        check_choice("corner relief", self.relief, RELIEFS)
        check_choice("grain", self.grain, GRAINS)
        check_number("tool's diameter", self.tool_mm, 0.1, 50.0)
        check_number("thickness", self.thickness_mm, 0.05, 200.0)
        check_number("finger width", self.finger_mm, 0.5, 1000.0)
        check_number("play", self.play_mm, 0.0, 2.0)
        check_number("kerf", self.kerf_mm, 0.0, 5.0)
        check_number("margin", self.margin_mm, 0.0, 500.0)
        check_number("spacing", self.spacing_mm, 0.0, 500.0)
        _check_sizes("sheet size", self.sheet_mm, 2, 10.0)
        joints: object = self.joints
        known = isinstance(joints, tuple | list) and all(
            isinstance(joint, JointChoice) for joint in joints
        )
        if not known:
            raise SettingsError("a joint is no JointChoice", (), HOW_TO_SAY)

    @property
    def beam_mm(self) -> float:
        """The widest beam that plates are made for: no laser's own kerf changes a plate."""
        return max(self.kerf_mm, USUAL_BEAM_MM)


@dataclass(frozen=True, slots=True)
class ShopSettings:
    """What the files, times and prices depend on, and no plate.

    Parameters
    ----------
    preset : str
        Names and colours of layers: a preset's name, or the path of a JSON file.
    page : str or None
        Size of the PDF's pages, on which sheets are tiled; None puts each sheet on one page.
    cut_mm_s, engrave_mm_s : float
        Speeds of the beam.
    pierce_s : float
        For each path: to get there and pierce.
    sheet_price : float or None
        Of one sheet of stock, in any currency.

    Raises
    ------
    SettingsError
        Where a number is out of range.
    """

    preset: str = "plain"
    page: str | None = None
    cut_mm_s: float = 10.0
    engrave_mm_s: float = 100.0
    pierce_s: float = 0.5
    sheet_price: float | None = None

    def __post_init__(self) -> None:
        if self.page is not None:
            check_choice("page", self.page, tuple(PAGES_MM))
        check_number("cutting speed", self.cut_mm_s, 0.01, 10000.0, "mm/s")
        check_number("engraving speed", self.engrave_mm_s, 0.01, 10000.0, "mm/s")
        check_number("time to pierce", self.pierce_s, 0.0, 600.0, "s")
        if self.sheet_price is not None:
            check_number("price of a sheet", self.sheet_price, 0.0, 1e9, "")


@dataclass(frozen=True, slots=True)
class ShellSettings:
    """Choices for a shelled solid.

    Parameters
    ----------
    wall_mm : float
        Thickness of the wall.
    side : str
        ``inside`` or ``outside``: where the wall lies, seen from the drawn faces.
    open_end : str
        Which end of a surface of revolution has no wall: ``bottom``, ``top``, ``both``, ``none``
        or ``wider`` (a lid is open below, a saucer above).
    solid : bool
        True makes no hollow at all.
    least_wall_mm : float
        What the printer can print; thinner walls are refused.
    tolerance_mm : float
        How far the mesh may leave curved surfaces.
    bed_mm : (x, y, z) or None
        What the printer can print at once.

    Raises
    ------
    SettingsError
        Where a choice is out of range.
    """

    wall_mm: float = 2.0
    side: str = "inside"
    open_end: str = "wider"
    solid: bool = False
    least_wall_mm: float = 0.4
    tolerance_mm: float = 0.02
    bed_mm: tuple[float, float, float] | None = None

    def __post_init__(self) -> None:
        check_number("wall", self.wall_mm, 0.05, 200.0)
        check_number("least wall", self.least_wall_mm, 0.0, 200.0)
        check_number("tolerance", self.tolerance_mm, 0.001, 5.0)
        _check_sizes("size of the bed", self.bed_mm, 3, 1.0)
        if self.wall_mm < self.least_wall_mm and not self.solid:
            raise SettingsError(
                f"the wall of {self.wall_mm:g} mm is thinner than the least wall of "
                f"{self.least_wall_mm:g} mm",
                (),
                "a thicker wall, or a printer with a finer nozzle",
            )
        check_side(self.side)
        check_choice("open end", self.open_end, OPEN_ENDS)


def bed_note(size_mm: tuple[float, float, float], bed_mm: tuple[float, float, float] | None) -> str:
    """What to say where a print is larger than the printer's bed; empty where it fits."""
    if bed_mm is None:
        return ""
    x, y, z = size_mm
    # By less than this a measured size may be too large.
    width, depth, height = (n + 1e-3 for n in bed_mm)
    flat = (x <= width and y <= depth) or (y <= width and x <= depth)
    if flat and z <= height:
        return ""
    size, room = (" x ".join(f"{n:.4g}" for n in sizes) for sizes in (size_mm, bed_mm))
    turned = all(
        a <= b for a, b in zip(sorted(size_mm), sorted((width, depth, height)), strict=True)
    )
    remedy = "lay it on another side" if turned else "a larger printer, or several parts"
    return f"the print is {size} mm, larger than the printer's {room} mm; try: {remedy}"


def check_number(name: str, value: object, least: float, most: float, unit: str = "mm") -> None:
    """Refuse what is no number, not finite or out of range, by its name."""
    remedy = f"a number from {least:g} to {most:g} {unit}".rstrip()
    if not isinstance(value, Real) or isinstance(value, bool):
        raise SettingsError(f"the {name} is {value!r}, no number", (), remedy)
    number = float(value)
    if not (math.isfinite(number) and least <= number <= most):
        raise SettingsError(f"the {name} is {number:g} {unit}".rstrip(), (), remedy)


def _check_sizes(name: str, sizes: object, count: int, least: float) -> None:
    """Refuse what is not so many numbers."""
    if sizes is None:
        return
    if not isinstance(sizes, tuple | list) or len(sizes) != count:
        raise SettingsError(f"the {name} is {sizes!r}, not {count} numbers", (), f"{count} numbers")
    for size in sizes:
        check_number(name, size, least, 100000.0)


def check_side(side: str) -> None:
    """Refuse a side that does not exist."""
    check_choice("side", side, SIDES)


def check_choice(name: str, value: str, choices: Sequence[str]) -> None:
    """Refuse a word that is no choice, by the setting's name."""
    if value not in choices:
        words = f"{', '.join(choices[:-1])} or {choices[-1]}"
        raise SettingsError(f"there is no {name} {value!r}", (), words)
