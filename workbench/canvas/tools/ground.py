"""What stands on the ground."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ....solver.annotating import toggle_ground
from ..hit_testing import inside_box, vertex_at
from ..plane import Point
from ..preview import Preview, Selection
from .base import Pointer, Tool

if TYPE_CHECKING:
    from ..drawing import Drawing


class GroundTool(Tool):
    """Puts vertices on the ground and takes them off it, by click or box."""

    NAME = "ground"
    KEY = "G"
    TITLE = "Ground"

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._lit: frozenset[str] = frozenset()
        self._pressed_at: Point | None = None
        self._box: tuple[Point, Point] | None = None

    @property
    def hint(self) -> str:
        """See `Tool`."""
        return "Click the vertices that stand on the ground, or drag a box around them"

    def preview(self) -> Preview:
        """See `Tool`."""
        return Preview(lit=Selection(vertices=self._lit), box=self._box)

    def press(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if self._pressed_at is not None:
            # The release of the last press was lost: it ends the box.
            return
        if self._lit:
            changed = toggle_ground(self.drawing.committed, self._lit)
            self.drawing.commit(changed, "Mark ground")
        else:
            self._pressed_at = pointer.point_px
            self._box = (pointer.point_px, pointer.point_px)

    def move(self, pointer: Pointer) -> None:
        """See `Tool`."""
        graph = self.drawing.graph
        if self._pressed_at is not None:
            self._box = (self._pressed_at, pointer.point_px)
            self._lit = inside_box(graph, *self._box).vertices
        else:
            vertex = vertex_at(graph, pointer.point_px, 1.5 * pointer.reach_px)
            self._lit = frozenset() if vertex is None else frozenset((vertex,))

    def release(self, pointer: Pointer) -> None:
        """See `Tool`."""
        if self._pressed_at is not None:
            self.move(pointer)
            boxed = sorted(self._lit)
            self.cancel()
            if boxed:
                self.drawing.commit(toggle_ground(self.drawing.committed, boxed), "Mark ground")

    def cancel(self) -> bool:
        """See `Tool`."""
        begun = self._pressed_at is not None
        self._pressed_at = self._box = None
        self._lit = frozenset()
        return begun
