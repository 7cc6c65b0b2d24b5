"""The marker that gives photos their camera and scale, as a file to print."""

from __future__ import annotations

from pathlib import Path

from .. import host
from .base import Command, CommandError


class PrintMarker(Command):
    """Ask for the size and a name, write the file, show it."""

    NAME = "InContext_PrintMarker"
    ICON = "InContext_PrintMarker"
    MENU_TEXT = "Print marker..."
    TOOLTIP = (
        "Write a marker to print as PDF or SVG: on the ground in a photo, it gives the camera and "
        "the scale"
    )
    NEEDS = ("numpy", "scipy")

    def run(self) -> None:
        """See the class."""
        from ..marker_sheet import USUAL_SIZE_MM
        from ..panels.asking import ask_for_length, ask_for_new_file, show_file

        title = host.translate("InContext", "Print marker")
        words = host.translate("InContext", "Side of the black square")
        try:
            size_mm = ask_for_length(title, words, USUAL_SIZE_MM)
        except ValueError as error:
            raise CommandError(host.translate("InContext", str(error))) from error
        path = (
            None
            if size_mm is None
            else ask_for_new_file(title, "PDF (*.pdf);;SVG (*.svg)", "marker.pdf")
        )
        if path is not None:
            write_marker(path, size_mm)
            show_file(path)


def write_marker(path: Path, size_mm: float) -> None:
    """Write the marker's file, and say where it is."""
    from ...solver.files import write_files
    from ..marker_sheet import marker_file

    write_files({path: marker_file(path, size_mm)})
    host.note(str(path))
