"""The shape that all annotations and the drawing allow, or who is to blame that there is none.

Two questions, the first asked of every sketch: whether annotations clash whatever the drawing
(`lift_without_culprit`), and else whether the drawing speaks against one (`lift_or_blame`). That is
believed in this order: all hold and the drawing is followed; a hand that leans explains the rest;
a size is a wish; one annotation is false; the search went astray.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from .annotations import Angle, Diameter, Length
from .blaming import (
    Blame,
    blame_by_relief,
    blame_for_clash,
    blame_for_several,
    blame_for_wishes,
    find_blame,
    suspicion,
)
from .candidates import (
    MAX_COORDINATES,
    MAX_NUMBERS,
    drawing_rms,
    is_held,
    is_settled,
    reading_of,
)
from .closer_look import CLOSER_LOOK_RMS, DOUBTFUL_RMS, needs_a_closer_look
from .diagnosis import (
    Reading,
    disagree,
    false_together,
    find_clash,
    without,
)
from .effort import GUESSING, Effort
from .graph import SketchGraph
from .leaning import as_leaning, leaning_reading
from .lifting import Lifted, lift
from .problem import IMAGINED_SIGMA, conditions_of
from .starting.rescuing import found_otherwise, lift_as_guessed, rescued
from .structure import Structure, build_structure
from .trials import Trials
from .values import Stop
from .wishes import drawn_shape, fulfilled, proportions_of

#: A hand that leans and meets a drawing as well as this (RMS, parts of its diagonal), as ends meet,
#: is believed before a false annotation that explains less than so many times more: people lean,
#: and seldom say what is false.
CAREFUL_RMS, TIMES_BETTER = 0.0035, 2.0
#: Up to odds of 20,000 to 1 against it (twice their logarithm).
LEANS_RATHER = 20.0
#: So many annotations are left out, at most, to show a shape where they clash.
MAX_CULPRITS = 4
#: Of more edges and annotations than these nobody draws, one is left out.
MANY_SAID = 1500


def lift_or_blame(
    core: SketchGraph, structure: Structure, effort: Effort
) -> tuple[Lifted | None, Blame | None]:
    """The shape, or where an annotation contradicts the drawing grossly the shape without it."""
    with effort.at_most(GUESSING):
        lifted = lift_as_guessed(core, structure, effort)
    lifted = lifted or lift(core, structure, effort, doubt_rms=DOUBTFUL_RMS)
    if lifted is None or effort.stopped:
        return lifted, None
    rest = _Rest(core, effort)
    trials = Trials(core, effort, rest.lifted)
    relieved, leaning = _at_first_sight(core, lifted, trials), None
    if relieved is None or relieved.held or not relieved.clear:
        lifted, leaning = _with_lean(core, structure, lifted, effort)
    if effort.stopped or _is_fine(core, lifted):
        return leaning or lifted, None
    effort.doing("looking for annotations that disagree")
    blamed = _most_to_blame(core, lifted, relieved, trials)
    if effort.stopped:
        return lifted, None
    if leaning is not None and _explains(core, leaning, lifted, blamed, rest):
        return leaning, None
    if blamed is not None and blamed.is_barely_checked:
        other = _found_after_all(core, structure, lifted, effort)
        # A guess is no minimum: that the drawing can be followed better without is no evidence.
        if other is not None or lifted.as_guessed:
            return other or lifted, None
    wished = _as_wished(core, structure, lifted, blamed, effort)
    if wished is not None:
        return wished
    if effort.stopped:
        return lifted, None
    if blamed is not None and blamed.explains and not blamed.held:
        other = _shown_without(core, blamed, rest)
        if other is not None:
            return other, blamed
    return _after_all(core, structure, lifted, blamed, trials, rest)


def _after_all(
    core: SketchGraph,
    structure: Structure,
    lifted: Lifted,
    blamed: Blame | None,
    trials: Trials,
    rest: _Rest,
) -> tuple[Lifted | None, Blame | None]:
    """What is shown where nobody's absence explains the drawing: the verdict on the whole shape."""
    effort = rest.effort
    effort.allow_a_last_descent()
    if lifted.doubtful:
        whole = lift(core, structure, effort)
        if whole is None:
            return None, blamed
        lifted = whole
        if is_held(lifted):
            blamed = blame_by_relief(core, lifted, trials)
    if blamed is not None and not blamed.held:
        other = _shown_without(core, blamed, rest)
        if other is not None:
            return other, blamed
        blamed = None
    if blamed is None or not is_settled(lifted):
        lifted = _better_from_elsewhere(core, lifted, effort)
    if blamed is None and is_settled(lifted):
        blamed = suspicion(core, lifted, effort)
    return lifted, blamed


