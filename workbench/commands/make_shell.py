"""From the model to a hollow solid."""

from __future__ import annotations

from typing import Any

from .. import host
from .base import Command
from .choosing import reveal
from .lift import has_sketch_or_model, model_to_make


class MakeShell(Command):
    """Make the hollow solid of a lifted model."""

    NAME = "InContext_MakeShell"
    ICON = "InContext_ShelledSolid"
    MENU_TEXT = "Make shelled solid"
    TOOLTIP = (
        "Make one hollow solid of the sketch, for a 3D printer; faces left out are openings. "
        "The first time takes some seconds"
    )
    SHORTCUT = "I, S"
    NEEDS = ("numpy", "scipy", "cadquery")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With a lifted model in the document, or a sketch to lift first."""
        return has_sketch_or_model()

    def run(self) -> None:
        """See the class."""
        from ..panels.waiting import busy

        model = model_to_make()
        with busy():
            solid = shell_for(model)
        reveal(solid.Document)


def shell_for(lifted_model: Any) -> Any:
    """The hollow solid of a lifted model."""
    from ..features.shelled_solid import make_shelled_solid

    document = lifted_model.Document
    with host.transaction(document, host.translate("InContext", "Make shelled solid")):
        solid = make_shelled_solid(document, lifted_model)
        document.recompute()
    return solid
