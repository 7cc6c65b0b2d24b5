"""The lifted model as one hollow solid, for a 3D printer."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import host
from ..problems import in_words, known_problems
from ..wording import in_language
from . import pipeline
from .driven import driven_text
from .preset_proxy import PresetProxy
from .properties import OUTCOME, TAKEN, Property, apply_preferences, fail, set_outcome
from .proxy import is_of_type

if TYPE_CHECKING:
    from ..fabrication.settings import ShellSettings

TYPE = "InContext::ShelledSolid"
SIDES = ("inside", "outside", "middle")
OPEN_ENDS = ("wider", "bottom", "top", "both", "none")


class ShelledSolid(PresetProxy):
    """Hollows a lifted model out; faces left out are openings."""

    MAKES = "print"
    TYPE = TYPE
    PROPERTIES = (
        Property("App::PropertyLink", "LiftedModel", "Shell", "The model that is hollowed out"),
        *TAKEN,
        Property("App::PropertyLength", "Wall", "Shell", "Thickness of the wall", 2.0),
        Property(
            "App::PropertyEnumeration",
            "Side",
            "Shell",
            "Where the wall lies: inside means that the drawn faces are the outside",
            choices=SIDES,
        ),
        Property(
            "App::PropertyEnumeration",
            "OpenEnd",
            "Shell",
            "Which end of a surface of revolution has no wall",
            choices=OPEN_ENDS,
        ),
        Property("App::PropertyBool", "Solid", "Shell", "No hollow at all"),
        Property(
            "App::PropertyLength",
            "LeastWall",
            "Printer",
            "What the printer can print; thinner walls are refused",
            0.4,
        ),
        Property(
            "App::PropertyLength",
            "Tolerance",
            "Printer",
            "How far the triangles of exported files may leave curved surfaces",
            0.02,
        ),
        Property(
            "App::PropertyVector",
            "Bed",
            "Printer",
            "What the printer can print at once, in mm; 0 for unknown",
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
    from ..fabrication.settings import bed_note
    from .brep_bridge import shape_from_brep

    obj.Shape = shape_from_brep(text)
    words = host.translate("InContext", "{:.1f} cm3 of material").format(obj.Shape.Volume / 1e3)
    box = obj.Shape.BoundBox
    note = bed_note((box.XLength, box.YLength, box.ZLength), settings_of(obj).bed_mm)
    set_outcome(obj, "made", f"{words}; {in_language(note)}" if note else words)


def settings_of(obj: Any) -> ShellSettings:
    """What the object's properties say; raises FabricationError where that cannot be."""
    from ..fabrication.settings import ShellSettings

    return ShellSettings(
        wall_mm=obj.Wall.Value,
        side=str(obj.Side),
        open_end=str(obj.OpenEnd),
        solid=obj.Solid,
        least_wall_mm=obj.LeastWall.Value,
        tolerance_mm=obj.Tolerance.Value,
        bed_mm=(obj.Bed.x, obj.Bed.y, obj.Bed.z) if obj.Bed.Length else None,
    )


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
    apply_preferences(obj)
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
