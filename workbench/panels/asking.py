"""Asking a person for files and folders."""

from __future__ import annotations

from pathlib import Path

import FreeCADGui

from .. import host
from ..canvas.photo import readable_formats
from ..canvas.qt import QtGui

_LAST_FOLDER = "LastFolder"


def ask_for_file(title: str, kinds: str) -> Path | None:
    """A file to open, or None."""
    name, _ = QtGui.QFileDialog.getOpenFileName(_window(), title, _last_folder(), kinds)
    return _remembered(name)


def photo_kinds() -> str:
    """The photos that can be read, as file dialogs ask for them."""
    names = {"JPEG": "*.jpg *.jpeg", "TIFF": "*.tif *.tiff", "HEIC": "*.heic *.heif"}
    endings = " ".join(names.get(f, f"*.{f.lower()}") for f in readable_formats())
    photos, others = (host.translate("InContext", words) for words in ("Photos", "All files"))
    return f"{photos} ({endings});;{others} (*)"


def ask_for_folder(title: str) -> Path | None:
    """A folder to write into, or None."""
    return _remembered(QtGui.QFileDialog.getExistingDirectory(_window(), title, _last_folder()))


def _window() -> QtGui.QWidget:
    return FreeCADGui.getMainWindow()


def _last_folder() -> str:
    return host.preferences().GetString(_LAST_FOLDER, str(Path.home()))


def _remembered(name: str) -> Path | None:
    if not name:
        return None
    path = Path(name)
    host.preferences().SetString(_LAST_FOLDER, str(path if path.is_dir() else path.parent))
    return path
