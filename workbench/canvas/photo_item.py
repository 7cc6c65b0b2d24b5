"""The photo in the scene, painted from the copy that has just enough px.

Terms
-----
level
    The photo, or a smaller copy of it. Of a large photo the smallest is there first.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .photo_edges import Patch
from .qt import QtCore, QtGui

if TYPE_CHECKING:
    from .plane import Point

_Qt = QtCore.Qt

#: From this zoom on photo pixels are shown as sharp squares, screen px per photo px.
SHARP_FROM = 4.0


class PhotoItem(QtGui.QGraphicsItem):
    """A photo of a size in scene units, whatever the size of its levels."""

    def __init__(self) -> None:
        super().__init__()
        self._levels: list[QtGui.QImage] = []
        self._area = QtCore.QRectF()

    def show_levels(self, levels: list[QtGui.QImage], size_px: tuple[float, float]) -> None:
        """Show a photo of a size; no levels show none."""
        self.prepareGeometryChange()
        self._levels = sorted(levels, key=lambda level: level.width())
        self._area = QtCore.QRectF(0, 0, *size_px) if levels else QtCore.QRectF()
        self.update()

    def add_level(self, level: QtGui.QImage, size_px: tuple[float, float]) -> None:
        """Show a photo in more detail than before."""
        self.show_levels([*self._levels, level], size_px)

    @property
    def levels(self) -> tuple[QtGui.QImage, ...]:
        """What there is of the photo, the smallest first."""
        return tuple(self._levels)

    def grey_around(self, place_px: Point, radius_px: float, zoom: float) -> Patch | None:
        """The photo about a place in grey levels, with one px for each of the screen, or coarser.

        Parameters
        ----------
        place_px : (u, v)
        radius_px : float
            Half of its side.
        zoom : float
            Screen px per photo px.
        """
        if not self._levels:
            return None
        (u, v), side = place_px, 2 * radius_px
        level = self.level_for(zoom)
        across = level.width() / self._area.width()
        area = _scaled(QtCore.QRectF(u - radius_px, v - radius_px, side, side), across, across)
        source = area.toAlignedRect().intersected(level.rect())
        if source.isEmpty():
            return None
        part = level.copy(source)
        shrunk = min(1.0, zoom / across)
        if shrunk < 1.0:
            size = QtCore.QSize(*(max(1, round(shrunk * n)) for n in (part.width(), part.height())))
            part = part.scaled(size, _Qt.IgnoreAspectRatio, _Qt.SmoothTransformation)
        part = part.convertToFormat(QtGui.QImage.Format_Grayscale8)
        rows = np.frombuffer(part.constBits(), dtype=np.uint8).reshape(-1, part.bytesPerLine())
        grey = rows[:, : part.width()].astype(float)
        size_px = source.width() / part.width() / across
        return Patch(grey, (source.x() / across, source.y() / across), size_px)

    def boundingRect(self) -> QtCore.QRectF:  # noqa: N802  Qt's name
        """The photo's area in the scene."""
        return self._area

    def level_for(self, zoom: float) -> QtGui.QImage:
        """The smallest level with a px for each on the screen, else the largest."""
        enough = (x for x in self._levels if x.width() >= zoom * self._area.width())
        return next(enough, self._levels[-1])

    def paint(self, painter: QtGui.QPainter, option: object, widget: object = None) -> None:
        """Paint what is in view."""
        # The device itself may be a whole window, of which the view is a part.
        way, _ = painter.worldTransform().inverted()
        device = painter.device()
        seen = way.mapRect(QtCore.QRectF(0, 0, device.width(), device.height()))
        seen = seen.intersected(self._area)
        if seen.isEmpty() or not self._levels:
            return
        zoom = painter.worldTransform().m11()
        level = self.level_for(zoom * device.devicePixelRatioF())
        across, down = level.width() / self._area.width(), level.height() / self._area.height()
        source = _scaled(seen, across, down)
        # Whole px of the level: parts of them would make the edges of the view swim.
        whole = QtCore.QRectF(source.toAlignedRect().intersected(level.rect()))
        target = _scaled(whole, 1 / across, 1 / down)
        painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform, zoom < SHARP_FROM)
        painter.drawImage(target, level, whole)


def _scaled(area: QtCore.QRectF, across: float, down: float) -> QtCore.QRectF:
    return QtCore.QRectF(
        area.x() * across, area.y() * down, area.width() * across, area.height() * down
    )
