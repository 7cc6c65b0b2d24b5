"""Properties of document objects, declared as data.

One declaration serves making an object and opening an old one: whatever is missing is added, so
that a document saved before a property existed has it with its default afterwards.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from .. import host


class Editor(IntEnum):
    """How the property editor shows a property; the numbers are FreeCAD's."""

    CHANGEABLE = 0
    READ_ONLY = 1
    HIDDEN = 2


@dataclass(frozen=True, slots=True)
class Property:
    """One property of a document object.

    Parameters
    ----------
    type : str
        FreeCAD's type, such as ``App::PropertyLength``.
    name : str
        ASCII; never renamed, documents store it.
    group, doc : str
        Heading and tooltip in the property editor.
    default : object
        First value; None leaves FreeCAD's own.
    choices : tuple of str
        For enumerations.
    editor : Editor
    """

    type: str
    name: str
    group: str
    doc: str
    default: Any = None
    choices: tuple[str, ...] = ()
    editor: Editor = Editor.CHANGEABLE


def ensure_properties(obj: Any, properties: Iterable[Property]) -> None:
    """Give the object each declared property that it lacks; values that are there stay."""
    for prop in properties:
        if prop.name not in obj.PropertiesList:
            _add(obj, prop)
        # FreeCAD forgets the editor's mode when it saves, hence on every call.
        obj.setEditorMode(prop.name, int(prop.editor))


def _add(obj: Any, prop: Property) -> None:
    doc = host.translate("App::Property", prop.doc)
    obj.addProperty(prop.type, prop.name, prop.group, doc)
    if prop.choices:
        setattr(obj, prop.name, list(prop.choices))
    if prop.default is not None:
        setattr(obj, prop.name, prop.default)


#: What the preferences page says of new objects, by the names of the properties.
PREFERRED_LENGTHS = (
    "Thickness",
    "FingerWidth",
    "Play",
    "Kerf",
    "SheetWidth",
    "SheetHeight",
    "Wall",
)
PREFERRED_TEXTS = ("Preset",)
#: Each with "ForPlates" or "ForPrint" behind it.
PREFERRED_PRESETS = ("Material", "Machine")


def apply_preferences(obj: Any) -> None:
    """Give a new object the first values that the person prefers."""
    chosen = host.preferences()
    for name in PREFERRED_LENGTHS:
        if name in obj.PropertiesList:
            setattr(obj, name, chosen.GetFloat(name, getattr(obj, name).Value))
    for name in PREFERRED_TEXTS:
        if name in obj.PropertiesList:
            setattr(obj, name, chosen.GetString(name, getattr(obj, name)))
    makes = "ForPrint" if "Wall" in obj.PropertiesList else "ForPlates"
    for name in PREFERRED_PRESETS:
        preset = chosen.GetString(name + makes, "")
        # Taken last: what a material says is meant.
        if preset in (obj.getEnumerationsOfProperty(name) or ()):
            setattr(obj, name, preset)


#: Drop-downs whose choice sets other values, which may be edited afterwards.
TAKEN = (
    Property(
        "App::PropertyEnumeration",
        "Material",
        "Presets",
        "Choosing one sets the values that suit it; they can be edited all the same",
        choices=("-",),
    ),
    Property(
        "App::PropertyEnumeration",
        "Machine",
        "Presets",
        "Choosing one sets the values that suit it; they can be edited all the same",
        choices=("-",),
    ),
)

#: How the last recompute ended; every object that computes something has these two.
OUTCOME = (
    Property(
        "App::PropertyString",
        "Status",
        "Result",
        "How the last recompute ended",
        editor=Editor.READ_ONLY,
    ),
    Property(
        "App::PropertyString",
        "Message",
        "Result",
        "What the last recompute has to say",
        editor=Editor.READ_ONLY,
    ),
)


def set_outcome(obj: Any, status: str, message: str) -> None:
    """Write how a recompute ended, only where that is new: an equal value need not be an edit."""
    if obj.Status != status:
        obj.Status = status
    if obj.Message != message:
        obj.Message = message


def fail(obj: Any, status: str, message: str) -> None:
    """Write that a recompute failed, and say so in the report view."""
    set_outcome(obj, status, message)
    host.report(f"{obj.Label}: {message}")
