"""What a plate set's files will hold, in numbers and strokes: to be shown before it is written."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ..wording import in_language
from .exports import sheets_of
from .plate_set import plates_of, settings_of, shop_settings_of

if TYPE_CHECKING:
    from ...solver.values import Array

#: What is no path to be cut or engraved.
_NOT_SHOWN = ("SHEET", "SCALE")


@dataclass(frozen=True, slots=True, eq=False)
class SheetPicture:
    """Sheets side by side, mm, y upwards, the first one's corner in the origin.

    Parameters
    ----------
    stock : tuple of (x, width, height)
    strokes : tuple of (colour, (k, 2) array, closed)
        Colours as hexadecimal, as the preset says.
    words : tuple of str
        The stock's sizes.
    n_plates : int
    cut_mm, time_s : float
    price : float or None
        Of all stock, where that of a sheet is known.
    effects : tuple of str
        What kerf, play and corner relief come to, in the person's language.
    """

    stock: tuple[tuple[float, float, float], ...]
    strokes: tuple[tuple[str, Array, bool], ...]
    words: tuple[str, ...]
    n_plates: int
    cut_mm: float
    time_s: float
    price: float | None = None
    effects: tuple[str, ...] = ()


def picture_of(plate_set: Any) -> SheetPicture:
    """The picture of a plate set's sheets.

    Raises
    ------
    SketchError, FabricationError
        Where there are no plates, or they fit on no sheet.
    """
    from ..fabrication.drawing import GAP_MM, draw
    from ..fabrication.fits import cutting_effects
    from ..fabrication.parts import parts_list
    from ..fabrication.presets import load_preset

    sheets, shop = sheets_of(plate_set), shop_settings_of(plate_set)
    plates, preset = plates_of(plate_set), load_preset(shop.preset)
    total = parts_list(plates, sheets, shop)[-1]
    stock, x = [], 0.0
    for sheet in sheets:
        stock.append((x, sheet.width_mm, sheet.height_mm))
        x += sheet.width_mm + GAP_MM
    strokes = tuple(
        (preset.layers[path.purpose].rgb, path.points, path.closed)
        for path in draw(sheets, preset).paths
        if path.purpose not in _NOT_SHOWN
    )
    sizes = {f"{s.width_mm:g} x {s.height_mm:g} x {s.thickness_mm:g} mm" for s in sheets}
    words = tuple(sorted(sizes))
    effects = tuple(map(in_language, cutting_effects(settings_of(plate_set))))
    return SheetPicture(
        tuple(stock), strokes, words, len(plates), total.cut_mm, total.time_s, total.price, effects
    )
