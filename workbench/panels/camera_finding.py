"""From a rectangle that was clicked in the photo, or the printed marker, to the known camera."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from .. import host
from ..canvas.photo import PhotoError
from ..canvas.qt import QtCore
from ..canvas.questions import KnownRectangle
from ..features import pipeline
from ..features.known_rectangle import marker_text, rectangle_of, set_camera
from ..problems import in_words, known_problems
from .messages import tell
from .photo_pixels import grey_photo

if TYPE_CHECKING:
    from ...solver.graph import Photo
    from ..canvas.view import SketchView
    from ..marker_finding import Found, SeenCorners


class CameraFinding:
    """Serves the camera tool of one tab.

    Parameters
    ----------
    obj : FreeCAD document object
        The photo sketch.
    view : SketchView
    """

    def __init__(self, obj: Any, view: SketchView) -> None:
        self._obj = obj
        self._view = view
        view.rectangle_told.connect(self._take)
        self.show()

    def show(self) -> None:
        """Show the tool what the document knows."""
        told = rectangle_of(self._obj.Marker)
        self._view.set_rectangle(None if told is None else KnownRectangle(*told))

    def _take(self, told: KnownRectangle | None) -> None:
        # Not within the mouse's own event: a window that waits must not stand in its way.
        QtCore.QTimer.singleShot(0, lambda: self._find(told))

    def _find(self, told: KnownRectangle | None) -> None:
        graph = pipeline.graph_of(self._obj.Sketch)
        if told is not None and not told.corners_px:
            set_camera(self._obj, replace(graph, camera=None), "")
            return
        if graph.photo is None:
            tell(host.translate("InContext", "There is no photo: choose one first."))
            return
        try:
            seen = self._seen(graph.photo, told)
            if seen is not None:
                self._settle(graph.photo, seen, told)
        except (PhotoError, *known_problems()) as error:
            tell(in_words(error))

    def _seen(self, photo: Photo, told: KnownRectangle | None) -> SeenCorners | None:
        """The corners in the photo; None where a person wanted no OpenCV, or did not wait."""
        from ..marker_finding import seen_corners
        from .installing import offer_to_install

        corners, path = None if told is None else told.corners_px, self._obj.Photo
        words = host.translate("InContext", "Looking for the corners in the photo ...")

        def look(stop: host.Stop, progress: host.Progress) -> SeenCorners:
            return seen_corners(photo, grey_photo(path, photo), corners)

        try:
            return host.work(words, look)
        except ModuleNotFoundError as error:
            missing = error
        return host.work(words, look) if offer_to_install(missing) else None

    def _settle(self, photo: Photo, seen: SeenCorners, told: KnownRectangle | None) -> None:
        """Write the camera; where the size is not known, ask for it first."""
        from ..marker_finding import camera_of_corners
        from .rectangle_dialog import RectangleDialog

        if told is not None and told.size_mm is not None:
            self._write(camera_of_corners(photo, seen, told.size_mm), told.size_mm)
            return
        dialog = RectangleDialog(photo, seen, self._view)
        dialog.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        dialog.finished.connect(lambda _: self.show())
        dialog.accepted.connect(lambda: self._write(dialog.found, dialog.size_mm))
        dialog.open()

    def _write(self, found: Found, size_mm: tuple[float, float]) -> None:
        """Write the camera and what told it, and show the ground.

        What is drawn already has its say: a small rectangle alone tells the focal length badly.
        """
        from ...solver.perspective.refining import refined_camera

        graph = pipeline.graph_of(self._obj.Sketch)
        words = host.translate("InContext", "Finding the camera ...")
        refined = host.work(words, lambda stop, progress: refined_camera(graph, found.view))
        graph = replace(graph, camera=refined or found.view.camera)
        set_camera(self._obj, graph, marker_text(found.view.corners_px.tolist(), size_mm))
        if not self._view.attraction.grid_shown:
            self._view.toggle_grid()
