"""Engraved letters as single strokes: capitals, digits, a few signs.

Terms
-----
glyph
    Polylines on a grid 4 wide and 6 high; two digits are one point, ``|`` lifts the pen.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from ...solver.values import Array, frozen_array

_GLYPHS = {
    "A": "00 26 40|13 33",
    "B": "00 06 36 45 44 33 03|33 42 41 30 00",
    "C": "45 36 16 05 01 10 30 41",
    "D": "00 06 26 44 42 20 00",
    "E": "46 06 00 40|03 33",
    "F": "46 06 00|03 33",
    "G": "45 36 16 05 01 10 30 41 43 23",
    "H": "00 06|40 46|03 43",
    "I": "20 26",
    "J": "46 41 30 10 01",
    "K": "00 06|46 03 40",
    "L": "06 00 40",
    "M": "00 06 23 46 40",
    "N": "00 06 40 46",
    "O": "10 01 05 16 36 45 41 30 10",
    "P": "00 06 36 45 44 33 03",
    "Q": "10 01 05 16 36 45 41 30 10|22 40",
    "R": "00 06 36 45 44 33 03|23 40",
    "S": "45 36 16 05 04 13 33 42 41 30 10 01",
    "T": "06 46|26 20",
    "U": "06 01 10 30 41 46",
    "V": "06 20 46",
    "W": "06 10 23 30 46",
    "X": "00 46|06 40",
    "Y": "06 23 46|23 20",
    "Z": "06 46 00 40",
    "0": "10 01 05 16 36 45 41 30 10|12 34",
    "1": "15 26 20|10 30",
    "2": "05 16 36 45 44 00 40",
    "3": "05 16 36 45 44 33 23|33 42 41 30 10 01",
    "4": "30 36 02 42",
    "5": "46 06 04 34 43 41 30 10 01",
    "6": "45 36 16 05 01 10 30 41 42 33 03",
    "7": "06 46 10",
    "8": "13 04 05 16 36 45 44 33 13 02 01 10 30 41 42 33",
    "9": "01 10 30 41 45 36 16 05 04 13 43",
    " ": "",
    ".": "20 21",
    ",": "22 10",
    ":": "21 22|24 25",
    "-": "13 33",
    "_": "00 40",
    "+": "13 33|22 24",
    "/": "00 46",
    "#": "11 15|31 35|02 42|04 44",
    "@": "41 30 10 01 05 16 36 45 42 32 22 24 34",
    "(": "36 24 22 30",
    ")": "16 24 22 10",
    "?": "05 16 36 45 44 23 22|20 21",
}
_WIDTH, _HEIGHT, _ADVANCE = 4.0, 6.0, 6.0


def text_width_mm(text: str, height_mm: float) -> float:
    """Width of a line of text."""
    return max(0.0, len(text) * _ADVANCE - (_ADVANCE - _WIDTH)) * height_mm / _HEIGHT


def text_strokes(text: str, at_mm: tuple[float, float], height_mm: float) -> list[Array]:
    """A line of text as polylines.

    Parameters
    ----------
    text : str
        Small letters become capitals; what has no glyph becomes a question mark.
    at_mm : (x, y)
        Its lower left corner.
    height_mm : float

    Returns
    -------
    list of (k, 2) arrays
        Open polylines, mm.
    """
    scale = height_mm / _HEIGHT
    strokes = []
    for n, letter in enumerate(text.upper()):
        start = np.array([n * _ADVANCE, 0.0])
        strokes += [np.round((points + start) * scale + at_mm, 6) for points in _glyph(letter)]
    return strokes


@cache
def _glyph(letter: str) -> tuple[Array, ...]:
    """The strokes of a letter at the origin, in its own units."""
    strokes = _GLYPHS.get(letter, _GLYPHS["?"]).split("|")
    return tuple(
        frozen_array([[int(p[0]), int(p[1])] for p in stroke.split()], (-1, 2))
        for stroke in strokes
        if stroke
    )
