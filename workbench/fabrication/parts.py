"""The parts list: plates, sheets, lengths, an estimate of time and price.

Terms
-----
cut length
    Of all closed paths of a plate, in the middle of the beam.
time
    Paths at their speeds, and for each path the time to get there and pierce. Machines slow down
    in corners: it is an estimate.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry import Polygon

from ...solver.values import Array
from .plates import Plate
from .settings import ShopSettings
from .sheets import Part, Sheet

_HEAD = (
    "kind",
    "id",
    "faces",
    "thickness_mm",
    "width_mm",
    "height_mm",
    "area_mm2",
    "cut_mm",
    "time_s",
    "used_share",
    "price",
)


@dataclass(frozen=True, slots=True)
class Row:
    """One plate, one sheet, or the sum.

    Parameters
    ----------
    kind : str
        ``plate``, ``sheet`` or ``total``.
    id : str
        The plate's, the sheet's number, or empty.
    face_ids : tuple of str
    thickness_mm, width_mm, height_mm : float or None
        Finished size of a plate.
    area_mm2 : float
        Of a plate's material, or of the stock.
    cut_mm, time_s : float
    used_share : float or None
        Of a sheet's area, that plates take.
    price : float or None
        Where the price of a sheet is known.
    """

    kind: str
    id: str
    face_ids: tuple[str, ...]
    thickness_mm: float | None
    width_mm: float | None
    height_mm: float | None
    area_mm2: float
    cut_mm: float
    time_s: float
    used_share: float | None = None
    price: float | None = None


def parts_list(
    plates: Sequence[Plate], sheets: Sequence[Sheet], shop: ShopSettings
) -> tuple[Row, ...]:
    """All plates in their order, then the sheets, then the sum.

    Parameters
    ----------
    plates : sequence of Plate
    sheets : sequence of Sheet
        The same plates laid out.
    shop : ShopSettings

    Returns
    -------
    tuple of Row
    """
    laid = {part.plate_id: part for sheet in sheets for part in sheet.parts}
    rows = [_plate_row(plate, laid[plate.id], shop) for plate in plates]
    areas = {row.id: row.area_mm2 for row in rows}
    for number, sheet in enumerate(sheets, start=1):
        size = sheet.width_mm * sheet.height_mm
        rows.append(
            Row(
                "sheet",
                str(number),
                (),
                sheet.thickness_mm,
                sheet.width_mm,
                sheet.height_mm,
                size,
                sum(_cut_mm(part) for part in sheet.parts),
                sum(_time_s(part, shop) for part in sheet.parts),
                sum(areas[part.plate_id] for part in sheet.parts) / size,
                shop.sheet_price,
            )
        )
    price = None if shop.sheet_price is None else shop.sheet_price * len(sheets)
    made = rows[: len(plates)]
    total = Row(
        "total",
        "",
        (),
        None,
        None,
        None,
        sum(row.area_mm2 for row in made),
        sum(row.cut_mm for row in made),
        sum(row.time_s for row in made),
        None,
        price,
    )
    return (*rows, total)


def _plate_row(plate: Plate, part: Part, shop: ShopSettings) -> Row:
    width, height = plate.size_mm
    area, cut, time = plate.polygon.area, _cut_mm(part), _time_s(part, shop)
    return Row(
        "plate", plate.id, plate.face_ids, plate.thickness_mm, width, height, area, cut, time
    )


def _length_mm(paths: Iterable[Array]) -> float:
    return sum(float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum()) for path in paths)


def _cut_mm(part: Part) -> float:
    return sum(float(shapely.length(Polygon(ring).exterior)) for ring in (part.outer, *part.inner))


def _time_s(part: Part, shop: ShopSettings) -> float:
    paths = 1 + len(part.inner) + len(part.name)
    cut, engraved = _cut_mm(part) / shop.cut_mm_s, _length_mm(part.name) / shop.engrave_mm_s
    return cut + engraved + paths * shop.pierce_s


def parts_csv_bytes(rows: Sequence[Row]) -> bytes:
    """The list as CSV: one head line, a point in numbers, commas between."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(_HEAD)
    for row in rows:
        numbers = (row.thickness_mm, row.width_mm, row.height_mm, row.area_mm2, row.cut_mm)
        shares = (row.time_s, row.used_share, row.price)
        writer.writerow(
            [row.kind, row.id, " ".join(row.face_ids), *map(_number, (*numbers, *shares))]
        )
    return text.getvalue().encode()


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.3f}".rstrip("0").rstrip(".")
