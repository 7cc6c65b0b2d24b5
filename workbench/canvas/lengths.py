"""Lengths as people type them: "210", "21 cm", "3/4 in", "1 1/2 in"."""

from __future__ import annotations

import re
from fractions import Fraction

#: What is 1 of each unit in mm; without a unit it is mm.
MM_PER_UNIT = {
    "": 1.0,
    "mm": 1.0,
    "cm": 10.0,
    "dm": 100.0,
    "m": 1000.0,
    "in": 25.4,
    "inch": 25.4,
    '"': 25.4,
    "ft": 304.8,
    "'": 304.8,
}

_LENGTH = re.compile(
    r"""(?P<whole>\d+(?:[.,]\d*)?|[.,]\d+)?    # 21   1.5   2,5   .5
        (?:\s+(?P<top>\d+)\s*/\s*(?P<bottom>\d+))?
        \s*(?P<unit>[a-z"']*)""",
    re.VERBOSE,
)
_FRACTION = re.compile(r"(?P<top>\d+)\s*/\s*(?P<bottom>\d+)\s*(?P<unit>[a-z\"']*)")

#: The longest that is taken: 1 km; more is a slip of the hand.
MOST_MM = 1e6


def parse_length(text: str) -> float:
    """A length in mm.

    Parameters
    ----------
    text : str
        A number, whole, decimal or a fraction, and a unit; mm where there is none.

    Raises
    ------
    ValueError
        Where it is none; says what would be.
    """
    plain = text.strip().lower()
    number, unit = _split(plain)
    length = round(number * MM_PER_UNIT.get(unit, 0.0), 6)
    if not 0 < length <= MOST_MM:
        raise ValueError("Type a length, such as 210, 21 cm or 3/4 in")
    return length


def exact_text(length_mm: float) -> str:
    """A length to be edited: nothing of it may be lost by opening it and saying yes."""
    return f"{length_mm:.6f}".rstrip("0").rstrip(".") + " mm"


def _split(text: str) -> tuple[float, str]:
    """The number and the unit of a text; 0 where it has another form."""
    fraction = _FRACTION.fullmatch(text)
    if fraction:
        return _quotient(fraction), fraction["unit"]
    mixed = _LENGTH.fullmatch(text)
    # "1 1/2" is one and a half, "1.5 1/2" is nothing.
    if not mixed or not mixed["whole"] or (mixed["top"] and not mixed["whole"].isdigit()):
        return 0.0, ""
    whole = float(mixed["whole"].replace(",", "."))
    return whole + (_quotient(mixed) if mixed["top"] else 0.0), mixed["unit"]


def _quotient(match: re.Match[str]) -> float:
    top, bottom = int(match["top"]), int(match["bottom"])
    return float(Fraction(top, bottom)) if bottom else 0.0
