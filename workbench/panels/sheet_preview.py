"""A picture of the sheets with their cut paths, as they will be in the files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..canvas.qt import QtCore, QtGui

if TYPE_CHECKING:
    from ..features.sheet_picture import SheetPicture

#: Colours of the stock and of what is around it; the paths have their preset's.
_STOCK, _AROUND, _BORDER = "#fdfaf3", "#e4e1da", "#b9b2a3"
_FREE_PX = 14
_LINE_PX = 1.4
#: A preset's yellow would vanish on light stock.
_DARKEST_LIGHT = 0.8


class SheetPreview(QtGui.QWidget):
    """Sheets side by side, as large as there is room for.

    Parameters
    ----------
    picture : SheetPicture
    """

    def __init__(self, picture: SheetPicture) -> None:
        super().__init__()
        self._picture = picture
        self.setMinimumSize(420, 260)
        self.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Expanding)

    def sizeHint(self) -> QtCore.QSize:  # noqa: N802  Qt's name
        """Wide enough to tell one path from the next."""
        return QtCore.QSize(720, 420)

    def paintEvent(self, event: QtGui.QPaintEvent) -> None:  # noqa: N802  Qt's name
        """Qt calls this."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.fillRect(self.rect(), QtGui.QColor(_AROUND))
        view = self._view()
        self._paint_stock(painter, view)
        for rgb, points, closed in self._picture.strokes:
            colour = QtGui.QColor(rgb)
            if colour.lightnessF() > _DARKEST_LIGHT:
                colour = colour.darker(170)
            painter.setPen(QtGui.QPen(colour, _LINE_PX))
            painter.setBrush(QtCore.Qt.NoBrush)
            polygon = QtGui.QPolygonF([view.map(QtCore.QPointF(x, y)) for x, y in points])
            if closed:
                painter.drawPolygon(polygon)
            else:
                painter.drawPolyline(polygon)
        painter.end()

    def _paint_stock(self, painter: QtGui.QPainter, view: QtGui.QTransform) -> None:
        painter.setPen(QtGui.QPen(QtGui.QColor(_BORDER), 1))
        painter.setBrush(QtGui.QColor(_STOCK))
        for x, width, height in self._picture.stock:
            painter.drawRect(view.mapRect(QtCore.QRectF(x, 0, width, height)))

    def _view(self) -> QtGui.QTransform:
        """From millimetres, y upwards, to the widget's pixels."""
        stock = self._picture.stock
        width, height = stock[-1][0] + stock[-1][1], max(high for _, _, high in stock)
        room_x, room_y = self.width() - 2 * _FREE_PX, self.height() - 2 * _FREE_PX
        scale = max(min(room_x / width, room_y / height), 1e-6)
        left, top = (self.width() - scale * width) / 2, (self.height() + scale * height) / 2
        return QtGui.QTransform(scale, 0, 0, -scale, left, top)
