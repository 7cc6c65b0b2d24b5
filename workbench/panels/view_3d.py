"""The 3D view, looking at the model from where the photo was taken."""

from __future__ import annotations

import math
from typing import Any

import FreeCAD
import FreeCADGui

from ..features.lifted_model import solution_of

#: Room around the object.
MARGIN = 1.15


def look_from_the_camera(lifted_model: Any) -> None:
    """Put the eye of the document's 3D view where the photo's camera stood, looking at the object.

    The object then has the perspective that it has in the photo; the angle of view is narrowed
    until the object fills the view.
    """
    views = FreeCADGui.getDocument(lifted_model.Document.Name).mdiViewsOfType("Gui::View3DInventor")
    camera = solution_of(lifted_model).camera
    if not views or camera is None:
        return
    box = lifted_model.Shape.BoundBox
    eye = FreeCAD.Vector(*(float(x) for x in camera.position_mm))
    if box.isInside(eye):
        return
    turn = _turn(eye - box.Center)
    views[0].setCameraType("Perspective")
    node = views[0].getCameraNode()
    node.position.setValue(eye.x, eye.y, eye.z)
    node.orientation.setValue(*turn.Q)
    node.focalDistance.setValue((eye - box.Center).Length)
    node.heightAngle.setValue(_height_angle_rad(eye, turn, box))


def _turn(back: Any) -> Any:
    """The rotation of a camera that stands upright; `back` points from its target to its eye."""
    up = FreeCAD.Vector(0, 0, 1)
    right = up.cross(back)
    if right.Length < 1e-6:  # straight from above
        right = FreeCAD.Vector(1, 0, 0)
    return FreeCAD.Rotation(right, up, back, "ZXY")


def _height_angle_rad(eye: Any, turn: Any, box: Any) -> float:
    """The angle of view, up and down, that just takes in a box."""
    seen = [turn.inverted().multVec(box.getPoint(k) - eye) for k in range(8)]
    slopes = [max(abs(p.x), abs(p.y)) / -p.z for p in seen if p.z < 0]
    return 2 * math.atan(MARGIN * max(slopes, default=1.0))
