"""From the model to a hollow solid."""

from __future__ import annotations

from typing import Any

from .. import host
from ..features.lifted_model import is_lifted_model
from .base import Command
from .choosing import chosen, objects_of, reveal


class MakeShell(Command):
    """Make the hollow solid of a lifted model."""

    NAME = "InContext_MakeShell"
    ICON = "InContext_ShelledSolid"
    MENU_TEXT = "Make shelled solid"
    TOOLTIP = (
        "Make one hollow solid of the model, for a 3D printer; faces left out are openings. "
        "The first time takes some seconds"
    )
    SHORTCUT = "I, S"

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With a lifted model in the document."""
        return bool(objects_of(is_lifted_model))

    def run(self) -> None:
        """See the class."""
        from ..panels.waiting import busy

        model = chosen(is_lifted_model, "a lifted model")
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
