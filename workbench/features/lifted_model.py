"""The lifted model: a photo sketch in 3D."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import host
from ..problems import StoppedError, in_words, known_problems
from ..wording import in_language
from . import pipeline
from .dimension_names import is_dimension
from .dimensions import show_dimensions, take_edit
from .driven import driven_text
from .methods import METHOD
from .model_angles import SAID
from .properties import OUTCOME, Editor, Property, fail, set_outcome
from .proxy import Proxy, is_of_type

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph
    from ...solver.solution import Solution

TYPE = "InContext::LiftedModel"


class LiftedModel(Proxy):
    """Solves its sketch. A solve that ends badly keeps the last good shape and says why."""

    TYPE = TYPE
    PROPERTIES = (
        Property("App::PropertyLink", "PhotoSketch", "Model", "The sketch that is lifted to 3D"),
        METHOD,
        SAID,
        *OUTCOME,
        Property(
            "App::PropertyBool",
            "ScaleAssumed",
            "Result",
            "True where no length says how big the object is: its longest edge is 100 mm then",
            editor=Editor.READ_ONLY,
        ),
    )

    def execute(self, obj: Any) -> None:
        """Lift the sketch."""
        if obj.PhotoSketch is None:
            set_outcome(obj, "no_sketch", host.translate("InContext", "choose a photo sketch"))
            return
        try:
            pipeline.forget_stop(driven_text(obj))
            solution = solution_of(obj)
        except StoppedError as error:
            set_outcome(obj, "stopped", in_words(error))
            return
        except known_problems() as error:
            fail(obj, "unreadable", in_words(error))
            return
        if solution.status.value != "converged":
            # No fault: a sketch in the making is so most of the time.
            words = _words(pipeline.graph_of(driven_text(obj)), solution)
            set_outcome(obj, solution.status.value, words)
            host.note(f"{obj.Label}: {words}")
            return
        _show(obj, solution)

    def onChanged(self, obj: Any, name: str) -> None:  # noqa: N802  FreeCAD's name
        """A typed dimension goes into the sketch."""
        if is_dimension(name):
            take_edit(obj, name)


def _show(obj: Any, solution: Solution) -> None:
    from .shapes import solution_shape

    graph = pipeline.graph_of(driven_text(obj))
    obj.Shape = solution_shape(solution, graph)
    show_dimensions(obj, graph, solution)
    obj.ScaleAssumed = bool(solution.scale_assumed)
    set_outcome(obj, solution.status.value, _words(graph, solution))


def _words(graph: SketchGraph, solution: Solution) -> str:
    from ...solver.editing.nearly_flat import message_with_wanting_faces

    return in_language(message_with_wanting_faces(graph, solution))


def make_lifted_model(document: Any, photo_sketch: Any) -> Any:
    """A lifted model of a photo sketch; recompute the document to see it.

    Parameters
    ----------
    document : FreeCAD document
    photo_sketch : FreeCAD document object
        What `make_photo_sketch` gave.

    Returns
    -------
    FreeCAD document object
    """
    obj = document.addObject("Part::FeaturePython", "LiftedModel")
    LiftedModel(obj)
    obj.Label = host.translate("InContext", "Lifted model")
    obj.PhotoSketch = photo_sketch
    if host.has_window():
        from .view_providers import LiftedModelView

        LiftedModelView(obj.ViewObject)
    return obj


def is_lifted_model(obj: Any) -> bool:
    """True for lifted models."""
    return is_of_type(obj, TYPE)


def solution_of(obj: Any) -> Solution:
    """The solution behind a lifted model; raises SketchError where its text is no sketch."""
    return pipeline.solution_of(driven_text(obj))
