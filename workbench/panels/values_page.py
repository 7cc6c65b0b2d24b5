"""The preferences page of first values: sizes and the preset that new objects begin with.

Plain fields: FreeCAD's own for units keep two decimals, which in inches makes a kerf of 0.15 mm one
of 0.25 mm as soon as somebody presses OK.
"""

from __future__ import annotations

import math
import re

from .. import host
from ..canvas.lengths import MM_PER_UNIT, parse_length
from ..canvas.qt import QtGui

_ALIKE = 1e-6


class ValuesPage:
    """FreeCAD asks for `form`, `loadSettings` and `saveSettings`."""

    def __init__(self, parent: QtGui.QWidget | None = None) -> None:
        import FreeCADGui

        from ..features.properties import PREFERRED_LENGTHS, PREFERRED_TEXTS

        self.form = FreeCADGui.PySideUic.loadUi(host.resource("ui", "preferences.ui"))
        self.form.setParent(parent)
        self.lengths = {name: self._field(name) for name in PREFERRED_LENGTHS}
        self.texts = {name: self._field(name) for name in PREFERRED_TEXTS}
        self._shown: dict[str, str] = {}

    def _field(self, name: str) -> QtGui.QLineEdit:
        field: QtGui.QLineEdit = self.form.findChild(QtGui.QLineEdit, f"value{name}")
        return field

    def loadSettings(self) -> None:  # noqa: N802  FreeCAD's names
        """Show what is preferred, lengths in the person's units."""
        chosen, first = host.preferences(), _first_values()
        for name, field in self.lengths.items():
            self._shown[name] = in_units(chosen.GetFloat(name, first[name] or 0.0))
            field.setText(self._shown[name])
        for name, field in self.texts.items():
            field.setText(chosen.GetString(name, first[name]))

    def saveSettings(self) -> None:  # noqa: N802
        """Remember what was changed; what is no length is said, and the old one stays."""
        chosen = host.preferences()
        for name, field in self.lengths.items():
            if field.text() == self._shown.get(name):
                continue
            try:
                chosen.SetFloat(name, length_mm(field.text()))
            except ValueError as error:
                words = host.translate("InContext", "{}: not a length, the old one stays.")
                host.warn(f"{words.format(field.text())} {error}")
        for name, field in self.texts.items():
            chosen.SetString(name, field.text().strip())


def _first_values() -> dict[str, object]:
    """What the properties begin with by themselves."""
    from ..features.plate_set import PlateSet
    from ..features.shelled_solid import ShelledSolid

    return {prop.name: prop.default for cls in (ShelledSolid, PlateSet) for prop in cls.PROPERTIES}


def in_units(length_mm: float) -> str:
    """A length in millimetres or inches, as the person's units are, with all its decimals."""
    unit = _unit()
    return f"{length_mm / MM_PER_UNIT[unit]:.6f}".rstrip("0").rstrip(".") + f" {unit}"


def _unit() -> str:
    import FreeCAD

    _, factor, _ = FreeCAD.Units.Quantity(3, FreeCAD.Units.Length).getUserPreferred()
    # Metric units are powers of ten of a millimetre.
    return "mm" if abs(math.remainder(math.log10(factor), 1)) < _ALIKE else "in"


def length_mm(text: str) -> float:
    """A length as it was typed; a number alone is in the person's unit.

    Raises
    ------
    ValueError
        Where it is none.
    """
    words = text.strip()
    if re.fullmatch(r"[0.,]*0[0.,]*\s*[a-z\"']*", words):
        return 0.0
    return parse_length(f"{words} {_unit()}" if re.fullmatch(r"[\d.,/ ]+", words) else words)
