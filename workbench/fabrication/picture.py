"""NAME.png: the sketch over the photo, and beside it what will be made."""

from __future__ import annotations

import io
from collections.abc import Iterable, Sequence
from itertools import pairwise

import numpy as np
from PIL import Image, ImageDraw

from ...solver.annotations import Ground
from ...solver.graph import Ellipse, SketchGraph
from ...solver.solution import Solution
from ...solver.values import Array
from .annotation_marks import BLUE, AnnotationMarks
from .rendering import Scene, render
from .strokes import text_strokes, text_width_mm

PANEL_HEIGHT_PX = 720
GREEN = (24, 150, 72)
ORANGE = (226, 122, 24)
GREY = (110, 110, 110)
_SUPER = 3
_PAD = 24
_CAPTION = 44


def picture_png(
    graph: SketchGraph, solution: Solution, scene: Scene, photo: Image.Image | None, caption: str
) -> bytes:
    """The picture as PNG.

    Parameters
    ----------
    graph : SketchGraph
    solution : Solution
        Its camera gives the direction of view.
    scene : Scene
        The plates or the solid.
    photo : PIL.Image.Image or None
        Upright; None draws on a white page.
    caption : str
        One short line below the result.

    Returns
    -------
    bytes
    """
    left = sketch_panel(graph, photo)
    right = render(scene, solution.camera, (PANEL_HEIGHT_PX, PANEL_HEIGHT_PX))
    width = left.width + right.width + 3 * _PAD
    page = Image.new("RGB", (width, PANEL_HEIGHT_PX + _PAD + _CAPTION), "white")
    page.paste(left, (_PAD, _PAD))
    page.paste(right, (left.width + 2 * _PAD, _PAD))
    _write(page, caption, left.width + 2 * _PAD + right.width / 2)
    return _png(page)


def scene_png(scene: Scene, size_px: tuple[int, int] = (1200, 900)) -> bytes:
    """A scene alone as PNG, seen from the front, right and above."""
    return _png(render(scene, None, size_px))


def _png(page: Image.Image) -> bytes:
    buffer = io.BytesIO()
    page.save(buffer, "PNG")
    return buffer.getvalue()


def sketch_panel(graph: SketchGraph, photo: Image.Image | None) -> Image.Image:
    """The photo, dimmed a little, with the sketch drawn over it."""
    low, high = _frame(graph)
    scale = PANEL_HEIGHT_PX / float(high[1] - low[1])
    width = int(np.clip(round((high[0] - low[0]) * scale), 240, 2 * PANEL_HEIGHT_PX))
    scale = min(scale, width / float(high[0] - low[0]))
    size = (width * _SUPER, PANEL_HEIGHT_PX * _SUPER)
    page = Image.new("RGB", size, (252, 252, 252))
    shift = (np.array(size) - scale * _SUPER * (high - low)) / 2 - scale * _SUPER * low
    if photo is not None and graph.photo is not None:
        fitted = (
            round(graph.photo.width_px * scale * _SUPER),
            round(graph.photo.height_px * scale * _SUPER),
        )
        picture = photo.convert("RGB").resize(fitted, Image.Resampling.LANCZOS)
        dimmed = Image.blend(picture, Image.new("RGB", fitted, "white"), 0.28)
        page.paste(dimmed, (round(shift[0]), round(shift[1])))
    _SketchPainter(graph, ImageDraw.Draw(page), scale * _SUPER, shift).paint()
    return page.resize((width, PANEL_HEIGHT_PX), Image.Resampling.BOX)


def _frame(graph: SketchGraph) -> tuple[Array, Array]:
    """The part of the photo's plane that is shown: the photo, or the drawing with a border."""
    if graph.photo is not None:
        return np.zeros(2), np.array([graph.photo.width_px, graph.photo.height_px], dtype=float)
    drawn = list(graph.vertices.values())
    for circle in graph.circles.values():
        drawn += [*circle.a, *circle.b]
    points = np.array(drawn)
    low, high = points.min(axis=0), points.max(axis=0)
    border = 0.08 * float((high - low).max()) + 1.0
    return low - border, high + border


