"""What a person can do: one command a file, all of them in COMMANDS, in the menu's order."""

from __future__ import annotations

from .base import Command
from .check_fit import CheckFit
from .draw_plates import DrawPlates
from .edit_sketch import EditSketch
from .export_plates import ExportPlates
from .export_print import ExportPrint
from .fix_angle import FixAngle
from .fix_length import FixLength
from .import_sketch import ImportSketch
from .languages import add_command
from .lift import Lift
from .make_fit_test import MakeFitTest
from .make_plates import MakePlates
from .make_shell import MakeShell
from .new_sketch import NewSketch
from .open_example import OpenExample
from .paste_photo import PastePhoto
from .photo_camera import PhotoCamera
from .print_marker import PrintMarker
from .replace_photo import ReplacePhoto
from .straighten_photo import StraightenPhoto
from .view_through_photo import ViewThroughPhoto

COMMANDS: tuple[type[Command], ...] = (
    NewSketch,
    PastePhoto,
    ImportSketch,
    OpenExample,
    EditSketch,
    ReplacePhoto,
    PhotoCamera,
    StraightenPhoto,
    PrintMarker,
    ViewThroughPhoto,
    Lift,
    FixLength,
    FixAngle,
    MakePlates,
    MakeShell,
    CheckFit,
    MakeFitTest,
    DrawPlates,
    ExportPlates,
    ExportPrint,
)

#: Where toolbar and menu have a line between two groups: before these.
_GROUPS = (EditSketch, ExportPlates)


def register_commands() -> list[str]:
    """Make the commands known to FreeCAD.

    Returns
    -------
    list of str
        Their names as toolbars and menus take them, with separators.
    """
    names = []
    for command in COMMANDS:
        add_command(command())
        if command in _GROUPS:
            names.append("Separator")
        names.append(command.NAME)
    return names
