"""The drawing as DXF R2000: closed LWPOLYLINEs in real millimetres, the same bytes every time.

No SPLINE, no INSERT: programs read them differently. Holes stand before outlines.
"""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from ezdxf._options import options
from ezdxf.document import Drawing as Document
from ezdxf.filemanagement import new

from .drawing import LAYERS, Drawing, draw
from .sheets import Sheet


def dxf_bytes(sheets: Sequence[Sheet]) -> bytes:
    """All sheets as one DXF file.

    Parameters
    ----------
    sheets : sequence of Sheet

    Returns
    -------
    bytes
        Equal for equal sheets.
    """
    with _fixed_dates():
        document = _document(draw(sheets))
        text = io.StringIO()
        document.write(text)
    return text.getvalue().encode(document.output_encoding, errors="dxfreplace")


def _document(drawing: Drawing) -> Document:
    document = new("R2000")
    document.header["$INSUNITS"] = 4
    document.header["$MEASUREMENT"] = 1
    for name, layer in LAYERS.items():
        document.layers.add(name, color=layer.aci)
    # Neither the border of the stock nor the scale bar is to be cut or printed.
    for name in ("SHEET", "SCALE"):
        document.layers.get(name).dxf.plot = 0
    space = document.modelspace()
    for path in drawing.paths:
        space.add_lwpolyline(
            path.points.tolist(), close=path.closed, dxfattribs={"layer": path.layer}
        )
    space.reset_extents((*drawing.low_mm, 0.0), (*drawing.high_mm, 0.0))
    return document


@contextmanager
def _fixed_dates() -> Iterator[None]:
    """Dates and identifiers that do not change from one writing to the next."""
    before = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        options.write_fixed_meta_data_for_testing = before
