"""What is known of the camera that took a sketch's photo: its lens, and where it looked.

Terms
-----
middle of view
    Where the axis of view meets the photo (the principal point): its middle, unless the photo was
    cropped.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from .. import host
from ..exif import FRAME_DIAGONAL_MM, PhotoData, photo_data
from . import pipeline
from .known_rectangle import marker_text, rectangle_of

if TYPE_CHECKING:
    from ...solver.graph import Photo, Point, SketchGraph
    from ...solver.perspective.cropping import ViewMiddle


@dataclass(frozen=True, slots=True)
class PhotoCamera:
    """What is told of the camera.

    Parameters
    ----------
    focal_px : float or None
        None where the drawing is to tell it.
    middle_px : (u, v) or None
        None for the photo's middle.
    """

    focal_px: float | None
    middle_px: Point | None


def told_camera(graph: SketchGraph) -> PhotoCamera:
    """What the sketch says of its photo's camera."""
    photo = _photo(graph)
    return PhotoCamera(photo.focal_px, photo.principal_point_px)


def _photo(graph: SketchGraph) -> Photo:
    assert graph.photo is not None
    return graph.photo


def px_per_mm(obj: Any, graph: SketchGraph) -> float:
    """Photo px a millimetre of the 35 mm equivalent, as the whole photo has it."""
    photo = _photo(graph)
    data = photo_data(obj.Photo) if obj.Photo else None
    whole = None if data is None else data.whole_size_px
    return math.hypot(*(whole or (photo.width_px, photo.height_px))) / FRAME_DIAGONAL_MM


def cropping_words(obj: Any, graph: SketchGraph) -> str:
    """Whether the photo seems to have been cropped, in a sentence; empty where it does not."""
    data: PhotoData | None = photo_data(obj.Photo) if obj.Photo else None
    if data is None or graph.photo is None:
        return ""
    whole = data.whole_size_px
    if whole is not None:
        words = "This photo seems cropped: the camera wrote {0} x {1} px, {2} x {3} px are left."
        return host.translate("InContext", words).format(*whole, *data.size_px)
    if data.is_of_a_camera and data.has_unusual_shape:
        words = "This photo seems cropped: no camera takes photos of {0} x {1} px."
        return host.translate("InContext", words).format(*data.size_px)
    return ""


def middle_by_lines(obj: Any, graph: SketchGraph) -> ViewMiddle | None:
    """The middle of view as the traced lines tell it; None where they do not."""
    from ...solver.perspective.vanishing_points import traced_middle

    solution = pipeline.solution_of(obj.Sketch)
    if graph.camera is not None or solution.status.value != "converged":
        return None
    found = traced_middle(graph, solution)
    return found if found is not None and is_sure(found, _photo(graph)) else None


def is_sure(middle: ViewMiddle, photo: Photo) -> bool:
    """Whether a middle of view is told well enough to be taken: to 5 % of the photo."""
    longer = max(photo.width_px, photo.height_px)
    is_near = all(-longer < x < 2 * longer for x in middle.principal_px.tolist())
    return is_near and middle.sigma_px < 0.05 * longer


def set_photo_camera(obj: Any, camera: PhotoCamera) -> None:
    """Write what is known of the camera, as one step to undo.

    A camera that a rectangle told is found again by it.

    Raises
    ------
    SketchError
        Where the rectangle cannot be seen so.
    """
    from ...solver.serialise import sketch_to_text

    before = pipeline.graph_of(obj.Sketch)
    photo = replace(_photo(before), focal_px=camera.focal_px, principal_point_px=camera.middle_px)
    graph, marker = _seen_again(replace(before, photo=photo), obj.Marker)
    with host.transaction(obj.Document, host.translate("InContext", "Camera of the photo")):
        obj.Marker = marker
        obj.Sketch = sketch_to_text(graph)
        obj.Document.recompute()


def _seen_again(graph: SketchGraph, marker: str) -> tuple[SketchGraph, str]:
    """The graph with the camera that its rectangle tells now."""
    told = rectangle_of(marker)
    if told is None or graph.camera is None:
        return graph, marker
    found = rectangle_view(graph, told)
    return replace(graph, camera=found.camera), marker_text(found.corners_px.tolist(), told[1])


def rectangle_view(graph: SketchGraph, told: tuple[tuple[Point, ...], Point]) -> Any:
    """The camera by corners that the photo has put right already; raises SketchError."""
    from ...solver.perspective.marker import camera_from_rectangle
    from ..marker_finding import LEAST_SIGMA_PX

    corners, size_mm = told
    return camera_from_rectangle(
        _photo(graph), corners, size_mm, corner_sigma_px=3 * LEAST_SIGMA_PX
    )


def refine_camera(obj: Any) -> bool:
    """Have rectangle and drawing tell the camera together, as one step to undo.

    Returns
    -------
    bool
        False where they do not agree, or one of them is missing.

    Raises
    ------
    SketchError
        Where the rectangle cannot be seen so.
    """
    from ...solver.perspective.refining import refined_camera
    from ...solver.serialise import sketch_to_text

    graph, told = pipeline.graph_of(obj.Sketch), rectangle_of(obj.Marker)
    if told is None or graph.camera is None:
        return False
    camera = refined_camera(graph, rectangle_view(graph, told))
    if camera is None:
        return False
    with host.transaction(obj.Document, host.translate("InContext", "Refine camera")):
        obj.Sketch = sketch_to_text(replace(graph, camera=camera))
        obj.Document.recompute()
    return True
