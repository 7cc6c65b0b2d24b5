"""Keeps a copy of a document where FreeCAD looks for what it can recover after it was killed.

FreeCAD itself writes that copy every quarter of an hour. Here it is written after every step that
a person has made, so that nothing committed is lost; FreeCAD then offers it at its next start.

Terms
-----
transient folder
    FreeCAD's own working folder of an open document, gone when the document is closed.
patch
    A copy made of the one before by putting in the sketches alone: a document of which FreeCAD has
    much to write would make the hand wait. The whole follows when it rests.
stand-in
    A few bytes in the place of a large photo while FreeCAD writes, which it does at 40 MB a second.
    The photo itself is put in by a thread.
"""

from __future__ import annotations

import os
import re
import time
import zipfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape

import FreeCAD

from .. import host
from ..canvas.photo import FILES
from ..canvas.qt import QtCore
from ..features.photo_sketch import TYPE
from ..features.proxy import is_of_type
from .aside import POLL_MS, Aside

#: The names that FreeCAD looks for.
COPY, DESCRIPTION = "fc_recovery_file.fcstd", "fc_recovery_file.xml"
_BINARY = "SaveBinaryBrep"
_PART = "incontext_recovery.FCStd"
_CONTENT = "Document.xml"
#: A document that takes longer to write is patched while the hand is at work.
PATIENCE_S = 0.08
#: FreeCAD writes photos smaller than this itself.
LARGE_BYTES = 1_000_000
#: The hand rests when nothing has changed for so long.
REST_MS = 5000
#: Writing takes no more than this part of the time, however fast one edit follows the other.
SHARE = 0.2

#: In an attribute, besides what is written so everywhere in XML.
_ESCAPED = {"\n": "&#10;", "\t": "&#9;", "\r": "&#13;", '"': "&quot;"}
_PREFERENCES = "User parameter:BaseApp/Preferences/Document"
_DESCRIBED = """<?xml version='1.0' encoding='utf-8'?>
<AutoRecovery SchemaVersion="1">
  <Status>Created</Status>
  <Label>{}</Label>
  <FileName>{}</FileName>
</AutoRecovery>
"""


class Keeper(QtCore.QObject):
    """Writes the copies of documents that have changed, as soon as the change is complete."""

    def __init__(self) -> None:
        super().__init__()
        self._changed: set[str] = set()
        self._patched: set[str] = set()
        self._took_s: dict[str, float] = {}
        self._busy_until_s = 0.0
        self._aside = Aside(self)
        self._soon, self._rest = self._timer(self._keep_changed), self._timer(self._keep_patched)

    def _timer(self, work: Any) -> QtCore.QTimer:
        timer = QtCore.QTimer(self)
        timer.setSingleShot(True)
        timer.timeout.connect(work)
        return timer

    def note_change(self, document: Any) -> None:
        """A document has changed: its copy is written when what is going on now is done."""
        self._changed.add(document.Name)
        if not self._soon.isActive():
            wait_s = max(0.0, self._busy_until_s - time.monotonic())
            self._soon.start(max(round(1e3 * wait_s), POLL_MS if self._aside.is_busy else 0))

    def _keep_changed(self) -> None:
        began = time.monotonic()
        names, self._changed = self._changed, set()
        for document in _open(names):
            if document.Restoring or document.Recomputing or self._aside.is_busy:
                self.note_change(document)
            elif self._took_s.get(document.Name, 0.0) < PATIENCE_S:
                self._keep(document)
            else:
                self._patch(document)
        took_s = time.monotonic() - began
        self._busy_until_s = time.monotonic() + took_s * (1 / SHARE - 1)

    def _keep_patched(self) -> None:
        names, self._patched = self._patched, set()
        for document in _open(names):
            if self._aside.is_busy:
                self._patch_later_as_a_whole(document)
            else:
                self._keep(document)

    def _patch_later_as_a_whole(self, document: Any) -> None:
        self._patched.add(document.Name)
        self._rest.start(REST_MS)

    def _patch(self, document: Any) -> None:
        name = document.Name

        def settle(is_patched: bool) -> None:
            for document in _open({name}):
                if is_patched:
                    self._patch_later_as_a_whole(document)
                else:
                    self._keep(document)

        self._aside.begin(patching(document), settle)

    def _keep(self, document: Any) -> None:
        began = time.monotonic()
        try:
            finish = keeping(document)
        except OSError as error:
            host.report(error)
        else:
            self._aside.begin(finish, lambda error: error and host.report(error))
        self._took_s[document.Name] = time.monotonic() - began


def _open(names: set[str]) -> list[Any]:
    return [FreeCAD.getDocument(name) for name in sorted(names & set(FreeCAD.listDocuments()))]


