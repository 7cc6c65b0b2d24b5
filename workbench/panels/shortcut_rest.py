"""Our shortcuts rest while a sketch has the keyboard.

They begin with a letter and go on with another one, as FreeCAD's own do. Qt remembers the first
one for as long as it takes: begun in the tree, one would go on with a key that is meant for the
sketch, which cannot claim the second letter of a shortcut as it claims first ones.
"""

from __future__ import annotations

import FreeCADGui

from ..canvas.qt import QtCore, QtGui

_Qt = QtCore.Qt
#: Those that rest now, and where they are heard else.
_resting: list[tuple[QtGui.QAction, _Qt.ShortcutContext]] = []


class ShortcutRest(QtCore.QObject):
    """Watches one widget; lives as long as it does."""

    def __init__(self, watched: QtGui.QWidget) -> None:
        super().__init__(watched)
        watched.installEventFilter(self)
        watched.destroyed.connect(_wake)

    def eventFilter(self, watched: QtCore.QObject, event: QtCore.QEvent) -> bool:  # noqa: N802
        """See Qt."""
        if event.type() == QtCore.QEvent.FocusIn:
            _wake()
            _rest()
        elif event.type() == QtCore.QEvent.FocusOut:
            _wake()
        return False


def _rest() -> None:
    for action in FreeCADGui.getMainWindow().findChildren(QtGui.QAction):
        if action.objectName().startswith("InContext_") and not action.shortcut().isEmpty():
            _resting.append((action, action.shortcutContext()))
            # No button or menu has the keyboard itself.
            action.setShortcutContext(_Qt.WidgetShortcut)


def _wake(*_: object) -> None:
    while _resting:
        action, context = _resting.pop()
        action.setShortcutContext(context)
