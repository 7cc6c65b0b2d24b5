"""The plates' files: DXF and SVG for the cutter, STEP and plates.json for other programs."""

from __future__ import annotations

from typing import Any

from .. import host
from ..features.plate_set import is_plate_set
from .base import Command
from .choosing import chosen, objects_of


class ExportPlates(Command):
    """Show the sheets, ask for formats and a folder, write the files."""

    NAME = "InContext_ExportPlates"
    ICON = "InContext_ExportPlates"
    MENU_TEXT = "Export plates..."
    TOOLTIP = (
        "Show the sheets and the length of the cuts, and write DXF, SVG, PDF, STEP and lists; "
        "where a fit test is selected, write that"
    )
    SHORTCUT = "I, X"
    NEEDS = ("numpy", "scipy", "shapely", "ezdxf")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With plates in the document."""
        return bool(objects_of(is_plate_set))

    def run(self) -> None:
        """See the class."""
        fit_test = _selected_fit_test()
        if fit_test is not None:
            _export_fit_test(fit_test)
            return
        from ..features.exports import export_plates
        from ..panels.export_dialog import ask_what_to_export

        plate_set = chosen(is_plate_set, "a plate set")
        choice = ask_what_to_export(dialog_for(plate_set))
        if choice is None:
            return
        for path in export_plates(plate_set, choice.folder, choice.name, choice.formats):
            host.note(str(path))


def dialog_for(plate_set: Any) -> Any:
    """The window that shows the sheets of a plate set before they are written.

    Raises
    ------
    SketchError, FabricationError
        Where there are no plates, or they fit on no sheet.
    """
    from ..features.exports import PLATE_FORMATS, usual_formats
    from ..features.sheet_picture import picture_of
    from ..panels.export_dialog import ExportDialog, sheets_words
    from ..panels.sheet_preview import SheetPreview

    picture, usual = picture_of(plate_set), usual_formats(plate_set)
    return ExportDialog(
        host.translate("InContext", "Export plates"),
        sheets_words(picture),
        {ending: ending in usual for ending in PLATE_FORMATS},
        file_name(plate_set),
        SheetPreview(picture),
    )


def _export_fit_test(fit_test: Any) -> None:
    from ..features.fit_test import export_fit_test
    from ..panels.asking import ask_for_folder

    folder = ask_for_folder(host.translate("InContext", "Choose a folder for the fit test"))
    if folder is not None:
        for path in export_fit_test(fit_test, folder, file_name(fit_test)):
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
