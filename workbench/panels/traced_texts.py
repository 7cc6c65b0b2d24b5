"""What is said of lines that are traced on real things: how well they agree, what to mind."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .. import host
from ..cropped_photos import perspective_notes
from ..wording import in_language

if TYPE_CHECKING:
    from ...solver.graph import SketchGraph
    from ...solver.perspective.vanishing_points import TracedLine
    from ...solver.solution import Solution


def words_of(graph: SketchGraph, solution: Solution) -> tuple[str, str]:
    """Some sentences, and each line's own numbers, worst first; both empty where none is traced."""
    from ...solver.perspective.vanishing_points import traced_lines

    if not graph.construction:
        return "", ""
    traced = traced_lines(graph, solution)
    if not traced.lines:
        return "", ""
    ranked = sorted(traced.lines.items(), key=lambda item: -item[1].off_px)
    worst, line = ranked[0]
    words = host.translate("InContext", "{0} traced lines, the worst ({1}) {2:.1f} px off.")
    said = words.format(len(ranked), worst, line.off_px)
    notes = map(in_language, perspective_notes(graph, traced))
    return " ".join((said, *notes)), "\n".join(_numbers(*item) for item in ranked)


def _numbers(edge: str, line: TracedLine) -> str:
    return f"{edge}: {line.off_px:.1f} px, {math.degrees(line.off_rad):.2f}°"
