"""A new photo sketch from the picture in the clipboard."""

from __future__ import annotations

from .. import host
from .base import Command, CommandError, active_document


class PastePhoto(Command):
    """Take the picture, open its tab."""

    NAME = "InContext_PastePhoto"
    ICON = "InContext_PastePhoto"
    MENU_TEXT = "New sketch from the clipboard"
    TOOLTIP = "Take the picture, or the picture file, that was copied last as the photo"

    def run(self) -> None:
        """See the class."""
        from ..panels.clipboard import photo_file
        from ..panels.tabs import show_tab
        from .new_sketch import new_sketch

        with photo_file() as path:
            if path is None:
                words = "there is no picture in the clipboard; copy one first"
                raise CommandError(host.translate("InContext", words))
            show_tab(new_sketch(active_document(), path))
