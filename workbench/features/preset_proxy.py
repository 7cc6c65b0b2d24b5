"""What objects with drop-downs for presets have in common."""

from __future__ import annotations

from typing import Any, ClassVar

from .presets import KINDS, offer_presets, take_preset
from .proxy import Proxy, is_edited


class PresetProxy(Proxy):
    """Of an object whose material and machine can be chosen."""

    #: What the object makes, as presets say what they are for.
    MAKES: ClassVar[str]

    def __init__(self, obj: Any) -> None:
        super().__init__(obj)
        offer_presets(obj, self.MAKES)

    def onDocumentRestored(self, obj: Any) -> None:  # noqa: N802  FreeCAD's name
        """See `Proxy.onDocumentRestored`; presets may have come and gone."""
        super().onDocumentRestored(obj)
        offer_presets(obj, self.MAKES)

    def onChanged(self, obj: Any, name: str) -> None:  # noqa: N802
        """A preset that was chosen sets its values."""
        if name in KINDS and is_edited(obj):
            take_preset(obj, name, self.MAKES)
