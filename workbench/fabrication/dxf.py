"""The drawing as DXF R2000: closed LWPOLYLINEs in real millimetres, the same bytes every time.

No SPLINE, no INSERT: programs read them differently. Holes stand before outlines. A preset may
ask for R12 (POLYLINE, no units in the file) or for single lines.
"""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import pairwise
from typing import Any

from ezdxf._options import options
from ezdxf.document import Drawing as Document
from ezdxf.filemanagement import new
from ezdxf.layouts.layout import Modelspace

from .drawing import Drawing, Path, draw
from .presets import DEFAULT, Preset, load_preset
from .sheets import Sheet

#: After this in the file come its entities.
_ENTITIES = "  0\nSECTION\n  2\nENTITIES\n"


def dxf_bytes(sheets: Sequence[Sheet], preset: Preset | None = None) -> bytes:
    """All sheets as one DXF file.

    Parameters
    ----------
    sheets : sequence of Sheet
    preset : Preset or None
        Names and colours of layers; None takes the plain ones.

    Returns
    -------
    bytes
        Equal for equal sheets.
    """
    preset = preset or load_preset(DEFAULT)
    drawing = draw(sheets, preset)
    with _fixed_dates():
        document, entities = _document(drawing, preset)
        text = io.StringIO()
        document.write(text)
    before, mark, after = text.getvalue().partition(_ENTITIES)
    whole = before + mark + entities + after
    return whole.encode(document.output_encoding, errors="dxfreplace")


def _document(drawing: Drawing, preset: Preset) -> tuple[Document, str]:
    """The document, and the text of what is drawn where we write that ourselves."""
    document = new(preset.dxf)
    if preset.dxf != "R12":
        document.header["$INSUNITS"] = 4
        document.header["$MEASUREMENT"] = 1
    for purpose, layer in preset.layers.items():
        if layer.shown and layer.name not in document.layers:
            document.layers.add(layer.name, color=layer.aci)
            # Neither the border of the stock nor the scale bar is to be cut or printed.
            if purpose in ("SHEET", "SCALE") and preset.dxf != "R12":
                document.layers.get(layer.name).dxf.plot = 0
    space = document.modelspace()
    space.reset_extents((*drawing.low_mm, 0.0), (*drawing.high_mm, 0.0))
    if preset.dxf != "R12" and not preset.lines:
        return document, "".join(_polylines(document, drawing, preset))
    for path in drawing.paths:
        layer = preset.layers[path.purpose]
        attributes = {"layer": layer.name} | ({"color": layer.aci} if layer.name == "0" else {})
        _add(space, path, attributes, preset)
    return document, ""


def _polylines(document: Document, drawing: Drawing, preset: Preset) -> Iterator[str]:
    """Each path as an LWPOLYLINE: through ezdxf it takes ten times as long."""
    owner = document.modelspace().layout_key
    for path in drawing.paths:
        layer = preset.layers[path.purpose]
        color = f" 62\n{layer.aci}\n" if layer.name == "0" else ""
        points = "".join(f" 10\n{x}\n 20\n{y}\n" for x, y in path.points.tolist())
        yield (
            f"  0\nLWPOLYLINE\n  5\n{document.entitydb.next_handle()}\n330\n{owner}\n"
            f"100\nAcDbEntity\n  8\n{layer.name}\n{color}"
            f"100\nAcDbPolyline\n 90\n{len(path.points)}\n 70\n{int(path.closed)}\n{points}"
        )


def _add(space: Modelspace, path: Path, attributes: dict[str, Any], preset: Preset) -> None:
    points = path.points.tolist()
    if preset.lines:
        for start, end in pairwise([*points, *(points[:1] if path.closed else [])]):
            space.add_line(start, end, dxfattribs=attributes)
    else:
        space.add_polyline2d(points, close=path.closed, dxfattribs=attributes)


@contextmanager
def _fixed_dates() -> Iterator[None]:
    """Dates and identifiers that do not change from one writing to the next."""
    before = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        options.write_fixed_meta_data_for_testing = before
