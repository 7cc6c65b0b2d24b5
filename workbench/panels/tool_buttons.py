"""The tools' buttons in FreeCAD's toolbar: the one at work in the tab at the front is down."""

from __future__ import annotations

import FreeCADGui

from ..canvas.tools import TOOLS
from . import tabs


def command_name(tool: str) -> str:
    """The command of a tool."""
    return "InContext_Tool" + "".join(word.capitalize() for word in tool.split("_"))


def show_active_tool(*_: object) -> None:
    """Press the button of the tool at work, and let the others up."""
    controller = tabs.active_tab()
    at_work = None if controller is None else controller.tab.view.tool_name
    for tool in TOOLS:
        command = FreeCADGui.Command.get(command_name(tool))
        for action in () if command is None else command.getAction():
            # FreeCAD would take a button that goes down for a press of it.
            was_blocked = action.blockSignals(True)
            action.setChecked(tool == at_work)
            action.blockSignals(was_blocked)
