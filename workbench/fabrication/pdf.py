"""The drawing as PDF in true size: a page for each sheet, or tiled on small pages to be glued.

Terms
-----
tile
    What of a sheet is on one page. Tiles share a strip, with marks where they go on one another.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...solver.values import Array
from .drawing import Drawing, draw
from .pdf_file import POINTS_PER_MM, pdf_file, plain
from .presets import DEFAULT, Preset, load_preset
from .settings import PAGES_MM
from .sheets import Sheet
from .strokes import text_strokes

HAIRLINE_MM = 0.1
BORDER_MM = 5.0
#: What a printer leaves white, and what two tiles share.
TILE_BORDER_MM, TILE_OVERLAP_MM = 10.0, 8.0


@dataclass(frozen=True, slots=True)
class _Page:
    """A page: its size, the part of the drawing on it, and the name of the tile."""

    size_mm: tuple[float, float]
    low_mm: tuple[float, float]
    border_mm: float
    label: str


def pdf_bytes(
    sheets: Sequence[Sheet], preset: Preset | None = None, page: str | None = None
) -> bytes:
    """All sheets as one PDF file.

    Parameters
    ----------
    sheets : sequence of Sheet
    preset : Preset or None
        Colours of layers; None takes the plain ones.
    page : str or None
        A key of `PAGES_MM` to tile on such pages; None makes pages as large as the sheets.

    Returns
    -------
    bytes
        Equal for equal sheets. One millimetre is one millimetre on paper.
    """
    preset = preset or load_preset(DEFAULT)
    pages: list[tuple[_Page, bytes]] = []
    for number, sheet in enumerate(sheets, start=1):
        drawing = draw([sheet], preset)
        places = [_whole(drawing)] if page is None else _tiles(drawing, PAGES_MM[page], number)
        pages += [(place, _content(place, drawing, preset)) for place in places]
    return pdf_file([(place.size_mm, content) for place, content in pages])


def _whole(drawing: Drawing) -> _Page:
    low, high = np.array(drawing.low_mm), np.array(drawing.high_mm)
    width, height = (high - low + 2 * BORDER_MM).tolist()
    return _Page((width, height), (float(low[0]), float(low[1])), BORDER_MM, "")


def _tiles(drawing: Drawing, size: tuple[float, float], number: int) -> list[_Page]:
    """The fewest pages, upright or lying, row by row from the top."""
    low, high = np.array(drawing.low_mm), np.array(drawing.high_mm)
    grids = []
    for width, height in (size, size[::-1]):
        room = np.array([width, height]) - 2 * TILE_BORDER_MM
        steps = room - TILE_OVERLAP_MM
        count = np.maximum(1, np.ceil((high - low - TILE_OVERLAP_MM) / steps - 1e-9)).astype(int)
        grids.append((int(count.prod()), (width, height), steps, count))
    total, (width, height), steps, count = min(grids, key=lambda grid: grid[0])
    pages: list[_Page] = []
    for row in reversed(range(int(count[1]))):
        for column in range(int(count[0])):
            corner = low + steps * [column, row]
            label = f"{number}: {len(pages) + 1} / {total}"
            pages.append(
                _Page((width, height), (float(corner[0]), float(corner[1])), TILE_BORDER_MM, label)
            )
    return pages


def _content(page: _Page, drawing: Drawing, preset: Preset) -> bytes:
    lines = [f"{plain(POINTS_PER_MM)} 0 0 {plain(POINTS_PER_MM)} 0 0 cm"]
    lines += [f"{HAIRLINE_MM} w 1 j 1 J", "q"]
    border, (width, height) = page.border_mm, page.size_mm
    if page.label:
        # A line on the very edge is whole.
        low = border - HAIRLINE_MM
        room = (width - 2 * low, height - 2 * low)
        lines.append(f"{plain(low)} {plain(low)} {plain(room[0])} {plain(room[1])} re W n")
    shift = np.array([border, border]) - page.low_mm
    colour = ""
    for path in drawing.paths:
        wanted = _colour(preset.layers[path.purpose].rgb)
        if wanted != colour:
            colour = wanted
            lines.append(colour)
        lines.append(_path(path.points + shift, closed=path.closed))
    lines.append("Q")
    if page.label:
        lines.append(_colour("#808080"))
        lines += [_path(stroke, closed=False) for stroke in _marks(page)]
    return "\n".join(lines).encode()


def _marks(page: _Page) -> Iterator[Array]:
    """Ticks where neighbouring tiles begin, and the tile's name."""
    border, (width, height) = page.border_mm, page.size_mm
    inset = border + TILE_OVERLAP_MM / 2
    for x in (inset, width - inset):
        for y, out in ((border, -1.0), (height - border, 1.0)):
            yield np.array([[x, y], [x, y + 4.0 * out]])
    for y in (inset, height - inset):
        for x, out in ((border, -1.0), (width - border, 1.0)):
            yield np.array([[x, y], [x + 4.0 * out, y]])
    yield from text_strokes(page.label, (border + TILE_OVERLAP_MM, 3.0), 3.0)


def _path(points: Array, *, closed: bool) -> str:
    pairs = [f"{plain(x)} {plain(y)}" for x, y in points.tolist()]
    return f"{pairs[0]} m {' '.join(f'{pair} l' for pair in pairs[1:])} {'s' if closed else 'S'}"


def _colour(rgb: str) -> str:
    return " ".join(plain(int(rgb[n : n + 2], 16) / 255) for n in (1, 3, 5)) + " RG"
