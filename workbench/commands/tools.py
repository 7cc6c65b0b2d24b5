"""The drawing tools as commands: one class a tool, all of them in TOOL_COMMANDS."""

from __future__ import annotations

from typing import ClassVar

from .. import host
from ..features.photo_sketch import is_photo_sketch
from .base import Command
from .choosing import chosen, objects_of
from .languages import add_command
from .tab_commands import TAB_COMMANDS


class ToolCommand(Command):
    """Takes a tool in the tab at the front, or in the tab of the chosen sketch.

    The tools' keys are the tab's own and no shortcuts of FreeCAD's: a single letter must not draw
    while a person works elsewhere. So the tooltips name them.
    """

    TOOL: ClassVar[str]
    KEY: ClassVar[str]

    def GetResources(self) -> dict[str, str | bool]:  # noqa: N802  FreeCAD's names
        """See `Command`; the button of the tool at work is down."""
        resources = super().GetResources()
        in_sketch = host.translate("InContext", "key {} in the sketch")
        resources["ToolTip"] += f" ({in_sketch.format(self.KEY)})"
        return {**resources, "Checkable": False}

    def IsActive(self) -> bool:  # noqa: N802
        """With a photo sketch in the document."""
        return bool(objects_of(is_photo_sketch))

    def run(self) -> None:
        """See the class."""
        from ..panels.open_tabs import active_tab
        from ..panels.tabs import show_tab
        from ..panels.tool_buttons import show_active_tool

        try:
            controller = active_tab() or show_tab(chosen(is_photo_sketch, "a photo sketch"))
            # First: the tool may open a field to type in.
            controller.tab.view.setFocus()
            controller.tab.view.use_tool(self.TOOL)
        finally:
            # The press has turned the button over, whatever came of it.
            show_active_tool()


class Select(ToolCommand):
    """Select and move."""

    NAME = "InContext_ToolSelect"
    ICON = "InContext_ToolSelect"
    TOOL, KEY = "select", "S"
    MENU_TEXT = "Select"
    TOOLTIP = "Click or box to select, drag to move; drop a vertex on another one to merge them"


class Line(ToolCommand):
    """Draw lines."""

    NAME = "InContext_ToolLine"
    ICON = "InContext_ToolLine"
    TOOL, KEY = "line", "L"
    MENU_TEXT = "Line"
    TOOLTIP = "Draw straight edges, click after click or one with each drag"


class Rectangle(ToolCommand):
    """Draw rectangles."""

    NAME = "InContext_ToolRectangle"
    ICON = "InContext_ToolRectangle"
    TOOL, KEY = "rectangle", "R"
    MENU_TEXT = "Rectangle"
    TOOLTIP = (
        "One drag makes four edges and four right angles, in perspective once that is known; "
        "move the corners afterwards"
    )


class Square(ToolCommand):
    """Draw squares."""

    NAME = "InContext_ToolSquare"
    ICON = "InContext_ToolSquare"
    TOOL, KEY = "square", "Q"
    MENU_TEXT = "Square"
    TOOLTIP = "As the rectangle, with four equal sides"


class Box(ToolCommand):
    """Draw boxes."""

    NAME = "InContext_ToolBox"
    ICON = "InContext_ToolBox"
    TOOL, KEY = "box", "B"
    MENU_TEXT = "Box"
    TOOLTIP = (
        "Click the seven corners that are seen of a box, such as a book in the photo; "
        "as construction it gives the perspective"
    )


class Circle(ToolCommand):
    """Draw circles."""

    NAME = "InContext_ToolCircle"
    ICON = "InContext_ToolCircle"
    TOOL, KEY = "circle", "C"
    MENU_TEXT = "Circle"
    TOOLTIP = "Drag a box around a horizontal circle as it is seen; pull its four grips afterwards"


class Revolution(ToolCommand):
    """Draw surfaces of revolution."""

    NAME = "InContext_ToolRevolution"
    ICON = "InContext_ToolRevolution"
    TOOL, KEY = "revolution", "V"
    MENU_TEXT = "Surface of revolution"
    TOOLTIP = "Draw the ground, bottom and top circle, then the side from bottom to top"


