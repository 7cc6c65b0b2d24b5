"""The files of plates and prints: what a cutter, a slicer, another program or a script needs."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from .. import host
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


def export_print(shelled_solid: Any, folder: Path, name: str) -> tuple[Path, ...]:
    """Write a shelled solid as STL, 3MF and STEP: all of them or none.

    Parameters
    ----------
    shelled_solid : FreeCAD document object
    folder : Path
        Made where it is missing.
    name : str
        What stands before the endings, and the solid's name in the 3MF.

    Returns
    -------
    tuple of Path

    Raises
    ------
    SketchError, FabricationError
        Where there is no solid, or the folder cannot be written.
    """
    from ...solver.files import write_files
    from . import pipeline
    from .dimensions import driven_text
    from .shelled_solid import settings_of as shell_settings_of

    settings = shell_settings_of(shelled_solid)
    model = pipeline.model_of(driven_text(shelled_solid.LiftedModel), settings.wall_mm)
    with host.own_packages_first():
        from ..fabrication import shell_solid
        from ..fabrication.meshes import mesh_of, stl_bytes, threemf_bytes
        from ..fabrication.solids import shape_step_bytes

        solid = shell_solid(model, settings)
        mesh = mesh_of(solid, settings.tolerance_mm)
        contents = {
            folder / f"{name}.stl": stl_bytes(mesh),
            folder / f"{name}.3mf": threemf_bytes(mesh, name),
            folder / f"{name}.step": shape_step_bytes(solid, name),
        }
    write_files(contents)
    return tuple(contents)
