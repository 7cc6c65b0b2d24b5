"""What a person draws and annotates with: one tool a file, all of them in TOOLS."""

from __future__ import annotations

from .base import Tool
from .box import BoxTool
from .camera import CameraTool
from .circle import CircleTool
from .equal_length import EqualLengthTool
from .faces import LeaveOutTool, ThicknessTool
from .ground import GroundTool
from .length import LengthTool
from .line import LineTool
from .on_face import OnFaceTool
from .parallel import ParallelTool
from .rectangle import RectangleTool
from .revolution import RevolutionTool
from .right_angle import RightAngleTool
from .select import SelectTool
from .square import SquareTool
from .symmetry_plane import SymmetryPlaneTool

#: By name, in the toolbar's order.
TOOLS: dict[str, type[Tool]] = {
    tool.NAME: tool
    for tool in (
        SelectTool,
        LineTool,
        RectangleTool,
        SquareTool,
        BoxTool,
        CircleTool,
        RevolutionTool,
        RightAngleTool,
        ParallelTool,
        EqualLengthTool,
        GroundTool,
        SymmetryPlaneTool,
        OnFaceTool,
        LengthTool,
        ThicknessTool,
        LeaveOutTool,
        CameraTool,
    )
}

#: The tool of each key.
KEYS: dict[str, str] = {tool.KEY: name for name, tool in TOOLS.items()}
