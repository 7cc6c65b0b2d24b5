"""The examples: photo and sketch on the left, plates or print on the right."""

from __future__ import annotations

from typing import Any, ClassVar

import FreeCAD

from .. import host
from ..examples import EXAMPLES
from .base import Command
from .languages import add_command

FIRST = EXAMPLES[0]
#: What the menu calls them, and what they show.
_WORDS = {
    "bookshelf": ("Bookshelf", "Wood for a laser, over a photo of six books on a desk"),
    "organizer": ("Desktop organizer", "Plates for a laser, over a photo of stationery"),
    "desk_tidy": ("Desk tidy with a step", "Plates for a laser, over a cropped photo"),
    "teapot_lid": ("Teapot lid", "A print; traced tiles give the size"),
    "cup_saucer": ("Cup saucer", "A print; a marker in the photo gives camera and size"),
    "scissors_cover": ("Cover for scissors", "A print whose wall lies outside what is drawn"),
    "chair_box": ("Storage box for a chair", "Cardboard for a laser, over a photo of a room"),
}


class OpenExample(Command):
    """Make an example in a document of its own, show photo and result side by side."""

    NAME = "InContext_OpenExample"
    ICON = "InContext_OpenExample"
    MENU_TEXT = "Open the bookshelf example"
    TOOLTIP = "A bookshelf drawn over a photo of a desk, all the way to its plates"
    EXAMPLE: ClassVar[str] = FIRST

    def run(self) -> None:
        """See the class."""
        from ..panels.tabs import show_tab
        from ..panels.tiling import show_side_by_side
        from ..panels.view_3d import look_from_the_camera
        from ..panels.waiting import busy

        with busy():
            document = open_example(self.EXAMPLE)
        sketch, model, _ = document.Objects[:3]
        show_side_by_side(show_tab(sketch))
        look_from_the_camera(model)


def _command(name: str) -> type[OpenExample]:
    text, tooltip = _WORDS[name]
    code = "".join(word.capitalize() for word in name.split("_"))
    body = {"NAME": f"InContext_Example{code}", "EXAMPLE": name}
    return type(code, (OpenExample,), {**body, "MENU_TEXT": text, "TOOLTIP": tooltip})


#: One for each example, for the menu of examples.
EXAMPLE_COMMANDS: tuple[type[OpenExample], ...] = tuple(_command(name) for name in EXAMPLES)


def open_example(name: str = FIRST) -> Any:
    """A new document with an example; raises SketchError or FabricationError."""
    from ..features.examples import make_example

    document = FreeCAD.newDocument("".join(word.capitalize() for word in name.split("_")))
    document.Label = host.translate("InContext", _WORDS[name][0])
    make_example(document, name)
    return document


def register_examples() -> list[str]:
    """Make the examples known to FreeCAD; gives their names in the menu's order."""
    for command in EXAMPLE_COMMANDS:
        add_command(command())
    return [command.NAME for command in EXAMPLE_COMMANDS]
