"""What all tools have in common, and the values that pass between them and the view."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from .. import stops
from ..plane import Point
from ..preview import Preview
from ..snapping import Lead, Snap, SnapKind, always, never, snap

if TYPE_CHECKING:
    from ....solver.graph import SketchGraph
    from ..drawing import Drawing
    from ..questions import Question
    from ..selection import Selection

#: A press and its release this many times the reach apart draw; closer, they are a click.
DRAG = 0.6
#: What is taken hold of moves with the pointer from here on; less is a trembling hand.
TREMBLE = 0.25


@dataclass(frozen=True, slots=True)
class Pointer:
    """Where the pointer is.

    Parameters
    ----------
    point_px : (u, v)
        Photo position.
    reach_px : float
        How near is near, in photo px.
    adding : bool
        Whether the key is held that adds to a selection, and joins edges where they cross.
    is_free : bool
        Whether the key is held that keeps the pointer from sticking to anything.
    is_second : bool
        Whether it is the second press of a double click.
    """

    point_px: Point
    reach_px: float
    adding: bool = False
    is_free: bool = False
    is_second: bool = False

    def is_far_from(self, point_px: Point, reaches: float = DRAG) -> bool:
        """Whether a position is more than so many times the reach away."""
        return math.dist(self.point_px, point_px) > reaches * self.reach_px


class Tool:
    """One tool. Subclasses say what presses, moves and releases do to the drawing.

    A tool reads and edits through its `Drawing` alone and never sees Qt.
    """

    NAME: ClassVar[str]
    KEY: ClassVar[str]
    TITLE: ClassVar[str]
    #: Names the step in the undo list.
    WORDS: ClassVar[str] = ""
    #: Whether the pointer is a cross, which points better than an arrow.
    CROSS: ClassVar[bool] = True

    def __init__(self, drawing: Drawing) -> None:
        self.drawing = drawing

    @property
    def hint(self) -> str:
        """What to do next, one line."""
        raise NotImplementedError

    @property
    def can_move(self) -> bool:
        """Whether a press would take hold of something to move it."""
        return False

    @classmethod
    def says(cls, graph: SketchGraph, chosen: Selection) -> SketchGraph | None:
        """The graph with what the tool says said of all that is chosen; None where it says nothing.

        Of one vertex or edge nothing: it may still be selected from moving it.
        """
        return None

    def begin_with(self, chosen: Selection) -> None:
        """The tool is taken: say what it says of what was selected."""
        said = self.says(self.drawing.committed, chosen)
        if said is not None:
            self.drawing.commit(said, self.WORDS)

    def size_meant(self) -> Question | None:
        """Whose size a number means that is typed now; None where it means nothing."""
        return None

    def press(self, pointer: Pointer) -> None:
        """The left button goes down."""

    def right(self, pointer: Pointer) -> bool:
        """The right button goes down: done with what was begun; True where it has a menu."""
        self.finish()
        return False

    def move(self, pointer: Pointer) -> None:
        """The pointer moves, with or without the button."""

    def release(self, pointer: Pointer) -> None:
        """The left button goes up."""

    def again(self) -> None:
        """The tool's own key is pressed while it is at work."""

    def finish(self) -> None:
        """Done with what was begun."""

    def enter(self) -> None:
        """The Enter key: done with what was begun."""
        self.finish()

    def cancel(self) -> bool:
        """Give up what was begun; False where there was nothing."""
        return False

    def delete(self) -> bool:
        """Take away what the tool is about; False where it is about nothing."""
        return False

    def graph_replaced(self) -> None:
        """The graph came from elsewhere: by undo, say."""
        self.cancel()

    def stops(self, reach_px: float) -> list[Point]:
        """Places to point at, one after the other, for who works with keys alone."""
        graph = self.drawing.graph
        return [*stops.vertices(graph), *stops.edges(graph), *stops.circles(graph)]

    def preview(self) -> Preview:
        """What to show besides the graph."""
        return Preview()

    def snap(self, pointer: Pointer, lead: Lead | None = None) -> Snap:
        """What the pointer sticks to, unless it is kept from it."""
        if pointer.is_free:
            return Snap(SnapKind.FREE, pointer.point_px)
        solved = self.drawing.solved
        meet = always if pointer.adding else never if solved is None else solved.meet
        place, reach = pointer.point_px, pointer.reach_px
        found = snap(self.drawing.committed, place, reach, lead=lead, meet=meet)
        return self.drawing.attracted(found, reach)


class TwoPointTool(Tool):
    """A tool that draws from one place to another: press, drag, release; or click and click."""

    def __init__(self, drawing: Drawing) -> None:
        super().__init__(drawing)
        self._start: Snap | None = None
        self._end: Snap | None = None
        self._reach_px = 0.0
        self._pressed_at: Point | None = None

    def press(self, pointer: Pointer) -> None:
        """Begin, or end with a second click."""
        self._pressed_at = pointer.point_px
        if self._start is None:
            self._start = self._end
        else:
            self._draw()

    def move(self, pointer: Pointer) -> None:
        """Show what would be drawn."""
        self._reach_px = pointer.reach_px
        self._end = self.snap(pointer)

    def release(self, pointer: Pointer) -> None:
        """End a drag; after a click, wait for the second one."""
        pressed_at, self._pressed_at = self._pressed_at, None
        if self._start is None or pressed_at is None or not pointer.is_far_from(pressed_at):
            return
        self.move(pointer)
        self._draw()
        self._start = None

    def finish(self) -> None:
        """Draw no further."""
        self.cancel()

    def cancel(self) -> bool:
        """Forget the start."""
        begun, self._start, self._pressed_at = self._start is not None, None, None
        return begun

    def _draw(self) -> None:
        """Draw from start to end."""
        raise NotImplementedError
