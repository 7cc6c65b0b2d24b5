"""From the sketch to its 3D model."""

from __future__ import annotations

from typing import Any

from .. import host
from ..features.photo_sketch import is_photo_sketch
from .base import Command
from .choosing import chosen, objects_of, reveal


class Lift(Command):
    """Make the lifted model of a photo sketch."""

    NAME = "InContext_Lift"
    ICON = "InContext_LiftedModel"
    MENU_TEXT = "Lift to 3D"
    TOOLTIP = "Make the 3D model of the sketch; it follows every change of the sketch"
    SHORTCUT = "I, L"

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With a photo sketch in the document."""
        return bool(objects_of(is_photo_sketch))

    def run(self) -> None:
        """See the class."""
        from ..panels.view_3d import look_from_the_camera

        model = lift(chosen(is_photo_sketch, "a photo sketch"))
        reveal(model.Document)
        if not model.Shape.isNull():
            look_from_the_camera(model)


def lift(photo_sketch: Any) -> Any:
    """The lifted model of a photo sketch."""
    from ..features.lifted_model import make_lifted_model

    document = photo_sketch.Document
    with host.transaction(document, host.translate("InContext", "Lift to 3D")):
        model = make_lifted_model(document, photo_sketch)
        document.recompute()
    return model
