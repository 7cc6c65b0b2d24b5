"""Lengths as people type them: "210", "21 cm", "3/4 in", "1 1/2 in", "2*18 mm + 5 mm".

Terms
-----
literal
    A number as it is written, a fraction too, with its unit where there is one: "21 cm", "2".
power
    What a value is: 0 a plain number, 1 a length; a product adds them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

#: What is 1 of each unit in mm; a sum's numbers without a unit are mm.
MM_PER_UNIT = {
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

_TOKEN = re.compile(
    r"""(?:(?P<whole>\d+)\s+)?(?P<top>\d+)\s*/\s*(?P<bottom>\d+)(?![\d.,])
            \s*(?P<of_fraction>[a-z]+|["'])?                                # 3/4 in   1 1/2 in
      | (?P<number>\d+(?:[.,]\d*)?|[.,]\d+)\s*(?P<unit>[a-z]+|["'])?        # 21 cm   2,5   .5
      | (?P<sign>[-+*/()])""",
    re.VERBOSE,
)
_GAP = re.compile(r"\s*")
#: Other ways to write the same.
_SAME = str.maketrans("×·−÷″′⁄（）", "**-/\"'/()")

#: The longest that is taken: 1 km; more is a slip of the hand.
MOST_MM = 1e6
#: Nobody types more; brackets in brackets without end would exhaust Python.
MOST_LETTERS = 200


@dataclass(frozen=True, slots=True)
class _Value:
    """A number, in mm where it is a length, and its power."""

    number: float
    power: int = 0

    def plus(self, other: _Value, way: int) -> _Value:
        """The sum, or the difference; what has no unit is mm there."""
        if {self.power, other.power} - {0, 1} and self.power != other.power:
            raise ValueError
        return _Value(self.number + way * other.number, max(self.power, other.power))

    def times(self, other: _Value, way: int) -> _Value:
        """The product, or the quotient."""
        return _Value(self.number * other.number**way, self.power + way * other.power)


def parse_length(text: str) -> float:
    """A length in mm.

    Parameters
    ----------
    text : str
        A number, whole, decimal or a fraction, and a unit, mm where there is none; or several of
        them with + - * / and brackets between them.

    Raises
    ------
    ValueError
        Where it is none; says what would be.
    """
    try:
        value = _Reading(text.strip().lower().translate(_SAME)).value()
    except (ValueError, ArithmeticError):
        value = _Value(0.0)
    length = round(value.number, 6)
    if value.power not in (0, 1) or not 0 < length <= MOST_MM:
        raise ValueError("Type a length, such as 210, 21 cm, 3/4 in or 2*18 mm + 5 mm")
    return length


def exact_text(length_mm: float) -> str:
    """A length to be edited: nothing of it may be lost by opening it and saying yes."""
    return f"{length_mm:.6f}".rstrip("0").rstrip(".") + " mm"


class _Reading:
    """Reads a text from left to right, products before sums; a ValueError where it cannot."""

    def __init__(self, text: str) -> None:
        if len(text) > MOST_LETTERS:
            raise ValueError
        self._left = list(_tokens(text.removeprefix("=")))

    def value(self) -> _Value:
        """What the whole text is worth."""
        value = self._sum()
        if self._left:
            raise ValueError
        return value

    def _sum(self) -> _Value:
        value = self._product()
        while self._next_is("+", "-"):
            way = -1 if self._left.pop(0) == "-" else 1
            value = value.plus(self._product(), way)
        return value

    def _product(self) -> _Value:
        value = self._factor()
        while self._next_is("*", "/"):
            way = -1 if self._left.pop(0) == "/" else 1
            value = value.times(self._factor(), way)
        return value

    def _factor(self) -> _Value:
        """A literal, feet and inches, or what is in brackets."""
        if not self._left:
            raise ValueError
        first = self._left.pop(0)
        if first == "(":
            value = self._sum()
            if not self._next_is(")"):
                raise ValueError
            self._left.pop(0)
            return value
        if isinstance(first, str):
            raise ValueError
        number, unit = first
        if unit in ("'", "ft") and self._left and self._left[0][1:] in (('"',), ("in",)):
            inches, inch = self._left.pop(0)
            return _length(number, unit).plus(_length(inches, inch), 1)
        return _length(number, unit)

    def _next_is(self, *signs: str) -> bool:
        return bool(self._left) and self._left[0] in signs


def _length(number: float, unit: str) -> _Value:
    """A literal's value."""
    if not unit:
        return _Value(number)
    if unit not in MM_PER_UNIT:
        raise ValueError
    return _Value(number * MM_PER_UNIT[unit], 1)


def _tokens(text: str) -> Iterator[str | tuple[float, str]]:
    """The signs of a text, and its literals as number and unit."""
    at = 0
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            raise ValueError
        at = _GAP.match(text, match.end()).end()
        if match["sign"]:
            yield match["sign"]
        elif match["number"]:
            yield float(match["number"].replace(",", ".")), match["unit"] or ""
        else:
            fraction = Fraction(int(match["top"]), int(match["bottom"]))
            yield float(int(match["whole"] or 0) + fraction), match["of_fraction"] or ""
