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
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from .errors import SettingsError
from .joints import JointChoice

SIDES = ("inside", "outside", "middle")
OPEN_ENDS = ("wider", "bottom", "top", "both", "none")

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
    joints: tuple[JointChoice, ...] = ()

    def __post_init__(self) -> None:
        check_side(self.side)
        check_number("thickness", self.thickness_mm, 0.05, 200.0)
        check_number("finger width", self.finger_mm, 0.5, 1000.0)
        check_number("play", self.play_mm, 0.0, 2.0)
        check_number("kerf", self.kerf_mm, 0.0, 5.0)
        check_number("margin", self.margin_mm, 0.0, 500.0)
        check_number("spacing", self.spacing_mm, 0.0, 500.0)
        for size in self.sheet_mm or ():
            check_number("sheet size", size, 10.0, 100000.0)


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

    Raises
    ------
    SettingsError
        Where a choice is out of range.
    """

    wall_mm: float = 2.0
    side: str = "inside"
    open_end: str = "wider"

    def __post_init__(self) -> None:
        check_number("wall", self.wall_mm, 0.05, 200.0)
        check_side(self.side)
        if self.open_end not in OPEN_ENDS:
            raise SettingsError(f"there is no open end {self.open_end!r}", (), ", ".join(OPEN_ENDS))


def check_number(name: str, value: float, least: float, most: float) -> None:
    """Refuse a number that is not finite or out of range, by its name."""
    if not (math.isfinite(value) and least <= value <= most):
        raise SettingsError(
            f"the {name} is {value:g} mm", (), f"a number from {least:g} to {most:g} mm"
        )


def check_side(side: str) -> None:
    """Refuse a side that does not exist."""
    if side not in SIDES:
        raise SettingsError(f"there is no side {side!r}", (), "inside, outside or middle")
