"""Does it fit what is on the photo, and will it stand?"""

from __future__ import annotations

from typing import Any

from .. import host
from .base import Command
from .choosing import chosen, objects_of


class CheckFit(Command):
    """Check plates or a solid against the things on the photo, and show the numbers."""

    NAME = "InContext_CheckFit"
    ICON = "InContext_FitCheck"
    MENU_TEXT = "Check fit"
    TOOLTIP = (
        "Test the plates or the solid against the things traced on the photo, and whether they "
        "stand: clearance, overlaps in red, centre of mass, loose and thin parts"
    )
    SHORTCUT = "I, H"
    NEEDS = ("numpy", "scipy", "shapely", "manifold3d")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With plates or a shelled solid in the document."""
        from ..features.fit_check import can_be_checked

        return bool(objects_of(can_be_checked))

    def run(self) -> None:
        """See the class."""
        from ..panels.fit_panel import show_fit

        show_fit(fit_check_for(_selected_check() or _to_check()))


def _selected_check() -> Any:
    import FreeCADGui

    from ..features.fit_check import is_fit_check

    found = [obj for obj in FreeCADGui.Selection.getSelection() if is_fit_check(obj)]
    return found[0].Checked if len(found) == 1 else None


def _to_check() -> Any:
    from ..features.fit_check import can_be_checked

    return chosen(can_be_checked, "plates or a shelled solid")


def fit_check_for(made: Any) -> Any:
    """The fit check of plates or a solid, a new one where there is none."""
    from ..features.fit_check import is_fit_check, make_fit_check

    document = made.Document
    known = [obj for obj in document.Objects if is_fit_check(obj) and obj.Checked is made]
    if known:
        document.recompute()
        return known[0]
    with host.transaction(document, host.translate("InContext", "Check fit")):
        check = make_fit_check(document, made)
        document.recompute()
    return check
