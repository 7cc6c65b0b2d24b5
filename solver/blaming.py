"""Who is to blame where the annotations do not fit together or not to the drawing.

Where annotations clash whatever the drawing, reasoning alone finds them (`blame_for_clash`). Else
two ways lead to suspects, the second only where the first was not enough: what each annotation
keeps the shape from (`blame_by_relief`), and what gives way first where all of them are springs
(`find_blame`). Whoever is suspected is left out and the rest solved (`trials`): only what that
shows is evidence.

Terms
-----
blame
    The annotations that contradict the rest, and the sentence that says so.
whole
    The reading with all annotations, against which those without one are held.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from .annotations import Angle, Diameter, Length, targets_of
from .candidates import Candidate, drawing_rms, drawn_diagonal, lift_near, reading_of
from .closer_look import BARELY, DOUBTFUL_RMS, Hint, hints
from .diagnosis import (
    MAX_TRIED,
    Clash,
    KnownShape,
    Reading,
    as_well,
    best_first,
    contradicts,
    convict,
    freedoms,
    relax,
)
from .graph import SketchGraph
from .problem import Problem
from .trials import Trials, is_far
from .values import Stop

#: Further from the drawing than this nobody draws: an annotation that asks for it is not true.
GROSS_RMS = 0.03
#: So many are named where none is proved to be false.
MOST_SUSPECTS = 3
#: Where a drawing is met so well (RMS, parts of its diagonal), it does not lean.
CLEAR_RMS = 0.0035
#: Who is expected to explain less than this part of what was expected of one who then explained all
#: of it is not tried any more.
RIVAL = 0.5
#: Of two readings whose information differs by less neither explains a drawing better.
TIE = 0.5


@dataclass(frozen=True, slots=True)
class Blame:
    """What contradicts the rest.

    Parameters
    ----------
    ids : tuple of annotation ids
        Most to blame first.
    message : str
        A sentence for people.
    held : bool
        Whether all annotations hold all the same, and only the drawing is not followed.
    best : Reading or None
        Without the first, where that was solved.
    explains : bool
        Whether the drawing is followed without it, and nothing speaks against the rest any more.
    clear : bool
        Whether that is so at the price of one number, and so well that no lean does as much.
    """

    ids: tuple[str, ...]
    message: str
    held: bool
    best: Reading | None = None
    explains: bool = False
    clear: bool = False

    @property
    def information(self) -> float:
        """Of the best reading (`Reading.information`)."""
        return math.inf if self.best is None else self.best.information

    @property
    def is_barely_checked(self) -> bool:
        """Whether so much was left open that a search may have ended at another shape."""
        if self.best is None:
            return False
        return self.best.n_observed - self.best.n_free < BARELY * self.best.n_observed


def blame_by_relief(graph: SketchGraph, lifted: Candidate, trials: Trials) -> Blame | None:
    """Which annotation keeps a shape from the drawing, where leaving it out shows that at once.

    Parameters
    ----------
    graph : SketchGraph
    lifted : Candidate
        The best shape found so far.
    trials : Trials
        Gets more.
    """
    whole, known = reading_of(graph, lifted), KnownShape.at(lifted.full, lifted.minimum.x)
    expected: dict[str, float] = {}
    for hint in hints(graph, lifted, whole)[:MAX_TRIED]:
        expected[hint.id] = whole.misfit - hint.reading.misfit
        found = trials.best if trials.explained(whole) else None
        if found is None or expected[hint.id] > RIVAL * expected.get(found[0], 0.0):
            _try(hint, whole, known, trials)
    trials.settle_the_best()
    if is_far(whole) and trials.explained(whole):
        # From here the shape without a rival may be out of reach.
        trials.lost_ones_afresh(whole)
    return _verdict(graph, lifted.problem, whole, trials)


def _try(hint: Hint, whole: Reading, known: KnownShape, trials: Trials) -> None:
    """From nearby, or from nothing where that is far away or does not explain what it should."""
    near = None if whole.rms > DOUBTFUL_RMS else trials.near(hint.id, known)
    if is_far(whole) and (near is None or (hint.reading.explains and not near.explains)):
        trials.anew(hint.id)


def find_blame(
    graph: SketchGraph, lifted: Candidate, trials: Trials, *, lost: bool
) -> Blame | None:
    """Which annotation gives way where all may, and contradicts the drawing and the others.

    Parameters
    ----------
    graph : SketchGraph
    lifted : Candidate
        The best shape found so far.
    trials : Trials
        Gets more.
    lost : bool
        Whether the best shape is so bad that it is no place to look around from.
    """
    whole = reading_of(graph, lifted)
    for relaxed in relax(graph, lifted.problem, lifted.minimum.x, trials.stop, lost=lost):
        near = partial(trials.near, known=relaxed.shape)
        convict([(s.id, s.weight) for s in relaxed.suspects], near)
        trials.settle_the_best()
        if not is_far(whole) or trials.explained(whole):
            break
    if is_far(whole):
        trials.lost_ones_afresh(whole)
    return _verdict(graph, lifted.problem, whole, trials)


def _verdict(graph: SketchGraph, problem: Problem, whole: Reading, trials: Trials) -> Blame | None:
    """Who the trials show to be to blame, if anybody."""
    against = _against(graph, whole, trials)
    # With the right shape in sight, perhaps all annotations hold.
    near = trials.shapes[against[0][0]] if against else None
    again = None if near is None else _reading_again(graph, near, trials.stop)
    if again is not None and again.misfit < whole.misfit:
        whole, against = again, _against(graph, again, trials)
        if not against and is_far(whole):
            trials.lost_ones_afresh(whole)
            against = _against(graph, whole, trials)
    return _blame(graph, problem, whole, against, trials.explained(whole)) if against else None


def _against(graph: SketchGraph, whole: Reading, trials: Trials) -> list[tuple[str, Reading]]:
    """Annotations that the drawing speaks against, and the readings without them, best first."""
    return [
        (id_, reading)
        for id_, reading in best_first(trials.readings.items())
        if reading.rms < GROSS_RMS
        and contradicts(whole, reading, len(graph.annotations))
        and not trials.leaves_open(id_)
    ]


def _blame(
    graph: SketchGraph,
    problem: Problem,
    whole: Reading,
    against: list[tuple[str, Reading]],
    explains: bool,
) -> Blame:
    best = against[0][1]
    clear = explains and best.rms < CLEAR_RMS and best.n_free <= whole.n_free + 1
    fall = whole.information - best.information
    named = [(id_, r) for id_, r in against if whole.information - r.information > fall / 2]
    ids = tuple(id_ for id_, _ in likeliest_first(graph, named))
    px = drawn_diagonal(problem) * problem.px_per_unit
    missed = (
        f"with it the drawing is missed by {_few_digits(whole.rms * px)} px, "
        f"without it by {_few_digits(best.rms * px)} px"
    )
    remedy = f"Correct {_or(ids)}, or take it away."
    wish = isinstance(graph.annotations[ids[0]], Length | Diameter | Angle)
    if whole.converged and (wish or whole.rms < GROSS_RMS):
        return Blame(
            ids,
            f"Solved, but {_or(ids)} contradicts the drawing: {missed}. {remedy}",
            True,
            best=best,
            explains=explains,
            clear=clear,
        )
    return Blame(
        ids,
        f"{_or(ids)} contradicts the rest: {missed}. Solved without {ids[0]}. {remedy}",
        False,
        best=best,
        explains=explains,
        clear=clear,
    )


def likeliest_first(
    graph: SketchGraph, tried: list[tuple[str, Reading]]
) -> list[tuple[str, Reading]]:
    """Readings by what was left out, the likeliest falsehood first.

    Where the drawing tells two apart by no more than chance, what leaves less open comes first,
    then a wish, then what says less.

    Parameters
    ----------
    graph : SketchGraph
    tried : list of (annotation id, Reading)
        The best reading first.
    """

    def order(named: tuple[str, Reading]) -> tuple[float, int, float, bool, int]:
        (id_, reading), best = named, tried[0][1]
        annotation, more = graph.annotations[id_], reading.information - best.information
        beyond = 0.0 if more < TIE else more
        rival = reading.n_free == best.n_free or as_well(reading, best)
        elements = sum(len(ids) for ids in targets_of(annotation).values())
        wish = isinstance(annotation, Length | Diameter | Angle)
        return (0.0 if rival else beyond, reading.n_free, beyond, not wish, elements)

    return sorted(tried, key=order)


def suspicion(graph: SketchGraph, lifted: Candidate, stop: Stop) -> Blame | None:
    """What to look at first where the drawing is grossly missed and nothing explains why."""
    rms = drawing_rms(lifted)
    names = [*graph.vertices, *graph.circles]
    if rms <= GROSS_RMS or freedoms(lifted.full, lifted.minimum.x, names).count:
        return None
    relaxed = next(relax(graph, lifted.problem, lifted.minimum.x, stop, lost=True), None)
    if relaxed is None or not relaxed.suspects:
        return None
    ids = tuple(s.id for s in relaxed.suspects[:MOST_SUSPECTS])
    px = rms * drawn_diagonal(lifted.problem) * lifted.problem.px_per_unit
    return Blame(ids, f"Solved, but the drawing is missed by {px:.0f} px: check {_or(ids)}.", True)


def blame_for_several(ids: tuple[str, ...]) -> Blame:
    """What is said of a few that are false together."""
    return Blame(ids, f"{_and(ids)} cannot hold with the rest: try removing them.", False)


def blame_for_clash(
    graph: SketchGraph, clash: Clash, attempt: Callable[[str], Reading | None]
) -> Blame:
    """Whom to blame where annotations cannot all hold, whatever the drawing."""
    several = clash.culprits if len(clash.culprits) > 1 else ()
    tried = convict([(id_, 1.0) for id_ in several], attempt, afresh=True)
    ids = tuple(dict.fromkeys([*(id_ for id_, _ in likeliest_first(graph, tried)), *clash.ids]))
    if not clash.culprits:
        return Blame(ids, f"{_and(ids)} cannot all hold: take one of them away.", False)
    rest = f" together with {_and(ids[1:])}" if len(ids) > 1 else ""
    return Blame(ids, f"{ids[0]} cannot hold{rest}: try removing {ids[0]}.", False)


def blame_for_wishes(graph: SketchGraph, ids: tuple[str, ...], whole: Candidate) -> Blame:
    """What is said where sizes hold though the drawing shows others."""
    missed = reading_of(graph, whole).rms * drawn_diagonal(whole.problem)
    px = missed * whole.problem.px_per_unit
    missed_px = _few_digits(px)
    words = f"Solved, but {_or(ids)} contradicts the drawing, which is missed by {missed_px} px."
    return Blame(ids, words, True)


def _reading_again(graph: SketchGraph, other: Candidate, stop: Stop) -> Reading | None:
    """All annotations, begun from a shape without one of them."""
    found = lift_near(graph, KnownShape.at(other.full, other.minimum.x), stop)
    return None if found is None else reading_of(graph, found)


def _few_digits(px: float) -> str:
    """As people read it: no more than a tenth of a pixel, no exponent."""
    return f"{px:.0f}" if px >= 10 else f"{round(px, 1):g}"


def _or(ids: tuple[str, ...]) -> str:
    return " or ".join(ids)


def _and(ids: tuple[str, ...]) -> str:
    if len(ids) < 2:
        return "".join(ids)
    return f"{', '.join(ids[:-1])} and {ids[-1]}"