def _better_from_elsewhere(core: SketchGraph, lifted: Lifted, effort: Effort) -> Lifted:
    """Begun from other shapes, where this one does not hold, or is further off than people draw.

    That no false annotation and no lean explains it shows that it may be the wrong valley.
    """
    missed = drawing_rms(lifted) if is_settled(lifted) else math.inf
    if missed < IMAGINED_SIGMA:
        return lifted
    effort.doing("beginning from other shapes")
    other = rescued(core, lifted, effort)
    return lifted if other is None or TIMES_BETTER * drawing_rms(other) > missed else other


def _shown_without(core: SketchGraph, blamed: Blame, rest: _Rest) -> Lifted | None:
    """The shape without the culprit, if it follows the drawing about as well as it is told to."""
    other = rest.lifted(blamed.ids[0])
    if other is None or other.doubtful or blamed.best is None:
        return None
    reading = reading_of(without(core, blamed.ids[0]), other)
    return other if reading.explains or reading.rms < TIMES_BETTER * blamed.best.rms else None


def _at_first_sight(core: SketchGraph, lifted: Lifted, trials: Trials) -> Blame | None:
    """What a first look that misses the drawing by far shows already."""
    return blame_by_relief(core, lifted, trials) if lifted.doubtful else None


def _most_to_blame(
    core: SketchGraph, lifted: Lifted, relieved: Blame | None, trials: Trials
) -> Blame | None:
    """Looked for from here, and from other beginnings where that does not explain the drawing."""
    if relieved is None and not lifted.doubtful:
        relieved = blame_by_relief(core, lifted, trials)
    if relieved is not None and relieved.explains:
        return relieved
    found = find_blame(core, lifted, trials, lost=lifted.doubtful)
    either = [b for b in (relieved, found) if b is not None]
    return min(either, key=lambda b: b.information, default=None)


def _with_lean(
    core: SketchGraph, structure: Structure, lifted: Lifted, effort: Effort
) -> tuple[Lifted, Lifted | None]:
    """A reading, and the same with a lean where the drawing shows one."""
    leaning = as_leaning(core, lifted, effort)
    if leaning is None or not lifted.doubtful:
        return lifted, leaning
    # Only a first look was taken: the exact drawing of something else looks like a lean, too.
    whole = lift(core, structure, effort)
    if whole is None or not _is_fine(core, whole):
        return lifted, leaning
    return whole, as_leaning(core, whole, effort)


def _found_after_all(
    core: SketchGraph, structure: Structure, lifted: Lifted, effort: Effort
) -> Lifted | None:
    """A shape that all annotations hold for and that follows the drawing, looked for at length."""
    whole = lift(core, structure, effort) if lifted.doubtful else None
    if whole is not None and is_settled(whole) and reading_of(core, whole).explains:
        return whole
    other = found_otherwise(core, whole or lifted, effort)
    return other if other is not None and reading_of(core, other).explains else None


def _explains(
    core: SketchGraph, leaning: Lifted, lifted: Lifted, blamed: Blame | None, rest: _Rest
) -> bool:
    """Whether a hand that leans explains the drawing better than a false annotation."""
    found = leaning_reading(core, leaning, lifted)
    if not found.plausible or blamed is None:
        return found.plausible
    if found.rms > CAREFUL_RMS and found.information >= blamed.information:
        return False
    # Without it the drawing may be met better than was seen from nearby, to the last digits even.
    other = rest.lifted(blamed.ids[0])
    if other is None or other.doubtful:
        return True
    best = reading_of(without(core, blamed.ids[0]), other)
    hardly_better = (
        found.rms < min(CAREFUL_RMS, TIMES_BETTER * best.rms)
        and found.information < best.information + LEANS_RATHER
    )
    return hardly_better or found.information < best.information


