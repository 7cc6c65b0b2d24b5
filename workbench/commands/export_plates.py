"""The plates' files: DXF and SVG for the cutter, STEP and plates.json for other programs."""

from __future__ import annotations

from typing import Any

from .. import host
from ..features.plate_set import is_plate_set
from .base import Command
from .choosing import chosen, objects_of


class ExportPlates(Command):
    """Ask for a folder, write the files."""

    NAME = "InContext_ExportPlates"
    ICON = "InContext_ExportPlates"
    MENU_TEXT = "Export plates..."
    TOOLTIP = (
        "Write the plates as DXF, SVG, STEP and plates.json into a folder; where a fit test is "
        "selected, write that"
    )
    SHORTCUT = "I, X"
    NEEDS = ("numpy", "scipy", "shapely", "ezdxf")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With plates in the document."""
        return bool(objects_of(is_plate_set))

    def run(self) -> None:
        """See the class."""
        from ..features.exports import export_plates
        from ..features.fit_test import export_fit_test
        from ..panels.asking import ask_for_folder

        fit_test = _selected_fit_test()
        what = fit_test or chosen(is_plate_set, "a plate set")
        folder = ask_for_folder(host.translate(self.NAME, "Choose a folder for the plates"))
        if folder is None:
            return
        export = export_plates if fit_test is None else export_fit_test
        for path in export(what, folder, file_name(what)):
            host.note(str(path))


def _selected_fit_test() -> Any:
    import FreeCADGui

    from ..features.fit_test import is_fit_test

    found = [obj for obj in FreeCADGui.Selection.getSelection() if is_fit_test(obj)]
    return found[0] if len(found) == 1 else None


def file_name(plate_set) -> str:
    """What the files are called: as the document, without what file systems refuse."""
    label = plate_set.Document.Label
    return "".join(c if c.isalnum() or c in "-_ " else "_" for c in label).strip() or "plates"
