"""Paints the grid on the ground, in screen px."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from . import style
from .plaques import paint_words
from .qt import QtCore, QtGui

if TYPE_CHECKING:
    from .ground_grid import GroundGrid
    from .plane import Point


def paint_grid(
    painter: QtGui.QPainter, grid: GroundGrid, on_screen: Callable[[Point], Point]
) -> None:
    """Paint fine and strong lines, light over dark, so that they read on any photo."""
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    fine, strong = (
        [QtCore.QLineF(*on_screen(p), *on_screen(q)) for p, q in lines] for lines in grid.lines_px
    )
    for lines, alpha in ((fine, style.GRID_ALPHA), (strong, style.GRID_STRONG_ALPHA)):
        for colour, wide in ((style.GRID_CASING, 2.2), (style.GRID, 1.0)):
            ink = QtGui.QColor(colour)
            ink.setAlpha(alpha // 2 if wide > 1 else alpha)
            painter.setPen(QtGui.QPen(ink, wide))
            painter.drawLines(lines)


def paint_note(painter: QtGui.QPainter, area: QtCore.QRect, words: str) -> None:
    """Say something about the grid in the lower left corner."""
    paint_words(painter, words, (8, area.height() - 8), (6, 2), above=True)
