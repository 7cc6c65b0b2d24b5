"""Paints the lifted shape over the photo, and what it makes evident as ghosts."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from . import style
from .overlay import polygon
from .qt import QtCore, QtGui

if TYPE_CHECKING:
    from .lifted import LiftedView
    from .plane import Point

_Qt = QtCore.Qt


def paint_lift(
    painter: QtGui.QPainter, lifted: LiftedView, on_screen: Callable[[Point], Point]
) -> None:
    """Paint the shape that the sketch stands for: its faces as a breath, its edges fine."""
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    fill = QtGui.QColor(style.LIFTED)
    fill.setAlpha(style.LIFTED_ALPHA)
    painter.setPen(_Qt.NoPen)
    painter.setBrush(fill)
    for loop in lifted.faces:
        painter.drawPolygon(polygon(map(on_screen, loop)))
    whole = [*lifted.edges.values(), *lifted.circles]
    _lines(painter, [[on_screen(p) for p in line] for line in whole], _Qt.SolidLine)
    _lines(painter, [[on_screen(p) for p in line] for line in lifted.copies], _Qt.DashLine)


def _lines(painter: QtGui.QPainter, lines: Iterable[list[Point]], dashes: _Qt.PenStyle) -> None:
    painter.setBrush(_Qt.NoBrush)
    painter.setPen(QtGui.QPen(QtGui.QColor(style.LIFTED_LINE), style.LIFTED_PX, dashes))
    for line in lines:
        painter.drawPolyline(polygon(line))
