"""Another photo under the same sketch."""

from __future__ import annotations

from .. import host
from ..features.photo_sketch import is_photo_sketch
from .base import Command
from .choosing import chosen, objects_of


class ReplacePhoto(Command):
    """Ask for a photo, put it under the sketch."""

    NAME = "InContext_ReplacePhoto"
    ICON = "InContext_ReplacePhoto"
    MENU_TEXT = "Replace photo..."
    TOOLTIP = "Put another photo under the sketch; a photo can also be dropped on it or pasted"

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With a photo sketch in the document."""
        return bool(objects_of(is_photo_sketch))

    def run(self) -> None:
        """See the class."""
        from ..canvas.photo import photo_size
        from ..features.photo_change import replace_photo
        from ..panels.asking import ask_for_file, photo_kinds

        sketch = chosen(is_photo_sketch, "a photo sketch")
        path = ask_for_file(host.translate(self.NAME, "Choose a photo"), photo_kinds())
        if path is not None:
            replace_photo(sketch, path, photo_size(path))
