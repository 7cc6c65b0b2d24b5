"""From the sketch to its 3D model."""

from __future__ import annotations

from typing import Any

from .. import host
from ..features import pipeline
from ..features.lifted_model import is_lifted_model
from ..features.photo_sketch import is_photo_sketch
from .base import Command, CommandError
from .choosing import chosen, objects_of, reveal


class Lift(Command):
    """Make the lifted model of a photo sketch."""

    NAME = "InContext_Lift"
    ICON = "InContext_LiftedModel"
    MENU_TEXT = "Lift to 3D"
    TOOLTIP = "Make the 3D model of the sketch; it follows every change of the sketch"
    SHORTCUT = "I, L"
    NEEDS = ("numpy", "scipy")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With a photo sketch in the document."""
        return bool(objects_of(is_photo_sketch))

    def run(self) -> None:
        """See the class."""
        _lift_and_look(chosen(is_photo_sketch, "a photo sketch"))


def _lift_and_look(photo_sketch: Any) -> Any:
    """The lifted model of a photo sketch, beside its tab, seen from where the photo was taken."""
    from ..panels.open_tabs import active_tab
    from ..panels.tiling import show_side_by_side
    from ..panels.view_3d import look_from_the_camera

    model, front = lift(photo_sketch), active_tab()
    if front is not None and front.obj is photo_sketch:
        # Else a tab as large as the window hides what has just been made.
        show_side_by_side(front)
    reveal(model.Document)
    if not model.Shape.isNull():
        look_from_the_camera(model)
    return model


def has_sketch_or_model() -> bool:
    """Whether there is something in the document that `model_to_make` could give."""
    return bool(objects_of(is_lifted_model) or objects_of(is_photo_sketch))


def model_to_make() -> Any:
    """The chosen lifted model; where there is none yet, the chosen sketch is lifted.

    Raises
    ------
    CommandError
        Where nothing is chosen, or the sketch is not solved yet.
    """
    if objects_of(is_lifted_model):
        return chosen(is_lifted_model, "a lifted model")
    sketch = chosen(is_photo_sketch, "a photo sketch")
    solution = pipeline.solution_of(sketch.Sketch)
    if solution.status.value != "converged":
        raise CommandError(solution.message)
    return _lift_and_look(sketch)


def lift(photo_sketch: Any) -> Any:
    """The lifted model of a photo sketch."""
    from ..features.lifted_model import make_lifted_model

    document = photo_sketch.Document
    with host.transaction(document, host.translate("InContext", "Lift to 3D")):
        model = make_lifted_model(document, photo_sketch)
        document.recompute()
    return model
