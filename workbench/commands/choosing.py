"""Which object a command is about: the selected one, or the only one there is."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD
import FreeCADGui

from .. import host
from .base import CommandError

IsKind = Callable[[Any], bool]


def objects_of(is_kind: IsKind) -> list[Any]:
    """All objects of a kind in the active document."""
    document = FreeCAD.ActiveDocument
    return [] if document is None else [obj for obj in document.Objects if is_kind(obj)]


def chosen(is_kind: IsKind, what: str) -> Any:
    """The object a command is about.

    Selected objects of the kind come first; then what a selected object is made of or what is
    made of it; then the only one in the document.

    Raises
    ------
    CommandError
        Where that is none or more than one.
    """
    selected = FreeCADGui.Selection.getSelection()
    related = [o for s in selected for o in (*s.OutListRecursive, *s.InListRecursive)]
    for candidates in (selected, related, objects_of(is_kind)):
        found = list(dict.fromkeys(obj for obj in candidates if is_kind(obj)))
        if len(found) == 1:
            return found[0]
    words = host.translate("InContext", "select {} first")
    raise CommandError(words.format(host.translate("InContext", what)))


def reveal(document: Any) -> None:
    """Show the whole object in the document's 3D view."""
    view = FreeCADGui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")
    if view:
        view[0].fitAll()
