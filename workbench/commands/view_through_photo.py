"""The 3D view as the photo's camera saw it, with the photo behind the object."""

from __future__ import annotations

from ..features.photo_sketch import is_photo_sketch
from .base import Command
from .choosing import chosen, objects_of


class ViewThroughPhoto(Command):
    """Look through the photo; once more brings the old view back."""

    NAME = "InContext_ViewThroughPhoto"
    ICON = "InContext_ViewThroughPhoto"
    MENU_TEXT = "View through photo"
    TOOLTIP = (
        "Look at the 3D model from where the photo was taken, with the photo behind it; "
        "once more brings the old view back"
    )
    SHORTCUT = "I, V"

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With a photo sketch in the document."""
        return bool(objects_of(is_photo_sketch))

    def run(self) -> None:
        """See the class."""
        from ..panels.tabs import show_tab
        from ..panels.view_through import look_as_before, look_through, looks_through

        sketch = chosen(is_photo_sketch, "a photo sketch")
        if looks_through(sketch):
            look_as_before(sketch)
            return
        show_tab(sketch)
        look_through(sketch)
