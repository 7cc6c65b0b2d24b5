"""A small piece to cut first, which tells the play to set."""

from __future__ import annotations

from typing import Any

from .. import host
from ..features.plate_set import is_plate_set
from .base import Command
from .choosing import chosen, objects_of, reveal


class MakeFitTest(Command):
    """Make the fit test of plates."""

    NAME = "InContext_MakeFitTest"
    ICON = "InContext_FitTest"
    MENU_TEXT = "Make fit test"
    TOOLTIP = (
        "Make a small comb with notches of different play and a tab, with the settings of the "
        "plates: cut it first; selected, it is written by Export plates"
    )
    SHORTCUT = "I, K"
    NEEDS = ("numpy", "scipy", "shapely")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With plates in the document."""
        return bool(objects_of(is_plate_set))

    def run(self) -> None:
        """See the class."""
        fit_test = fit_test_for(chosen(is_plate_set, "a plate set"))
        reveal(fit_test.Document)


def fit_test_for(plate_set: Any) -> Any:
    """The fit test of a plate set."""
    from ..features.fit_test import make_fit_test

    document = plate_set.Document
    with host.transaction(document, host.translate("InContext", "Make fit test")):
        fit_test = make_fit_test(document, plate_set)
        document.recompute()
    return fit_test