def _as_wished(
    core: SketchGraph, structure: Structure, lifted: Lifted, blamed: Blame | None, stop: Stop
) -> tuple[Lifted, Blame] | None:
    """The shape with the sizes that keep the drawing from being met, where there are such."""
    if blamed is None and is_settled(lifted):
        return None
    several, first = proportions_of(core), blamed.ids[:1] if blamed is not None else ()
    wishes_of_kind = Length | Diameter | Angle
    tries = [first] if all(isinstance(core.annotations[i], wishes_of_kind) for i in first) else []
    # One alone would have been blamed; several may hide behind each other.
    explained = blamed is not None and blamed.explains
    tries += [several] if len(several) > 1 and not explained else []
    for wishes in tries:
        drawn = drawn_shape(core, wishes, stop) if wishes else None
        found = None if drawn is None else fulfilled(core, structure, drawn, stop)
        if found is not None:
            ids = blamed.ids if blamed is not None and wishes == first else wishes
            return found, blame_for_wishes(core, ids, found)
    return None


def _is_fine(core: SketchGraph, lifted: Lifted) -> bool:
    return not lifted.doubtful and is_settled(lifted) and not needs_a_closer_look(core, lifted)


def lift_without_culprit(core: SketchGraph, effort: Effort) -> tuple[Lifted | None, Blame]:
    """The shape without the culprit, where annotations cannot all hold; none where it is lost."""
    effort.doing("looking for annotations that disagree")
    rest = _Rest(core, effort)
    doubt_rms = DOUBTFUL_RMS

    def attempt(id_: str) -> Reading | None:
        nonlocal doubt_rms
        lifted = None if effort.stopped else rest.lifted(id_, doubt_rms=doubt_rms)
        if lifted is None or lifted.doubtful:
            return None
        reading = reading_of(without(core, id_), lifted)
        if reading.explains:
            # Beside one that explains the drawing a careless look at others will do.
            doubt_rms = CLOSER_LOOK_RMS
        return reading

    clash = find_clash(core, effort)
    together = None if clash.culprits else _without_several(core, rest)
    if together is not None:
        return together
    blamed = blame_for_clash(core, clash, attempt)
    first = blamed.ids[0]
    lifted = rest.lifted(first)
    if lifted is None and not effort.stopped:
        lifted = rest.lifted(*_several_culprits(core, first, effort))
    return None if lifted is None or lifted.doubtful else lifted, blamed


def _without_several(core: SketchGraph, rest: _Rest) -> tuple[Lifted, Blame] | None:
    """The shape without a few that are false together, where the drawing shows which these are."""
    ids: list[str] = []
    for id_ in false_together(core, rest.effort)[:MAX_CULPRITS]:
        ids.append(id_)
        if len(ids) > 1 and not disagree(without(core, *ids)):
            lifted = rest.lifted(*ids)
            if lifted is not None and not lifted.doubtful:
                return lifted, blame_for_several(tuple(ids))
    return None


def _several_culprits(core: SketchGraph, first: str, effort: Effort) -> list[str]:
    """More and more annotations taken away, until the rest agrees."""
    ids = [first]
    if len(core.edges) + len(core.annotations) > MANY_SAID:
        return ids
    while len(ids) < MAX_CULPRITS and disagree(without(core, *ids)) and not effort():
        ids.append(find_clash(without(core, *ids), effort).ids[0])
    return ids


@dataclass(frozen=True, slots=True, eq=False)
class _Rest:
    """The sketch without some annotations, lifted from nothing: each such shape once."""

    core: SketchGraph
    effort: Effort
    known: dict[tuple[str, ...], Lifted | None] = field(default_factory=dict)

    def lifted(self, *ids: str, doubt_rms: float = DOUBTFUL_RMS) -> Lifted | None:
        """None where the others clash as well, or are too many; doubtful where that is missed."""
        if ids not in self.known:
            self.known[ids] = self._lifted(without(self.core, *ids), doubt_rms)
        return self.known[ids]

    def _lifted(self, rest: SketchGraph, doubt_rms: float) -> Lifted | None:
        structure = build_structure(rest)
        if disagree(rest) or structure.n_coordinates > MAX_COORDINATES:
            return None
        conditions = conditions_of(rest, structure)
        if conditions * structure.n_coordinates > MAX_NUMBERS:
            return None
        self.effort.weigh(structure.n_coordinates, conditions)
        return lift(rest, structure, self.effort, doubt_rms=doubt_rms)
