"""The tab of a photo sketch."""

from __future__ import annotations

from ..features.photo_sketch import is_photo_sketch
from .base import Command
from .choosing import chosen, objects_of


class EditSketch(Command):
    """Show the tab."""

    NAME = "InContext_EditSketch"
    ICON = "InContext_EditSketch"
    MENU_TEXT = "Edit sketch"
    TOOLTIP = "Show the photo and the sketch over it; drag a vertex, and the model follows"
    SHORTCUT = "I, E"

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With a photo sketch in the document."""
        return bool(objects_of(is_photo_sketch))

    def run(self) -> None:
        """See the class."""
        from ..panels.tabs import show_tab
        from ..panels.tiling import show_side_by_side

        show_side_by_side(show_tab(chosen(is_photo_sketch, "a photo sketch")))
