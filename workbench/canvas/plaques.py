"""Paints what is said in words and numbers: on plaques, and beside vertices."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import style, symbols
from .plane import middle
from .qt import QtCore, QtGui

if TYPE_CHECKING:
    from .scene import Scene
    from .symbols import Point

_Qt = QtCore.Qt


def paint_plaques(painter: QtGui.QPainter, scene: Scene) -> None:
    """Paint a plaque for each size that is said."""
    marks = scene.marks
    if not (marks.lengths or marks.diameters or marks.thicknesses):
        return
    font = painter.font()
    font.setPixelSize(style.TEXT_PX)
    font.setBold(True)
    painter.setFont(font)
    centre = middle([*scene.screen.values(), *(p for c in scene.circles.values() for p in c)])
    for edge, text in marks.lengths.items():
        room = _room(painter, text)
        place = symbols.beside(*scene.ends(edge), centre, room, style.PLAQUE_DISTANCE_PX)
        _plaque(painter, text, place)
    for circle, text in marks.diameters.items():
        line = scene.circles[circle]
        lowest = max(line, key=lambda p: p[1])
        below = style.PLAQUE_DISTANCE_PX + _room(painter, text)[1] / 2
        _plaque(painter, text, (lowest[0], lowest[1] + below))
    for face, text in marks.thicknesses.items():
        outline = scene.outline((scene.graph.faces or {})[face].loop)
        if outline:
            _plaque(painter, text, middle(outline))


def paint_numbers(painter: QtGui.QPainter, scene: Scene) -> None:
    """Paint beside each vertex how many parameters it has; those with none are pale."""
    if not scene.numbers:
        return
    font = painter.font()
    font.setPixelSize(style.TEXT_PX)
    font.setBold(True)
    painter.setFont(font)
    side = style.TEXT_PX + 4
    for vertex, number in scene.numbers.items():
        if vertex not in scene.screen:
            continue
        x, y = scene.screen[vertex]
        badge = QtCore.QRectF(x + style.BADGE_PX, y - style.BADGE_PX - side, side, side)
        painter.setPen(QtGui.QPen(QtGui.QColor(style.CASING), 1.5))
        painter.setBrush(QtGui.QColor(style.NUMBER if number else style.NO_NUMBER))
        painter.drawEllipse(badge)
        painter.drawText(badge, _Qt.AlignCenter, str(number))


def paint_words(
    painter: QtGui.QPainter,
    words: str,
    place: Point,
    margin: Point = (4, 1),
    *,
    above: bool = False,
) -> None:
    """Paint a line of words on a pale plaque, its upper left corner at a place on the screen.

    Parameters
    ----------
    painter : QPainter
    words : str
    place : (x, y)
    margin : (x, y)
        Around the words, px.
    above : bool
        Whether the place is the plaque's lower left corner.
    """
    font = painter.font()
    font.setPixelSize(style.TEXT_PX)
    font.setBold(False)
    painter.setFont(font)
    size = painter.fontMetrics().size(0, words)
    wide, high = size.width() + 2 * margin[0], size.height() + 2 * margin[1]
    plaque = QtCore.QRectF(place[0], place[1] - (high if above else 0), wide, high)
    fill = QtGui.QColor(style.CASING)
    fill.setAlpha(style.CASING_ALPHA)
    painter.setPen(_Qt.NoPen)
    painter.setBrush(fill)
    painter.drawRoundedRect(plaque, 3, 3)
    painter.setPen(QtGui.QColor(style.TEXT))
    painter.drawText(plaque, _Qt.AlignCenter, words)


def _room(painter: QtGui.QPainter, text: str) -> Point:
    size = painter.fontMetrics().size(0, text)
    return (size.width() + 10, size.height() + 4)


def _plaque(painter: QtGui.QPainter, text: str, place: Point) -> None:
    plaque = QtCore.QRectF(0, 0, *_room(painter, text))
    plaque.moveCenter(QtCore.QPointF(*place))
    painter.setPen(QtGui.QPen(QtGui.QColor(style.ANNOTATION), 1))
    painter.setBrush(QtGui.QColor(style.CASING))
    painter.drawRoundedRect(plaque, 3, 3)
    painter.drawText(plaque, _Qt.AlignCenter, text)
