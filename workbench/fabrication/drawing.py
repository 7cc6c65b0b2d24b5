"""The drawing of all sheets, which the DXF and the SVG show alike.

Terms
-----
purpose
    What a path is for, one of `PURPOSES`; a preset says on which layer it goes in which colour.
    Holes have their own purpose so that they can be cut first.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...solver.values import Array
from .presets import PURPOSES, Preset
from .sheets import Sheet
from .strokes import text_strokes

#: Between two sheets, and between the sheets and the scale bar, mm.
GAP_MM = 20.0
SCALE_BAR_MM = 100.0


@dataclass(frozen=True, slots=True, eq=False)
class Path:
    """A polyline with its purpose; mm, y upwards."""

    purpose: str
    points: Array
    closed: bool


@dataclass(frozen=True, slots=True)
class Drawing:
    """All paths, and the corners of the box around them."""

    paths: tuple[Path, ...]
    low_mm: tuple[float, float]
    high_mm: tuple[float, float]


def draw(sheets: Sequence[Sheet], preset: Preset | None = None) -> Drawing:
    """All sheets side by side, with a scale bar below.

    Parameters
    ----------
    sheets : sequence of Sheet
    preset : Preset or None
        Whose hidden layers are left out.

    Returns
    -------
    Drawing
        Sorted in the order of `PURPOSES`; the first sheet's corner lies in the origin.
    """
    paths: list[Path] = []
    x = 0.0
    for sheet in sheets:
        paths += _sheet_paths(sheet, np.array([x, 0.0]))
        x += sheet.width_mm + GAP_MM
    paths += _scale_bar(np.array([0.0, -GAP_MM]))
    paths.sort(key=lambda path: PURPOSES.index(path.purpose))
    if preset is not None:
        paths = [path for path in paths if preset.layers[path.purpose].shown]
    every = np.vstack([path.points for path in paths])
    low, high = every.min(axis=0), every.max(axis=0)
    return Drawing(tuple(paths), (float(low[0]), float(low[1])), (float(high[0]), float(high[1])))


def _sheet_paths(sheet: Sheet, corner: Array) -> Iterator[Path]:
    for part in sheet.parts:
        yield from (Path("ENGRAVE", stroke + corner, False) for stroke in part.name)
        yield from (Path("CUT_INNER", ring + corner, True) for ring in part.inner)
        yield Path("CUT_OUTER", part.outer + corner, True)
    width, height = sheet.width_mm, sheet.height_mm
    border = np.array([[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]])
    yield Path("SHEET", border + corner, True)
    note = f"{width:g} x {height:g} x {sheet.thickness_mm:g} mm"
    for stroke in text_strokes(note, (float(corner[0]), height + 4.0), 6.0):
        yield Path("SHEET", stroke, False)


def _scale_bar(corner: Array) -> Iterator[Path]:
    end = np.array([SCALE_BAR_MM, 0.0])
    tick = np.array([0.0, 4.0])
    yield Path("SCALE", np.array([corner + tick, corner, corner + end, corner + end + tick]), False)
    for stroke in text_strokes("100 mm", (SCALE_BAR_MM / 2 - 17.0, float(corner[1]) + 3.0), 6.0):
        yield Path("SCALE", stroke, False)
