"""Commands for the sketch in the tab at the front that are no tools: all in TAB_COMMANDS."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from .. import host
from ..features.photo_sketch import is_photo_sketch
from .base import Command
from .choosing import objects_of

if TYPE_CHECKING:
    from ..canvas.view import SketchView


class TabCommand(Command):
    """Does something in the tab at the front; its key is the tab's own, as the tools' are."""

    KEY: ClassVar[str]

    def GetResources(self) -> dict[str, str]:  # noqa: N802  FreeCAD's names
        """See `Command`."""
        resources = super().GetResources()
        in_sketch = host.translate("InContext", "key {} in the sketch")
        resources["ToolTip"] += f" ({in_sketch.format(self.KEY)})"
        return resources

    def IsActive(self) -> bool:  # noqa: N802
        """With a sketch's tab at the front."""
        if not objects_of(is_photo_sketch):
            # FreeCAD asks while it starts, which must not wait for the solver.
            return False
        from ..panels.open_tabs import active_tab

        return active_tab() is not None

    def run(self) -> None:
        """See the class."""
        from ..panels.open_tabs import active_tab

        controller = active_tab()
        if controller is not None:
            self.act(controller.tab.view)
            controller.tab.view.setFocus()

    def act(self, view: SketchView) -> None:
        """Do it."""
        raise NotImplementedError


class Construction(TabCommand):
    """Make the selection construction, or part of the object again."""

    NAME = "InContext_Construction"
    ICON = "InContext_Construction"
    KEY = "X"
    MENU_TEXT = "Construction"
    TOOLTIP = (
        "Make the selected edges and circles construction: traced on what is in the photo, no "
        "part of the object; or part of it again"
    )

    def act(self, view: SketchView) -> None:
        """See `TabCommand`."""
        view.toggle_construction()


class Switch(TabCommand):
    """Switches something on and off; its button is down while it is on."""

    def GetResources(self) -> dict[str, str | bool]:  # noqa: N802  FreeCAD's names
        """See `Command`."""
        return {**super().GetResources(), "Checkable": False}

    def run(self) -> None:
        """See the class."""
        from ..panels.tool_buttons import show_active_tool

        try:
            super().run()
        finally:
            # The press has turned the button over, whatever came of it.
            show_active_tool()


class Numbers(Switch):
    """Show how many parameters each vertex has."""

    NAME = "InContext_Numbers"
    ICON = "InContext_Numbers"
    KEY = "N"
    MENU_TEXT = "Parameter numbers"
    TOOLTIP = (
        "Show at each vertex how many of its three coordinates are still its own: what is said "
        "of the sketch gives the others"
    )

    def act(self, view: SketchView) -> None:
        """See `TabCommand`."""
        view.toggle_numbers()


class Grid(Switch):
    """Show a grid on the ground."""

    NAME = "InContext_Grid"
    ICON = "InContext_Grid"
    KEY = "K"
    MENU_TEXT = "Ground grid"
    TOOLTIP = (
        "Show a grid on the ground in the photo's perspective, once that is known; the pen sticks "
        "to its lines and crossings"
    )

    def act(self, view: SketchView) -> None:
        """See `TabCommand`."""
        view.toggle_grid()


class PhotoEdges(Switch):
    """Have the photo's edges attract the pen."""

    NAME = "InContext_PhotoEdges"
    ICON = "InContext_PhotoEdges"
    KEY = "I"
    MENU_TEXT = "Stick to the photo's edges"
    TOOLTIP = "Have the pen stick to straight edges and corners that are seen in the photo"

    def act(self, view: SketchView) -> None:
        """See `TabCommand`."""
        view.toggle_photo_edges()


TAB_COMMANDS: tuple[type[TabCommand], ...] = (Construction, Numbers, Grid, PhotoEdges)
