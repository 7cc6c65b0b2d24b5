"""The small field over an edge in which its length is typed."""

from __future__ import annotations

from collections.abc import Callable

from . import style
from .lengths import parse_length
from .qt import QtCore, QtGui

_Qt = QtCore.Qt


class LengthEditor(QtGui.QLineEdit):
    """Opens over an edge; Enter says the length, Escape or a click elsewhere says nothing.

    Parameters
    ----------
    parent : QWidget
        What it lies on.
    said : callable
        Takes the edge, and its length in mm or None where the field was emptied.
    """

    def __init__(self, parent: QtGui.QWidget, said: Callable[[str, float | None], None]) -> None:
        super().__init__(parent)
        self._said = said
        self._edge = ""
        self.setFixedWidth(96)
        self.setPlaceholderText("210, 21 cm, 3/4 in")
        self.textEdited.connect(lambda _: self._show_fault(""))
        self.hide()

    def open(self, edge: str, text: str, middle: QtCore.QPoint) -> None:
        """Ask for the length of an edge, at the middle of it on the screen."""
        self._edge = edge
        self._show_fault("")
        self.setText(text)
        self.selectAll()
        area = self.parentWidget().rect()
        self.adjustSize()
        x = max(0, min(middle.x() - self.width() // 2, area.width() - self.width()))
        y = max(0, min(middle.y() - self.height() // 2, area.height() - self.height()))
        self.move(x, y)
        self.show()
        self.setFocus()

    def close_unsaid(self) -> None:
        """Say nothing."""
        if self.isVisible():
            self.hide()
            self._view().setFocus()

    def _view(self) -> QtGui.QWidget:
        return self.parentWidget().parentWidget()

    def _say(self) -> None:
        text = self.text().strip()
        try:
            length = parse_length(text) if text else None
        except ValueError as error:
            self._show_fault(str(error))
            return
        self.close_unsaid()
        self._said(self._edge, length)

    def _show_fault(self, words: str) -> None:
        """Say what is wrong with the text; nothing where nothing is."""
        self.setStyleSheet(f"border: 2px solid {style.CONFLICT};" if words else "")
        self.setToolTip(words)
        if words:
            QtGui.QToolTip.showText(self.mapToGlobal(QtCore.QPoint(0, self.height())), words, self)

    def event(self, event: QtCore.QEvent) -> bool:
        """Keep every key: FreeCAD has shortcuts for single letters."""
        if event.type() == QtCore.QEvent.ShortcutOverride:
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:  # noqa: N802  Qt's name
        """Enter, Escape; else type."""
        if event.key() in (_Qt.Key_Return, _Qt.Key_Enter):
            self._say()
        elif event.key() == _Qt.Key_Escape:
            self.close_unsaid()
        else:
            super().keyPressEvent(event)
