"""What a sketch is solved to when its annotations do not fit together or not to the drawing.

Terms
-----
blame
    The annotations that contradict the rest, and the sentence that says so.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from .annotations import Angle, Diameter, Length, targets_of
from .candidates import Candidate, drawing_rms, drawn_diagonal, lift_near, reading_of
from .diagnosis import (
    MANY_UNKNOWNS,
    MAX_TRIED,
    MAX_UNKNOWNS,
    Clash,
    KnownShape,
    Reading,
    as_well,
    best_first,
    contradicts,
    convict,
    freedoms,
    is_undecided,
    leftover_suspects,
    relax,
    reliefs,
    without,
)
from .graph import SketchGraph
from .least_squares import EXACT_COST
from .problem import Problem
from .values import Stop

#: A first view that misses the drawing by this part of its diagonal (RMS) makes doubtful whether
#: the annotations are true; a result that does so is looked at more closely.
DOUBTFUL_RMS, CLOSER_LOOK_RMS, SMALL_LOOK_RMS = 0.03, 0.012, 0.0095
#: Hands draw so well: what is missed by more, or by so little that nobody drew it, is worth the
#: question what each annotation keeps the shape from, which takes longer than all else.
ALL_BUT_EXACT, AS_DRAWN = 0.0015, 0.0055
#: So much has to speak against an annotation for a closer look (Bayesian information).
SUSPICIOUS = 12.0
#: Further from the drawing than this nobody draws: an annotation that asks for it is not true.
GROSS_RMS = 0.03
#: So many are named where none is proved to be false.
MOST_SUSPECTS = 3
#: Where a drawing is met so well (RMS, parts of its diagonal), it does not lean.
CLEAR_RMS = 0.0035
#: Without what is blamed so much of the misfit goes, at least, to first order from far away.
WORTH_A_TRY = 0.05
#: Readings whose information differs by less explain a drawing equally well.
TIE = 0.5
#: Of what is drawn so small a part, left over to check a shape, leaves several that nearly fit.
BARELY = 0.25
#: A descent that is not at its end goes on while it takes so much off: where a shape hardly holds,
#: hundreds of steps lead to it.
GETS_ON = 0.9
Afresh = Callable[[str], Candidate | None]


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


def is_doubtful(graph: SketchGraph, lifted: Candidate) -> bool:
    """Whether a first view misses the drawing so far that some annotation may be false."""
    n = 2 * lifted.full.n_vertices + lifted.problem.circles.supports.size
    rms = np.sqrt(2 * lifted.minimum.cost / max(1, n)) / drawn_diagonal(lifted.problem)
    return bool(rms > DOUBTFUL_RMS)


def needs_a_closer_look(graph: SketchGraph, lifted: Candidate, *, dragging: bool = False) -> bool:
    """Whether a result is so far from the drawing, or an annotation so suspicious.

    Small sketches hide a false annotation most easily and are soonest looked at; while one is
    dragged, what was found before stays.
    """
    if lifted.minimum.cost <= EXACT_COST and lifted.minimum.converged:
        return False
    problem = lifted.problem
    small = 3 * (len(problem.points) + len(problem.circles)) <= MANY_UNKNOWNS
    far = SMALL_LOOK_RMS if small and not dragging else CLOSER_LOOK_RMS
    rms = drawing_rms(lifted)
    if rms > far:
        return True
    if dragging or _is_large(lifted) or ALL_BUT_EXACT < rms < AS_DRAWN:
        found = leftover_suspects(graph, lifted.full, lifted.minimum.x)
        return bool(found) and found[0].weight > SUSPICIOUS
    return bool(relieving(graph, lifted, reading_of(graph, lifted)))


def _is_large(lifted: Candidate) -> bool:
    return 3 * (len(lifted.problem.points) + len(lifted.problem.circles)) > MAX_UNKNOWNS


def relieving(
    graph: SketchGraph, lifted: Candidate, whole: Reading, *, far: bool = False
) -> list[tuple[str, float]]:
    """Annotations without which, to first order, the drawing is met better than chance allows.

    Parameters
    ----------
    graph : SketchGraph
    lifted : Candidate
    whole : Reading
        Of it.
    far : bool
        Whether chance may do as much, for from far away first order tells little.

    Returns
    -------
    list of (annotation id, part of the misfit that goes)
        The likeliest first.
    """
    unit = drawn_diagonal(lifted.problem) ** 2 * max(whole.misfit, 1e-300)
    found, among = [], len(graph.annotations)
    enough: dict[int, bool] = {}
    for relief in reliefs(graph, lifted.full, lifted.minimum.x):
        freed = max(1, relief.freed)
        if not enough.get(freed, True):
            # The largest come first, and one that gained more at the same price was not enough.
            continue
        goes = min(relief.gain / unit, 1.0)
        n_free = whole.n_free + freed
        misfit = whole.misfit * (1 - goes)
        part = replace(whole, misfit=misfit, n_free=n_free, plausible=True, converged=True)
        enough[freed] = (far and goes > WORTH_A_TRY) or contradicts(whole, part, among)
        if enough[freed]:
            found.append((part.information, relief.id, goes))
    return [(id_, goes) for _, id_, goes in sorted(found)]


def blame_by_relief(
    graph: SketchGraph, lifted: Candidate, stop: Stop, afresh: Afresh
) -> Blame | None:
    """Which annotation keeps a shape from the drawing, where leaving it out shows that at once.

    Parameters
    ----------
    graph : SketchGraph
    lifted : Candidate
        The best shape found so far.
    stop, afresh : callable
        As for `find_blame`.
    """
    whole = reading_of(graph, lifted)
    trials = _Trials(graph, whole, KnownShape.at(lifted.full, lifted.minimum.x), stop, afresh)
    for id_, _ in relieving(graph, lifted, whole, far=trials.far)[:MAX_TRIED]:
        trials.near(id_)
    trials.settle_the_best()
    if trials.far and trials.explained():
        # From here the shape without a rival may be out of reach.
        trials.lost_ones_afresh()
    return _blame_of(graph, lifted.problem, trials)


def find_blame(
    graph: SketchGraph, lifted: Candidate, stop: Stop, afresh: Afresh, *, lost: bool
) -> Blame | None:
    """Which annotation contradicts the drawing and the others, if one does.

    Parameters
    ----------
    graph : SketchGraph
    lifted : Candidate
        The best shape found so far.
    stop : callable
    afresh : callable
        Solves without an annotation, from nothing: where the drawing is missed by far, and from
        where all give way no shape is found.
    lost : bool
        Whether the best shape is so bad that it is no place to look around from.
    """
    whole, shape = reading_of(graph, lifted), KnownShape.at(lifted.full, lifted.minimum.x)
    trials = _Trials(graph, whole, shape, stop, afresh)
    for relaxed in relax(graph, lifted.problem, lifted.minimum.x, stop, lost=lost):
        trials = replace(trials, known=relaxed.shape)
        convict([(s.id, s.weight) for s in relaxed.suspects], trials.near)
        trials.settle_the_best()
        if not trials.far or trials.explained():
            break
    if trials.far:
        trials.lost_ones_afresh()
    return _blame_of(graph, lifted.problem, trials)


@dataclass(frozen=True, slots=True, eq=False)
class _Trials:
    """Solves without one annotation each, and what they came to."""

    graph: SketchGraph
    whole: Reading
    known: KnownShape
    stop: Stop
    afresh: Afresh
    shapes: dict[str, Candidate | None] = field(default_factory=dict)
    readings: dict[str, Reading] = field(default_factory=dict)
    alone: dict[Candidate, bool] = field(default_factory=dict)

    @property
    def far(self) -> bool:
        """Whether the drawing is missed by so much that something has to be wrong."""
        return self.whole.rms > CLOSER_LOOK_RMS

    def explained(self) -> bool:
        """Whether one of them follows the drawing, and nothing speaks against the rest any more."""
        if not any(r.explains for r in self.readings.values()):
            return False
        id_, reading = best_first(self.readings.items())[0]
        shape = self.shapes[id_]
        if shape is None:
            return False
        if shape not in self.alone:
            self.alone[shape] = not relieving(without(self.graph, id_), shape, reading)
        return self.alone[shape]

    def leaves_open(self, id_: str) -> bool:
        """Whether it was only an annotation that fixes what is open without it."""
        shape = self.shapes[id_]
        return shape is not None and is_undecided(self.graph, id_, shape.full, shape.minimum.x)

    def near(self, id_: str) -> Reading | None:
        """Begun from the shape that is known."""
        if self.stop():
            return None
        return self._seen(id_, lift_near(without(self.graph, id_), self.known, self.stop))

    def settle_the_best(self) -> None:
        """Brought to its end, as long as that gets it on."""
        if not self.readings:
            return
        id_ = best_first(self.readings.items())[0][0]
        rest, near = without(self.graph, id_), self.shapes[id_]
        while near is not None and not near.minimum.converged and not self.stop():
            before = near.minimum.cost
            near = lift_near(rest, KnownShape.at(near.full, near.minimum.x), self.stop)
            if near is not None and near.minimum.cost < before:
                self.shapes[id_], self.readings[id_] = near, reading_of(rest, near)
            if near is None or not near.minimum.cost < GETS_ON * before:
                return

    def lost_ones_afresh(self) -> None:
        """Begun from nothing where no good shape was found nearby, until one explains the drawing.

        Where one does already, the others only if it leaves more open than one number, with which
        much is explained.
        """
        explained = self.explained()
        if explained and best_first(self.readings.items())[0][1].n_free <= self.whole.n_free + 1:
            return
        for id_ in list(self.shapes):
            reading = self.readings.get(id_)
            if self.stop() or (reading is not None and reading.explains):
                continue
            again = self._seen(id_, self.afresh(id_))
            if not explained and again is not None and again.explains:
                break

    def _seen(self, id_: str, found: Candidate | None) -> Reading | None:
        reading = None if found is None else reading_of(without(self.graph, id_), found)
        if id_ not in self.readings or (reading is not None and reading.explains):
            self.shapes[id_] = found
            if reading is not None:
                self.readings[id_] = reading
        return self.readings.get(id_)


def _blame_of(graph: SketchGraph, problem: Problem, trials: _Trials) -> Blame | None:
    whole, among = trials.whole, len(graph.annotations)
    against = [
        (id_, reading)
        for id_, reading in best_first(trials.readings.items())
        if contradicts(whole, reading, among) and not trials.leaves_open(id_)
    ]
    # With the right shape in sight, perhaps all annotations hold.
    near = trials.shapes[against[0][0]] if against else None
    again = None if near is None else _reading_again(graph, near, trials.stop)
    if again is not None and again.misfit < whole.misfit:
        whole = again
        against = [(id_, r) for id_, r in against if contradicts(whole, r, among)]
    return _blame(graph, problem, whole, against, trials.explained()) if against else None


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
    wish = isinstance(graph.annotations[ids[0]], Length | Diameter | Angle)
    if whole.converged and (wish or whole.rms < GROSS_RMS):
        return Blame(
            ids,
            f"Solved, but {_or(ids)} contradicts the drawing: {missed}.",
            True,
            best=best,
            explains=explains,
            clear=clear,
        )
    return Blame(
        ids,
        f"{_or(ids)} contradicts the rest: {missed}. Solved without {ids[0]}.",
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
