"""The plates of a lifted model, finger-jointed, as solids in their places."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from .. import host
from ..problems import in_words, known_problems
from ..wording import in_language
from . import pipeline
from .driven import driven_text
from .preset_proxy import PresetProxy
from .properties import OUTCOME, TAKEN, Editor, Property, apply_preferences, fail, set_outcome
from .proxy import is_of_type

if TYPE_CHECKING:
    from ..fabrication.plates import Joined
    from ..fabrication.settings import PlateSettings, ShopSettings

TYPE = "InContext::PlateSet"
SIDES = ("inside", "outside", "middle")
RELIEFS = ("none", "dogbone", "tbone")
GRAINS = ("free", "x", "y")


class PlateSet(PresetProxy):
    """Makes plates of a lifted model. The kerf is for the cut paths alone: no solid knows it."""

    MAKES = "plates"
    TYPE = TYPE
    PROPERTIES = (
        Property("App::PropertyLink", "LiftedModel", "Plates", "The model that plates are made of"),
        *TAKEN,
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
            "App::PropertyStringList",
            "JointChoices",
            "Joints",
            "Other joints at some edges, such as e5=butt or f1:f2=finger,finger=8,owner=f1; "
            "kinds: auto, finger, butt, half_lap, tab_slot, none",
        ),
        Property(
            "App::PropertyLength",
            "Kerf",
            "Cutting",
            "Full width that the beam removes; changes the cut paths only, never the plates",
            0.0,
        ),
        Property(
            "App::PropertyEnumeration",
            "CornerRelief",
            "Cutting",
            "Room for a round cutter in corners that look inwards; a laser needs none",
            choices=RELIEFS,
        ),
        Property(
            "App::PropertyLength",
            "ToolDiameter",
            "Cutting",
            "Diameter of the round cutter, for the corner relief",
            3.0,
        ),
        Property(
            "App::PropertyString",
            "Preset",
            "Cutting",
            "Layers and colours in files: a shop's or program's name, or your own .json file",
            "plain",
        ),
        Property(
            "App::PropertyLength",
            "SheetWidth",
            "Sheets",
            "Size of the stock; 0 takes the smallest usual sheet that holds every plate",
        ),
        Property("App::PropertyLength", "SheetHeight", "Sheets", "Size of the stock"),
        Property("App::PropertyLength", "Margin", "Sheets", "Free border of a sheet", 5.0),
        Property("App::PropertyLength", "Spacing", "Sheets", "Between two plates", 3.0),
        Property(
            "App::PropertyEnumeration",
            "Grain",
            "Sheets",
            "Where the direction that is up lies on the sheet",
            choices=GRAINS,
        ),
        Property("App::PropertyBool", "WithPdf", "Files", "Export a PDF in true size too"),
        Property(
            "App::PropertyString", "PdfPage", "Files", "Tile the PDF on A4, A3 or letter pages"
        ),
        Property("App::PropertyBool", "WithPartsList", "Files", "Export the parts list too"),
        Property(
            "App::PropertyBool", "WithCoupon", "Files", "Export a fit test with these settings too"
        ),
        Property("App::PropertyFloat", "CuttingSpeed", "Files", "For the time, in mm/s", 10.0),
        Property("App::PropertyFloat", "SheetPrice", "Files", "For the parts list; 0 for unknown"),
        Property(
            "App::PropertyBool",
            "Exploded",
            "Plates",
            "Show the plates apart, the way they are put together",
        ),
        *OUTCOME,
        Property(
            "App::PropertyStringList",
            "Fit",
            "Result",
            "What fingers, play and kerf come to, in millimetres",
            editor=Editor.READ_ONLY,
        ),
        Property(
            "App::PropertyStringList",
            "Joints",
            "Result",
            "How the plates are joined at each edge",
            editor=Editor.READ_ONLY,
        ),
        Property(
            "App::PropertyStringList",
            "Assembly",
            "Result",
            "In which order the plates go together",
            editor=Editor.READ_ONLY,
        ),
        Property(
            "App::PropertyInteger",
            "PlateCount",
            "Result",
            "How many plates there are",
            editor=Editor.READ_ONLY,
        ),
        Property(
            "App::PropertyStringList",
            "PlateIds",
            "Result",
            "Which plate each of the solids is",
            editor=Editor.HIDDEN,
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
            joined = joined_of(obj)
            fit = effects_of(obj)
        except known_problems() as error:
            fail(obj, "not_made", in_words(error))
            return
        _set_lines(obj, "Fit", fit)
        _set_lines(obj, "Joints", tuple(joint.words for joint in joined.joints))
        _show(obj, joined)
        reason = _why_not_cut(obj, joined)
        if reason:
            fail(obj, "not_cut", f"{reason}; {obj.Message}")


def _why_not_cut(obj: Any, joined: Joined) -> str:
    """Why these plates cannot be cut as the settings say: told now, not at the export."""
    from ..fabrication.sheets import paths_that_fit

    try:
        paths_that_fit(joined.plates, settings_of(obj), joined.joints)
    except known_problems() as error:
        return in_words(error)
    return ""


def _show(obj: Any, joined: Joined) -> None:
    from ..fabrication.notes import notes_of
    from .references import show_plates
    from .shapes import plates_shape

    plates, steps, locked = _put_together(joined, exploded=obj.Exploded)
    notes = map(in_language, notes_of(joined))
    words = [host.translate("InContext", "{} plates").format(len(plates)), *notes]
    _set_lines(obj, "Assembly", steps)
    show_plates(obj, plates_shape(plates), [plate.id for plate in plates])
    obj.PlateCount = len(plates)
    set_outcome(obj, "made", "; ".join([*words, *locked]))


def _put_together(
    joined: Joined, *, exploded: bool
) -> tuple[tuple[Any, ...], tuple[str, ...], tuple[str, ...]]:
    """The plates where they are shown, the steps to them, and why there are none."""
    try:
        steps = pipeline.steps_of(joined)
    except known_problems() as error:
        return joined.plates, (in_words(error),), (in_words(error),)
    plates = joined.plates
    if exploded:
        from ..fabrication.assembly import exploded as apart

        plates = apart(plates, steps)
    return plates, tuple(step.words for step in steps), ()


def _set_lines(obj: Any, name: str, lines: tuple[str, ...]) -> None:
    """Write a list only where it is new: an equal value need not be an edit."""
    said = tuple(map(in_language, lines))
    if tuple(getattr(obj, name)) != said:
        setattr(obj, name, list(said))


def settings_of(obj: Any) -> PlateSettings:
    """What the object's properties say; raises FabricationError where that cannot be."""
    from ..fabrication.joints import JointChoice
    from ..fabrication.settings import PlateSettings

    width, height = obj.SheetWidth.Value, obj.SheetHeight.Value
    return PlateSettings(
        thickness_mm=obj.Thickness.Value,
        side=str(obj.Side),
        finger_mm=obj.FingerWidth.Value,
        play_mm=obj.Play.Value,
        kerf_mm=obj.Kerf.Value,
        sheet_mm=(width, height) if width or height else None,
        margin_mm=obj.Margin.Value,
        spacing_mm=obj.Spacing.Value,
        relief=str(obj.CornerRelief),
        tool_mm=obj.ToolDiameter.Value,
        grain=str(obj.Grain),
        joints=tuple(JointChoice.parse(line) for line in obj.JointChoices if line.strip()),
    )


