"""Telling a person that something did not work, in a small window."""

from __future__ import annotations

import FreeCADGui

from .. import host
from ..canvas.qt import QtGui
from ..wording import in_language


def tell(words: str) -> None:
    """Say what went wrong and what to try; also in the report view, to copy from."""
    words = in_language(words)
    host.report(words)
    QtGui.QMessageBox.warning(
        FreeCADGui.getMainWindow(), host.translate("InContext", "Modeling in Context"), words
    )


def mention(words: str) -> None:
    """Say how something went; also in the report view."""
    host.note(words)
    QtGui.QMessageBox.information(
        FreeCADGui.getMainWindow(), host.translate("InContext", "Modeling in Context"), words
    )
