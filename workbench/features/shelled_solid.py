"""The lifted model as one hollow solid, for a 3D printer."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import host
from ..problems import in_words, known_problems
from . import pipeline
from .dimensions import driven_text
from .properties import OUTCOME, Property, fail, set_outcome
from .proxy import Proxy, is_of_type

if TYPE_CHECKING:
    from ..fabrication.settings import ShellSettings

TYPE = "InContext::ShelledSolid"
SIDES = ("inside", "outside")


class ShelledSolid(Proxy):
    """Hollows a lifted model out; faces left out are openings."""

    TYPE = TYPE
    PROPERTIES = (
        Property("App::PropertyLink", "LiftedModel", "Shell", "The model that is hollowed out"),
        Property("App::PropertyLength", "Wall", "Shell", "Thickness of the wall", 2.0),
        Property(
            "App::PropertyEnumeration",
            "Side",
            "Shell",
            "Where the wall lies: inside means that the drawn faces are the outside",
            choices=SIDES,
        ),
        *OUTCOME,
    )

    def execute(self, obj: Any) -> None:
        """Make the solid; where that cannot be done, keep the last one and say why."""
        if obj.LiftedModel is None or obj.LiftedModel.PhotoSketch is None:
            set_outcome(obj, "no_model", host.translate("InContext", "choose a lifted model"))
            return
        if obj.LiftedModel.Status != "converged":
            # The model has said in words what is wrong: once is enough.
            words = host.translate("InContext", "waits for {}").format(obj.LiftedModel.Label)
            set_outcome(obj, "waiting", words)
            return
        try:
            text = pipeline.shell_of(driven_text(obj.LiftedModel), settings_of(obj))
        except known_problems() as error:
            fail(obj, "not_made", in_words(error))
            return
        _show(obj, text)


def _show(obj: Any, text: str) -> None:
    from .brep_bridge import shape_from_brep

    obj.Shape = shape_from_brep(text)
    words = host.translate("InContext", "{:.1f} cm3 of material").format(obj.Shape.Volume / 1e3)
    set_outcome(obj, "made", words)


def settings_of(obj: Any) -> ShellSettings:
    """What the object's properties say; raises FabricationError where that cannot be."""
    from ..fabrication.settings import ShellSettings

    return ShellSettings(wall_mm=obj.Wall.Value, side=str(obj.Side))


def make_shelled_solid(document: Any, lifted_model: Any) -> Any:
    """The hollow solid of a lifted model; recompute the document to see it.

    Parameters
    ----------
    document : FreeCAD document
    lifted_model : FreeCAD document object
        What `make_lifted_model` gave.

    Returns
    -------
    FreeCAD document object
    """
    obj = document.addObject("Part::FeaturePython", "ShelledSolid")
    ShelledSolid(obj)
    obj.Label = host.translate("InContext", "Shelled solid")
    obj.LiftedModel = lifted_model
    if host.has_window():
        from .view_providers import ShelledSolidView

        ShelledSolidView(obj.ViewObject)
        lifted_model.ViewObject.Visibility = False
    return obj


def is_shelled_solid(obj: Any) -> bool:
    """True for shelled solids."""
    return is_of_type(obj, TYPE)
