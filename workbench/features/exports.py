"""The files of a plate set: what a laser cutter, another CAD program or a script needs."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from .plate_set import plates_of, settings_of


def export_plates(plate_set: Any, folder: Path, name: str) -> tuple[Path, ...]:
    """Write the plates as DXF, SVG, STEP and plates.json: all of them or none.

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
    from ..fabrication.plates_json import plates_json_bytes
    from ..fabrication.sheets import lay_out
    from ..fabrication.svg import svg_bytes

    plates = plates_of(plate_set)
    sheets = lay_out(plates, settings_of(plate_set))
    contents = {
        folder / f"{name}.dxf": dxf_bytes(sheets),
        folder / f"{name}.svg": svg_bytes(sheets),
        folder / f"{name}.step": _step_bytes(plates),
        folder / f"{name}.plates.json": plates_json_bytes(plates),
    }
    write_files(contents)
    return tuple(contents)


def _step_bytes(plates: tuple[Any, ...]) -> bytes:
    """The plates as STEP, by FreeCAD's own kernel: no other one need be loaded for it."""
    from .shapes import plates_shape

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "plates.step")
        plates_shape(plates).exportStep(str(path))
        return path.read_bytes()
