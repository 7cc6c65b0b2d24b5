"""The photo in the 3D view: on the plane of its sketch, just behind the lifted object."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..canvas.lifted import ring_mm
from ..canvas.qt import QtCore, QtGui

if TYPE_CHECKING:
    from ...solver.camera import Camera
    from ...solver.graph import SketchGraph
    from ...solver.solution import Solution

#: Longer side of the photo as the graphics card gets it, px.
TEXTURE_PX = 2048
#: How far behind the object's farthest vertex the photo stands.
BEHIND = 1.02


def corners_mm(camera: Camera, size_px: tuple[float, float], depth_mm: float) -> np.ndarray:
    """Where the photo's corners stand in the world, at a depth before the camera.

    Returns
    -------
    (4, 3) array
        Bottom left, bottom right, top right, top left as seen.
    """
    width, height = size_px
    px = np.array([(0, height), (width, height), (width, 0), (0, 0)], dtype=float)
    rays = np.hstack([(px - camera.principal_point_px) / camera.focal_px, np.ones((4, 1))])
    return camera.position_mm + depth_mm * rays @ camera.rotation_cam_from_world


def depth_behind_mm(solution: Solution) -> float:
    """The depth at which everything of a solution lies before the photo."""
    camera = solution.camera
    rings = [point for circle in solution.circles.values() for point in ring_mm(circle)]
    points = np.array([*solution.vertices_mm.values(), *rings])
    in_cam = points @ camera.rotation_cam_from_world.T + camera.translation_cam_from_world_mm
    return BEHIND * float(in_cam[:, 2].max())


class PhotoPlane:
    """The photo of one sketch in the 3D view.

    Parameters
    ----------
    obj : FreeCAD document object
        A photo sketch.
    """

    def __init__(self, obj: Any) -> None:
        from pivy import coin

        self._obj = obj
        self._places = coin.SoCoordinate3()
        self._billboard: Any = None

    def take_photo(self, image: QtGui.QImage | None) -> None:
        """Show another photo from now on; None shows none."""
        self._billboard = None if image is None else _billboard(_texture(image), self._places)

    def stand(self, graph: SketchGraph, solution: Solution | None) -> None:
        """Put the photo where a solution has it; nothing where there is none."""
        root = getattr(self._obj.ViewObject.Proxy, "photo_root", None)
        if root is None:
            return
        root.removeAllChildren()
        if self._billboard is None or graph.photo is None or solution is None:
            return
        if solution.camera is None or not (solution.vertices_mm or solution.circles):
            return
        size_px = (graph.photo.width_px, graph.photo.height_px)
        corners = corners_mm(solution.camera, size_px, depth_behind_mm(solution))
        if np.isfinite(corners).all():
            self._places.point.setValues(0, 4, corners.tolist())
            root.addChild(self._billboard)


def _billboard(texture: Any, places: Any) -> Any:
    from pivy import coin

    # A group of FreeCAD's own: "fit all" is about the object, not about the photo behind it.
    group = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    pick, light, colour = coin.SoPickStyle(), coin.SoLightModel(), coin.SoBaseColor()
    pick.style = coin.SoPickStyle.UNPICKABLE
    light.model = coin.SoLightModel.BASE_COLOR
    colour.rgb = (1, 1, 1)
    where, face = coin.SoTextureCoordinate2(), coin.SoFaceSet()
    where.point.setValues(0, 4, [(0, 0), (1, 0), (1, 1), (0, 1)])
    face.numVertices.setValue(4)
    for node in (pick, light, colour, texture, where, places, face):
        group.addChild(node)
    # Python keeps alive what it has made itself; what `createInstance` gives dies with its parent.
    holder = coin.SoSeparator()
    holder.addChild(group)
    return holder


def _texture(image: QtGui.QImage) -> Any:
    from pivy import coin

    if max(image.width(), image.height()) > TEXTURE_PX:
        smooth = QtCore.Qt.SmoothTransformation
        image = image.scaled(TEXTURE_PX, TEXTURE_PX, QtCore.Qt.KeepAspectRatio, smooth)
    image = image.convertToFormat(QtGui.QImage.Format_RGB888)
    width, height, line = image.width(), image.height(), image.bytesPerLine()
    rows = np.frombuffer(image.constBits(), dtype=np.uint8)[: height * line].reshape(height, line)
    texture = coin.SoTexture2()
    # Coin counts rows from below.
    upwards = rows[::-1, : 3 * width]
    texture.image.setValue(coin.SbVec2s(width, height), 3, upwards.tobytes())
    return texture
