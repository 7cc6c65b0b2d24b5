"""File > Export: what FreeCAD calls for the kinds of files that `Init.py` tells it of."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from .. import host
from ..problems import in_words, known_problems
from .exports import PLATE_FORMATS, PRINT_FORMATS, plate_file, print_file, sheets_of
from .plate_set import is_plate_set
from .shelled_solid import is_shelled_solid


def export(objects: list[Any], filename: str) -> None:
    """Write the selected plates or print into one file.

    Parameters
    ----------
    objects : list of FreeCAD document objects
    filename : str
        Its ending tells the format.

    Raises
    ------
    RuntimeError
        Where nothing of it can be written; FreeCAD shows the words.
    """
    from ...solver.files import write_files

    path = Path(filename)
    try:
        write_files({path: _content(objects, path)})
    except known_problems() as error:
        raise RuntimeError(in_words(error)) from None


def _content(objects: list[Any], path: Path) -> bytes:
    plates = [obj for obj in objects if is_plate_set(obj)]
    solids = [obj for obj in objects if is_shelled_solid(obj)]
    name = path.name.lower()
    if len(plates) + len(solids) != 1:
        words = "select one set of plates or one shelled solid; each goes into a file of its own"
        raise RuntimeError(host.translate("InContext", words))
    formats = PLATE_FORMATS if plates else PRINT_FORMATS
    ending = next((one for one in formats if name.endswith(one)), None)
    if ending is None:
        words = host.translate("InContext", "{0} cannot be written as {1}; there are: {2}")
        label, kinds = objects[0].Label, ", ".join(formats)
        raise RuntimeError(words.format(label, path.suffix or path.name, kinds))
    if plates:
        return plate_file(plates[0], sheets_of(plates[0]), ending)
    return print_file(solids[0], path.name[: -len(ending)], ending)
