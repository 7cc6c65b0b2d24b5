"""Telling a person that something did not work, in a small window."""

from __future__ import annotations

import FreeCADGui

from .. import host
from ..canvas.qt import QtGui


def tell(words: str) -> None:
    """Say what went wrong and what to try; also in the report view, to copy from."""
    host.report(words)
    QtGui.QMessageBox.warning(
        FreeCADGui.getMainWindow(), host.translate("InContext", "Modeling in Context"), words
    )
