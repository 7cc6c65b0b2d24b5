"""The plates of a lifted model, finger-jointed, as solids in their places."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import host
from ..problems import in_words, known_problems
from . import pipeline
from .dimensions import driven_text
from .properties import OUTCOME, Editor, Property, fail, set_outcome
from .proxy import Proxy, is_of_type

if TYPE_CHECKING:
    from ..fabrication.settings import PlateSettings

TYPE = "InContext::PlateSet"
SIDES = ("inside", "outside", "middle")


class PlateSet(Proxy):
    """Makes plates of a lifted model. The kerf is for the cut paths alone: no solid knows it."""

    TYPE = TYPE
    PROPERTIES = (
        Property("App::PropertyLink", "LiftedModel", "Plates", "The model that plates are made of"),
        Property(
            "App::PropertyLength",
            "Thickness",
            "Plates",
            "Thickness of the sheets, for faces that name none of their own",
            3.0,
        ),
        Property(
            "App::PropertyEnumeration",
            "Side",
            "Plates",
            "Where the material lies: inside means that the drawn faces are the outside",
            choices=SIDES,
        ),
        Property(
            "App::PropertyLength", "FingerWidth", "Joints", "How wide fingers should be", 12.0
        ),
        Property(
            "App::PropertyLength",
            "Play",
            "Joints",
            "How much wider a slot is than the finger that goes into it",
            0.0,
        ),
        Property(
            "App::PropertyLength",
            "Kerf",
            "Cutting",
            "Full width that the beam removes; changes the cut paths only, never the plates",
            0.0,
        ),
        *OUTCOME,
        Property(
            "App::PropertyInteger",
            "PlateCount",
            "Result",
            "How many plates there are",
            editor=Editor.READ_ONLY,
        ),
    )

    def execute(self, obj: Any) -> None:
        """Make the plates; where that cannot be done, keep the last ones and say why."""
        if obj.LiftedModel is None or obj.LiftedModel.PhotoSketch is None:
            set_outcome(obj, "no_model", host.translate("InContext", "choose a lifted model"))
            return
        if obj.LiftedModel.Status != "converged":
            # The model has said in words what is wrong: once is enough.
            words = host.translate("InContext", "waits for {}").format(obj.LiftedModel.Label)
            set_outcome(obj, "waiting", words)
            return
        try:
            plates = plates_of(obj)
        except known_problems() as error:
            fail(obj, "not_made", in_words(error))
            return
        _show(obj, plates)


def _show(obj: Any, plates: tuple[Any, ...]) -> None:
    from .shapes import plates_shape

    obj.Shape = plates_shape(plates)
    obj.PlateCount = len(plates)
    words = host.translate("InContext", "{} plates").format(len(plates))
    set_outcome(obj, "made", words)


def settings_of(obj: Any, *, with_kerf: bool = True) -> PlateSettings:
    """What the object's properties say; raises FabricationError where that cannot be.

    Parameters
    ----------
    obj : plate set
    with_kerf : bool
        False for the plates themselves, which have their finished sizes whatever the kerf.
    """
    from ..fabrication.settings import PlateSettings

    return PlateSettings(
        thickness_mm=obj.Thickness.Value,
        side=str(obj.Side),
        finger_mm=obj.FingerWidth.Value,
        play_mm=obj.Play.Value,
        kerf_mm=obj.Kerf.Value if with_kerf else 0.0,
    )


def plates_of(obj: Any) -> tuple[Any, ...]:
    """The plates of a plate set; raises SketchError or FabricationError."""
    settings_of(obj)  # a kerf out of range is said here, though no plate depends on it
    text = driven_text(obj.LiftedModel)
    return pipeline.plates_of(text, settings_of(obj, with_kerf=False))


def make_plate_set(document: Any, lifted_model: Any) -> Any:
    """The plates of a lifted model; recompute the document to see them.

    Parameters
    ----------
    document : FreeCAD document
    lifted_model : FreeCAD document object
        What `make_lifted_model` gave.

    Returns
    -------
    FreeCAD document object
    """
    obj = document.addObject("Part::FeaturePython", "PlateSet")
    PlateSet(obj)
    obj.Label = host.translate("InContext", "Plates")
    obj.LiftedModel = lifted_model
    if host.has_window():
        from .view_providers import PlateSetView

        PlateSetView(obj.ViewObject)
        lifted_model.ViewObject.Visibility = False
    return obj


def is_plate_set(obj: Any) -> bool:
    """True for plate sets."""
    return is_of_type(obj, TYPE)
