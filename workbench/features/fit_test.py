"""The fit test: two small pieces, cut first, that tell which play to set."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import host
from ..problems import in_words, known_problems
from .plate_set import is_plate_set, settings_of, shop_settings_of
from .properties import OUTCOME, Editor, Property, fail, set_outcome
from .proxy import Proxy, is_of_type

if TYPE_CHECKING:
    from ..fabrication.plates import Plate

TYPE = "InContext::FitTest"
#: Between the object and the pieces, mm.
_BESIDE_MM = 20.0


class FitTest(Proxy):
    """A comb of notches with different plays, and a tab, with the settings of a plate set."""

    TYPE = TYPE
    PROPERTIES = (
        Property("App::PropertyLink", "PlateSet", "Fit test", "The plates whose settings it tries"),
        *OUTCOME,
        Property(
            "App::PropertyFloatList",
            "Plays",
            "Result",
            "The play of each notch in mm, from left to right; it is engraved beside it",
            editor=Editor.READ_ONLY,
        ),
    )

    def execute(self, obj: Any) -> None:
        """Make the pieces; where that cannot be done, keep the last ones and say why."""
        if obj.PlateSet is None or not is_plate_set(obj.PlateSet):
            set_outcome(obj, "no_plates", host.translate("InContext", "choose plates"))
            return
        try:
            settings = settings_of(obj.PlateSet)
        except known_problems() as error:
            fail(obj, "not_made", in_words(error))
            return
        from ..fabrication.fits import coupon, coupon_plays
        from .shapes import plates_shape

        obj.Shape = plates_shape(_laid_out(coupon(settings), obj.PlateSet))
        obj.Plays = list(coupon_plays(settings))
        words = host.translate(
            "InContext", "cut it first; the notch in which the tab sits well says which play to set"
        )
        set_outcome(obj, "made", words)


def _laid_out(pieces: tuple[Plate, ...], plate_set: Any) -> list[Plate]:
    """The pieces on the ground before the object, one before the other."""
    box = plate_set.Shape.BoundBox
    x, y, z = (box.XMin, box.YMin, box.ZMin) if box.isValid() else (0.0, 0.0, 0.0)
    placed = []
    for piece in pieces:
        y -= piece.size_mm[1] + _BESIDE_MM
        place = piece.world_from_plate.copy()
        place[:3, 3] = (x, y, z)
        placed.append(replace(piece, world_from_plate=place))
    return placed


def make_fit_test(document: Any, plate_set: Any) -> Any:
    """The fit test of a plate set; recompute the document to see it.

    Parameters
    ----------
    document : FreeCAD document
    plate_set : FreeCAD document object
        What `make_plate_set` gave.

    Returns
    -------
    FreeCAD document object
    """
    obj = document.addObject("Part::FeaturePython", "FitTest")
    FitTest(obj)
    obj.Label = host.translate("InContext", "Fit test")
    obj.PlateSet = plate_set
    if host.has_window():
        from .view_providers import FitTestView

        FitTestView(obj.ViewObject)
    return obj


def is_fit_test(obj: Any) -> bool:
    """True for fit tests."""
    return is_of_type(obj, TYPE)


def export_fit_test(fit_test: Any, folder: Path, name: str) -> tuple[Path, ...]:
    """Write a fit test as NAME.coupon.dxf and .svg: both or none.

    Raises
    ------
    SketchError, FabricationError
        Where a setting cannot be, or the folder cannot be written.
    """
    from ...solver.files import write_files
    from ..making import coupon_files

    plate_set = fit_test.PlateSet
    files = coupon_files(settings_of(plate_set), shop_settings_of(plate_set), name)
    paths = {folder / file: data for file, data in files.items()}
    write_files(paths)
    return tuple(paths)
