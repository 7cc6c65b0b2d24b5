"""Objects of ours that lost their Python side get it back before a document can be saved so.

FreeCAD refuses the Python side of an object whose module it does not know, and forgets its name
when it then saves the document: without this addon, or with one that failed to start. The
properties stay, and they tell what the object was.
"""

from __future__ import annotations

from typing import Any

import FreeCAD

#: The two kinds of object that have a Python side of ours.
_KINDS = ("App::FeaturePython", "Part::FeaturePython")


class Waker:
    """Looks through documents as they are opened and before they are saved."""

    def slotActivateDocument(self, document: Any) -> None:  # noqa: N802  FreeCAD's names
        """A document comes to the front, a newly opened one too, after all of it is there."""
        if not document.Restoring:
            wake(document)

    def slotStartSaveDocument(self, document: Any, name: str) -> None:  # noqa: N802
        """A document is about to be written."""
        wake(document)


def wake(document: Any) -> tuple[str, ...]:
    """Give back their Python side to the objects that lost it, and say so.

    Returns
    -------
    tuple of str
        The names of those objects.
    """
    lost = [
        obj
        for kind in _KINDS
        for obj in document.findObjects(kind)
        if obj.TypeId == kind and getattr(obj, "Proxy", obj) is None
    ]
    woken = [obj for obj in lost if _wake(obj)]
    if woken:
        from .. import host

        words = host.translate(
            "InContext",
            "{} had been opened or saved without this addon and had lost what makes them follow "
            "the sketch; they have it again",
        )
        host.warn(words.format(", ".join(obj.Label for obj in woken)))
    return tuple(obj.Name for obj in woken)


def _wake(obj: Any) -> bool:
    from .fit_check import FitCheck
    from .fit_test import FitTest
    from .flat_plate import FlatPlate
    from .lifted_model import LiftedModel
    from .photo_sketch import PhotoSketch
    from .plate_set import PlateSet
    from .proxy import ORIGINAL_PROPERTIES
    from .shelled_solid import ShelledSolid

    for cls in (PhotoSketch, LiftedModel, PlateSet, ShelledSolid, FitTest, FitCheck, FlatPlate):
        if ORIGINAL_PROPERTIES[cls.TYPE] <= set(obj.PropertiesList):
            proxy = cls.__new__(cls)
            obj.Proxy = proxy
            # Of an unknown version: everything that came after the first is looked after.
            proxy.loads(None)
            proxy.onDocumentRestored(obj)
            _wake_view(obj, cls.__name__)
            return True
    return False


def _wake_view(obj: Any, name: str) -> None:
    if FreeCAD.GuiUp:
        from . import fit_view, view_providers

        home = fit_view if hasattr(fit_view, f"{name}View") else view_providers
        cls = getattr(home, f"{name}View")
        # Not by its own constructor: that would dress it anew, and its colours are the person's.
        obj.ViewObject.Proxy = cls.__new__(cls)


def start() -> None:
    """Begin to look after documents."""
    FreeCAD.addDocumentObserver(Waker())
