"""What is written, where, and what it will look like: asked in one window before an export."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import FreeCADGui

from .. import host
from ..canvas.qt import QtGui
from .asking import ask_for_folder, last_folder

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ..features.sheet_picture import SheetPicture

#: What a format is for, in a few words.
_FOR = {
    ".dxf": "cutter",
    ".svg": "cutter",
    ".pdf": "true size on paper",
    ".step": "other CAD programs",
    ".plates.json": "scripts",
    ".parts.csv": "parts list",
    ".stl": "slicer",
    ".3mf": "slicer, with units",
}


@dataclass(frozen=True, slots=True)
class Choice:
    """What a person wants written."""

    folder: Path
    name: str
    formats: tuple[str, ...]


class ExportDialog(QtGui.QDialog):
    """Shows what will be written, asks for the formats, the folder and the name.

    Parameters
    ----------
    title : str
    words : str
        What is written, in numbers.
    formats : mapping of str to bool
        Endings, and whether each is ticked at first.
    name : str
        What stands before the endings.
    preview : QWidget or None
    """

    def __init__(
        self, title: str, words: str, formats: dict[str, bool], name: str, preview: Any = None
    ) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self.setWindowTitle(title)
        translate = host.translate
        self._boxes = {ending: _box(ending, ticked) for ending, ticked in formats.items()}
        self._name = QtGui.QLineEdit(name)
        self._folder = QtGui.QLineEdit(last_folder())
        choose = QtGui.QPushButton(translate("InContext", "Choose..."))
        choose.setAutoDefault(False)
        choose.clicked.connect(self._choose)
        self.export_button = QtGui.QPushButton(translate("InContext", "Export"))
        self.export_button.setDefault(True)
        self.export_button.clicked.connect(self.accept)
        cancel = QtGui.QPushButton(translate("InContext", "Cancel"))
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        layout = QtGui.QVBoxLayout(self)
        layout.setSpacing(10)
        if preview is not None:
            layout.addWidget(preview, 1)
        told = QtGui.QLabel(words)
        told.setWordWrap(True)
        layout.addWidget(told)
        layout.addLayout(_grid(self._boxes.values()))
        form = QtGui.QFormLayout()
        form.addRow(translate("InContext", "Name"), self._name)
        form.addRow(translate("InContext", "Folder"), _row(self._folder, choose))
        layout.addLayout(form)
        layout.addLayout(_row(None, cancel, self.export_button))
        for field in (self._name, self._folder):
            field.textChanged.connect(self._look)
        for box in self._boxes.values():
            box.toggled.connect(self._look)
        self._look()

    @property
    def choice(self) -> Choice:
        """What is chosen now."""
        formats = tuple(ending for ending, box in self._boxes.items() if box.isChecked())
        return Choice(Path(self._folder.text().strip()), self._name.text().strip(), formats)

    def _choose(self) -> None:
        folder = ask_for_folder(host.translate("InContext", "Choose a folder"))
        if folder is not None:
            self._folder.setText(str(folder))

    def _look(self, *_: Any) -> None:
        chosen = self.choice
        sound = chosen.name and not set(chosen.name) & set('/\\:*?"<>|')
        self.export_button.setEnabled(
            bool(sound and chosen.formats and self._folder.text().strip())
        )


def ask_what_to_export(dialog: ExportDialog) -> Choice | None:
    """Show the dialog; None where the person would rather not."""
    from .asking import remember_folder, shown

    if not shown(dialog):
        return None
    remember_folder(dialog.choice.folder)
    return dialog.choice


def sheets_words(picture: SheetPicture) -> str:
    """How many sheets of what, how long the cuts are and take, the price, and what is set."""
    words = host.translate(
        "InContext", "{0} plates on {1} sheets ({2}), {3:.2f} m of cuts, about {4} min"
    )
    minutes = max(1, round(picture.time_s / 60))
    stock, metres = ", ".join(picture.words), picture.cut_mm / 1000
    said = words.format(picture.n_plates, len(picture.stock), stock, metres, minutes)
    if picture.price is not None:
        said += host.translate("InContext", ", {0:.2f} for the stock").format(picture.price)
    return "\n".join([said, *picture.effects])


def _box(ending: str, ticked: bool) -> QtGui.QCheckBox:
    what = host.translate("InContext", _FOR[ending])
    box = QtGui.QCheckBox(f"{ending[1:].upper() if ending.count('.') == 1 else ending[1:]}: {what}")
    box.setChecked(ticked)
    return box


def _grid(boxes: Iterable[QtGui.QCheckBox]) -> QtGui.QGridLayout:
    grid = QtGui.QGridLayout()
    for k, box in enumerate(boxes):
        grid.addWidget(box, k // 3, k % 3)
    return grid


def _row(first: QtGui.QWidget | None, *others: QtGui.QWidget) -> QtGui.QHBoxLayout:
    row = QtGui.QHBoxLayout()
    if first is None:
        row.addStretch(1)
    else:
        row.addWidget(first, 1)
    for widget in others:
        row.addWidget(widget)
    return row
