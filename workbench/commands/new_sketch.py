"""A new photo sketch from a photo."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from .. import host
from .base import Command, active_document


class NewSketch(Command):
    """Ask for a photo, open its tab."""

    NAME = "InContext_NewSketch"
    ICON = "InContext_NewSketch"
    MENU_TEXT = "New sketch from a photo..."
    TOOLTIP = (
        "Choose the photo of the place where the new object will live; "
        "it is kept inside the document"
    )
    SHORTCUT = "I, N"

    def run(self) -> None:
        """See the class."""
        from ..panels.asking import ask_for_file, photo_kinds
        from ..panels.tabs import show_tab

        path = ask_for_file(host.translate(self.NAME, "Choose a photo"), photo_kinds())
        if path is not None:
            show_tab(new_sketch(active_document(), path))


def new_sketch(document: Any, path: Path) -> Any:
    """An empty photo sketch over a photo.

    Raises
    ------
    PhotoError
        Where the file is no photo that can be read.
    """
    from ...solver.graph import Photo, SketchGraph
    from ...solver.serialise import sketch_to_text
    from ..canvas.photo import photo_size
    from ..exif import focal_length_px
    from ..features.photo_sketch import make_photo_sketch

    size_px = photo_size(path)
    graph = SketchGraph(photo=Photo(path.name, *size_px, focal_px=focal_length_px(path)))
    with host.transaction(document, host.translate("InContext", "New sketch from a photo")):
        obj = make_photo_sketch(document, sketch_to_text(graph), path)
        document.recompute()
    return obj
