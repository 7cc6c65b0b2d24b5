"""A TechDraw page of the plates: each in its true outline with its main sizes, and a parts list.

Everything on the page follows the plates: the views show flat plates, the sizes are measured in
the views, and the cells of the parts list are expressions.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import FreeCAD

from .. import host
from .flat_plate import make_flat_plate
from .plate_set import plates_of

#: The page, A3 across, its free border, and the room for the list at its right, mm.
PAGE_MM, BORDER_MM, LIST_MM = (420.0, 297.0), 14.0, 112.0
#: Between two plates, with room for a size.
GAP_MM = 24.0
SCALES = (5.0, 2.0, 1.0, 0.5, 0.4, 1 / 3, 0.25, 0.2, 0.15, 0.1, 0.05, 0.02, 0.01)
#: On the page: nearer than this, a view has its plate's size.
_SAME_MM = 1e-3
#: Of the parts list, mm on the page.
_COLUMN_MM, _ROW_MM, _TEXT_MM = 27, 9, 4.0
#: TechDraw takes sizes in tables for pixels of a screen.
_PX_PER_MM = 96 / 25.4
_COLUMNS = ("Plate", "Width", "Height", "Thickness")


@dataclass(frozen=True, slots=True)
class _Place:
    """Where on the page the middle of a plate is."""

    x_mm: float
    y_mm: float


def make_plate_drawing(document: Any, plate_set: Any) -> Any:
    """A page of a plate set's plates; recompute the document to see it.

    Parameters
    ----------
    document : FreeCAD document
    plate_set : FreeCAD document object

    Returns
    -------
    FreeCAD document object
        The page.

    Raises
    ------
    SketchError, FabricationError
        Where there are no plates.
    """
    plates = plates_of(plate_set)
    flat = [make_flat_plate(document, plate_set, plate.id) for plate in plates]
    document.recompute(flat)
    scale, places = _layout([plate.size_mm for plate in plates])
    page = _page(document, scale)
    for obj, place in zip(flat, places, strict=True):
        _add_view(page, obj, scale, place)
    _add_list(page, flat)
    group = document.addObject("App::DocumentObjectGroup", "FlatPlates")
    group.Label = host.translate("InContext", "Flat plates")
    group.Group = flat
    document.recompute()
    return page


def _page(document: Any, scale: float) -> Any:
    page = document.addObject("TechDraw::DrawPage", "PlatesPage")
    page.Label = host.translate("InContext", "Drawing of the plates")
    template = document.addObject("TechDraw::DrawSVGTemplate", "PlatesTemplate")
    # FreeCAD's own ones have other places and names in every version.
    template.Template = host.resource("drawing", "a3.svg")
    page.Template = template
    page.Scale = scale
    if host.has_window():
        # Frames and dots are for arranging views; on paper they are not.
        page.ViewObject.ShowFrames = False
    return page


def _layout(sizes: list[tuple[float, float]]) -> tuple[float, list[_Place]]:
    """The largest usual scale at which all plates have room, and their places."""
    for scale in SCALES:
        places = _rows([(scale * width, scale * height) for width, height in sizes])
        if places is not None:
            return scale, places
    return SCALES[-1], [_Place(PAGE_MM[0] / 2, PAGE_MM[1] / 2)] * len(sizes)


def _rows(sizes: list[tuple[float, float]]) -> list[_Place] | None:
    """Row by row from the top, left to right; None where the page is too small."""
    right = PAGE_MM[0] - BORDER_MM - LIST_MM
    x, top, tallest = BORDER_MM, PAGE_MM[1] - BORDER_MM, 0.0
    places = []
    for width, height in sizes:
        if x > BORDER_MM and x + width + GAP_MM > right:
            x, top, tallest = BORDER_MM, top - tallest - GAP_MM, 0.0
        if x + width + GAP_MM > right or top - height - GAP_MM < BORDER_MM:
            return None
        places.append(_Place(x + GAP_MM + width / 2, top - height / 2))
        x += width + GAP_MM
        tallest = max(tallest, height)
    return places


def _add_view(page: Any, flat: Any, scale: float, place: _Place) -> None:
    document = page.Document
    view = document.addObject("TechDraw::DrawViewPart", f"View{flat.Name}")
    page.addView(view)
    view.Source = [flat]
    view.Direction, view.XDirection = FreeCAD.Vector(0, 0, 1), FreeCAD.Vector(1, 0, 0)
    view.ScaleType, view.Scale = "Custom", scale
    view.X, view.Y = place.x_mm, place.y_mm
    name = document.addObject("TechDraw::DrawViewAnnotation", f"Name{flat.Name}")
    page.addView(name)
    name.Text, name.TextSize = [flat.PlateId], 5.0
    name.X, name.Y = place.x_mm, place.y_mm


def add_sizes(page: Any) -> None:
    """Width and height of each plate, in the views.

    They are measured in what is seen, which FreeCAD 1.0 and later work out on the side: once the
    page's views are there.
    """
    import TechDraw

    views = [v for v in page.Views if v.TypeId == "TechDraw::DrawViewPart"]
    for view in views:
        flat = view.Source[0]
        width, height = (view.Scale * s.Value for s in (flat.PlateWidth, flat.PlateHeight))
        for direction, x, y in ((0, 0.0, -height / 2 - 7), (1, -width / 2 - 7, 0.0)):
            before = set(page.Document.Objects)
            TechDraw.makeExtentDim(view, [], direction)
            for size in set(page.Document.Objects) - before:
                if size.TypeId == "TechDraw::DrawViewDimExtent":
                    size.X, size.Y = x, y


def views_are_ready(page: Any) -> bool:
    """Whether all views know the edges of their plates as they are now.

    FreeCAD 1.0 and later show the edges of before until those on the side are worked out.
    """
    views = [v for v in page.Views if v.TypeId == "TechDraw::DrawViewPart"]
    return all(_shows_its_plate(view) for view in views)


def _shows_its_plate(view: Any) -> bool:
    edges, flat = view.getVisibleEdges(), view.Source[0]
    if len(edges) < 3:
        return False
    points = [vertex.Point for edge in edges for vertex in edge.Vertexes]
    return all(
        abs(max(coordinates) - min(coordinates) - view.Scale * size.Value) < _SAME_MM
        for coordinates, size in (
            ([point.x for point in points], flat.PlateWidth),
            ([point.y for point in points], flat.PlateHeight),
        )
    )


def _add_list(page: Any, flat: list[Any]) -> None:
    document = page.Document
    sheet = document.addObject("Spreadsheet::Sheet", "PartsList")
    sheet.Label = host.translate("InContext", "Parts list")
    for column, words in zip("ABCD", _COLUMNS, strict=True):
        sheet.set(f"{column}1", host.translate("InContext", words))
    for row, obj in enumerate(flat, start=2):
        sheet.set(f"A{row}", f"'{obj.PlateId}")
        for column, name in zip(
            "BCD", ("PlateWidth", "PlateHeight", "PlateThickness"), strict=True
        ):
            sheet.set(f"{column}{row}", f"={obj.Name}.{name}")
    for column in "ABCD":
        sheet.setColumnWidth(column, _COLUMN_MM)
    for row in range(1, len(flat) + 2):
        sheet.setRowHeight(str(row), _ROW_MM)
    sheet.setStyle("A1:D1", "bold")
    document.recompute([sheet])
    view = document.addObject("TechDraw::DrawViewSpreadsheet", "PartsListView")
    page.addView(view)
    view.Source = sheet
    top = PAGE_MM[1] - BORDER_MM
    view.CellStart, view.CellEnd = "A1", f"D{len(flat) + 1}"
    view.TextSize, view.ScaleType, view.Scale = _TEXT_MM, "Custom", _PX_PER_MM
    view.X, view.Y = PAGE_MM[0] - BORDER_MM - LIST_MM / 2, top - (len(flat) + 1) * _ROW_MM / 2
