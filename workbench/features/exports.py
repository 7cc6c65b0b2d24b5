"""The files of a plate set: what a laser cutter, another CAD program or a script needs."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from .plate_set import joined_of, settings_of, shop_settings_of


def export_plates(plate_set: Any, folder: Path, name: str) -> tuple[Path, ...]:
    """Write the plates as DXF, SVG, STEP and plates.json: all of them or none.

    What the plate set's properties ask for besides, PDF, parts list and fit test, is written too.

    Parameters
    ----------
    plate_set : FreeCAD document object
    folder : Path
        Made where it is missing.
    name : str
        What stands before the endings.

    Returns
    -------
    tuple of Path

    Raises
    ------
    SketchError, FabricationError
        Where there are no plates, they fit on no sheet, or the folder cannot be written.
    """
    from ...solver.files import write_files
    from ..fabrication.dxf import dxf_bytes
    from ..fabrication.marks import edge_marks
    from ..fabrication.plates_json import plates_json_bytes
    from ..fabrication.presets import load_preset
    from ..fabrication.sheets import lay_out
    from ..fabrication.svg import svg_bytes
    from ..making import Extras, Order, extra_files

    joined, settings, shop = (
        joined_of(plate_set),
        settings_of(plate_set),
        shop_settings_of(plate_set),
    )
    plates, preset = joined.plates, load_preset(shop.preset)
    sheets = lay_out(plates, settings, edge_marks(plates, joined.joints))
    extras = Extras(
        pdf=plate_set.WithPdf or bool(plate_set.PdfPage),
        parts=plate_set.WithPartsList,
        coupon=plate_set.WithCoupon,
    )
    contents = {
        f"{name}.dxf": dxf_bytes(sheets, preset),
        f"{name}.svg": svg_bytes(sheets, preset),
        f"{name}.step": _step_bytes(plates),
        f"{name}.plates.json": plates_json_bytes(plates),
        **extra_files(plates, sheets, settings, Order(name, settings, shop=shop, extras=extras)),
    }
    paths = {folder / file: data for file, data in contents.items()}
    write_files(paths)
    return tuple(paths)


def _step_bytes(plates: tuple[Any, ...]) -> bytes:
    """The plates as STEP, by FreeCAD's own kernel: no other one need be loaded for it."""
    from .shapes import plates_shape

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "plates.step")
        plates_shape(plates).exportStep(str(path))
        return path.read_bytes()
