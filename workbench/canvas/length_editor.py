"""The small field over the photo in which a length, a diameter or a thickness is typed."""

from __future__ import annotations

from collections.abc import Callable

from . import style
from .lengths import exact_text, parse_length
from .qt import QtCore, QtGui
from .questions import About, Question

_Qt = QtCore.Qt

_EXAMPLES = {
    About.EDGE: "210, 21 cm, 3/4 in",
    About.CIRCLE: "90, 9 cm, 3/4 in",
    About.FACE: "3, 0.5 cm, 1/8 in",
}


class LengthEditor(QtGui.QLineEdit):
    """Opens where it is asked; Enter says the length, Escape or a click elsewhere says nothing.

    Parameters
    ----------
    parent : QWidget
        What it lies on.
    said : callable
        Takes the question, and the length in mm or None where the field was emptied.
    """

    def __init__(
        self, parent: QtGui.QWidget, said: Callable[[Question, float | None], None]
    ) -> None:
        super().__init__(parent)
        self._said = said
        self._question: Question | None = None
        self.textChanged.connect(self._make_room)
        self.textEdited.connect(lambda _: self._show_fault(""))
        self.hide()

    def open(self, question: Question, middle: QtCore.QPoint, begun: str = "") -> None:
        """Ask, at a place on the screen; the answer may have been begun."""
        self._question = question
        self._show_fault("")
        self.setPlaceholderText(self._view().in_words(_EXAMPLES[question.about]))
        said = "" if question.said_mm is None else exact_text(question.said_mm)
        self.setText(begun or said)
        self._make_room(self.text())
        if not begun:
            self.selectAll()
        area = self.parentWidget().rect()
        self.adjustSize()
        x = max(0, min(middle.x() - self.width() // 2, area.width() - self.width()))
        y = max(0, min(middle.y() - self.height() // 2, area.height() - self.height()))
        self.move(x, y)
        self.show()
        self.setFocus()

    def _make_room(self, text: str) -> None:
        """As wide as an example, or what is typed."""
        texts = (text, *_EXAMPLES.values())
        width = max(self.fontMetrics().size(0, words).width() for words in texts) + 20
        self.setFixedWidth(min(width, self.parentWidget().width()))
        self.move(max(0, min(self.x(), self.parentWidget().width() - self.width())), self.y())

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
            self._show_fault(self._view().in_words(str(error)))
            return
        self.close_unsaid()
        if self._question is not None:
            self._said(self._question, length)

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
