"""Qt, by the one way that FreeCAD 0.20 to 1.1 share: all classes, widgets too, from `QtGui`.

FreeCAD's `PySide` stands for PySide2 or PySide6, whichever FreeCAD was built with.
"""

from PySide import QtCore, QtGui

__all__ = ["QtCore", "QtGui", "position_of"]


def position_of(event: QtGui.QMouseEvent) -> QtCore.QPoint:
    """Where the pointer is in its widget, px: Qt 6 has another name for it."""
    return event.position().toPoint() if hasattr(event, "position") else event.pos()
