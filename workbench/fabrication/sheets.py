"""Plates laid out on sheets of stock.

Terms
-----
sheet
    The stock; all plates on one sheet have its thickness.
part
    A plate's cut paths at their place on a sheet, with its name to be engraved.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.values import Array
from .cut_paths import CutPath, cut_path
from .errors import FabricationError
from .joints import Joint
from .narrow_places import TooNarrowError
from .packing import pack
from .plates import Plate
from .settings import USUAL_SHEETS_MM, PlateSettings
from .strokes import text_strokes, text_width_mm

#: Heights of engraved names, mm; the largest that fits is taken.
TEXT_HEIGHTS_MM = (8.0, 6.0, 5.0, 4.0, 3.0, 2.5)
#: Between a name and the marks, mm.
_CLEAR_MM = 1.5
#: Around a name to the part's border and slots, mm: as it looks well, and as it must be.
_BORDERS_MM = (4.0, 1.0)
#: Where names are tried, in parts of the bounding box from its middle, the nearest first.
_TRIED = np.array(
    sorted(
        ((x / 10, y / 10) for x in range(-4, 5) for y in range(-4, 5)),
        key=lambda share: round(float(np.hypot(*share)), 6),
    )
)


Marks = Mapping[str, Sequence[Array]]


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """One plate on a sheet; all positions in mm from the sheet's lower left corner.

    Parameters
    ----------
    plate_id : str
    outer : (k, 2) array
    inner : tuple of (k, 2) arrays
    name : tuple of (k, 2) arrays
        What is engraved: the strokes of its name, empty where it does not fit, and its marks.
    """

    plate_id: str
    outer: Array
    inner: tuple[Array, ...]
    name: tuple[Array, ...]


@dataclass(frozen=True, slots=True)
class Sheet:
    """A sheet of stock with its parts."""

    width_mm: float
    height_mm: float
    thickness_mm: float
    parts: tuple[Part, ...]


def lay_out(
    plates: Sequence[Plate],
    settings: PlateSettings,
    marks: Marks | None = None,
    joints: Sequence[Joint] = (),
) -> tuple[Sheet, ...]:
    """Cut paths of all plates, laid out on as few sheets as can be found.

    Parameters
    ----------
    plates : sequence of Plate
    settings : PlateSettings
        All about cutting and sheets is used.
    marks : mapping of plate id to strokes
        In the plate's frame, to be engraved besides its name.
    joints : sequence of Joint
        Between the plates: to name the edge where something is too narrow to be cut.

    Returns
    -------
    tuple of Sheet
        Thin stock first.

    Raises
    ------
    FabricationError
        Where a plate is larger than the sheet, or a notch narrower than the kerf.
    """
    paths, size = paths_that_fit(plates, settings, joints)
    sheets: list[Sheet] = []
    for thickness in sorted({path.thickness_mm for path in paths}):
        group = [path for path in paths if path.thickness_mm == thickness]
        sheets += _sheets(group, size, thickness, settings, marks or {})
    return tuple(sheets)


def paths_that_fit(
    plates: Sequence[Plate], settings: PlateSettings, joints: Sequence[Joint] = ()
) -> tuple[list[CutPath], tuple[float, float]]:
    """The cut paths of plates, and the size of a sheet that takes each; raises as `lay_out`."""
    try:
        paths = [
            cut_path(plate, settings.kerf_mm, settings.relief, settings.tool_mm) for plate in plates
        ]
    except TooNarrowError as error:
        raise error.at_edges(joints, plates) from None
    size = settings.sheet_mm or _usual_sheet(paths, settings)
    _check_fit(paths, size, settings)
    return paths, size


def _size(path: CutPath) -> tuple[float, float]:
    width, height = np.ptp(path.outer, axis=0)
    return float(width), float(height)


def _room(size: tuple[float, float], settings: PlateSettings) -> tuple[float, float]:
    return size[0] - 2 * settings.margin_mm, size[1] - 2 * settings.margin_mm


def _fits(path: CutPath, room: tuple[float, float], grain: str) -> bool:
    width, height = _size(path)
    if grain != "free":
        across, up = (height, width) if grain == "x" else (width, height)
        return across <= room[0] + 1e-9 and up <= room[1] + 1e-9
    long, short = max(room), min(room)
    return max(width, height) <= long + 1e-9 and min(width, height) <= short + 1e-9


def _usual_sheet(paths: Sequence[CutPath], settings: PlateSettings) -> tuple[float, float]:
    for size in USUAL_SHEETS_MM:
        if all(_fits(path, _room(size, settings), settings.grain) for path in paths):
            return size
    return USUAL_SHEETS_MM[-1]


def _check_fit(
    paths: Sequence[CutPath], size: tuple[float, float], settings: PlateSettings
) -> None:
    room = _room(size, settings)
    large = [path for path in paths if not _fits(path, room, settings.grain)]
    if large:
        width, height = _size(large[0])
        raise FabricationError(
            f"a plate of {width:.1f} x {height:.1f} mm does not fit on a sheet of {size[0]:g} x "
            f"{size[1]:g} mm with a margin of {settings.margin_mm:g} mm"
            + ("" if settings.grain == "free" else f" and its grain along {settings.grain}"),
            (path.plate_id for path in large),
            _remedy(large, size, settings),
        )


def _remedy(large: Sequence[CutPath], size: tuple[float, float], settings: PlateSettings) -> str:
    """What would let plates fit that do not."""
    if all(_fits(path, _room(size, settings), "free") for path in large):
        return "a larger sheet, or another grain"
    if all(_fits(path, size, settings.grain) for path in large):
        return "a larger sheet, or a smaller margin"
    return "a larger sheet"


def _sheets(
    paths: Sequence[CutPath],
    size: tuple[float, float],
    thickness: float,
    settings: PlateSettings,
    marks: Marks,
) -> list[Sheet]:
    gap, room = settings.spacing_mm, _room(size, settings)
    across = settings.grain == "x"
    sizes = [(width + gap, height + gap) for width, height in map(_size, paths)]
    sizes = [size[::-1] for size in sizes] if across else sizes
    places = pack(sizes, (room[0] + gap, room[1] + gap), turnable=settings.grain == "free")
    sheets = []
    for number in range(max(place.sheet for place in places) + 1):
        parts = []
        for path, place in zip(paths, places, strict=True):
            if place.sheet == number:
                corner = np.array([place.x + settings.margin_mm, place.y + settings.margin_mm])
                strokes = marks.get(path.plate_id, ())
                parts.append(_part(path, corner, strokes, turned=place.turned or across))
        sheets.append(Sheet(size[0], size[1], thickness, tuple(parts)))
    return sheets


def _part(path: CutPath, corner: Array, marks: Sequence[Array], *, turned: bool) -> Part:
    turn = np.array([[0.0, -1.0], [1.0, 0.0]]) if turned else np.eye(2)
    shift = corner - (path.outer @ turn.T).min(axis=0)
    outer, *inner = (np.round(ring @ turn.T + shift, 6) + 0.0 for ring in (path.outer, *path.inner))
    strokes = [np.round(mark @ turn.T + shift, 6) for mark in marks]
    name = _name(path.plate_id, outer, inner, strokes)
    return Part(path.plate_id, outer, tuple(inner), (*name, *strokes))


def _name(text: str, outer: Array, inner: Sequence[Array], marks: Sequence[Array]) -> list[Array]:
    """Strokes of a name where it lies wholly within the part, near its middle."""
    area = Polygon(outer, inner)
    shapely.prepare(area)
    middles = _spots(outer)
    for height in TEXT_HEIGHTS_MM:
        half = np.array([text_width_mm(text, height), height]) / 2
        rooms = np.hstack([middles - half, middles + half])
        for mark in marks:
            low, high = mark.min(axis=0) - _CLEAR_MM, mark.max(axis=0) + _CLEAR_MM
            rooms = rooms[((rooms[:, :2] >= high) | (rooms[:, 2:] <= low)).any(axis=1)]
        for border in _BORDERS_MM:
            around = rooms + np.array([-1.0, -1.0, 1.0, 1.0]) * border
            fitting = np.flatnonzero(shapely.contains(area, shapely.box(*around.T)))
            if len(fitting):
                x, y = rooms[fitting[0], :2].tolist()
                return text_strokes(text, (x, y), height)
    return []


def _spots(outer: Array) -> Array:
    """Places in a part's bounding box, from its middle outwards."""
    low, high = outer.min(axis=0), outer.max(axis=0)
    return np.asarray(low + (0.5 + _TRIED) * (high - low))
