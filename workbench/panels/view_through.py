"""Looking through the photo: FreeCAD's camera set to the solved one, and back again."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import FreeCAD
import numpy as np

from ..features import pipeline
from .messages import tell
from .photo_plane import depth_behind_mm
from .shape_preview import view_3d_of

if TYPE_CHECKING:
    from ...solver.camera import Camera
    from ...solver.graph import SketchGraph
    from ...solver.values import Array


#: An eye so near to the photo's, in parts of its distance, is there.
SAME_PLACE = 1e-4
#: What makes up a view; not every kind of camera has all of these.
_FIELDS = ("position", "orientation", "focalDistance", "heightAngle", "height", "aspectRatio")


@dataclass(frozen=True, slots=True)
class _Before:
    """How the 3D view was: its camera, as texts of Coin's, and whether the photo was shown.

    Not as FreeCAD writes a camera: its `setCamera` knows no angle of view.
    """

    camera_type: str
    camera: dict[str, str]
    photo_shown: bool


#: By document and object.
_before: dict[tuple[str, str], _Before] = {}


def looks_through(obj: Any) -> bool:
    """Whether the 3D view looks through the photo of a sketch."""
    return _key(obj) in _before


def look_through(obj: Any) -> None:
    """Look through the photo of a sketch, whose tab is open: it puts the photo there."""
    view = view_3d_of(obj.Document.Name)
    if view is None:
        return
    graph, solution = pipeline.graph_of(obj.Sketch), pipeline.solution_of(obj.Sketch)
    if solution.camera is None or not (solution.vertices_mm or solution.circles):
        tell(solution.message)
        return
    shown = bool(obj.ViewObject.Visibility)
    _before[_key(obj)] = _Before(view.getCameraType(), _fields(view), shown)
    obj.ViewObject.Visibility = True
    _look(view, solution.camera, _sides(graph), depth_behind_mm(solution))


def follow(document_name: str, old: Camera, new: Camera) -> None:
    """Keep looking from where the photo was taken, where the 3D view did so until now.

    The world has its frame and its size from the sketch: with another one the eye is elsewhere.
    """
    view = view_3d_of(document_name)
    if view is None or view.getCameraType() != "Perspective":
        return
    node, eye = view.getCameraNode(), old.position_mm
    off = np.array(node.position.getValue().getValue()) - eye
    if float(np.linalg.norm(off)) > SAME_PLACE * max(float(np.linalg.norm(eye)), 1.0):
        return
    before, after = old.rotation_cam_from_world, new.rotation_cam_from_world
    turn = _rotation(after) * _rotation(before).inverted()
    looking = FreeCAD.Rotation(*node.orientation.getValue().getValue())
    node.position.setValue(*map(float, new.position_mm))
    node.orientation.setValue(*(turn * looking).Q)
    slope = math.tan(node.heightAngle.getValue() / 2) * old.focal_px / new.focal_px
    node.heightAngle.setValue(2 * math.atan(slope))
    # What is looked at stays in the middle, and as large.
    grown = float(np.linalg.norm(new.position_mm) / max(float(np.linalg.norm(eye)), 1e-9))
    node.focalDistance.setValue(node.focalDistance.getValue() * grown)


def look_as_before(obj: Any) -> None:
    """Bring back the view that was there before `look_through`."""
    view = view_3d_of(obj.Document.Name)
    if view is None:
        return
    before = _before.pop(_key(obj))
    view.setCameraType(before.camera_type)
    for name, text in before.camera.items():
        view.getCameraNode().getField(name).set(text)
    obj.ViewObject.Visibility = before.photo_shown


def _key(obj: Any) -> tuple[str, str]:
    return (obj.Document.Name, obj.Name)


def _fields(view: Any) -> dict[str, str]:
    """A view's camera."""
    fields = {name: view.getCameraNode().getField(name) for name in _FIELDS}
    return {name: field.get().getString() for name, field in fields.items() if field is not None}


def forget(document_name: str) -> None:
    """A document is gone."""
    for key in [key for key in _before if key[0] == document_name]:
        del _before[key]


def _sides(graph: SketchGraph) -> tuple[float, float]:
    """How far the photo reaches from its principal point, across and down, px."""
    (u, v), photo = graph.principal_point_px, graph.photo
    if photo is None:
        return (abs(u), abs(v))
    return (max(u, photo.width_px - u), max(v, photo.height_px - v))


def _look(view: Any, camera: Camera, sides_px: tuple[float, float], depth_mm: float) -> None:
    """Put the eye where the photo's camera stood, the whole photo in view."""
    view.setCameraType("Perspective")
    node = view.getCameraNode()
    node.position.setValue(*map(float, camera.position_mm))
    node.orientation.setValue(*_rotation(camera.rotation_cam_from_world).Q)
    node.focalDistance.setValue(depth_mm)
    node.heightAngle.setValue(_angle_rad(sides_px, camera.focal_px, view.getSize()))


def _rotation(rotation_cam_from_world: Array) -> Any:
    """A camera's orientation as Coin has it: x to the right, y up, looking along -z."""
    right, down, forward = rotation_cam_from_world
    axes = [FreeCAD.Vector(*map(float, axis)) for axis in (right, -down, -forward)]
    return FreeCAD.Rotation(*axes, "ZXY")


def _angle_rad(sides_px: tuple[float, float], focal_px: float, window_px: tuple[int, int]) -> float:
    """The angle of view that takes in the photo; Coin's is that of the window's shorter side."""
    across, down = (side / focal_px for side in sides_px)
    ratio = window_px[0] / window_px[1]
    slope = max(down, across / ratio) if ratio >= 1 else max(across, down * ratio)
    return 2 * math.atan(slope)
