"""What a person draws and annotates with: one tool a file, all of them in TOOLS."""

from __future__ import annotations

from .base import Tool
from .circle import CircleTool
from .equal_length import EqualLengthTool
from .faces import LeaveOutTool, ThicknessTool
from .ground import GroundTool
from .length import LengthTool
from .line import LineTool
from .parallel import ParallelTool
from .rectangle import RectangleTool
from .revolution import RevolutionTool
from .right_angle import RightAngleTool
from .select import SelectTool

#: By name, in the toolbar's order.
TOOLS: dict[str, type[Tool]] = {
    tool.NAME: tool
    for tool in (
        SelectTool,
        LineTool,
        RectangleTool,
        CircleTool,
        RevolutionTool,
        RightAngleTool,
        ParallelTool,
        EqualLengthTool,
        GroundTool,
        LengthTool,
        ThicknessTool,
        LeaveOutTool,
    )
}

#: The tool of each key.
KEYS: dict[str, str] = {tool.KEY: name for name, tool in TOOLS.items()}
