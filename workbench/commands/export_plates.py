"""The plates' files: DXF and SVG for the cutter, STEP and plates.json for other programs."""

from __future__ import annotations

from .. import host
from ..features.plate_set import is_plate_set
from .base import Command
from .choosing import chosen, objects_of


class ExportPlates(Command):
    """Ask for a folder, write the files."""

    NAME = "InContext_ExportPlates"
    ICON = "InContext_ExportPlates"
    MENU_TEXT = "Export plates..."
    TOOLTIP = "Write the plates as DXF, SVG, STEP and plates.json into a folder"
    SHORTCUT = "I, X"
    NEEDS = ("numpy", "scipy", "shapely", "ezdxf")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With plates in the document."""
        return bool(objects_of(is_plate_set))

    def run(self) -> None:
        """See the class."""
        from ..features.exports import export_plates
        from ..panels.asking import ask_for_folder

        plate_set = chosen(is_plate_set, "a plate set")
        folder = ask_for_folder(host.translate(self.NAME, "Choose a folder for the plates"))
        if folder is None:
            return
        for path in export_plates(plate_set, folder, file_name(plate_set)):
            host.note(str(path))


def file_name(plate_set) -> str:
    """What the files are called: as the document, without what file systems refuse."""
    label = plate_set.Document.Label
    return "".join(c if c.isalnum() or c in "-_ " else "_" for c in label).strip() or "plates"
