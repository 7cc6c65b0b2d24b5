"""From the model to plates."""

from __future__ import annotations

from typing import Any

from .. import host
from .base import Command
from .choosing import reveal
from .lift import has_sketch_or_model, model_to_make


class MakePlates(Command):
    """Make the plates of a lifted model."""

    NAME = "InContext_MakePlates"
    ICON = "InContext_PlateSet"
    MENU_TEXT = "Make plates"
    TOOLTIP = (
        "Make finger-jointed plates of the sketch; thickness, fingers, play and kerf are "
        "properties of the result"
    )
    SHORTCUT = "I, P"
    NEEDS = ("numpy", "scipy", "shapely", "manifold3d")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With a lifted model in the document, or a sketch to lift first."""
        return has_sketch_or_model()

    def run(self) -> None:
        """See the class."""
        plate_set = plates_for(model_to_make())
        reveal(plate_set.Document)


def plates_for(lifted_model: Any) -> Any:
    """The plate set of a lifted model."""
    from ..features.plate_set import make_plate_set

    document = lifted_model.Document
    with host.transaction(document, host.translate("InContext", "Make plates")):
        plate_set = make_plate_set(document, lifted_model)
        document.recompute()
    return plate_set
