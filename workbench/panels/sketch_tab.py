"""The tab of a photo sketch: the photo, what to do next, and how the solve went."""

from __future__ import annotations

import re
from functools import partial
from html import escape
from typing import TYPE_CHECKING

from .. import host
from ..canvas.qt import QtCore, QtGui
from ..canvas.view import SketchView

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph

_Qt = QtCore.Qt

GOOD, BAD = "#1f9d3a", "#d8281c"
#: The photo's slider: how faint and how strong the photo can be, per cent.
STRENGTH_RANGE = (15, 100)
INVITATION = "Draw the new object over the photo: press L for lines, R for rectangles"


class SketchTab(QtGui.QWidget):
    """Photo and sketch above; hint, outcome, photo strength and zoom below."""

    def __init__(self, graph: SketchGraph, image: QtGui.QImage | None, title: str) -> None:
        super().__init__()
        # Themes are style sheets, which colour plain widgets only if asked to: dark words on dark.
        self.setAttribute(_Qt.WA_StyledBackground)
        self.setAutoFillBackground(True)
        self.view = SketchView(graph, image)
        self._light = QtGui.QLabel()
        self._light.setFixedSize(10, 10)
        self._outcome = ""
        self._said: tuple[str, bool] | None = None
        self._words = QtGui.QLabel()
        self._words.setTextFormat(_Qt.RichText)
        self._words.linkActivated.connect(self.view.go_to)
        self._hint = QtGui.QLabel()
        self._hint.setContentsMargins(8, 3, 8, 0)
        self._hint.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Preferred)
        # A long message is cut off rather than making the window wider.
        self._words.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Preferred)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.view, 1)
        layout.addWidget(self._hint)
        layout.addWidget(self._bar())
        self.setFocusProxy(self.view)
        self.setWindowTitle(title)
        self.setWindowIcon(QtGui.QIcon(host.icon("InContext_PhotoSketch")))
        self.view.painting.in_words = partial(host.translate, "InContext")
        self.view.painting.invitation = host.translate("InContext", INVITATION)
        self.view.hint_changed.connect(self.show_hint)
        self.show_hint(self.view.hint)
        self.show_outcome("", good=True)

    def _bar(self) -> QtGui.QWidget:
        bar = QtGui.QWidget()
        row = QtGui.QHBoxLayout(bar)
        row.setContentsMargins(8, 3, 8, 3)
        row.setSpacing(6)
        row.addWidget(self._light)
        row.addWidget(self._words, 1)
        row.addWidget(QtGui.QLabel(host.translate("InContext", "Photo")))
        row.addWidget(self._slider())
        row.addWidget(self._fit_button())
        return bar

    def _slider(self) -> QtGui.QSlider:
        slider = QtGui.QSlider(_Qt.Horizontal)
        slider.setRange(*STRENGTH_RANGE)
        slider.setValue(STRENGTH_RANGE[1])
        slider.setFixedWidth(90)
        slider.setFocusPolicy(_Qt.NoFocus)
        slider.setToolTip(
            host.translate("InContext", "How strong the photo is: fade it to see the lines")
        )
        slider.valueChanged.connect(lambda value: self.view.set_photo_strength(value / 100))
        return slider

    def _fit_button(self) -> QtGui.QToolButton:
        button = QtGui.QToolButton()
        button.setIcon(QtGui.QIcon(":/icons/zoom-all.svg"))
        button.setAutoRaise(True)
        button.setFocusPolicy(_Qt.NoFocus)
        button.setToolTip(host.translate("InContext", "Show the whole photo (F)"))
        button.clicked.connect(self.view.fit)
        return button

    @property
    def outcome(self) -> str:
        """What is said of the last solve."""
        return self._outcome

    @property
    def outcome_with_links(self) -> str:
        """The same for people, each vertex, edge and annotation as a link that goes there."""
        graph = self.view.graph
        ids = {*graph.vertices, *graph.edges, *graph.circles, *graph.annotations}
        words = re.split(r"([\w@]+)", self._outcome)
        return "".join(f'<a href="{w}">{w}</a>' if w in ids else escape(w) for w in words)

    def show_hint(self, words: str) -> None:
        """Say what to do next."""
        self._hint.setText(host.translate("InContext", words))

    def show_outcome(self, words: str, *, good: bool) -> None:
        """Say how the last solve went."""
        if (words, good) == self._said:
            return
        self._said = (words, good)
        colour = GOOD if good else BAD
        self._light.setVisible(bool(words))
        self._light.setStyleSheet(f"background: {colour}; border-radius: 5px;")
        self._outcome = words
        self._words.setText(self.outcome_with_links)
        self._words.setToolTip(words)
