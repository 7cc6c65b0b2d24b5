"""The drawing as SVG in millimetres: hairlines, one group a layer, the same bytes every time."""

from __future__ import annotations

from collections.abc import Sequence

from .drawing import Drawing, Path, draw
from .presets import DEFAULT, Preset, load_preset
from .sheets import Sheet

HAIRLINE_MM = 0.1
_BORDER_MM = 2.0


def svg_bytes(sheets: Sequence[Sheet], preset: Preset | None = None) -> bytes:
    """All sheets as one SVG file.

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
    width = drawing.high_mm[0] - drawing.low_mm[0] + 2 * _BORDER_MM
    height = drawing.high_mm[1] - drawing.low_mm[1] + 2 * _BORDER_MM
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<svg xmlns="http://www.w3.org/2000/svg" '
        'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        f'width="{_number(width)}mm" height="{_number(height)}mm" '
        f'viewBox="0 0 {_number(width)} {_number(height)}">',
    ]
    for purpose, layer in preset.layers.items():
        if not layer.shown:
            continue
        lines.append(
            f'<g id="{purpose}" inkscape:groupmode="layer" inkscape:label="{layer.name}" '
            f'fill="none" stroke="{layer.rgb}" stroke-width="{HAIRLINE_MM}">'
        )
        lines += [_path(path, drawing) for path in drawing.paths if path.purpose == purpose]
        lines.append("</g>")
    return "\n".join([*lines, "</svg>", ""]).encode()


def _path(path: Path, drawing: Drawing) -> str:
    left, top = drawing.low_mm[0] - _BORDER_MM, drawing.high_mm[1] + _BORDER_MM
    points = [f"{_number(x - left)},{_number(top - y)}" for x, y in path.points.tolist()]
    return f'<path d="M {" L ".join(points)}{" Z" if path.closed else ""}"/>'


def _number(value: float) -> str:
    """At most four decimals, no trailing zeros, never -0."""
    text = f"{value:.4f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
