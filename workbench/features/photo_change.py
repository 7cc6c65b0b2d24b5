"""Another photo for a sketch that is there already."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import host
from ..exif import focal_length_px
from . import pipeline

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph

#: Photos of which the sides' ratio differs by less are the same view in another size.
SAME_VIEW = 0.01


def replace_photo(obj: Any, path: Path, size_px: tuple[int, int]) -> None:
    """Put another photo under a sketch, as one step to undo.

    Parameters
    ----------
    obj : FreeCAD document object
        A photo sketch.
    path : Path
        The photo, which is copied into the document.
    size_px : (width, height)
        Of the upright photo.
    """
    from ...solver.serialise import sketch_to_text

    before = pipeline.graph_of(obj.Sketch)
    graph = with_photo(before, path.name, size_px, focal_length_px(path))
    with host.transaction(obj.Document, host.translate("InContext", "Replace photo")):
        obj.Photo = str(path)
        obj.Marker = _marker_text(obj, before, graph)
        obj.Sketch = sketch_to_text(graph)
        obj.Document.recompute()


def with_photo(
    graph: SketchGraph, name: str, size_px: tuple[int, int], focal_px: float | None
) -> SketchGraph:
    """The graph over another photo; the drawing is scaled where it is the same view, larger or
    smaller, and stays where it is, in px, on any other.
    """
    from ...solver.editing.elements import scaled
    from ...solver.graph import Photo

    width, height = size_px
    photo = Photo(name, width, height, focal_px=focal_px)
    before = graph.photo
    if before is None:
        return replace(graph, photo=photo)
    across, down = width / before.width_px, height / before.height_px
    factor = across if abs(across - down) < SAME_VIEW * across else 1.0
    if factor != across:
        # Where the camera was is known of the old photo only.
        return replace(graph, photo=photo, camera=None)
    if focal_px is None and before.focal_px is not None:
        photo = replace(photo, focal_px=factor * before.focal_px)
    return replace(scaled(graph, factor), photo=photo)


def _marker_text(obj: Any, before: SketchGraph, after: SketchGraph) -> str:
    """What tells the camera, on the other photo."""
    from .known_rectangle import marker_text, rectangle_of

    told = rectangle_of(obj.Marker)
    if told is None or after.camera is None or before.photo is None or after.photo is None:
        return ""
    corners, size_mm = told
    factor = after.photo.width_px / before.photo.width_px
    return marker_text([(factor * u, factor * v) for u, v in corners], size_mm)
