"""The lens's distortion of one tab's photo: noticed, and taken out."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import host
from ..canvas.photo import PhotoError
from ..canvas.qt import QtCore
from ..features import pipeline
from ..features.known_rectangle import marker_text, rectangle_of
from ..problems import known_problems
from ..wording import in_language
from .aside import Aside
from .photo_pixels import colour_photo, grey_photo, save_colours

if TYPE_CHECKING:
    from ...solver.graph import Photo, SketchGraph
    from ..canvas.view import SketchView
    from ..lens import Lens, PlumbLine

#: Lines are looked at in the photo once the hand has rested so long.
REST_MS = 800


class LensWatch:
    """Says so where lines on straight things bend.

    Parameters
    ----------
    obj : FreeCAD document object
        The photo sketch.
    view : SketchView
    told : callable
        Called where `words` are new.
    """

    def __init__(self, obj: Any, view: SketchView, told: Callable[[], None]) -> None:
        self._obj, self._view, self._told = obj, view, told
        self._seen: tuple[object, ...] = ()
        #: A sentence, or nothing.
        self.words = ""
        self._aside = Aside(view)
        self._timer = QtCore.QTimer(view)
        self._timer.setSingleShot(True)
        self._timer.setInterval(REST_MS)
        self._timer.timeout.connect(self.look)
        view.graph_shown.connect(self._look_soon)
        self._look_soon(view.graph)

    def _look_soon(self, graph: SketchGraph) -> None:
        if graph.photo is not None and (graph.edges or graph.circles or self.words):
            self._timer.start()

    def look(self) -> None:
        """Look at the lines in the photo now."""
        graph = self._view.graph
        traced = [graph.edges.get(e, ()) for e in graph.construction]
        seen = (self._obj.Photo, tuple(graph.vertices.get(v) for ends in traced for v in ends))
        if self._view.is_in_hand or seen == self._seen:
            return
        self._seen = seen
        # A large photo takes seconds to read.
        path, marker = self._obj.Photo, self._obj.Marker
        self._aside.begin(lambda: _lens_if_known(path, marker, graph), self._say)

    def _say(self, lens: Lens | None) -> None:
        before, self.words = self.words, ""
        if lens is not None:
            self.words = " ".join(map(in_language, lens.notes))
        if self.words != before:
            self._told()


def lens_of_object(obj: Any, graph: SketchGraph) -> Lens | None:
    """The lens of a photo sketch, by its traced lines, the sides of what tells its camera, and the
    photo's own long edges.

    Raises
    ------
    StoppedError
        Where a person did not wait for it.
    """
    path, marker = obj.Photo, obj.Marker
    words = host.translate("InContext", "Looking at the straight lines in the photo ...")
    # Packed, for there may be none.
    return pipeline.in_sight(words, lambda: (_lens_of(path, marker, graph),))[0]


def _lens_if_known(path: str, marker: str, graph: SketchGraph) -> Lens | None:
    try:
        return _lens_of(path, marker, graph)
    except (OSError, PhotoError, *known_problems()):
        # Of the photo itself something is said where it is shown.
        return None


def _lens_of(path: str, marker: str, graph: SketchGraph) -> Lens | None:
    from ..lens import lens_of, traced_ends

    grey = None if graph.photo is None else grey_photo(path, graph.photo)
    if graph.photo is None or grey is None:
        return None
    lines = traced_ends(graph)
    told = rectangle_of(marker)
    if told is not None:
        corners = np.array(told[0])
        lines |= {f"{k + 1}": (corners[k], corners[(k + 1) % 4]) for k in range(4)}
    edges = _edges(path, Path(path).stat().st_mtime_ns, graph.photo)
    return lens_of(grey, lines, np.array(graph.principal_point_px), edges)


@lru_cache(maxsize=2)
def _edges(path: str, changed_ns: int, photo: Photo) -> tuple[PlumbLine, ...]:
    """The photo's own long edges: however the sketch changes, they are the same."""
    from ..lens import edges_of

    grey = grey_photo(path, photo)
    middle = photo.principal_point_px
    return () if grey is None else edges_of(grey, None if middle is None else np.array(middle))


def straighten(obj: Any, lens: Lens) -> None:
    """Put the straightened photo under a sketch, as one step to undo; the sketch moves with it.

    Raises
    ------
    StoppedError
        Where a person did not wait for it.
    """
    from ...solver.serialise import sketch_to_text

    graph, photo, marker = pipeline.graph_of(obj.Sketch), obj.Photo, obj.Marker
    assert graph.photo is not None
    with tempfile.TemporaryDirectory(prefix="incontext-") as folder:
        path = Path(folder, f"{Path(graph.photo.file or 'photo').stem}-straight.jpg")
        words = host.translate("InContext", "Straightening the photo ...")
        moved, marker = pipeline.in_sight(words, _straightened, graph, photo, marker, lens, path)
        with host.transaction(obj.Document, host.translate("InContext", "Straighten photo")):
            obj.Photo = str(path)
            obj.Marker = marker
            obj.Sketch = sketch_to_text(moved)
            obj.Document.recompute()


def _straightened(
    graph: SketchGraph, photo: str, marker: str, lens: Lens, path: Path
) -> tuple[SketchGraph, str]:
    """Write the straight photo; the sketch over it, and what tells its camera."""
    from ..straight_photo import straight_picture, straightened_sketch

    assert graph.photo is not None
    save_colours(straight_picture(colour_photo(photo, graph.photo), lens), str(path))
    return _with_camera(marker, straightened_sketch(graph, lens, path.name), lens, path)


def _with_camera(
    marker: str, graph: SketchGraph, lens: Lens, path: Path
) -> tuple[SketchGraph, str]:
    """The sketch with the camera that the rectangle tells in the straight photo."""
    from ..marker_finding import camera_of_corners, seen_corners

    told = rectangle_of(marker)
    if told is None or graph.photo is None:
        return graph, ""
    corners = lens.straightened(np.array(told[0]))
    seen = seen_corners(graph.photo, grey_photo(str(path), graph.photo), corners)
    view = camera_of_corners(graph.photo, seen, told[1]).view
    return replace(graph, camera=view.camera), marker_text(view.corners_px.tolist(), told[1])
