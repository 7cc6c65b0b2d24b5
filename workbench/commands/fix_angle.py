"""From an angle that is shown to one that drives, and back."""

from __future__ import annotations

from .. import host
from .base import Command, CommandError
from .fix_length import fix_or_free, selected_elements


class FixAngle(Command):
    """Fix the angle between two selected edges as it is, or let it follow again."""

    NAME = "InContext_FixAngle"
    ICON = "InContext_FixAngle"
    MENU_TEXT = "Fix or free angle"
    TOOLTIP = (
        "Fix the angle between two edges that meet, selected in 3D, to type it anew among the "
        "model's dimensions; a fixed one follows the drawing again"
    )
    SHORTCUT = "I, A"
    NEEDS = ("numpy", "scipy")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With two edges of a lifted model selected."""
        return any(_are_two_edges(elements) for _, elements in selected_elements())

    def run(self) -> None:
        """See the class."""
        from ..features.picking import corner_at

        for model, elements in selected_elements():
            corner = corner_at(model, elements) if _are_two_edges(elements) else None
            if corner is None:
                words = "no angle lies between these: select two drawn edges that meet"
                raise CommandError(host.translate("InContext", words))
            fix_or_free(model, [corner])


def _are_two_edges(elements: tuple[str, ...]) -> bool:
    return len(elements) == 2 and all(name.startswith("Edge") for name in elements)
