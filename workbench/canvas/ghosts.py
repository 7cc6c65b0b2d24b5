"""Suggestions as ghosts over the sketch: where each stands, and how it is painted.

Terms
-----
handle
    The place of a ghost, on the screen, at which it is taken by a click.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ...solver.annotations import Ground, RightAngle
from . import style, symbols
from .evident import Flat, edges_of, still_open
from .overlay import polygon
from .plane import middle
from .qt import QtCore, QtGui

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...solver.graph import SketchGraph
    from .evident import Suggestion
    from .scene import Scene
    from .symbols import Point, Stroke

_Qt = QtCore.Qt
#: A loop that may be flat is drawn again this much smaller.
FLAT_INSET = 0.85


@dataclass(frozen=True, slots=True)
class Ghost:
    """A suggestion on the screen: its strokes, and its handles."""

    suggestion: Suggestion
    strokes: tuple[Stroke, ...]
    handles: tuple[Point, ...]


def _ghost(scene: Scene, suggestion: Suggestion) -> Ghost:
    if isinstance(suggestion, RightAngle):
        ends = [scene.graph.edges[e] for e in suggestion.between]
        others = [w if v == suggestion.at else v for v, w in ends]
        corner = symbols.right_angle(
            *(scene.screen[v] for v in (suggestion.at, *others)), style.GHOST_PX
        )
        return Ghost(suggestion, (corner,), (corner[1],))
    if isinstance(suggestion, Ground):
        feet = [_below(scene.screen[v]) for v in suggestion.vertices]
        hatches = tuple(s for foot in feet for s in symbols.ground(foot, style.GHOST_PX))
        return Ghost(suggestion, hatches, tuple(feet))
    if isinstance(suggestion, Flat):
        return _flat(scene, suggestion)
    lines = [scene.ends(edge) for edge in edges_of(suggestion)]
    size, spacing = 1.6 * style.ARROW_PX, style.MARK_SPACING_PX
    marks = [mark for line in lines for mark in symbols.arrows(*line, 1, size, spacing)]
    return Ghost(suggestion, tuple(marks), tuple(map(_beside, lines)))


def _flat(scene: Scene, suggestion: Flat) -> Ghost:
    """The loop, drawn again a little within itself."""
    corners = [scene.screen[v] for v in suggestion.loop]
    x, y = (sum(along) / len(corners) for along in zip(*corners, strict=True))
    within = [(x + FLAT_INSET * (u - x), y + FLAT_INSET * (v - y)) for u, v in corners]
    return Ghost(suggestion, ((*within, within[0]),), ((x, y),))


def _beside(line: tuple[Point, Point]) -> Point:
    """A place on an edge that is not the marks' own."""
    middle_, (x, y) = middle(line), line[1]
    away = min(0.25, style.GHOST_PX / max(math.dist(*line), 1.0))
    return (middle_[0] + away * (x - line[0][0]), middle_[1] + away * (y - line[0][1]))


def _below(place: Point) -> Point:
    return (place[0], place[1] + style.GHOST_PX)


class Ghosts:
    """The suggestions of a view, and which of them is pointed at."""

    def __init__(self) -> None:
        self._offered: tuple[Suggestion, ...] = ()
        self._painted: list[Ghost] = []
        self.suggestions: tuple[Suggestion, ...] = ()
        self.lit: Suggestion | None = None

    def offer(self, graph: SketchGraph, suggestions: tuple[Suggestion, ...]) -> None:
        """Suggest something else."""
        self._offered = suggestions
        self.follow(graph)

    def follow(self, graph: SketchGraph) -> None:
        """Drop what was said meanwhile, or of what is not there any more."""
        self.suggestions = still_open(graph, self._offered)
        self._painted, self.lit = [], None

    def point_at(self, place: Point | None, others: Sequence[Point] = ()) -> bool:
        """Light the ghost of which a handle is near, and nearer than other places.

        Says whether that has changed anything.
        """
        before, self.lit = self.lit, None
        if place is not None:
            near = ((min(math.dist(h, place) for h in g.handles), g) for g in self._painted)
            distance, ghost = min(near, key=lambda found: found[0], default=(math.inf, None))
            reach = min([style.PLUS_PX + 2, *(math.dist(other, place) for other in others)])
            if ghost is not None and distance <= reach:
                self.lit = ghost.suggestion
        return self.lit != before

    def paint(self, painter: QtGui.QPainter, scene: Scene) -> None:
        """Paint them, the one under the pointer strongly."""
        self._painted = [_ghost(scene, suggestion) for suggestion in self.suggestions]
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        for ghost in self._painted:
            _paint(painter, ghost, is_lit=ghost.suggestion == self.lit)


def _paint(painter: QtGui.QPainter, ghost: Ghost, *, is_lit: bool) -> None:
    casing, ink = QtGui.QColor(style.CASING), QtGui.QColor(style.GHOST)
    casing.setAlpha(style.CASING_ALPHA)
    width = style.EDGE_PX if is_lit else 1.2 * style.SYMBOL_PX
    dashes = _Qt.SolidLine if is_lit else _Qt.DotLine
    painter.setBrush(_Qt.NoBrush)
    for colour, wide, kind in ((casing, width + 2.4, _Qt.SolidLine), (ink, width, dashes)):
        painter.setPen(QtGui.QPen(colour, wide, kind))
        for line in ghost.strokes:
            painter.drawPolyline(polygon(line))
    for handle in ghost.handles:
        _plus(painter, handle, ink)


def _plus(painter: QtGui.QPainter, place: Point, ink: QtGui.QColor) -> None:
    """A small plus: a click adds this."""
    x, y = place
    painter.setPen(QtGui.QPen(QtGui.QColor(style.CASING), 1))
    painter.setBrush(ink)
    painter.drawEllipse(QtCore.QPointF(x, y), style.PLUS_PX, style.PLUS_PX)
    painter.setBrush(_Qt.NoBrush)
    arm = style.PLUS_PX - 2
    painter.drawLine(QtCore.QPointF(x - arm, y), QtCore.QPointF(x + arm, y))
    painter.drawLine(QtCore.QPointF(x, y - arm), QtCore.QPointF(x, y + arm))
