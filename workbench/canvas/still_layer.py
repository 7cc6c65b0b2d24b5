"""What stays where it is while something is dragged, painted once and then shown as a picture.

Hundreds of symbols take longer to paint than all the rest of a frame.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from .overlay import paint_lines
from .qt import QtCore, QtGui
from .scene import Part

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph
    from .plane import Point
    from .scene import Scene

_Qt = QtCore.Qt


class StillLayer:
    """The lines and symbols of a sketch in the hand, in two parts."""

    def __init__(self) -> None:
        self._key: tuple[object, ...] = ()
        self._committed: SketchGraph | None = None
        self._picture = QtGui.QPixmap()

    def paint(
        self,
        painter: QtGui.QPainter,
        scene: Scene,
        committed: SketchGraph,
        corners: tuple[Point, Point],
    ) -> None:
        """Paint what `overlay.paint_lines` does.

        Parameters
        ----------
        painter : QPainter
            In screen px.
        scene : Scene
        committed : SketchGraph
            The sketch as it was when it was taken into the hand.
        corners : two positions
            Where the photo's corner and its first px are on the screen.
        """
        moved = moved_ids(committed, scene.graph)
        ratio = painter.device().devicePixelRatioF()
        key = (moved, scene.findings, corners, painter.window().size(), ratio)
        if self._committed is not committed or key != self._key:
            self._key, self._committed = key, committed
            self._picture = self._painted(scene, moved, painter.window().size(), ratio)
        painter.drawPixmap(0, 0, self._picture)
        paint_lines(painter, replace(scene, part=Part(moved, moves=True)))

    def _painted(
        self, scene: Scene, moved: frozenset[str], size: QtCore.QSize, ratio: float
    ) -> QtGui.QPixmap:
        picture = QtGui.QPixmap(size * ratio)
        picture.setDevicePixelRatio(ratio)
        picture.fill(_Qt.transparent)
        painter = QtGui.QPainter(picture)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        paint_lines(painter, replace(scene, rings=(), part=Part(moved, moves=False)))
        painter.end()
        return picture


def moved_ids(before: SketchGraph, now: SketchGraph) -> frozenset[str]:
    """The vertices and circles that lie elsewhere than before, or were not there."""
    vertices = {v for v, place in now.vertices.items() if before.vertices.get(v) != place}
    return frozenset(vertices | {c for c, d in now.circles.items() if before.circles.get(c) != d})