class _SketchPainter:
    """Draws a graph's elements in the order in which they lie on one another."""

    def __init__(
        self, graph: SketchGraph, draw: ImageDraw.ImageDraw, scale: float, shift: Array
    ) -> None:
        self.graph, self.draw = graph, draw
        self.at = {v: scale * np.array(p) + shift for v, p in graph.vertices.items()}
        self.circles = {c: scale * _ellipse(e) + shift for c, e in graph.circles.items()}

    def paint(self) -> None:
        """Right angles, then lines, then vertices, then what else is said."""
        graph = self.graph
        marks = AnnotationMarks(graph, self.draw, self.at, self.circles, _SUPER)
        marks.below_lines()
        for id_, outline in self.circles.items():
            self._line(outline, id_)
        for id_, (v, w) in graph.edges.items():
            self._line([self.at[v], self.at[w]], id_)
        ground = {
            v for a in graph.annotations.values() if isinstance(a, Ground) for v in a.vertices
        }
        for v, spot in self.at.items():
            self._dot(spot, GREEN if v in ground else BLUE)
        marks.on_lines()

    def _line(self, points: Iterable[Array], id_: str) -> None:
        drawn = [(float(x), float(y)) for x, y in points]
        if id_ in self.graph.construction:
            for a, b in pairwise(drawn):
                self._dashed(np.array(a), np.array(b))
            return
        self.draw.line(drawn, fill="white", width=5 * _SUPER, joint="curve")
        self.draw.line(drawn, fill=BLUE, width=round(2.6 * _SUPER), joint="curve")

    def _dashed(self, a: Array, b: Array) -> None:
        count = max(1, int(np.linalg.norm(b - a) / (9 * _SUPER)))
        for n in range(0, count, 2):
            ends = [a + (b - a) * k / count for k in (n, min(n + 1.1, count))]
            self.draw.line([(x, y) for x, y in ends], fill=ORANGE, width=2 * _SUPER)

    def _dot(self, spot: Array, colour: tuple[int, int, int]) -> None:
        for radius, fill in ((5.6, "white"), (4.4, colour), (2.0, "white")):
            r = radius * _SUPER
            x, y = float(spot[0]), float(spot[1])
            self.draw.ellipse((x - r, y - r, x + r, y + r), fill=fill)


def _ellipse(circle: Ellipse) -> Array:
    a, b = np.array(circle.a), np.array(circle.b)
    middle = (a.mean(axis=0) + b.mean(axis=0)) / 2
    angles = np.linspace(0.0, 2 * np.pi, 97)[:, None]
    return np.asarray(
        middle + np.cos(angles) * (a[1] - a[0]) / 2 + np.sin(angles) * (b[1] - b[0]) / 2
    )


def _write(page: Image.Image, text: str, middle_x: float) -> None:
    """A line in the caption strip, in the strokes that are engraved on plates."""
    height = 11.0
    strip = Image.new("RGB", (page.width * _SUPER, _CAPTION * _SUPER), "white")
    draw = ImageDraw.Draw(strip)
    at = ((middle_x - text_width_mm(text, height) / 2) * _SUPER, 0.0)
    for stroke in text_strokes(text, at, height * _SUPER):
        points = [(float(x), (_CAPTION - 14) * _SUPER - float(y)) for x, y in stroke]
        draw.line(points, fill=GREY, width=round(1.3 * _SUPER), joint="curve")
    page.paste(
        strip.resize((page.width, _CAPTION), Image.Resampling.BOX), (0, page.height - _CAPTION)
    )


def caption_of(what: str, points_mm: Sequence[Array] | Array) -> str:
    """The caption: what, and its size in the world."""
    x, y, z = np.ptp(np.asarray(points_mm).reshape(-1, 3), axis=0)
    return f"{what}, {x:.0f} x {y:.0f} x {z:.0f} mm"
