"""The pointer of who works with keys alone: arrows move it, Space clicks, Tab goes on; no Qt.

Terms
-----
step
    How far an arrow key moves it, in px of the screen.
stop
    A place to which Tab brings it, see `stops`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .stops import everything, place_of
from .tools.base import Pointer

if TYPE_CHECKING:
    from .plane import Point
    from .tool_at_work import ToolAtWork

#: Steps plain, with Shift, and with Ctrl, px of the screen.
STEP_PX, FAST_PX, FINE_PX = 8, 40, 1


class KeyCursor:
    """A place in the photo that keys move; there is none while the mouse is used.

    Parameters
    ----------
    drawing : ToolAtWork
    """

    def __init__(self, drawing: ToolAtWork) -> None:
        self._drawing = drawing
        self._stop = -1
        self.place_px: Point | None = None

    def hide(self) -> bool:
        """The mouse is used again; says whether there was a cursor."""
        was_there, self.place_px = self.place_px is not None, None
        return was_there

    def step(self, by_px: Point, start_px: Point, pointer: Pointer) -> Point:
        """Move it by so much of the photo; it appears at `start_px`.

        `pointer` says how near is near, and which keys are held.
        """
        u, v = self.place_px or start_px
        return self._go_to((u + by_px[0], v + by_px[1]), pointer)

    def go_on(self, way: int, pointer: Pointer) -> Point | None:
        """Go to the next stop, or the one before; when selecting, select it.

        Returns
        -------
        (u, v) or None
            Where it is now; None where there is nothing to stop at.
        """
        if self._drawing.tool.NAME == "select":
            return self._select_next(way)
        stops = self._drawing.tool.stops(pointer.reach_px)
        if not stops:
            return None
        self._stop = (self._stop + way) % len(stops) if self._stop >= 0 or way > 0 else -1
        self._stop %= len(stops)
        return self._go_to(stops[self._stop], pointer)

    def _select_next(self, way: int) -> Point | None:
        drawing = self._drawing
        there = everything(drawing.graph)
        if not there:
            return None
        now = drawing.selection
        before = there.index(now) if now in there else (-1 if way > 0 else 0)
        drawing.select(there[(before + way) % len(there)])
        return place_of(drawing.graph, drawing.selection)

    def tool_changed(self) -> None:
        """Another tool has other stops."""
        self._stop = -1

    def click(self, pointer: Pointer) -> None:
        """Press and let go where it is."""
        self._drawing.press(pointer)
        self._drawing.release(pointer)

    def _go_to(self, place_px: Point, pointer: Pointer) -> Point:
        self.place_px = place_px
        self._drawing.move(Pointer(place_px, pointer.reach_px, pointer.adding, pointer.is_free))
        return place_px
