"""The preferences page of presets: what new objects begin with, and where own presets lie."""

from __future__ import annotations

from ..canvas.qt import QtCore, QtGui


class PresetPage:
    """FreeCAD asks for `form`, `loadSettings` and `saveSettings`."""

    def __init__(self, parent: QtGui.QWidget | None = None) -> None:
        from .. import host
        from ..features.presets import KINDS, own_folder

        translate = host.translate
        self.form = QtGui.QWidget(parent)
        self.form.setWindowTitle(translate("InContext", "Presets"))
        self.boxes: dict[str, QtGui.QComboBox] = {}
        layout = QtGui.QVBoxLayout(self.form)
        for title, makes in (("Of new plates", "ForPlates"), ("Of new shelled solids", "ForPrint")):
            group = QtGui.QGroupBox(translate("InContext", title))
            form = QtGui.QFormLayout(group)
            for kind in KINDS:
                box = self.boxes[kind + makes] = QtGui.QComboBox()
                box.setMinimumWidth(260)
                form.addRow(translate("InContext", kind), box)
            layout.addWidget(group)
        words = translate(
            "InContext", "Presets of your own, as .json files like ours, belong in {}"
        )
        told = QtGui.QLabel(words.format(own_folder()))
        told.setWordWrap(True)
        told.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        layout.addWidget(told)
        layout.addStretch(1)

    def loadSettings(self) -> None:  # noqa: N802  FreeCAD's names
        """Show what is preferred."""
        from .. import host
        from ..features.presets import KINDS, NONE, presets_of

        for name, box in self.boxes.items():
            kind = next(kind for kind in KINDS if name.startswith(kind))
            makes = "plates" if name.endswith("ForPlates") else "print"
            box.clear()
            box.addItems([NONE, *presets_of(kind, makes)])
            place = box.findText(host.preferences().GetString(name, NONE))
            box.setCurrentIndex(max(place, 0))

    def saveSettings(self) -> None:  # noqa: N802
        """Remember what is chosen."""
        from .. import host

        for name, box in self.boxes.items():
            host.preferences().SetString(name, box.currentText())
