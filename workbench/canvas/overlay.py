"""Paints the sketch over the photo, in screen px: lines and symbols keep their size at any zoom."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from ...solver.annotations import targets_of
from . import style, symbols
from .plane import middle
from .plaques import paint_numbers, paint_plaques
from .qt import QtCore, QtGui
from .said import arrows_on, ground_below, ticks_on
from .symmetry import outline_of

if TYPE_CHECKING:
    from .scene import Scene
    from .symbols import Point, Stroke

_Qt = QtCore.Qt


def paint(painter: QtGui.QPainter, scene: Scene, lines: Callable[[], None] | None = None) -> None:
    """Paint everything, from the back to the front; `lines` does what `paint_lines` does else."""
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    _paint_left_out(painter, scene)
    _paint_conflicts(painter, scene)
    if lines is None:
        paint_lines(painter, scene)
    else:
        lines()
    paint_plaques(painter, scene)
    paint_numbers(painter, scene)


def paint_lines(painter: QtGui.QPainter, scene: Scene) -> None:
    """Paint edges, vertices and the symbols on them."""
    # Below the edges, whose ends they would cover else.
    _paint_right_angles(painter, scene)
    _paint_ground(painter, scene)
    fine(painter, scene.rings, style.EDGE)
    _paint_edges(painter, scene)
    _paint_marks(painter, scene)
    _paint_symmetry_planes(painter, scene)
    _paint_vertices(painter, scene)
    _paint_touching(painter, scene)


def _paint_left_out(painter: QtGui.QPainter, scene: Scene) -> None:
    """Faces left out are pale and hatched, their holes not."""
    pale = QtGui.QColor(style.CASING)
    pale.setAlpha(style.PALE_ALPHA)
    colour = QtGui.QColor(style.LEFT_OUT)
    colour.setAlpha(style.LEFT_OUT_ALPHA)
    for face in (scene.graph.faces or {}).values():
        if face.included:
            continue
        # Where loops overlap, the hole is: odd and even, Qt's way if not told otherwise.
        path = QtGui.QPainterPath()
        for loop in face.loops:
            path.addPolygon(polygon(scene.outline(loop)))
            path.closeSubpath()
        painter.save()
        painter.fillPath(path, pale)
        painter.setClipPath(path)
        painter.setPen(QtGui.QPen(colour, style.FINE_PX))
        _hatch(painter, path.boundingRect().intersected(QtCore.QRectF(painter.window())))
        painter.restore()


def _hatch(painter: QtGui.QPainter, area: QtCore.QRectF) -> None:
    """Slanted lines over an area of the screen."""
    first = math.ceil((area.left() + area.top()) / style.HATCH_PX)
    last = math.floor((area.right() + area.bottom()) / style.HATCH_PX)
    for k in range(first, last + 1):
        sum_ = k * style.HATCH_PX
        low = QtCore.QPointF(sum_ - area.bottom(), area.bottom())
        painter.drawLine(low, QtCore.QPointF(sum_ - area.top(), area.top()))


def _paint_edges(painter: QtGui.QPainter, scene: Scene) -> None:
    helping = set(scene.graph.construction)
    edges = [e for e in scene.graph.edges if scene.shows_edge(e)]
    circles = {c: line for c, line in scene.circles.items() if scene.shows(c)}
    traced: list[Stroke] = [scene.ends(e) for e in edges if e in helping]
    drawn: list[Stroke] = [scene.ends(e) for e in edges if e not in helping]
    traced += [stroke for c, stroke in circles.items() if c in helping]
    drawn += [stroke for c, stroke in circles.items() if c not in helping]
    stroke(painter, traced, style.CONSTRUCTION, style.CONSTRUCTION_PX, dashed=True)
    stroke(painter, drawn, style.EDGE, style.EDGE_PX)


def _paint_conflicts(painter: QtGui.QPainter, scene: Scene) -> None:
    """A red halo behind every edge of which annotations say what cannot be."""
    named = [scene.graph.annotations.get(id_) for id_ in scene.findings.conflicts]
    edges = {e for a in named if a is not None for e in targets_of(a).get("edge", ())}
    halo = QtGui.QColor(style.CONFLICT)
    halo.setAlpha(style.CONFLICT_ALPHA)
    pen = QtGui.QPen(halo, style.CONFLICT_PX)
    pen.setCapStyle(_Qt.FlatCap)
    painter.setPen(pen)
    for edge in edges & set(scene.graph.edges):
        painter.drawPolyline(polygon(scene.ends(edge)))


def _paint_right_angles(painter: QtGui.QPainter, scene: Scene) -> None:
    marked: dict[bool, list[Stroke]] = {False: [], True: []}
    for id_, vertices in scene.marks.right_angles.items():
        if not scene.shows(*vertices):
            continue
        points = [scene.screen[v] for v in vertices]
        bad = id_ in scene.findings.conflicts
        marked[bad].append(symbols.right_angle(*points, style.RIGHT_ANGLE_PX))
    stroke(painter, marked[False], style.ANNOTATION, style.SYMBOL_PX)
    stroke(painter, marked[True], style.CONFLICT, 3 * style.SYMBOL_PX)


def _paint_marks(painter: QtGui.QPainter, scene: Scene) -> None:
    """Ticks and arrows: each group its number of them, and its colour."""
    strokes: dict[str, list[Stroke]] = {}
    for edge, count in scene.marks.equal_lengths.items():
        if scene.shows_edge(edge):
            strokes.setdefault(_group_colour(count), []).extend(ticks_on(scene.places, edge))
    for edge, count in scene.marks.parallels.items():
        if scene.shows_edge(edge):
            strokes.setdefault(_group_colour(count), []).extend(arrows_on(scene.places, edge))
    for colour, lines in strokes.items():
        stroke(painter, lines, colour, style.SYMBOL_PX)


def _group_colour(number: int) -> str:
    return style.GROUPS[(number - 1) % len(style.GROUPS)]


def _paint_symmetry_planes(painter: QtGui.QPainter, scene: Scene) -> None:
    """A dotted line around the middles of the edges that a plane halves, a diamond on each."""
    for edges in scene.marks.symmetry_planes:
        if not scene.shows(*(v for e in edges for v in scene.graph.edges[e])):
            continue
        middles = [middle(scene.ends(e)) for e in edges]
        fine(painter, [outline_of(middles)], style.SYMMETRY)
        diamonds = [symbols.diamond(place, style.DIAMOND_PX) for place in middles]
        stroke(painter, diamonds, style.SYMMETRY, style.SYMBOL_PX)


def _paint_ground(painter: QtGui.QPainter, scene: Scene) -> None:
    there = [v for v in scene.marks.ground if v in scene.screen and scene.shows(v)]
    strokes = [s for v in there for s in ground_below(scene.places, v)]
    stroke(painter, strokes, style.GROUND, style.SYMBOL_PX)


def _paint_touching(painter: QtGui.QPainter, scene: Scene) -> None:
    """A ring around vertices that touch a face."""
    radius = style.TOUCHING_PX
    places = [scene.screen[v] for v in scene.marks.on_face if scene.shows(v)]
    rings = [
        symbols.ellipse(((x - radius, y), (x + radius, y)), ((x, y - radius), (x, y + radius)))
        for x, y in places
    ]
    stroke(painter, rings, style.ANNOTATION, style.SYMBOL_PX)


def _paint_vertices(painter: QtGui.QPainter, scene: Scene) -> None:
    """Discs; green ones stand on the ground, orange squares are not held by anything yet."""
    radius = style.VERTEX_RADIUS_PX
    for vertex, (x, y) in scene.screen.items():
        if not scene.shows(vertex):
            continue
        on_ground = vertex in scene.marks.ground
        painter.setPen(QtGui.QPen(QtGui.QColor(style.CASING if on_ground else style.EDGE), 1.5))
        painter.setBrush(QtGui.QColor(style.GROUND if on_ground else style.VERTEX))
        if vertex in scene.findings.loose:
            painter.setBrush(QtGui.QColor(style.LOOSE))
            side = 2.6 * radius
            painter.drawRect(QtCore.QRectF(x - side / 2, y - side / 2, side, side))
        else:
            painter.drawEllipse(QtCore.QPointF(x, y), radius, radius)


def stroke(
    painter: QtGui.QPainter,
    strokes: Iterable[Stroke],
    colour: str,
    width_px: float,
    *,
    dashed: bool = False,
    casing_px: float = style.CASING_PX,
) -> None:
    """Lines with a white casing: all casings first, so that none cuts through a line."""
    # Not as one path, which Qt takes four times as long to paint.
    lines = [polygon(stroke) for stroke in strokes]
    casing = QtGui.QColor(style.CASING)
    casing.setAlpha(style.CASING_ALPHA)
    outer = QtGui.QPen(casing, width_px + 2 * casing_px)
    inner = QtGui.QPen(QtGui.QColor(colour), width_px)
    if dashed:
        inner.setDashPattern([4, 3])
    painter.setBrush(_Qt.NoBrush)
    for pen in (outer, inner):
        pen.setCapStyle(_Qt.FlatCap if dashed and pen is inner else _Qt.RoundCap)
        pen.setJoinStyle(_Qt.RoundJoin)
        painter.setPen(pen)
        for line in lines:
            painter.drawPolyline(line)


def fine(painter: QtGui.QPainter, strokes: Iterable[Stroke], colour: str) -> None:
    """Fine dashed lines that explain, no part of the drawing; white shows between the dashes."""
    stroke(painter, strokes, colour, style.FINE_PX, dashed=True, casing_px=0.0)


def polygon(points: Iterable[Point]) -> QtGui.QPolygonF:
    """Points as Qt takes them."""
    return QtGui.QPolygonF([QtCore.QPointF(x, y) for x, y in points])
