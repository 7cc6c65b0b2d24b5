"""A photo without its lens's distortion."""

from __future__ import annotations

from .. import host
from ..features.photo_sketch import is_photo_sketch
from .base import Command, CommandError
from .choosing import chosen, objects_of


class StraightenPhoto(Command):
    """See how the lens bends straight things, and take that out of the photo."""

    NAME = "InContext_StraightenPhoto"
    ICON = "InContext_StraightenPhoto"
    MENU_TEXT = "Straighten photo"
    TOOLTIP = (
        "Take the lens's distortion out of the photo: its long edges, and lines traced on straight "
        "things as construction, tell how it bends them"
    )
    NEEDS = ("numpy", "scipy")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With a photo sketch in the document."""
        return bool(objects_of(is_photo_sketch))

    def run(self) -> None:
        """See the class."""
        from ..features.pipeline import graph_of
        from ..panels.messages import mention
        from ..panels.straightening import lens_of_object, straighten

        sketch = chosen(is_photo_sketch, "a photo sketch")
        lens = lens_of_object(sketch, graph_of(sketch.Sketch))
        if lens is not None and lens.distorts:
            straighten(sketch, lens)
            return
        if lens is None:
            raise CommandError(
                host.translate(
                    "InContext",
                    "No straight thing is seen: draw lines along some, near the photo's borders, "
                    "and make them construction (X).",
                )
            )
        words = host.translate(
            "InContext",
            "Straight lines bend by {:.1f} px at most: there is nothing to straighten.",
        )
        mention(words.format(lens.worst[1]))
