"""Paints what a tool shows besides the graph: lit and selected parts, rubber bands, snaps."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from . import style, symbols
from .overlay import fine, polygon, stroke
from .plane import middle
from .plaques import paint_words
from .qt import QtCore, QtGui
from .said import symbol_of
from .scene import Scene
from .snapping import Snap, SnapKind

if TYPE_CHECKING:
    from .preview import Preview
    from .selection import Selection
    from .symbols import Point

_Qt = QtCore.Qt


@dataclass(frozen=True, slots=True)
class Work:
    """What is at work: a tool's preview, the selection, and the way from photo to screen.

    `in_words` puts a word into the person's language.
    """

    preview: Preview
    selection: Selection
    on_screen: Callable[[Point], Point]
    in_words: Callable[[str], str] = str


def paint_below(painter: QtGui.QPainter, scene: Scene, work: Work) -> None:
    """Paint halos behind edges and circles that are lit or selected, and faces that are lit."""
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    _areas(painter, [[work.on_screen(p) for p in area] for area in work.preview.areas])
    for chosen, colour in ((work.preview.lit, style.HOVER), (work.selection, style.SELECTED)):
        _halos(painter, scene, chosen.with_targets(scene.graph), colour)
        _symbol_halos(painter, scene, chosen.annotations, colour)


def _areas(painter: QtGui.QPainter, areas: list[list[Point]]) -> None:
    """Faces filled, with a dot in their middle: there is the place to point at."""
    fill = QtGui.QColor(style.HOVER)
    fill.setAlpha(style.AREA_ALPHA)
    for area in areas:
        painter.setPen(_Qt.NoPen)
        painter.setBrush(fill)
        painter.drawPolygon(polygon(area))
        painter.setBrush(QtGui.QColor(style.HOVER_LINE))
        painter.drawEllipse(QtCore.QPointF(*middle(area)), style.DOT_PX, style.DOT_PX)


def _halos(painter: QtGui.QPainter, scene: Scene, chosen: Selection, colour: str) -> None:
    pen = QtGui.QPen(QtGui.QColor(colour), style.HALO_PX)
    pen.setCapStyle(_Qt.RoundCap)
    painter.setPen(pen)
    painter.setBrush(_Qt.NoBrush)
    for edge in chosen.edges & set(scene.graph.edges):
        painter.drawPolyline(polygon(scene.ends(edge)))
    for circle in chosen.circles & set(scene.circles):
        painter.drawPolyline(polygon(scene.circles[circle]))


def _symbol_halos(
    painter: QtGui.QPainter, scene: Scene, annotations: frozenset[str], colour: str
) -> None:
    """Bands behind the symbols of annotations."""
    pen = QtGui.QPen(QtGui.QColor(colour), style.SYMBOL_HALO_PX)
    pen.setCapStyle(_Qt.RoundCap)
    pen.setJoinStyle(_Qt.RoundJoin)
    painter.setPen(pen)
    places = scene.places
    for id_ in annotations & set(scene.graph.annotations):
        symbol = symbol_of(places, id_)
        painter.setBrush(_Qt.NoBrush)
        for line in symbol.lines:
            painter.drawPolyline(polygon(line))
        painter.setBrush(QtGui.QColor(colour))
        for area in symbol.areas:
            painter.drawPolygon(polygon(area))


def paint_above(painter: QtGui.QPainter, scene: Scene, work: Work) -> None:
    """Paint all the rest."""
    chosen = work.selection.with_targets(scene.graph)
    _vertices(painter, scene, chosen.vertices, style.SELECTED)
    lit = work.preview.lit.with_targets(scene.graph)
    _vertices(painter, scene, lit.vertices, style.HOVER)
    guides = [tuple(map(work.on_screen, line)) for line in work.preview.guides]
    fine(painter, guides, style.GUIDE)
    bands = [[work.on_screen(p) for p in line] for line in work.preview.strokes]
    stroke(painter, bands, style.EDGE, style.EDGE_PX, dashed=True)
    _corners(painter, scene, work.preview)
    if work.preview.box is not None:
        _box(painter, [work.on_screen(p) for p in work.preview.box])
    _grips(painter, [work.on_screen(p) for p in work.preview.grips])
    if work.preview.snap is not None:
        _snap(painter, work.preview.snap, work)


def _vertices(painter: QtGui.QPainter, scene: Scene, vertices: frozenset[str], colour: str) -> None:
    painter.setPen(QtGui.QPen(QtGui.QColor(style.EDGE), 1.5))
    painter.setBrush(QtGui.QColor(colour))
    for vertex in vertices & set(scene.screen):
        centre = QtCore.QPointF(*scene.screen[vertex])
        painter.drawEllipse(centre, style.HOVER_RADIUS_PX, style.HOVER_RADIUS_PX)


def _corners(painter: QtGui.QPainter, scene: Scene, preview: Preview) -> None:
    # What was deleted meanwhile has no place.
    there = [corner for corner in preview.corners if set(corner) <= set(scene.screen)]
    points = [[scene.screen[v] for v in corner] for corner in there]
    squares = [symbols.right_angle(*three, 1.3 * style.RIGHT_ANGLE_PX) for three in points]
    stroke(painter, squares, style.HOVER_LINE, 2 * style.SYMBOL_PX)


def _box(painter: QtGui.QPainter, corners: list[Point]) -> None:
    fill = QtGui.QColor(style.SELECTED)
    fill.setAlpha(style.BOX_ALPHA)
    painter.setPen(QtGui.QPen(QtGui.QColor(style.EDGE), 1, _Qt.DashLine))
    painter.setBrush(fill)
    painter.drawRect(QtCore.QRectF(*(QtCore.QPointF(*corner) for corner in corners)).normalized())


def _grips(painter: QtGui.QPainter, places: list[Point]) -> None:
    """Small squares, by which circles are pulled."""
    painter.setPen(QtGui.QPen(QtGui.QColor(style.EDGE), 1.5))
    painter.setBrush(QtGui.QColor(style.VERTEX))
    half = style.GRIP_PX / 2
    for x, y in places:
        painter.drawRect(QtCore.QRectF(x - half, y - half, 2 * half, 2 * half))


def _snap(painter: QtGui.QPainter, snap: Snap, work: Work) -> None:
    """A mark for what the pointer sticks to, its word beside it, and the guide that leads."""
    x, y = work.on_screen(snap.point_px)
    r = style.SNAP_PX
    ring = symbols.ellipse(((x - r, y), (x + r, y)), ((x, y - r), (x, y + r)))
    cross = [((x - r, y - r), (x + r, y + r)), ((x - r, y + r), (x + r, y - r))]
    plus = [((x - r, y), (x + r, y)), ((x, y - r), (x, y + r))]
    marks = {
        SnapKind.VERTEX: [ring],
        SnapKind.AXIS_END: [symbols.diamond((x, y), r)],
        SnapKind.MIDPOINT: [((x - r, y + r), (x, y - r), (x + r, y + r), (x - r, y + r))],
        SnapKind.EDGE: cross,
        SnapKind.CROSSING: [ring, *cross],
        SnapKind.GRID: plus,
        SnapKind.PHOTO_EDGE: cross,
        SnapKind.PHOTO_CORNER: [ring, *plus],
    }
    if snap.guide is not None:
        fine(painter, [tuple(map(work.on_screen, snap.guide))], style.GUIDE)
    stroke(painter, marks.get(snap.kind, []), style.SNAP, style.EDGE_PX)
    if snap.kind is not SnapKind.FREE:
        paint_words(painter, work.in_words(snap.kind.value), (x + 1.6 * r, y + 2.4 * r))


def paint_invitation(painter: QtGui.QPainter, area: QtCore.QRect, words: str) -> None:
    """Say in the middle of an empty sketch what to do."""
    if not words:
        return
    font = painter.font()
    font.setPixelSize(style.INVITATION_PX)
    painter.setFont(font)
    room = QtCore.QRectF(area).adjusted(24, 24, -24, -24)
    # By option: PySide6 lets no flags of two kinds be joined.
    centred = QtGui.QTextOption(_Qt.AlignCenter)
    plaque = painter.boundingRect(room, words, centred).adjusted(-14, -8, 14, 8)
    fill = QtGui.QColor(style.CASING)
    fill.setAlpha(style.CASING_ALPHA)
    painter.setPen(_Qt.NoPen)
    painter.setBrush(fill)
    painter.drawRoundedRect(plaque, 6, 6)
    painter.setPen(QtGui.QColor(style.TEXT))
    painter.drawText(room, words, centred)


def paint_cursor(painter: QtGui.QPainter, place: Point) -> None:
    """A cross with an open middle, dark in a light casing, in px of the screen."""
    x, y = place
    near, far = style.CURSOR_PX
    arms = [
        QtCore.QLineF(x + near * dx, y + near * dy, x + far * dx, y + far * dy)
        for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1))
    ]
    for colour, wide in ((style.CASING, 5.0), (style.TEXT, 2.0)):
        pen = QtGui.QPen(QtGui.QColor(colour), wide)
        pen.setCapStyle(_Qt.RoundCap)
        painter.setPen(pen)
        painter.drawLines(arms)
