"""Paints a sketch and all that is shown with it, in screen px."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from . import overlay, previews, symbols, turning
from .ghosts import Ghosts
from .grid_painting import paint_grid, paint_note
from .lift_painting import paint_lift
from .lifted import LiftedView
from .marks import length_text
from .numbers import Numbers
from .scene import Findings, Scene
from .still_layer import StillLayer

if TYPE_CHECKING:
    from .key_cursor import KeyCursor
    from .plane import Point
    from .qt import QtGui
    from .tool_at_work import ToolAtWork

    #: From photo to screen.
    OnScreen = Callable[[Point], Point]


class SketchPainting:
    """What is shown with the sketch of a drawing, and how.

    Parameters
    ----------
    drawing : ToolAtWork
    cursor : KeyCursor
    """

    def __init__(self, drawing: ToolAtWork, cursor: KeyCursor) -> None:
        #: What is said in the middle of an empty sketch.
        self.invitation = ""
        #: Puts a word into the person's language.
        self.in_words: Callable[[str], str] = str
        #: How many parameters each vertex has.
        self.numbers = Numbers()
        #: Which vertices are not held yet, and which annotations disagree.
        self.findings = Findings()
        #: Where the lifted shape lies in the photo.
        self.lifted = LiftedView()
        #: What the lift makes evident.
        self.ghosts = Ghosts()
        self._drawing = drawing
        self._cursor = cursor
        self._still = StillLayer()

    def paint(self, painter: QtGui.QPainter, on_screen: OnScreen) -> None:
        """Paint the sketch with what lies below and above it.

        Parameters
        ----------
        painter : QPainter
            In screen px.
        on_screen : callable
            Takes a position in the photo, px, to the screen.
        """
        self._paint_grid(painter, on_screen)
        paint_lift(painter, self.lifted, on_screen)
        scene, drawing = self._scene(on_screen), self._drawing
        work = previews.Work(drawing.preview, drawing.selection, on_screen, self.in_words)
        previews.paint_below(painter, scene, work)
        overlay.paint(painter, scene, self._still_lines(painter, scene, on_screen))
        self.ghosts.paint(painter, scene)
        previews.paint_above(painter, scene, work)
        if self._cursor.place_px is not None:
            previews.paint_cursor(painter, on_screen(self._cursor.place_px))
        empty = not scene.graph.vertices and not scene.graph.circles and not work.preview.strokes
        if empty and drawing.tool.NAME != "camera":
            previews.paint_invitation(painter, painter.window(), self.invitation)

    def _scene(self, on_screen: OnScreen) -> Scene:
        graph = self._drawing.graph
        circles = {
            c: symbols.ellipse(tuple(map(on_screen, drawn.a)), tuple(map(on_screen, drawn.b)))
            for c, drawn in graph.circles.items()
        }
        return Scene(
            graph,
            self._drawing.marks,
            {v: on_screen(point) for v, point in graph.vertices.items()},
            circles,
            self.findings,
            tuple(tuple(map(on_screen, line)) for line in turning.rings_of(graph)),
            self.numbers.of(graph),
            mirrored={v: on_screen(place) for v, place in self.lifted.mirrored.items()},
        )

    def _still_lines(
        self, painter: QtGui.QPainter, scene: Scene, on_screen: OnScreen
    ) -> Callable[[], None] | None:
        """In the middle of a drag: paint what stays where it is as a picture of before."""
        committed = self._drawing.committed
        if scene.graph is committed:
            return None
        corners = (on_screen((0.0, 0.0)), on_screen((1.0, 1.0)))
        return lambda: self._still.paint(painter, scene, committed, corners)

    def _paint_grid(self, painter: QtGui.QPainter, on_screen: OnScreen) -> None:
        grid = self._drawing.grid
        if grid is not None:
            paint_grid(painter, grid, on_screen)
        if self._drawing.attraction.grid_shown:
            words = self.in_words(
                "Grid: {}" if grid else "The grid shows once the sketch is solved"
            )
            size = length_text(grid.spacing_mm) if grid else ""
            paint_note(painter, painter.window(), words.format(size))
