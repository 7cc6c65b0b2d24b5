"""Commands whose words follow when a person takes another language for FreeCAD.

FreeCAD keeps the mapping that a command's `GetResources` gave, and shows its words anew whenever
the language changes. So the same mapping gets the words of the new language just before.
"""

from __future__ import annotations

from typing import Any

from ..canvas.qt import QtCore
from .base import Command

_shown: list[tuple[Command, dict[str, Any]]] = []


def add_command(command: Command) -> None:
    """Make a command known to FreeCAD."""
    import FreeCADGui

    words: dict[str, Any] = command.GetResources()
    _shown.append((command, words))
    FreeCADGui.addCommand(command.NAME, _Kept(command, words))


def translate_anew() -> None:
    """Give all commands the words of the language that is FreeCAD's now."""
    for command, words in _shown:
        words.update(command.GetResources())


class _Kept:
    """A command as FreeCAD has it: always with the same mapping of words."""

    def __init__(self, command: Command, words: dict[str, Any]) -> None:
        self._words = words
        self.IsActive = command.IsActive
        self.Activated = command.Activated

    def GetResources(self) -> dict[str, Any]:  # noqa: N802  FreeCAD's name
        """How the command looks in menus and toolbars."""
        return self._words


class _Listener(QtCore.QObject):
    """Hears of a new language before FreeCAD's window does."""

    def eventFilter(self, watched: QtCore.QObject, event: QtCore.QEvent) -> bool:  # noqa: N802
        """See Qt."""
        if event.type() == QtCore.QEvent.LanguageChange:
            translate_anew()
        return False


def follow_language() -> None:
    """From now on the words follow."""
    import FreeCADGui

    window = FreeCADGui.getMainWindow()
    window.installEventFilter(_Listener(window))
