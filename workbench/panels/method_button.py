"""By which method a sketch's model is lifted: a small menu, for who wants to compare."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from .. import host
from ..canvas.qt import QtCore, QtGui
from ..features.methods import OURS, SLOW, choose_method

#: Behind what opens a menu.
_MENU = " \N{BLACK DOWN-POINTING SMALL TRIANGLE}"


class MethodButton(QtGui.QToolButton):
    """Names the method of the models at hand; its menu takes another one."""

    def __init__(self) -> None:
        super().__init__()
        self._models: list[Any] = []
        self._shown: tuple[str, ...] = ()
        self.setAutoRaise(True)
        self.setPopupMode(QtGui.QToolButton.InstantPopup)
        self.setToolButtonStyle(QtCore.Qt.ToolButtonTextOnly)
        # Qt paints its arrow over the text's end.
        self.setStyleSheet("QToolButton::menu-indicator { image: none; }")
        words = (
            "How the sketch is lifted. The methods of the papers are slow and less exact: they are "
            "there to compare with"
        )
        self.setToolTip(host.translate("InContext", words))
        menu = QtGui.QMenu(self)
        self._choices = {name: self._choice(menu, name) for name in (OURS, *SLOW)}
        self.setMenu(menu)

    def _choice(self, menu: QtGui.QMenu, name: str) -> Any:
        choice = menu.addAction(name)
        choice.setCheckable(True)
        choice.triggered.connect(lambda *_: self._take(name))
        return choice

    def show_models(self, models: Iterable[Any]) -> None:
        """Name the method of some lifted models; nothing is shown where there are none."""
        self._models = list(models)
        names = tuple(dict.fromkeys(str(model.Method) for model in self._models))
        self.setVisible(bool(names))
        if names == self._shown:
            return
        self._shown = names
        self.setText(host.translate("InContext", "Method: {}").format(", ".join(names)) + _MENU)
        for name, choice in self._choices.items():
            choice.setChecked(name in names)

    def _take(self, name: str) -> None:
        choose_method(self._models, name)
        # Whatever was taken, the menu's marks say what is so.
        self._shown = ()
        self.show_models(self._models)
