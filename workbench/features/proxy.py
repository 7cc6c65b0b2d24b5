"""What the Python side of every document object has in common."""

from __future__ import annotations

from typing import Any, ClassVar

from .migrations import migrate
from .properties import Property, ensure_properties

#: Version of what objects of this addon store; goes up when a migration is needed.
OBJECT_VERSION = 1

#: What each type of object has had since its first version: by these it is known even where
#: FreeCAD forgot its Python side.
ORIGINAL_PROPERTIES: dict[str, frozenset[str]] = {
    "InContext::PhotoSketch": frozenset({"Photo", "Sketch", "Status", "Message"}),
    "InContext::LiftedModel": frozenset({"PhotoSketch", "ScaleAssumed", "Status", "Message"}),
    "InContext::PlateSet": frozenset({"LiftedModel", "FingerWidth", "PlateCount", "Status"}),
    "InContext::FlatPlate": frozenset({"PlateSet", "PlateId", "PlateWidth", "Status"}),
    "InContext::FitTest": frozenset({"PlateSet", "Plays", "Status"}),
    "InContext::FitCheck": frozenset({"Checked", "Things", "Standing", "Status"}),
    "InContext::ShelledSolid": frozenset({"LiftedModel", "Wall", "Side", "Status"}),
}


class Proxy:
    """Behaviour of a document object; its data are the object's properties alone.

    FreeCAD stores the proxy's module and class name with the document and does not call
    `__init__` when it opens one.
    """

    TYPE: ClassVar[str] = ""
    PROPERTIES: ClassVar[tuple[Property, ...]] = ()

    def __init__(self, obj: Any) -> None:
        self.version = OBJECT_VERSION
        obj.Proxy = self
        ensure_properties(obj, self.PROPERTIES)

    def onDocumentRestored(self, obj: Any) -> None:  # noqa: N802  FreeCAD's name
        """Bring an object of an older version up to date; computes nothing."""
        ensure_properties(obj, self.PROPERTIES)
        migrate(obj, getattr(self, "version", 0), OBJECT_VERSION)
        self.version = OBJECT_VERSION

    def dumps(self) -> dict[str, Any]:
        """What is stored besides the properties (FreeCAD 1.0 and later)."""
        return {"version": getattr(self, "version", OBJECT_VERSION)}

    def loads(self, state: dict[str, Any] | None) -> None:
        """Take back what `dumps` gave."""
        self.version = int((state or {}).get("version", 0))

    # The same under the names that FreeCAD 0.20 asks for.
    __getstate__ = dumps
    __setstate__ = loads


def is_of_type(obj: Any, type_name: str) -> bool:
    """True for a document object whose proxy is of that type."""
    return getattr(getattr(obj, "Proxy", None), "TYPE", "") == type_name


def is_edited(obj: Any) -> bool:
    """Whether a change is a person's or a script's: not opening, undo, or a recompute."""
    document = obj.Document
    if document is None or "Restore" in obj.State:
        return False
    return not (document.Restoring or document.Recomputing or document.Transacting)
