"""What is known of the camera that took the photo."""

from __future__ import annotations

from .. import host
from ..features.photo_sketch import is_photo_sketch
from .base import Command, CommandError
from .choosing import chosen, objects_of


class PhotoCamera(Command):
    """See and say the focal length, and where the camera looked in a cropped photo."""

    NAME = "InContext_PhotoCamera"
    ICON = "InContext_PhotoCamera"
    MENU_TEXT = "Camera of the photo..."
    TOOLTIP = (
        "See and say what is known of the camera: its focal length, and in a cropped photo "
        "where it looked"
    )
    NEEDS = ("numpy", "scipy")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With a photo sketch in the document."""
        return bool(objects_of(is_photo_sketch))

    def run(self) -> None:
        """See the class."""
        from ..features.pipeline import graph_of
        from ..panels.camera_dialog import CameraDialog

        sketch = chosen(is_photo_sketch, "a photo sketch")
        if graph_of(sketch.Sketch).photo is None:
            raise CommandError(host.translate("InContext", "There is no photo: choose one first."))
        CameraDialog(sketch).show_until_answered()
