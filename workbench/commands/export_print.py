"""The print's files: STL and 3MF for the slicer, STEP for other programs."""

from __future__ import annotations

from typing import Any

from .. import host
from ..features.shelled_solid import is_shelled_solid
from .base import Command
from .choosing import chosen, objects_of
from .export_plates import file_name


class ExportPrint(Command):
    """Ask for formats and a folder, write the files."""

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
        from ..features.exports import PRINT_FORMATS, export_print
        from ..panels.export_dialog import ExportDialog, ask_what_to_export
        from ..panels.waiting import busy

        solid = chosen(is_shelled_solid, "a shelled solid")
        title = host.translate("InContext", "Export print")
        formats = dict.fromkeys(PRINT_FORMATS, True)
        choice = ask_what_to_export(
            ExportDialog(title, size_words(solid), formats, file_name(solid))
        )
        if choice is None:
            return
        with busy():
            paths = export_print(solid, choice.folder, choice.name, choice.formats)
        for path in paths:
            host.note(str(path))


def size_words(solid: Any) -> str:
    """How large a solid is, and what it says of itself."""
    box = solid.Shape.BoundBox
    size = f"{box.XLength:.1f} x {box.YLength:.1f} x {box.ZLength:.1f} mm"
    return f"{size}; {solid.Message}"
