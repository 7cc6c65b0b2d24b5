"""The bookshelf example: photo and sketch on the left, plates on the right."""

from __future__ import annotations

from typing import Any

import FreeCAD

from .base import Command

EXAMPLE = "bookshelf"


class OpenExample(Command):
    """Make the example in a document of its own, show photo and plates side by side."""

    NAME = "InContext_OpenExample"
    ICON = "InContext_OpenExample"
    MENU_TEXT = "Open the bookshelf example"
    TOOLTIP = "A bookshelf drawn over a photo of a desk, all the way to its plates"

    def run(self) -> None:
        """See the class."""
        from ..panels.tabs import show_tab
        from ..panels.tiling import show_side_by_side
        from ..panels.view_3d import look_from_the_camera

        document = open_example()
        sketch, model, _ = document.Objects[:3]
        show_side_by_side(show_tab(sketch))
        look_from_the_camera(model)


def open_example() -> Any:
    """A new document with the example; raises SketchError or FabricationError."""
    from ..features.examples import make_example

    document = FreeCAD.newDocument(EXAMPLE.capitalize())
    make_example(document, EXAMPLE)
    return document
