"""The numbers of a fit check, beside the 3D view."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .. import host
from ..canvas.qt import QtCore, QtGui

_GOOD, _BAD, _NOTE = "#2e7d32", "#c62828", "#8a6d00"


class FitPanel:
    """A task panel; FreeCAD asks for `form` and the buttons.

    Parameters
    ----------
    check : FreeCAD document object
        A fit check.
    """

    def __init__(self, check: Any) -> None:
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(check.Label)
        self.form.setWindowIcon(QtGui.QIcon(host.icon("InContext_FitCheck")))
        layout = QtGui.QVBoxLayout(self.form)
        for title, lines in sections(check):
            words = QtGui.QLabel(_html(title, lines))
            words.setWordWrap(True)
            words.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
            layout.addWidget(words)
        layout.addStretch()

    def getStandardButtons(self) -> int:  # noqa: N802  FreeCAD's name
        """One button: nothing is changed here."""
        button = QtGui.QDialogButtonBox.Close
        # PySide6 has enumerations, older bindings have numbers.
        return int(getattr(button, "value", button))

    def reject(self) -> bool:
        """Close."""
        FreeCADGui.Control.closeDialog()
        return True


def sections(check: Any) -> list[tuple[str, list[tuple[str, str]]]]:
    """What the panel says: titles, each with lines and their colours."""
    translate = host.translate
    if check.Status not in ("good", "in_the_way", "tips_over"):
        return [(check.Label, [(_BAD, check.Message)])]
    things = [
        (_GOOD if fits else _BAD, line) for fits, line in zip(check.Fits, check.Things, strict=True)
    ]
    hint = translate(
        "InContext",
        "Nothing is traced on the photo to fit to. Draw what is there with the line, box or "
        "circle tool and press X to make it construction.",
    )
    found = [
        (translate("InContext", "Does it fit?"), things or [(_NOTE, hint)]),
        (
            translate("InContext", "Will it stand?"),
            [(_GOOD if check.Stands else _BAD, check.Standing)],
        ),
    ]
    if check.WeakSpots:
        weak = [(_NOTE, line) for line in check.WeakSpots]
        found.append((translate("InContext", "Loose or thin"), weak))
    return found


def _html(title: str, lines: list[tuple[str, str]]) -> str:
    from html import escape

    rows = "".join(
        f'<p style="margin:4px 0"><span style="color:{colour}">&#9632;</span> {escape(line)}</p>'
        for colour, line in lines
    )
    return f"<b>{escape(title)}</b>{rows}"


def show_fit(check: Any) -> None:
    """Show the numbers of a fit check, in place of those shown before."""
    if FreeCADGui.Control.activeDialog():
        FreeCADGui.Control.closeDialog()
    FreeCADGui.Control.showDialog(FitPanel(check))
