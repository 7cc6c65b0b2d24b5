"""The files of plates and prints: what a cutter, a slicer, another program or a script needs.

Terms
-----
format
    One of `PLATE_FORMATS` or `PRINT_FORMATS`: the ending of its file, which comes after the name.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import host
from . import pipeline
from .plate_set import joined_of, settings_of, shop_settings_of

if TYPE_CHECKING:
    from ..fabrication.plates import Joined
    from ..fabrication.settings import PlateSettings
    from ..fabrication.sheets import Sheet

PLATE_FORMATS = (".dxf", ".svg", ".pdf", ".step", ".plates.json", ".parts.csv")
PRINT_FORMATS = (".stl", ".3mf", ".step")


def sheets_of(plate_set: Any) -> tuple[Sheet, ...]:
    """The plates' cut paths, laid out on sheets.

    Raises
    ------
    SketchError, FabricationError
        Where there are no plates, or they fit on no sheet.
    StoppedError
        Where a person did not wait for it.
    """
    words = host.translate("InContext", "Laying the plates out on sheets ...")
    return pipeline.in_sight(words, _laid_out, joined_of(plate_set), settings_of(plate_set))


def _laid_out(joined: Joined, settings: PlateSettings) -> tuple[Sheet, ...]:
    from ..fabrication.marks import edge_marks
    from ..fabrication.sheets import lay_out

    marks = edge_marks(joined.plates, joined.joints)
    return lay_out(joined.plates, settings, marks, joined.joints)


def usual_formats(plate_set: Any) -> tuple[str, ...]:
    """The formats that are written where nothing else is asked for, as its properties say."""
    wanted = [".dxf", ".svg", ".step", ".plates.json"]
    if plate_set.WithPdf or plate_set.PdfPage:
        wanted.append(".pdf")
    if plate_set.WithPartsList:
        wanted.append(".parts.csv")
    return tuple(one for one in PLATE_FORMATS if one in wanted)


def plate_file(plate_set: Any, sheets: Sequence[Sheet], ending: str) -> bytes:
    """One file of a plate set, whatever its format."""
    from ..fabrication.dxf import dxf_bytes
    from ..fabrication.parts import parts_csv_bytes, parts_list
    from ..fabrication.pdf import pdf_bytes
    from ..fabrication.plates_json import plates_json_bytes
    from ..fabrication.presets import load_preset
    from ..fabrication.solids import plates_step_bytes
    from ..fabrication.svg import svg_bytes

    shop, plates = shop_settings_of(plate_set), joined_of(plate_set).plates
    preset = load_preset(shop.preset)
    make: dict[str, Callable[[], bytes]] = {
        ".dxf": lambda: dxf_bytes(sheets, preset),
        ".svg": lambda: svg_bytes(sheets, preset),
        ".pdf": lambda: pdf_bytes(sheets, preset, shop.page),
        ".step": lambda: plates_step_bytes(plates, plate_set.Label),
        ".plates.json": lambda: plates_json_bytes(plates),
        ".parts.csv": lambda: parts_csv_bytes(parts_list(plates, sheets, shop)),
    }
    return pipeline.in_sight(_writing(ending), make[ending])


def _writing(ending: str) -> str:
    return host.translate("InContext", "Writing the {} file ...").format(ending[1:].upper())


def export_plates(
    plate_set: Any, folder: Path, name: str, formats: Iterable[str] | None = None
) -> tuple[Path, ...]:
    """Write the plates' files: all of them or none.

    Parameters
    ----------
    plate_set : FreeCAD document object
    folder : Path
        Made where it is missing.
    name : str
        What stands before the endings.
    formats : iterable of str, optional
        Of `PLATE_FORMATS`; those of `usual_formats` by default. The fit test is written besides,
        where the plate set asks for it.

    Returns
    -------
    tuple of Path

    Raises
    ------
    SketchError, FabricationError
        Where there are no plates, they fit on no sheet, or the folder cannot be written.
    """
    from ...solver.files import write_files
    from ..making import coupon_files

    sheets = sheets_of(plate_set)
    wanted = usual_formats(plate_set) if formats is None else tuple(formats)
    contents = {name + ending: plate_file(plate_set, sheets, ending) for ending in wanted}
    if plate_set.WithCoupon:
        contents |= coupon_files(settings_of(plate_set), shop_settings_of(plate_set), name)
    paths = {folder / file: data for file, data in contents.items()}
    write_files(paths)
    return tuple(paths)


def export_print(
    shelled_solid: Any, folder: Path, name: str, formats: Iterable[str] = PRINT_FORMATS
) -> tuple[Path, ...]:
    """Write a shelled solid's files: all of them or none.

    Parameters
    ----------
    shelled_solid : FreeCAD document object
    folder : Path
        Made where it is missing.
    name : str
        What stands before the endings, and the solid's name in the 3MF.
    formats : iterable of str
        Of `PRINT_FORMATS`.

    Returns
    -------
    tuple of Path

    Raises
    ------
    SketchError, FabricationError
        Where there is no solid, or the folder cannot be written.
    """
    from ...solver.files import write_files

    paths = {
        folder / (name + ending): print_file(shelled_solid, name, ending) for ending in formats
    }
    write_files(paths)
    return tuple(paths)


def print_file(shelled_solid: Any, name: str, ending: str) -> bytes:
    """One file of a shelled solid, whatever its format."""
    from .driven import driven_text
    from .shelled_solid import settings_of as shell_settings_of

    settings = shell_settings_of(shelled_solid)
    solid, mesh = pipeline.printed_of(driven_text(shelled_solid.LiftedModel), settings)

    def make() -> bytes:
        from ..fabrication.meshes import stl_bytes, threemf_bytes
        from ..fabrication.solids import shape_step_bytes

        with host.own_packages_first():
            if ending == ".step":
                return shape_step_bytes(solid, name)
            return stl_bytes(mesh) if ending == ".stl" else threemf_bytes(mesh, name)

    return pipeline.in_sight(_writing(ending), make)