def shop_settings_of(obj: Any) -> ShopSettings:
    """What the object's properties say about files; raises FabricationError."""
    from ..fabrication.presets import load_preset
    from ..fabrication.settings import ShopSettings

    load_preset(obj.Preset)
    return ShopSettings(
        preset=obj.Preset,
        page=obj.PdfPage or None,
        cut_mm_s=obj.CuttingSpeed,
        sheet_price=obj.SheetPrice or None,
    )


def effects_of(obj: Any) -> tuple[str, ...]:
    """What the settings come to in millimetres; raises FabricationError."""
    from ..fabrication.fits import effects

    shop_settings_of(obj)  # a preset that is not there is said at once, not at the export
    return effects(settings_of(obj))


def joined_of(obj: Any) -> Joined:
    """The plates of a plate set and their joints; raises SketchError or FabricationError."""
    geometry = _geometry(settings_of(obj))
    return pipeline.joined_of(driven_text(obj.LiftedModel), geometry)


def _geometry(settings: PlateSettings) -> PlateSettings:
    """The settings that plates depend on: a change of the sheet makes none again."""
    from ..fabrication.settings import PlateSettings as Plain

    plain = Plain()
    return replace(
        settings,
        kerf_mm=settings.beam_mm,
        sheet_mm=plain.sheet_mm,
        margin_mm=plain.margin_mm,
        spacing_mm=plain.spacing_mm,
        relief=plain.relief,
        tool_mm=plain.tool_mm,
        grain=plain.grain,
    )


def plates_of(obj: Any) -> tuple[Any, ...]:
    """The plates of a plate set; raises SketchError or FabricationError."""
    return joined_of(obj).plates


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
    apply_preferences(obj)
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
