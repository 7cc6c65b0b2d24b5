"""Asking a person for files and folders."""

from __future__ import annotations

from pathlib import Path

import FreeCADGui

from .. import host
from ..canvas.lengths import exact_text, parse_length
from ..canvas.photo import readable_formats
from ..canvas.qt import QtCore, QtGui

_LAST_FOLDER = "LastFolder"


def ask_for_file(title: str, kinds: str) -> Path | None:
    """A file to open, or None."""
    name, _ = QtGui.QFileDialog.getOpenFileName(_window(), title, last_folder(), kinds)
    return _remembered(name)


def photo_kinds() -> str:
    """The photos that can be read, as file dialogs ask for them."""
    names = {"JPEG": "*.jpg *.jpeg", "TIFF": "*.tif *.tiff", "HEIC": "*.heic *.heif"}
    endings = " ".join(names.get(f, f"*.{f.lower()}") for f in readable_formats())
    photos, others = (host.translate("InContext", words) for words in ("Photos", "All files"))
    return f"{photos} ({endings});;{others} (*)"


def ask_for_folder(title: str) -> Path | None:
    """A folder to write into, or None."""
    return _remembered(QtGui.QFileDialog.getExistingDirectory(_window(), title, last_folder()))


def ask_for_new_file(title: str, kinds: str, name: str) -> Path | None:
    """A file to write, or None; where the name has no ending, that of the kind."""
    suggested = str(Path(last_folder(), name))
    found, kind = QtGui.QFileDialog.getSaveFileName(_window(), title, suggested, kinds)
    path = _remembered(found)
    if path is None or path.suffix:
        return path
    return path.with_suffix(kind[kind.find("*") + 1 :].rstrip(")"))


def ask_for_length(title: str, words: str, usual_mm: float) -> float | None:
    """A length in mm, or None."""
    text, was_said = QtGui.QInputDialog.getText(
        _window(), title, words, QtGui.QLineEdit.Normal, exact_text(usual_mm)
    )
    return parse_length(text) if was_said else None


def show_file(path: Path) -> None:
    """Open a file with the system's own program for it."""
    QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(str(path)))


def shown(dialog: QtGui.QDialog) -> bool:
    """Show a window until it is answered; whether that was yes."""
    # PySide6 warns of the old name, which is the only one that PySide2 has.
    run = dialog.exec if hasattr(dialog, "exec") else dialog.exec_
    return bool(run())


def _window() -> QtGui.QWidget:
    return FreeCADGui.getMainWindow()


def last_folder() -> str:
    """The folder that was chosen last, else the person's own."""
    return host.preferences().GetString(_LAST_FOLDER, str(Path.home()))


def _remembered(name: str) -> Path | None:
    if not name:
        return None
    path = Path(name)
    remember_folder(path if path.is_dir() else path.parent)
    return path


def remember_folder(folder: Path) -> None:
    """Begin there the next time."""
    host.preferences().SetString(_LAST_FOLDER, str(folder))
