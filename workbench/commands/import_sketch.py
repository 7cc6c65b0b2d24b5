"""A photo sketch from a sketch file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from .. import host
from .base import Command, active_document


class ImportSketch(Command):
    """Ask for a sketch file, open its tab."""

    NAME = "InContext_ImportSketch"
    ICON = "InContext_ImportSketch"
    MENU_TEXT = "Import sketch..."
    TOOLTIP = "Open a .sketch.json file; its photo is taken from beside it"
    SHORTCUT = "I, I"

    def run(self) -> None:
        """See the class."""
        from ..panels.asking import ask_for_file
        from ..panels.tabs import show_tab

        kinds = "Sketches (*.sketch.json);;All files (*)"
        path = ask_for_file(host.translate(self.NAME, "Choose a sketch"), kinds)
        if path is not None:
            show_tab(imported(active_document(), path))


def imported(document: Any, path: Path) -> Any:
    """A photo sketch from a sketch file; raises SketchError."""
    from ..features.examples import import_sketch

    with host.transaction(document, host.translate("InContext", "Import sketch")):
        obj = import_sketch(document, path)
        document.recompute()
    return obj
