"""Whether a shape is worth the question who is to blame, and whom to ask first.

Terms
-----
closer look
    The question which annotation contradicts the drawing: it takes longer than the shape itself.
hint
    What first order tells of the shape without one annotation (`diagnosis.reliefs`), before that is
    solved.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from .candidates import Candidate, drawing_rms, drawn_diagonal, reading_of
from .diagnosis import (
    LEAST_NOTICEABLE,
    MANY_UNKNOWNS,
    MAX_UNKNOWNS,
    Reading,
    contradicts,
    leftover_suspects,
    reliefs,
)
from .graph import SketchGraph
from .least_squares import EXACT_COST

#: A first view that misses the drawing by this part of its diagonal (RMS) makes doubtful whether
#: the annotations are true; a result that does so is looked at more closely.
DOUBTFUL_RMS, CLOSER_LOOK_RMS, SMALL_LOOK_RMS = 0.03, 0.012, 0.0095
#: Hands draw so well: in larger sketches what is missed by more, or by so little that nobody drew
#: it, is worth the question what each annotation keeps the shape from, which takes longer than all
#: else.
ALL_BUT_EXACT, AS_DRAWN = 0.0015, 0.0055
#: So much has to speak against an annotation for a closer look (Bayesian information).
SUSPICIOUS = 12.0
#: From far away first order tells little: there so small a part of the misfit is worth a try, and
#: nearby so large a one, of which first order leaves some percent that go as well.
WORTH_A_TRY, NEARLY_ALL = 0.05, 0.9
#: Of what is drawn so small a part, left over to check a shape, leaves several that nearly fit.
BARELY = 0.25


@dataclass(frozen=True, slots=True)
class Hint:
    """An annotation, and how well the drawing would be followed without it, to first order."""

    id: str
    reading: Reading


def first_rms(lifted: Candidate) -> float:
    """How far a first view stays from the drawing, with all that was expected (RMS, parts)."""
    n = 2 * lifted.full.n_vertices + lifted.problem.circles.supports.size
    return math.sqrt(2 * lifted.minimum.cost / max(1, n)) / drawn_diagonal(lifted.problem)


def needs_a_closer_look(graph: SketchGraph, lifted: Candidate, *, dragging: bool = False) -> bool:
    """Whether a result is so far from the drawing, or an annotation so suspicious.

    Small sketches hide a false annotation most easily and are soonest looked at; while one is
    dragged, what was found before stays.
    """
    if lifted.minimum.cost <= EXACT_COST and lifted.minimum.converged:
        return False
    unknowns = 3 * (len(lifted.problem.points) + len(lifted.problem.circles))
    small = unknowns <= MANY_UNKNOWNS
    rms = drawing_rms(lifted)
    if rms > (SMALL_LOOK_RMS if small and not dragging else CLOSER_LOOK_RMS):
        return True
    if dragging or unknowns > MAX_UNKNOWNS or (not small and ALL_BUT_EXACT < rms < AS_DRAWN):
        found = leftover_suspects(graph, lifted.full, lifted.minimum.x)
        return bool(found) and found[0].weight > SUSPICIOUS
    return bool(hints(graph, lifted, reading_of(graph, lifted)))


def hints(graph: SketchGraph, lifted: Candidate, whole: Reading) -> list[Hint]:
    """Annotations without which, to first order, the drawing is met better than chance allows.

    From far away first order tells little, and what chance may do as well is worth a try.

    Parameters
    ----------
    graph : SketchGraph
    lifted : Candidate
    whole : Reading
        Of it.

    Returns
    -------
    list of Hint
        The likeliest first.
    """
    if whole.rms < LEAST_NOTICEABLE:
        return []
    unit = drawn_diagonal(lifted.problem) ** 2 * max(whole.misfit, 1e-300)
    enough = WORTH_A_TRY if whole.rms > SMALL_LOOK_RMS else NEARLY_ALL
    found, among = [], len(graph.annotations)
    worth: dict[int, bool] = {}
    for relief in reliefs(graph, lifted.full, lifted.minimum.x):
        freed = max(1, relief.freed)
        if not worth.get(freed, True):
            # The largest come first, and one that gained more at the same price was not enough.
            continue
        goes = min(relief.gain / unit, 1.0)
        misfit, n_free = whole.misfit * (1 - goes), whole.n_free + freed
        part = replace(whole, misfit=misfit, n_free=n_free, plausible=True, converged=True)
        worth[freed] = goes > enough or contradicts(whole, part, among)
        if worth[freed]:
            found.append(Hint(relief.id, part))
    return sorted(found, key=lambda hint: hint.reading.information)
