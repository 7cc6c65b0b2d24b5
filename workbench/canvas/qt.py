"""Qt, by the one way that FreeCAD 0.20 to 1.1 share: all classes, widgets too, from `QtGui`.

FreeCAD's `PySide` stands for PySide2 or PySide6, whichever FreeCAD was built with.
"""

from PySide import QtCore, QtGui

__all__ = ["QtCore", "QtGui"]
