"""The drawing as DXF R2000: closed LWPOLYLINEs in real millimetres, the same bytes every time.

No SPLINE, no INSERT: programs read them differently. Holes stand before outlines. A preset may
ask for R12 (POLYLINE, no units in the file) or for single lines.
"""

from __future__ import annotations

import io
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Any

from ezdxf._options import options
from ezdxf.document import Drawing as Document
from ezdxf.filemanagement import new
from ezdxf.layouts.layout import Modelspace

from .drawing import Drawing, Path, draw
from .presets import DEFAULT, Layer, Preset, load_preset
from .sheets import Sheet

#: After this in the file come its entities.
_ENTITIES = "  0\nSECTION\n  2\nENTITIES\n"
_SEED = "$HANDSEED\n  5\n{}\n"
#: Numbers that stand in a frame for the drawing's least and largest x and y.
_EXTENTS_MM = (-73110.25, -73111.25, 73112.25, 73113.25)


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
    if preset.dxf == "R12" or preset.lines:
        return _through_ezdxf(drawing, preset)
    frame = _frame(tuple(preset.layers.items()))
    entities, last = _polylines(drawing, preset, frame)
    values = (*drawing.low_mm, *drawing.high_mm)
    before = frame.before.replace(_SEED.format(frame.handle), _SEED.format(f"{last + 1:X}"))
    after = frame.after
    for mark, value in zip(_EXTENTS_MM, values, strict=True):
        before, after = (text.replace(repr(mark), repr(float(value))) for text in (before, after))
    return (before + entities + after).encode(frame.encoding, errors="dxfreplace")


@dataclass(frozen=True, slots=True)
class _Frame:
    """A file's text before and after its entities, the same for all drawings of a preset.

    Instead of the drawing's extents it has `_EXTENTS_MM`; `handle` is the first that is free.
    """

    before: str
    after: str
    owner: str
    handle: str
    encoding: str


@cache
def _frame(layers: tuple[tuple[str, Layer], ...]) -> _Frame:
    x, y, u, v = _EXTENTS_MM
    with _fixed_dates():
        document = _document("R2000", layers)
        document.modelspace().reset_extents((x, y, 0.0), (u, v, 0.0))
        text = io.StringIO()
        document.write(text)
    before, mark, after = text.getvalue().partition(_ENTITIES)
    return _Frame(
        before + mark,
        after,
        document.modelspace().layout_key,
        str(document.entitydb.handles),
        document.output_encoding,
    )


def _document(version: str, layers: Iterable[tuple[str, Layer]]) -> Document:
    """A document with nothing drawn in it."""
    document = new(version)
    if version != "R12":
        document.header["$INSUNITS"] = 4
        document.header["$MEASUREMENT"] = 1
    for purpose, layer in layers:
        if layer.shown and layer.name not in document.layers:
            document.layers.add(layer.name, color=layer.aci)
            # Neither the border of the stock nor the scale bar is to be cut or printed.
            if purpose in ("SHEET", "SCALE") and version != "R12":
                document.layers.get(layer.name).dxf.plot = 0
    return document


def _through_ezdxf(drawing: Drawing, preset: Preset) -> bytes:
    """What is asked for rarely."""
    with _fixed_dates():
        document = _document(preset.dxf, preset.layers.items())
        space = document.modelspace()
        space.reset_extents((*drawing.low_mm, 0.0), (*drawing.high_mm, 0.0))
        for path in drawing.paths:
            layer = preset.layers[path.purpose]
            own = {"color": layer.aci} if layer.name == "0" else {}
            _add(space, path, {"layer": layer.name} | own, preset)
        text = io.StringIO()
        document.write(text)
    return text.getvalue().encode(document.output_encoding, errors="dxfreplace")


def _polylines(drawing: Drawing, preset: Preset, frame: _Frame) -> tuple[str, int]:
    """Each path as an LWPOLYLINE, and the last handle: through ezdxf it takes ten times as long."""
    first, lines = int(frame.handle, 16), []
    for handle, path in enumerate(drawing.paths, start=first):
        layer = preset.layers[path.purpose]
        color = f" 62\n{layer.aci}\n" if layer.name == "0" else ""
        points = "".join([f" 10\n{x}\n 20\n{y}\n" for x, y in path.points.tolist()])
        lines.append(
            f"  0\nLWPOLYLINE\n  5\n{handle:X}\n330\n{frame.owner}\n"
            f"100\nAcDbEntity\n  8\n{layer.name}\n{color}"
            f"100\nAcDbPolyline\n 90\n{len(path.points)}\n 70\n{int(path.closed)}\n{points}"
        )
    return "".join(lines), first + len(lines) - 1


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
