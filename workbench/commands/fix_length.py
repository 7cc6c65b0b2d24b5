"""From a size that is shown to one that drives, and back."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .. import host
from ..features.dimension_names import Dimension
from ..features.lifted_model import is_lifted_model
from .base import Command, CommandError


class FixLength(Command):
    """Fix the sizes of the selected elements as they are, or let them follow again."""

    NAME = "InContext_FixLength"
    ICON = "InContext_ToolLength"
    MENU_TEXT = "Fix or free size"
    TOOLTIP = (
        "Fix the length of edges, the diameter of circles or the height of vertices selected in "
        "3D, to type it anew among the model's dimensions; fixed ones follow the drawing again"
    )
    SHORTCUT = "I, F"
    NEEDS = ("numpy", "scipy")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With edges or vertices of a lifted model selected."""
        return bool(selected_elements())

    def run(self) -> None:
        """See the class."""
        from ..features.picking import dimension_at

        for model, elements in selected_elements():
            found = [dimension_at(model, element) for element in elements]
            if None in found:
                words = (
                    "what lies on the ground has no height, and what is mirrored follows what is "
                    "drawn: select something else"
                )
                raise CommandError(host.translate("InContext", words))
            fix_or_free(model, list(dict.fromkeys(one for one in found if one)))


def fix_or_free(model: Any, dimensions: list[Dimension]) -> None:
    """Have dimensions drive; or follow again, where all of them drive already.

    Raises
    ------
    SketchError
        Where the sketch has no words for one of them.
    """
    from ..features import pipeline
    from ..features.dimensions import drive, driving_and_measured
    from ..features.lifted_model import solution_of

    graph = pipeline.graph_of(model.PhotoSketch.Sketch)
    said, sizes = driving_and_measured(model, graph, solution_of(model))
    free = all(dimension in said for dimension in dimensions)
    document = model.Document
    words = "Free size" if free else "Fix size"
    with host.transaction(document, host.translate("InContext", words)):
        for one in dimensions:
            # What was drawn is no round number: nobody means billionths of a millimetre.
            drive(model, one, None if free else said.get(one, round(sizes[one], 6)))
        document.recompute()


def selected_elements() -> list[tuple[Any, tuple[str, ...]]]:
    """Lifted models with their selected edges and vertices."""
    chosen = [
        (one.Object, tuple(n for n in one.SubElementNames if n.startswith(("Edge", "Vertex"))))
        for one in FreeCADGui.Selection.getSelectionEx()
        if is_lifted_model(one.Object)
    ]
    return [(model, elements) for model, elements in chosen if elements]