class RightAngle(ToolCommand):
    """Mark right angles."""

    NAME = "InContext_ToolRightAngle"
    ICON = "InContext_ToolRightAngle"
    TOOL, KEY = "right_angle", "A"
    MENU_TEXT = "Right angle"
    TOOLTIP = "Click an angle that is a right one, or inside a quadrilateral for all four"


class Parallel(ToolCommand):
    """Mark parallel edges."""

    NAME = "InContext_ToolParallel"
    ICON = "InContext_ToolParallel"
    TOOL, KEY = "parallel", "P"
    MENU_TEXT = "Parallel"
    TOOLTIP = "Click edges that are parallel, then press Enter"


class EqualLength(ToolCommand):
    """Mark equally long edges."""

    NAME = "InContext_ToolEqualLength"
    ICON = "InContext_ToolEqualLength"
    TOOL, KEY = "equal_length", "E"
    MENU_TEXT = "Equal length"
    TOOLTIP = "Click edges that are equally long, then press Enter"


class Ground(ToolCommand):
    """Mark what stands on the ground."""

    NAME = "InContext_ToolGround"
    ICON = "InContext_ToolGround"
    TOOL, KEY = "ground", "G"
    MENU_TEXT = "Ground"
    TOOLTIP = "Click vertices, edges or the middle of a face that stand on the ground, or box them"


class SymmetryPlane(ToolCommand):
    """Mark symmetry planes."""

    NAME = "InContext_ToolSymmetryPlane"
    ICON = "InContext_ToolSymmetryPlane"
    TOOL, KEY = "symmetry_plane", "M"
    MENU_TEXT = "Symmetry plane"
    TOOLTIP = "Click the middle of an edge that the plane halves; what is hidden behind is added"


class OnFace(ToolCommand):
    """Mark vertices that touch a face."""

    NAME = "InContext_ToolOnFace"
    ICON = "InContext_ToolOnFace"
    TOOL, KEY = "on_face", "H"
    MENU_TEXT = "On face"
    TOOLTIP = "Click a vertex, then the middle of the face that it touches"


class Length(ToolCommand):
    """Say how long an edge is."""

    NAME = "InContext_ToolLength"
    ICON = "InContext_ToolLength"
    TOOL, KEY = "length", "D"
    MENU_TEXT = "Length, diameter"
    TOOLTIP = "Click an edge or a circle and type its size: 210, 21 cm or 3/4 in"


class Thickness(ToolCommand):
    """Say how thick a face is."""

    NAME = "InContext_ToolThickness"
    ICON = "InContext_ToolThickness"
    TOOL, KEY = "thickness", "T"
    MENU_TEXT = "Thickness"
    TOOLTIP = "Click in the middle of a face and type how thick its plate is"


class LeaveOut(ToolCommand):
    """Leave faces out."""

    NAME = "InContext_ToolLeaveOut"
    ICON = "InContext_ToolLeaveOut"
    TOOL, KEY = "leave_out", "O"
    MENU_TEXT = "Leave face out"
    TOOLTIP = "Click in the middle of a face that stays open, such as the front of a shelf"


class Camera(ToolCommand):
    """Find the camera from a rectangle."""

    NAME = "InContext_ToolCamera"
    ICON = "InContext_ToolCamera"
    TOOL, KEY = "camera", "W"
    MENU_TEXT = "Camera from a rectangle"
    TOOLTIP = (
        "Click the four corners of a printed marker, a sheet of paper or a tile on the ground: "
        "it gives the camera and the scale"
    )


TOOL_COMMANDS: tuple[type[ToolCommand], ...] = (
    Select,
    Line,
    Rectangle,
    Square,
    Box,
    Circle,
    Revolution,
    RightAngle,
    Parallel,
    EqualLength,
    Ground,
    SymmetryPlane,
    OnFace,
    Length,
    Thickness,
    LeaveOut,
    Camera,
)

#: So many draw; the others say what is true.
FIRST = TOOL_COMMANDS.index(RightAngle)


def register_tools() -> list[str]:
    """Make the tools known to FreeCAD.

    Returns
    -------
    list of str
        Their names as toolbars and menus take them, with separators.
    """
    for command in (*TOOL_COMMANDS, *TAB_COMMANDS):
        add_command(command())
    names = [command.NAME for command in TOOL_COMMANDS]
    others = [command.NAME for command in TAB_COMMANDS]
    return [*names[:FIRST], "Separator", *names[FIRST:], "Separator", *others]
