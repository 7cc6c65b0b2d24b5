"""What is said of photos that may have been cropped, where the traced lines alone do not tell."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .exif import PhotoData

if TYPE_CHECKING:
    from ..solver.graph import SketchGraph
    from ..solver.perspective.vanishing_points import Traced


def perspective_notes(graph: SketchGraph, traced: Traced) -> tuple[str, ...]:
    """What the traced lines say, and that the photo may be cropped where they do not tell it."""
    if any("cropped" in note for note in traced.notes):
        return traced.notes
    return (*traced.notes, *may_be_cropped(graph))


def may_be_cropped(graph: SketchGraph) -> tuple[str, ...]:
    """A sentence where nobody says where a photo looked whose shape no camera's photos have."""
    photo = graph.photo
    if photo is None or graph.camera is not None or photo.principal_point_px is not None:
        return ()
    if not PhotoData((photo.width_px, photo.height_px)).has_unusual_shape:
        return ()
    return (
        f"No camera takes photos of {photo.width_px} x {photo.height_px} px: where this one was "
        "cropped, sizes may be off by some percent: use the whole photo, or say where it looked "
        "in the photo's camera.",
    )
