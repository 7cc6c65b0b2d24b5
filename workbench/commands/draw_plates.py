"""A technical drawing of the plates."""

from __future__ import annotations

from typing import Any

from .. import host
from ..features.plate_set import is_plate_set
from .base import Command
from .choosing import chosen, objects_of

#: After this long a new tab has its size, also in FreeCAD 1.1.
SETTLING_MS = 400


class DrawPlates(Command):
    """Make a TechDraw page of the plates."""

    NAME = "InContext_DrawPlates"
    ICON = "InContext_DrawPlates"
    MENU_TEXT = "Drawing of the plates"
    TOOLTIP = "Make a TechDraw page of the plates with their main sizes and a parts list"
    SHORTCUT = "I, D"
    NEEDS = ("numpy", "scipy", "shapely")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With plates in the document."""
        return bool(objects_of(is_plate_set))

    def run(self) -> None:
        """See the class."""
        page = drawing_for(chosen(is_plate_set, "a plate set"))
        page.ViewObject.doubleClicked()
        _show_whole_page()


def _show_whole_page() -> None:
    """At once, and when the new tab has its last size: FreeCAD shows some corner of the page."""
    import FreeCADGui

    from ..canvas.qt import QtCore

    for delay_ms in (0, SETTLING_MS):
        QtCore.QTimer.singleShot(delay_ms, lambda: FreeCADGui.SendMsgToActiveView("ViewFit"))


def drawing_for(plate_set: Any) -> Any:
    """The page of a plate set."""
    from ..features.plate_drawing import add_sizes, make_plate_drawing, views_are_ready
    from ..panels.waiting import busy, wait_for

    document = plate_set.Document
    with busy(), host.transaction(document, host.translate("InContext", "Drawing of the plates")):
        page = make_plate_drawing(document, plate_set)
        wait_for(lambda: views_are_ready(page))
        add_sizes(page)
        document.recompute()
    return page
