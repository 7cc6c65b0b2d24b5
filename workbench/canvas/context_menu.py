"""The menu of the right button: what can be done with what is selected, each with its key."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING

from .qt import QtCore, QtGui
from .tools import TOOLS

if TYPE_CHECKING:
    from .tool_at_work import ToolAtWork
    from .view import SketchView

#: In the editor's language, the key, and what it does.
Entry = tuple[str, str, Callable[[], None]]


def open_menu(view: SketchView, drawing: ToolAtWork, at: QtCore.QPoint) -> QtGui.QMenu:
    """Open the menu at a place on the screen; the view goes on working behind it."""
    menu = QtGui.QMenu(view)
    menu.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    for entries in (_about_selection(drawing), _always(view, drawing)):
        menu.addSeparator()
        for words, key, act in entries:
            key = QtGui.QKeySequence(key).toString(QtGui.QKeySequence.NativeText)
            action = menu.addAction(f"{view.in_words(words)}\t{key}")
            action.triggered.connect(partial(_without_arguments, act))
    menu.popup(at)
    return menu


def _without_arguments(act: Callable[[], None], *_: object) -> None:
    """Qt says whether an action is checked."""
    act()


def _about_selection(drawing: ToolAtWork) -> Iterator[Entry]:
    """What can be done with what is selected."""
    chosen, length = drawing.selection, TOOLS["length"]
    if drawing.tool.size_meant() is not None:
        yield length.TITLE, length.KEY, drawing.enter
    for name, tool in TOOLS.items():
        if tool.says(drawing.committed, chosen) is not None:
            yield tool.TITLE, tool.KEY, partial(drawing.say_of_selection, name)
    if chosen.edges or chosen.circles:
        yield "Construction", "X", drawing.toggle_construction
    if chosen:
        yield "Delete", "Delete", drawing.delete


def _always(view: SketchView, drawing: ToolAtWork) -> Iterator[Entry]:
    """What can be done at any time."""
    if view.suggestions:
        yield "Take suggestions", "Y", view.take_suggestions
    if drawing.graph.vertices or drawing.graph.circles:
        yield "Select all", "Ctrl+A", drawing.select_all
    yield "Whole photo", "F", view.fit
