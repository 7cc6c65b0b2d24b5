"""The fit check: does what is made fit the things on the photo, and will it stand?

It follows what it checks: a change of a size or of the thickness changes its numbers.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import host
from ..problems import in_words, known_problems
from ..wording import in_language
from . import pipeline
from .driven import driven_text
from .plate_set import is_plate_set, joined_of, settings_of
from .properties import OUTCOME, Editor, Property, fail, set_outcome
from .proxy import Proxy, is_of_type
from .shelled_solid import is_shelled_solid

if TYPE_CHECKING:
    from ..fabrication.checking import Check
    from ..fabrication.meshes import Mesh

TYPE = "InContext::FitCheck"


class FitCheck(Proxy):
    """Existing things in 3D, what reaches into them, and the centre of mass over its support."""

    TYPE = TYPE
    PROPERTIES = (
        Property(
            "App::PropertyLink", "Checked", "Check", "The plates or the solid that are checked"
        ),
        *OUTCOME,
        Property(
            "App::PropertyStringList",
            "Things",
            "Result",
            "Clearance, overlap and missing millimetres to each thing traced on the photo",
            editor=Editor.READ_ONLY,
        ),
        Property(
            "App::PropertyBoolList",
            "Fits",
            "Result",
            "Whether each of these things fits",
            editor=Editor.READ_ONLY,
        ),
        Property(
            "App::PropertyBool",
            "Stands",
            "Result",
            "Whether it stays as it is",
            editor=Editor.READ_ONLY,
        ),
        Property(
            "App::PropertyString",
            "Standing",
            "Result",
            "Whether it stands, and when it tips over",
            editor=Editor.READ_ONLY,
        ),
        Property(
            "App::PropertyStringList",
            "WeakSpots",
            "Result",
            "Loose and thin parts",
            editor=Editor.READ_ONLY,
        ),
        Property(
            "Part::PropertyPartShape",
            "Overlap",
            "Result",
            "What the object shares with existing things",
            editor=Editor.HIDDEN,
        ),
        Property(
            "App::PropertyVector",
            "CentreOfMass",
            "Result",
            "Of the object alone",
            editor=Editor.READ_ONLY,
        ),
        Property(
            "App::PropertyVectorList",
            "Support",
            "Result",
            "The polygon on which it stands",
            editor=Editor.HIDDEN,
        ),
    )

    def execute(self, obj: Any) -> None:
        """Check; where that cannot be done, keep the last result and say why."""
        made = obj.Checked
        if made is None:
            words = host.translate("InContext", "choose plates or a shelled solid")
            set_outcome(obj, "no_object", words)
            return
        if made.Status not in ("made", "not_cut"):
            # What is checked has said in words what is wrong: once is enough.
            words = host.translate("InContext", "waits for {}").format(made.Label)
            set_outcome(obj, "waiting", words)
            return
        try:
            check = check_of(made)
        except known_problems() as error:
            fail(obj, "not_checked", in_words(error))
            return
        _show(obj, check)


def _show(obj: Any, check: Check) -> None:
    import FreeCAD

    from .shapes import bodies_shape

    obj.Things = [in_language(fit.words) for fit in check.fits]
    obj.Fits = [fit.fits for fit in check.fits]
    obj.Stands = check.standing.stands
    obj.Standing = in_language(check.standing.words)
    obj.WeakSpots = [in_language(line) for line in check.weak]
    obj.Shape = bodies_shape(body for fit in check.fits for body in fit.thing.bodies)
    obj.Overlap = bodies_shape(o.body for fit in check.fits for o in fit.overlaps)
    standing = check.standing
    obj.CentreOfMass = FreeCAD.Vector(*standing.centre_mm.tolist())
    obj.Support = [FreeCAD.Vector(x, y, standing.ground_mm) for x, y in standing.support.tolist()]
    bad = sum(not fit.fits for fit in check.fits)
    said = []
    if not check.fits:
        words = "nothing is traced on the photo to fit to"
        said.append(host.translate("InContext", words))
    elif bad:
        words = host.translate("InContext", "{} of {} things are in the way")
        said.append(words.format(bad, len(check.fits)))
    else:
        said.append(host.translate("InContext", "it fits"))
    stands = "it stands" if standing.stands else "it does not stand"
    said.append(host.translate("InContext", stands))
    status = "in_the_way" if bad else "good" if standing.stands else "tips_over"
    set_outcome(obj, status, "; ".join(said))


def check_of(made: Any) -> Check:
    """The check of plates or a shelled solid; raises as `pipeline.joined_of` does."""
    from ..checked import plates_check, print_check

    words = host.translate("InContext", "Checking the fit ...")
    text = driven_text(made.LiftedModel)
    graph, solution = pipeline.graph_of(text), pipeline.solution_of(text)
    if is_plate_set(made):
        joined = joined_of(made)
        model = pipeline.model_of(text, settings_of(made).thickness_mm)
        return pipeline.in_sight(words, plates_check, joined, model, graph, solution)
    model = pipeline.model_of(text, made.Wall.Value)
    mesh, line_mm = _mesh_of(made.Shape, made.Tolerance.Value), made.LeastWall.Value
    return pipeline.in_sight(words, print_check, mesh, model, graph, solution, line_mm)


def _mesh_of(shape: Any, deflection_mm: float) -> Mesh:
    from ..fabrication.meshes import welded

    points, triangles = shape.tessellate(deflection_mm)
    return welded([tuple(p) for p in points], triangles)


def make_fit_check(document: Any, made: Any) -> Any:
    """The fit check of plates or a shelled solid; recompute the document to see it.

    Parameters
    ----------
    document : FreeCAD document
    made : FreeCAD document object
        What `make_plate_set` or `make_shelled_solid` gave.

    Returns
    -------
    FreeCAD document object
    """
    obj = document.addObject("Part::FeaturePython", "FitCheck")
    FitCheck(obj)
    obj.Label = host.translate("InContext", "Fit check")
    obj.Checked = made
    if host.has_window():
        from .fit_view import FitCheckView

        FitCheckView(obj.ViewObject)
    return obj


def is_fit_check(obj: Any) -> bool:
    """True for fit checks."""
    return is_of_type(obj, TYPE)


def can_be_checked(obj: Any) -> bool:
    """True for plate sets and shelled solids."""
    return is_plate_set(obj) or is_shelled_solid(obj)
