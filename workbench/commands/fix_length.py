"""From a length that is shown to one that drives, and back."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from .. import host
from ..features.lifted_model import is_lifted_model
from .base import Command, CommandError


class FixLength(Command):
    """Fix the lengths of the selected edges as they are, or let them follow again."""

    NAME = "InContext_FixLength"
    ICON = "InContext_ToolLength"
    MENU_TEXT = "Fix or free length"
    TOOLTIP = (
        "Fix the length of the edges selected in 3D, to type it anew among the model's dimensions; "
        "fixed ones follow the drawing again"
    )
    SHORTCUT = "I, F"
    NEEDS = ("numpy", "scipy")

    def IsActive(self) -> bool:  # noqa: N802  FreeCAD's name
        """With edges of a lifted model selected."""
        return bool(_selected_edges())

    def run(self) -> None:
        """See the class."""
        from ..features.dimensions import edge_at

        for model, elements in _selected_edges():
            edges = [edge_at(model, element) for element in elements]
            if None in edges:
                words = (
                    "edges of the mirrored half follow those that are drawn: select one of these"
                )
                raise CommandError(host.translate("InContext", words))
            fix_or_free(model, list(dict.fromkeys(edge for edge in edges if edge)))


def fix_or_free(model: Any, edges: list[str]) -> None:
    """Have lengths drive; or follow again, where all of them drive already."""
    from ...solver.dimensions import driving_sizes_mm, sizes_mm
    from ..features import pipeline
    from ..features.dimensions import drive
    from ..features.lifted_model import solution_of

    said = driving_sizes_mm(pipeline.graph_of(model.PhotoSketch.Sketch))
    measured = sizes_mm(solution_of(model))
    free = all(edge in said for edge in edges)
    document = model.Document
    words = "Free length" if free else "Fix length"
    with host.transaction(document, host.translate("InContext", words)):
        for edge in edges:
            # What was drawn is no round number: nobody means billionths of a millimetre.
            drive(model, edge, None if free else said.get(edge, round(measured[edge], 6)))
        document.recompute()


def _selected_edges() -> list[tuple[Any, tuple[str, ...]]]:
    """Lifted models with their selected edges."""
    chosen = [
        (one.Object, tuple(name for name in one.SubElementNames if name.startswith("Edge")))
        for one in FreeCADGui.Selection.getSelectionEx()
        if is_lifted_model(one.Object)
    ]
    return [(model, elements) for model, elements in chosen if elements]
