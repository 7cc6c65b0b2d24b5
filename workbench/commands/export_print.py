"""The print's files: STL and 3MF for the slicer, STEP for other programs."""

from __future__ import annotations

from .. import host
from ..features.shelled_solid import is_shelled_solid
from .base import Command
from .choosing import chosen, objects_of
from .export_plates import file_name


class ExportPrint(Command):
    """Ask for a folder, write the files."""

    NAME = "InContext_ExportPrint"
    ICON = "InContext_ExportPrint"
    MENU_TEXT = "Export print..."
    TOOLTIP = "Write the shelled solid as STL, 3MF and STEP into a folder"
    SHORTCUT = "I, 3"
    NEEDS = ("numpy", "scipy", "cadquery", "manifold3d", "lib3mf")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With a shelled solid in the document."""
        return bool(objects_of(is_shelled_solid))

    def run(self) -> None:
        """See the class."""
        from ..features.exports import export_print
        from ..panels.asking import ask_for_folder

        solid = chosen(is_shelled_solid, "a shelled solid")
        folder = ask_for_folder(host.translate(self.NAME, "Choose a folder for the print"))
        if folder is None:
            return
        for path in export_print(solid, folder, file_name(solid)):
            host.note(str(path))
