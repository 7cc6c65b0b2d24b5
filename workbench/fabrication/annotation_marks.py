"""What is said of a sketch, drawn over it: right angles, parallels, what touches, sizes.

Terms
-----
plaque
    A size in a small box beside what has it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TypeVar

import numpy as np
from PIL import ImageDraw

from ...solver.annotations import (
    Angle,
    Annotation,
    Diameter,
    EqualLength,
    Length,
    OnFace,
    Parallel,
    RightAngle,
    SymmetryPlane,
)
from ...solver.graph import SketchGraph
from ...solver.values import Array
from .strokes import text_strokes, text_width_mm

A = TypeVar("A", bound=Annotation)

BLUE = (28, 92, 214)
RED = (214, 48, 40)
PURPLE = (122, 60, 190)
#: Heights of letters and sizes of marks, in px of the finished picture.
_LETTERS, _SQUARE, _SMALL, _BESIDE, _MARGIN = 9.0, 14.0, 5.0, 8.0, 5.0
#: Of rings around vertices, outside of their discs.
_RING = 9.0
#: Parallels and equal lengths are marked this part of the way along: one beside the other.
_PARALLEL_AT, _EQUAL_AT = 0.62, 0.38
#: So many marks tell groups apart; then they begin anew.
_GROUPS = 4


class AnnotationMarks:
    """Draws annotations.

    Parameters
    ----------
    graph : SketchGraph
    draw : ImageDraw
    at : mapping of vertex to (2,) array
        Where vertices are on the page.
    circles : mapping of circle to (n, 2) array
        The same of the circles' outlines.
    px : float
        Of the page, in one of the finished picture.
    """

    def __init__(
        self,
        graph: SketchGraph,
        draw: ImageDraw.ImageDraw,
        at: Mapping[str, Array],
        circles: Mapping[str, Array],
        px: float,
    ) -> None:
        self._graph, self._draw, self._px = graph, draw, px
        self._at, self._circles = at, circles
        drawn = [*at.values(), *(outline.mean(axis=0) for outline in circles.values())]
        self._middle = np.mean(drawn, axis=0) if drawn else np.zeros(2)

    def below_lines(self) -> None:
        """Right angles: lines go over them."""
        for mark in self._of(RightAngle):
            self._right_angle(mark)

    def on_lines(self) -> None:
        """Parallels, equal lengths, what symmetry planes halve, what touches a face; sizes."""
        for n, parallel in enumerate(self._of(Parallel)):
            _, first = self._place(parallel.edges[0], _PARALLEL_AT)
            for edge in parallel.edges:
                self._arrows(edge, 1 + n % _GROUPS, first)
        for n, equal in enumerate(self._of(EqualLength)):
            for edge in equal.edges:
                self._ticks(edge, 1 + n % _GROUPS)
        for plane in self._of(SymmetryPlane):
            for edge in plane.midpoints_of:
                self._diamond(self._place(edge, 0.5)[0])
        for touching in self._of(OnFace):
            self._ring(self._at[touching.vertex])
        self._sizes()

    def _sizes(self) -> None:
        for length in self._of(Length):
            self._plaque(f"{length.length_mm:g} mm", *self._place(length.edge, 0.5))
        for angle in self._of(Angle):
            corner, arms = self._at[angle.at], [self._arm(angle.at, e) for e in angle.between]
            self._plaque(f"{angle.angle_deg:g} deg", corner, arms[0] - arms[1])
        for diameter in self._of(Diameter):
            outline = self._circles[diameter.circle]
            lowest = outline[np.argmax(outline[:, 1])]
            self._plaque(f"{diameter.diameter_mm:g} mm across", lowest, np.array([1.0, 0.0]))

    def _of(self, kind: type[A]) -> list[A]:
        return [a for a in self._graph.annotations.values() if isinstance(a, kind)]

    def _place(self, edge: str, part: float) -> tuple[Array, Array]:
        """A place on an edge, and the edge's way."""
        v, w = (self._at[end] for end in self._graph.edges[edge])
        return v + part * (w - v), w - v

    def _arm(self, vertex: str, edge: str) -> Array:
        v, w = self._graph.edges[edge]
        return self._at[w if v == vertex else v] - self._at[vertex]

    def _right_angle(self, mark: RightAngle) -> None:
        corner = self._at[mark.at]
        arms = [self._arm(mark.at, edge) for edge in mark.between]
        lengths = [float(np.linalg.norm(arm)) for arm in arms]
        if min(lengths) < 1e-6:
            return
        # A small square along the two edges, never longer than a third of the shorter one.
        size = min(_SQUARE * self._px, min(lengths) / 3)
        a, b = (arm * size / length for arm, length in zip(arms, lengths, strict=True))
        self._stroke([corner + a, corner + a + b, corner + b], BLUE)

    def _arrows(self, edge: str, count: int, like: Array) -> None:
        """Arrows to the same side as that way."""
        place, way = self._place(edge, _PARALLEL_AT)
        along, across = self._frame(way if way @ like >= 0 else -way)
        for n in range(count):
            tip = place + (0.8 * n + 0.5) * along
            self._stroke([tip - along - across, tip, tip - along + across], PURPLE)

    def _ticks(self, edge: str, count: int) -> None:
        place, way = self._place(edge, _EQUAL_AT)
        along, across = self._frame(way)
        for n in range(count):
            middle = place + 0.7 * n * along
            self._stroke([middle - 1.2 * across, middle + 1.2 * across], RED)

    def _diamond(self, place: Array) -> None:
        size = _SMALL * self._px
        ring = [(0, -1), (1, 0), (0, 1), (-1, 0), (0, -1)]
        self._stroke([place + size * np.array(corner) for corner in ring], PURPLE)

    def _ring(self, place: Array) -> None:
        angles = np.linspace(0.0, 2 * np.pi, 49)
        radius = _RING * self._px
        self._stroke([place + radius * np.array([np.cos(a), np.sin(a)]) for a in angles], RED)

    def _frame(self, way: Array) -> tuple[Array, Array]:
        """The way and what is square to it, as long as a small mark."""
        along = way * (_SMALL * self._px / max(float(np.linalg.norm(way)), 1e-9))
        return along, np.array([-along[1], along[0]])

    def _plaque(self, text: str, place: Array, way: Array) -> None:
        """A size beside a place, on the side away from the drawing's middle."""
        height = _LETTERS * self._px
        half = np.array([text_width_mm(text, height), height]) / 2 + _MARGIN * self._px
        _, across = self._frame(way)
        beside = across / max(float(np.linalg.norm(across)), 1e-9)
        beside = beside if beside @ (place - self._middle) >= 0 else -beside
        middle = place + beside * (_BESIDE * self._px + float(np.abs(beside) @ half))
        page = np.array(self._draw.im.size, dtype=float)
        middle = np.clip(middle, half + self._px, np.maximum(page - half - self._px, half))
        (left, top), (right, bottom) = middle - half, middle + half
        self._draw.rounded_rectangle(
            (left, top, right, bottom), 3 * self._px, "white", RED, round(1.2 * self._px)
        )
        start = (float(left) + _MARGIN * self._px, 0.0)
        for stroke in text_strokes(text, start, height):
            points = [(float(x), float(middle[1]) + height / 2 - float(y)) for x, y in stroke]
            self._draw.line(points, fill=RED, width=round(1.4 * self._px), joint="curve")

    def _stroke(self, points: Sequence[Array], colour: tuple[int, int, int]) -> None:
        drawn = [(float(x), float(y)) for x, y in points]
        self._draw.line(drawn, fill="white", width=round(3.4 * self._px))
        self._draw.line(drawn, fill=colour, width=round(1.4 * self._px))
