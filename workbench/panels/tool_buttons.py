"""The tools' buttons in FreeCAD's toolbar: the one at work in the tab at the front is down."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import FreeCADGui

from ..canvas.tools import TOOLS
from . import open_tabs

if TYPE_CHECKING:
    from ..canvas.view import SketchView

#: Commands that switch something of a view on and off, and whether it is on.
SWITCHES: dict[str, Callable[[SketchView], bool]] = {
    "InContext_Numbers": lambda view: view.painting.numbers.shown,
    "InContext_Grid": lambda view: view.attraction.grid_shown,
    "InContext_PhotoEdges": lambda view: view.attraction.photo_edges,
}


def command_name(tool: str) -> str:
    """The command of a tool."""
    return "InContext_Tool" + "".join(word.capitalize() for word in tool.split("_"))


def show_active_tool(*_: object) -> None:
    """Press the button of the tool at work, and let the others up."""
    controller = open_tabs.active_tab()
    at_work = None if controller is None else controller.tab.view.tool_name
    for tool in TOOLS:
        _show(command_name(tool), is_down=tool == at_work)
    for name, is_on in SWITCHES.items():
        _show(name, is_down=controller is not None and is_on(controller.tab.view))


def _show(name: str, *, is_down: bool) -> None:
    command = FreeCADGui.Command.get(name)
    for action in () if command is None else command.getAction():
        # FreeCAD would take a button that goes down for a press of it.
        was_blocked = action.blockSignals(True)
        action.setChecked(is_down)
        action.blockSignals(was_blocked)
