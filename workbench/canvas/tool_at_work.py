"""A drawing with the tool at work on it: who passes on what the pointer and the keys do.

Terms
-----
hint
    One line that says what to do next.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .drawing import Drawing, Listener
from .selection import Selection
from .tools import TOOLS

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph
    from .preview import Preview
    from .tools.base import Pointer, Tool


class ToolAtWork(Drawing):
    """A drawing, and the tool that works on it.

    Parameters
    ----------
    graph : SketchGraph
    listener : Listener
    """

    def __init__(self, graph: SketchGraph, listener: Listener) -> None:
        super().__init__(graph, listener)
        self._pointer: Pointer | None = None
        self._tool: Tool = TOOLS["select"](self)

    def replace_graph(self, graph: SketchGraph) -> None:
        """Take the document's graph; one that is not ours ends what the tool is doing."""
        ours = graph == self._committed and self._graph is self._committed
        super().replace_graph(graph)
        if not ours:
            self._tool.graph_replaced()
            self._listener.changed()

    @property
    def tool(self) -> Tool:
        """The tool at work."""
        return self._tool

    def use(self, name: str) -> None:
        """Take another tool; what the old one had begun is finished where that makes sense.

        The new one may say something of what was selected. One that is at work already is told so.
        """
        if name == self._tool.NAME:
            self._tool.again()
            self._listener.changed()
            return
        self._tool.finish()
        self._tool.cancel()
        chosen = self.selection if self._tool.NAME == "select" else Selection()
        self.select(Selection())
        self._tool = TOOLS[name](self)
        if self._pointer is not None:
            self._tool.move(self._pointer)
        self._tool.begin_with(chosen)
        self._listener.changed()

    def say_of_selection(self, name: str) -> None:
        """Say of what is selected what a tool says, and keep the tool at work."""
        TOOLS[name](self).begin_with(self.selection)

    @property
    def preview(self) -> Preview:
        """What the tool shows."""
        return self._tool.preview()

    def press(self, pointer: Pointer) -> None:
        """The left button goes down."""
        self.move(pointer)
        self._tool.press(pointer)
        self._listener.changed()

    def move(self, pointer: Pointer) -> None:
        """The pointer moves."""
        self._pointer = pointer
        before = (self.preview, self._graph)
        self._tool.move(pointer)
        # By identity: to compare what two graphs say takes a millisecond.
        if self.preview != before[0] or self._graph is not before[1]:
            self._listener.changed()

    def release(self, pointer: Pointer) -> None:
        """The left button goes up."""
        self._tool.release(pointer)
        self._listener.changed()

    def right(self, pointer: Pointer) -> bool:
        """The right button: done with what was begun; says whether it is to have a menu."""
        wants_menu = self._tool.right(pointer)
        self._listener.changed()
        return wants_menu

    def enter(self) -> None:
        """The Enter key: done with what was begun; or change what is selected."""
        self._tool.enter()
        self._listener.changed()

    def escape(self) -> None:
        """Give up what was begun; where nothing was, go back to selecting, then select nothing."""
        if not self._tool.cancel():
            if self._tool.NAME != "select":
                self.use("select")
            else:
                self.select(Selection())
        self._listener.changed()

    def delete(self) -> None:
        """Take away what the tool would take away, or what is selected."""
        if self._tool.delete():
            self._listener.changed()
            return
        before = self._committed
        super().delete()
        if self._committed is not before:
            # It may have been at work on just that.
            self._tool.graph_replaced()

    def select_all(self) -> None:
        """Select everything, with the tool for it."""
        self.use("select")
        super().select_all()
