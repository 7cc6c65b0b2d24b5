"""The printable marker: a black square with a pattern, its size on it, and a line to check it by.

Terms
-----
marker
    A square of 6 x 6 fields; the outer ones are black, the inner ones its pattern: number 0 of the
    ArUco dictionary 4X4_50, which other programs know, too. Its size is the black square's side.
quiet zone
    White paper round it, one field wide, by which it is told from what lies beside it.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import escape

from ..solver.errors import SketchError
from . import host
from .fabrication.pdf_file import POINTS_PER_MM, pdf_file

#: The pattern, row by row from the top; 1 is white.
PATTERN = ("1011", "0101", "0011", "0010")
FIELDS = 6
USUAL_SIZE_MM = 100.0
LEAST_MM, MOST_MM = 20.0, 1000.0
#: Paper on which it is printed, the smallest that holds it.
_PAPERS_MM = ((210.0, 297.0), (297.0, 420.0))
_LETTER_MM, _WRITTEN_MM = 3.6, 136.0
#: The line to check by, and its ticks.
_BAR_MM, _TICK_MM, _STROKE_MM = 100.0, 10.0, 0.25
_FONTS = (
    b"<< /Font << "
    b"/R << /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >> "
    b"/B << /Type /Font /Subtype /Type1 /BaseFont /Helvetica-Bold /Encoding /WinAnsiEncoding >> "
    b">> >>"
)

Box = tuple[float, float, float, float]


@dataclass(frozen=True, slots=True)
class _Words:
    """A line of text: the left end of its foot line, mm from the page's top left corner."""

    x: float
    y: float
    text: str
    source: str
    height_mm: float = _LETTER_MM
    is_bold: bool = False


@dataclass(frozen=True, slots=True)
class _Page:
    """What is on the paper, mm from its top left corner: boxes are (x, y, width, height)."""

    size_mm: tuple[float, float]
    black: Box
    white: tuple[Box, ...]
    bars: tuple[Box, ...]
    words: tuple[_Words, ...]


def marker_file(path: Path, size_mm: float = USUAL_SIZE_MM) -> bytes:
    """The marker as an SVG or a PDF file, by the ending of its name.

    Parameters
    ----------
    path : Path
        Nothing is written.
    size_mm : float
        Side of the black square.

    Raises
    ------
    SketchError
        Where the size or the ending cannot be.
    """
    if not LEAST_MM <= size_mm <= MOST_MM:
        raise SketchError(
            f"a marker of {size_mm:g} mm cannot be printed",
            (),
            f"a size from {LEAST_MM:g} to {MOST_MM:g} mm",
        )
    page = _page(size_mm)
    if path.suffix.lower() == ".svg":
        return _svg(page)
    if path.suffix.lower() == ".pdf":
        return pdf_file([(page.size_mm, _pdf_content(page))], _FONTS)
    raise SketchError(f"{path.name} is neither .svg nor .pdf", (), "such a name")


def _page(size_mm: float) -> _Page:
    field = size_mm / FIELDS
    fits = (p for p in _PAPERS_MM if size_mm + 2 * field <= p[0])
    wide = size_mm + 4 * field
    paper = next(fits, (wide, wide + 90.0))
    # All begins at one left edge; what is written is wider than a small marker.
    left = (paper[0] - max(size_mm, min(_WRITTEN_MM, paper[0] - 2 * field))) / 2
    top = max(2.5 * field + 24.0, (paper[1] - size_mm) / 2 - 30.0)
    white = tuple(
        (left + (1 + column) * field, top + (1 + row) * field, field, field)
        for row, line in enumerate(PATTERN)
        for column, bit in enumerate(line)
        if bit == "1"
    )
    foot = top + size_mm + 1.5 * field + 12.0
    black = (left, top, size_mm, size_mm)
    return _Page(paper, black, white, _bar(left, foot), _words(left, foot, size_mm))


def _bar(x: float, y: float) -> tuple[Box, ...]:
    """A line of 100 mm with ticks; the outer edges of the outer ticks are 100 mm apart."""
    stroke = _STROKE_MM
    ticks = []
    for k in range(int(_BAR_MM / _TICK_MM) + 1):
        tall = 4.0 if k % 5 == 0 else 2.0
        # Outer ticks lie within, those between are centred on their place.
        at = min(max(k * _TICK_MM - stroke / 2, 0.0), _BAR_MM - stroke)
        ticks.append((x + at, y - tall, stroke, tall))
    return ((x, y - stroke, _BAR_MM, stroke), *ticks)


def _words(x: float, y: float, size_mm: float) -> tuple[_Words, ...]:
    size = f"{size_mm:g} mm"
    lines = (
        "This line is 100 mm long. If yours is not, print again at 100 %, not fitted to the page.",
        "Lay the sheet flat on the ground where the new object will stand, and take the photo.",
    )
    title = "Marker: the black square measures {}"
    said = host.translate("InContext", title)
    found = [_Words(x, y - 9.0, said.format(size), title.format(size), 5.0, True)]
    for k, line in enumerate(lines):
        found.append(_Words(x, y + 7.0 + 5.5 * k, host.translate("InContext", line), line))
    return tuple(found)


def _number(value: float) -> str:
    text = f"{value:.4f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _svg(page: _Page) -> bytes:
    width, height = map(_number, page.size_mm)
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}mm" height="{height}mm" '
        f'viewBox="0 0 {width} {height}">',
        f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
        f'<path id="marker" d="{_svg_box(page.black)}"/>',
        # One path: fields side by side must not show a seam.
        f'<path id="pattern" fill="#ffffff" d="{" ".join(map(_svg_box, page.white))}"/>',
        f'<path id="scale" d="{" ".join(map(_svg_box, page.bars))}"/>',
        '<g font-family="Helvetica, Arial, sans-serif">',
    ]
    for words in page.words:
        weight = ' font-weight="bold"' if words.is_bold else ""
        lines.append(
            f'<text x="{_number(words.x)}" y="{_number(words.y)}" '
            f'font-size="{_number(words.height_mm)}"{weight}>{escape(words.text)}</text>'
        )
    return "\n".join([*lines, "</g>", "</svg>", ""]).encode()


def _svg_box(box: Box) -> str:
    x, y, width, height = map(_number, box)
    return f"M {x} {y} h {width} v {height} h -{width} Z"


def _pdf_content(page: _Page) -> bytes:
    tall = page.size_mm[1]
    lines = [f"{POINTS_PER_MM:.9f} 0 0 {POINTS_PER_MM:.9f} 0 0 cm".encode()]
    for grey, boxes in (("0 g", (page.black,)), ("1 g", page.white), ("0 g", page.bars)):
        lines.append(f"{grey} {' '.join(_pdf_box(box, tall) for box in boxes)} f".encode())
    for words in page.words:
        font = "/B" if words.is_bold else "/R"
        at = f"{_number(words.x)} {_number(tall - words.y)}"
        lines.append(
            f"BT {font} {_number(words.height_mm)} Tf {at} Td (".encode()
            + _pdf_text(words)
            + b") Tj ET"
        )
    return b"\n".join(lines)


def _pdf_box(box: Box, tall: float) -> str:
    x, y, width, height = box
    return " ".join(map(_number, (x, tall - y - height, width, height))) + " re"


def _pdf_text(words: _Words) -> bytes:
    """The text in the letters that the file's own fonts have; else as it was in English."""
    try:
        coded = words.text.encode("cp1252")
    except UnicodeEncodeError:
        coded = words.source.encode("cp1252")
    return coded.replace(b"\\", b"\\\\").replace(b"(", b"\\(").replace(b")", b"\\)")
