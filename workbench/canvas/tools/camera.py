"""The camera from a rectangle of known size: its four corners, clicked in the photo."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..plane import Point
from ..preview import Preview
from ..questions import KnownRectangle
from ..snapping import Snap, SnapKind
from .base import Pointer, Tool

if TYPE_CHECKING:
    from ..drawing import Drawing

_HINTS = (
    "Click the four corners of something flat on the ground whose size you know, or press the key "
    "again to find the printed marker",
    "Click the next corner; three are left",
    "Click the next corner; two are left",
    "Click the last corner",
)
_KNOWN = "Drag a corner to move it, Delete forgets the camera, four clicks elsewhere begin anew"


class CameraTool(Tool):
    """Asks for the camera once four corners are clicked; those that are known can be dragged.

    Corners are clicked as they are: what the photo shows puts them right afterwards.
    """

    NAME = "camera"
    KEY = "W"
    TITLE = "Camera from a rectangle"

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._corners: tuple[Point, ...] = ()
        self._at: Point | None = None
        self._held: int | None = None

    @property
    def hint(self) -> str:
        """See `Tool`."""
        if not self._corners and self.drawing.rectangle is not None:
            return _KNOWN
        return _HINTS[min(len(self._corners), 3)]

    @property
    def can_move(self) -> bool:
        """See `Tool`."""
        return self._held is not None

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        self._held = None if self._corners else self._near(pointer)
        if self._held is None and len(self._corners) < 4:
            there = any(not pointer.is_far_from(corner) for corner in self._corners)
            self._corners += () if there else (pointer.point_px,)

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        self._at = pointer.point_px

    def release(self, pointer: Pointer) -> None:
        """See `Tool`: what is asked, is asked once the button is up."""
        known, held = self.drawing.rectangle, self._held
        self._held = None
        if held is not None and known is not None:
            if pointer.is_far_from(known.corners_px[held]):
                self.drawing.tell_rectangle(known.with_corner(held, pointer.point_px))
        elif len(self._corners) == 4:
            corners, self._corners = self._corners, ()
            self.drawing.tell_rectangle(KnownRectangle(corners))

    def again(self) -> None:
        """See `Tool`: has the printed marker found."""
        self.cancel()
        self.drawing.tell_rectangle(None)

    def delete(self) -> bool:
        """See `Tool`: forgets the camera."""
        if self.drawing.rectangle is None and self.drawing.committed.camera is None:
            return False
        self.cancel()
        self.drawing.tell_rectangle(KnownRectangle(()))
        return True

    def cancel(self) -> bool:
        """See `Tool`."""
        begun = bool(self._corners) or self._held is not None
        self._corners, self._held = (), None
        return begun

    def preview(self) -> Preview:
        """See `Tool`."""
        known = self.drawing.rectangle
        pointed = Snap(SnapKind.FREE, self._at) if self._at is not None else None
        if self._corners:
            ends = (self._at,) if self._at is not None and len(self._corners) < 4 else ()
            line = (*self._corners, *ends)
            closed = (*line, line[0]) if len(line) == 4 else line
            return Preview(strokes=(closed,), grips=self._corners, snap=pointed)
        if known is None:
            return Preview(snap=pointed)
        corners = known.corners_px
        if self._held is not None and self._at is not None:
            corners = known.with_corner(self._held, self._at).corners_px
        return Preview(guides=((*corners, corners[0]),), grips=corners)

    def _near(self, pointer: Pointer) -> int | None:
        """The known corner under the pointer."""
        known = self.drawing.rectangle
        if known is None:
            return None
        distances = [math.dist(corner, pointer.point_px) for corner in known.corners_px]
        nearest = min(range(len(distances)), key=distances.__getitem__)
        return nearest if distances[nearest] <= 1.5 * pointer.reach_px else None
