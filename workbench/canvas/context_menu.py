"""The menu of the right button: what can be done with what is selected, each with its key."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import TYPE_CHECKING

from .qt import QtCore, QtGui
from .tools import TOOLS

if TYPE_CHECKING:
    from .tool_at_work import ToolAtWork

#: In the editor's language, the key, and what it does.
Entry = tuple[str, str, Callable[[], None]]


def open_menu(
    view: QtGui.QWidget,
    parts: Iterable[Iterable[Entry]],
    in_words: Callable[[str], str],
    at: QtCore.QPoint,
) -> QtGui.QMenu:
    """Open a menu at a place on the screen, with a line between its parts; the view goes on."""
    menu = QtGui.QMenu(view)
    menu.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    for entries in parts:
        menu.addSeparator()
        for words, key, act in entries:
            key = QtGui.QKeySequence(key).toString(QtGui.QKeySequence.NativeText)
            action = menu.addAction(f"{in_words(words)}\t{key}")
            action.triggered.connect(partial(_without_arguments, act))
    menu.popup(at)
    return menu


def _without_arguments(act: Callable[[], None], *_: object) -> None:
    """Qt says whether an action is checked."""
    act()


def about_selection(drawing: ToolAtWork) -> Iterator[Entry]:
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


def about_sketch(drawing: ToolAtWork) -> Iterator[Entry]:
    """What can be done with the sketch as a whole."""
    if drawing.graph.vertices or drawing.graph.circles:
        yield "Select all", "Ctrl+A", drawing.select_all


def about_suggestions(take: Callable[[], None]) -> Iterator[Entry]:
    """What can be done with suggestions where there are any."""
    yield "Take suggestions", "Y", take


def about_photo(fit: Callable[[], None]) -> Iterator[Entry]:
    """What can be done with the photo."""
    yield "Whole photo", "F", fit
