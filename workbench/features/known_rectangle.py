"""The rectangle in the photo that tells the camera, as the photo sketch stores it.

The sketch file holds the camera alone; corners and size are there to be edited.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from .. import host

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph

Point = tuple[float, float]


def rectangle_of(text: str) -> tuple[tuple[Point, ...], Point] | None:
    """Four corners, px, and two sides, mm; None where the text says none."""
    try:
        body = json.loads(text) if text else None
        corners = tuple((float(u), float(v)) for u, v in body["corners_px"])
        width, height = (float(side) for side in body["size_mm"])
    except (ValueError, TypeError, KeyError):
        # A script may write anything; the camera itself stands in the sketch.
        return None
    numbers = [*(x for corner in corners for x in corner), width, height]
    if len(corners) != 4 or not all(map(math.isfinite, numbers)):
        return None
    return corners, (width, height)


def marker_text(corners_px: Iterable[Point], size_mm: Point) -> str:
    """The text that `rectangle_of` reads."""
    corners = [[round(float(u), 3), round(float(v), 3)] for u, v in corners_px]
    return json.dumps({"corners_px": corners, "size_mm": [float(side) for side in size_mm]})


def set_camera(obj: Any, graph: SketchGraph, marker: str) -> None:
    """Write a sketch with its camera, and what told it, as one step to undo.

    Parameters
    ----------
    obj : FreeCAD document object
        A photo sketch.
    graph : SketchGraph
        With the camera, or without one.
    marker : str
        See `marker_text`; empty where nothing tells the camera.
    """
    from ...solver.serialise import sketch_to_text

    words = "Find camera" if graph.camera is not None else "Forget camera"
    with host.transaction(obj.Document, host.translate("InContext", words)):
        obj.Marker = marker
        obj.Sketch = sketch_to_text(graph)
        obj.Document.recompute()
