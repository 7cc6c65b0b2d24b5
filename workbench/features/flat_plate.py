"""One plate of a plate set, flat on the ground: what a technical drawing shows."""

from __future__ import annotations

from typing import Any

from .. import host
from ..problems import in_words, known_problems
from .plate_set import is_plate_set, plates_of
from .properties import OUTCOME, Editor, Property, fail, set_outcome
from .proxy import Proxy, is_of_type

TYPE = "InContext::FlatPlate"


class FlatPlate(Proxy):
    """Follows its plate; where that is gone, the last shape stays and says so."""

    TYPE = TYPE
    PROPERTIES = (
        Property("App::PropertyLink", "PlateSet", "Flat plate", "The plates that it is one of"),
        Property("App::PropertyString", "PlateId", "Flat plate", "Which of them"),
        Property("App::PropertyStringList", "PlateIds", "Result", "Its id", editor=Editor.HIDDEN),
        *OUTCOME,
        *(
            Property(
                "App::PropertyLength",
                name,
                "Result",
                "Finished size of the plate",
                editor=Editor.READ_ONLY,
            )
            for name in ("PlateWidth", "PlateHeight", "PlateThickness")
        ),
    )

    def execute(self, obj: Any) -> None:
        """Lay the plate down."""
        if obj.PlateSet is None or not is_plate_set(obj.PlateSet):
            set_outcome(obj, "no_plates", host.translate("InContext", "choose plates"))
            return
        try:
            plates = {plate.id: plate for plate in plates_of(obj.PlateSet)}
        except known_problems() as error:
            fail(obj, "not_made", in_words(error))
            return
        plate = plates.get(obj.PlateId)
        if plate is None:
            words = host.translate("InContext", "there is no plate {0} any more")
            fail(obj, "not_made", words.format(obj.PlateId))
            return
        from .references import show_plates
        from .shapes import flat_plate_solid, straight_sides_first

        show_plates(obj, straight_sides_first(flat_plate_solid(plate), plate), [plate.id])
        width, height = plate.size_mm
        sizes = {"PlateWidth": width, "PlateHeight": height, "PlateThickness": plate.thickness_mm}
        for name, size in sizes.items():
            if getattr(obj, name).Value != size:
                setattr(obj, name, size)
        set_outcome(obj, "made", "")


def make_flat_plate(document: Any, plate_set: Any, plate_id: str) -> Any:
    """One plate lying flat; recompute the document to see it."""
    obj = document.addObject("Part::FeaturePython", "FlatPlate")
    FlatPlate(obj)
    obj.Label = host.translate("InContext", "Plate {}").format(plate_id)
    obj.PlateSet, obj.PlateId = plate_set, plate_id
    if host.has_window():
        from .view_providers import FlatPlateView

        FlatPlateView(obj.ViewObject)
        obj.ViewObject.Visibility = False
    return obj


def is_flat_plate(obj: Any) -> bool:
    """True for flat plates."""
    return is_of_type(obj, TYPE)