def keeping(document: Any) -> Callable[[], OSError | None]:
    """Write a document's copy for recovery, but for its large photos, where a person wants that.

    Returns
    -------
    callable
        Puts the photos in and the copy in its place; needs no FreeCAD. Gives what went wrong.

    Raises
    ------
    OSError
        Where the folder cannot be written.
    """
    folder = Path(document.TransientDir)
    if not (_preferences().GetBool("RecoveryEnabled", True) and folder.is_dir()):
        return lambda: None
    with _quick_saving(), _photos_aside(document) as photos:
        document.saveCopy(str(folder / _PART))
    words = _DESCRIBED.format(escape(document.Label), escape(document.FileName))

    def finish() -> OSError | None:
        try:
            _put_in(photos, folder / _PART)
            (folder / DESCRIPTION).write_text(words, encoding="utf-8")
            # Written beside, then renamed: whenever FreeCAD is killed, one of the two is whole.
            os.replace(folder / _PART, folder / COPY)
        except OSError as error:
            # The document may have been closed, and its folder with it.
            return error if folder.is_dir() else None
        return None

    return finish


@contextmanager
def _photos_aside(document: Any) -> Iterator[dict[bytes, Path]]:
    """Have a few bytes stand for each large photo; they tell which one it is."""
    paths = {Path(o.Photo) for o in document.Objects if is_of_type(o, TYPE) and o.Photo}
    large = sorted(p for p in paths if p.is_file() and p.stat().st_size > LARGE_BYTES)
    photos = {f"incontext photo {k} {path.name}".encode(): path for k, path in enumerate(large)}
    moved: list[Path] = []
    with FILES:
        try:
            for stand_in, path in photos.items():
                # Where it is open, Windows does not let it go: FreeCAD then writes it.
                with suppress(PermissionError):
                    path.rename(_beside(path))
                    moved.append(path)
                    path.write_bytes(stand_in)
            yield photos
        finally:
            for path in moved:
                os.replace(_beside(path), path)


def _beside(path: Path) -> Path:
    return path.with_name(f"{path.name}.aside")


def _put_in(photos: Mapping[bytes, Path], copy: Path) -> None:
    """Put photos into a copy where something stands for them."""
    if not photos:
        return
    whole = copy.with_name(f"{copy.name}.whole")
    with zipfile.ZipFile(copy) as before, zipfile.ZipFile(whole, "w") as now:
        for name in before.namelist():
            content = before.read(name)
            if content in photos:
                now.write(photos[content], name)
            else:
                now.writestr(name, content)
    os.replace(whole, copy)


def patching(document: Any) -> Callable[[], bool]:
    """What puts a document's sketches into its copy; it needs no FreeCAD.

    Returns
    -------
    callable
        Gives False where there is no copy that has all of the sketches.
    """
    folder = Path(document.TransientDir)
    sketches = {o.Name: o.Sketch for o in document.Objects if is_of_type(o, TYPE)}
    return lambda: _patch(folder, sketches)


def _patch(folder: Path, sketches: Mapping[str, str]) -> bool:
    try:
        with zipfile.ZipFile(folder / COPY) as before, zipfile.ZipFile(folder / _PART, "w") as now:
            content = with_sketches(before.read(_CONTENT).decode(), sketches)
            # The content first, as FreeCAD reads it; photos are packed already.
            now.writestr(_CONTENT, content or "")
            for name in before.namelist():
                if name != _CONTENT:
                    now.writestr(name, before.read(name))
    except (OSError, KeyError, zipfile.BadZipFile):
        content = None
    if content is None:
        return False
    os.replace(folder / _PART, folder / COPY)
    return True


def with_sketches(content: str, sketches: Mapping[str, str]) -> str | None:
    """A document's content with other sketches; None where one of them is not in it.

    Parameters
    ----------
    content : str
        XML, as FreeCAD writes it.
    sketches : mapping of object name to text
    """
    for name, text in sketches.items():
        value = f'"{escape(text, _ESCAPED)}"'
        found = re.search(
            rf'<Object name="{re.escape(name)}"(?: [^>]*)?>(?:(?!</Object>).)*?'
            r'<Property name="Sketch"[^>]*>\s*<String value=("[^"]*")',
            content,
            re.DOTALL,
        )
        if found is None:
            return None
        content = content[: found.start(1)] + value + content[found.end(1) :]
    return content


def _preferences() -> Any:
    return FreeCAD.ParamGet(_PREFERENCES)


@contextmanager
def _quick_saving() -> Iterator[None]:
    """Save without a picture, shapes as they are in memory, and nothing packed."""
    settings = _preferences()
    picture, binary = (settings.GetBool(n, d) for n, d in (("SaveThumbnail", 1), (_BINARY, 0)))
    packing = settings.GetInt("CompressionLevel", 3)
    settings.SetBool("SaveThumbnail", False)
    settings.SetBool(_BINARY, True)
    settings.SetInt("CompressionLevel", 0)
    try:
        yield
    finally:
        settings.SetBool("SaveThumbnail", picture)
        settings.SetBool(_BINARY, binary)
        settings.SetInt("CompressionLevel", packing)


_keeper: list[Keeper] = []


def note_change(document: Any) -> None:
    """See `Keeper.note_change`."""
    if not _keeper:
        _keeper.append(Keeper())
    _keeper[0].note_change(document)
