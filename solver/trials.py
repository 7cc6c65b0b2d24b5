"""Solves without one annotation each, from which it is seen who is to blame.

Terms
-----
trial
    A solve without one annotation: from a shape that is known (near), or from nothing (afresh).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from .candidates import Candidate, lift_near, reading_of
from .closer_look import AS_DRAWN, hints
from .diagnosis import KnownShape, Reading, best_first, contradicts, is_undecided, without
from .graph import SketchGraph
from .values import Stop

#: A descent that is not at its end goes on while it takes so much off: where a shape hardly holds,
#: hundreds of steps lead to it.
GETS_ON = 0.9
Afresh = Callable[[str], Candidate | None]


def is_far(whole: Reading) -> bool:
    """Whether the drawing is missed by more than hands miss it: something has to be wrong."""
    return whole.rms > AS_DRAWN


@dataclass(frozen=True, slots=True, eq=False)
class Trials:
    """The best that was found without each annotation, whatever it was begun from.

    Parameters
    ----------
    graph : SketchGraph
        With all annotations.
    stop : callable
    afresh : callable
        Solves without an annotation, from nothing: where the drawing is missed by far, and from
        where all give way no shape is found.
    shapes, readings : dict by annotation id
        What was found; no reading where nothing was.
    """

    graph: SketchGraph
    stop: Stop
    afresh: Afresh
    shapes: dict[str, Candidate | None] = field(default_factory=dict)
    readings: dict[str, Reading] = field(default_factory=dict)
    _alone: dict[Candidate, bool] = field(default_factory=dict)

    @property
    def best(self) -> tuple[str, Reading] | None:
        """The annotation without which the drawing is followed best."""
        return next(iter(best_first(self.readings.items())), None)

    def explained(self, whole: Reading) -> bool:
        """Whether leaving out the best is all that it takes to follow the drawing."""
        if self.best is None or not self._tells(self.best[1], whole):
            return False
        id_, reading = self.best
        shape = self.shapes[id_]
        if shape is None or (shape not in self._alone and self.stop()):
            return False
        if shape not in self._alone:
            self._alone[shape] = not hints(without(self.graph, id_), shape, reading)
        return self._alone[shape]

    def _tells(self, reading: Reading, whole: Reading) -> bool:
        """Whether the drawing is followed, and better than by chance."""
        return reading.explains and contradicts(whole, reading, len(self.graph.annotations))

    def leaves_open(self, id_: str) -> bool:
        """Whether it was only an annotation that fixes what is open without it."""
        shape = self.shapes[id_]
        return shape is not None and is_undecided(self.graph, id_, shape.full, shape.minimum.x)

    def near(self, id_: str, known: KnownShape) -> Reading | None:
        """Begun from a shape that is known."""
        if self.stop():
            return None
        return self._seen(id_, lift_near(without(self.graph, id_), known, self.stop))

    def anew(self, id_: str) -> Reading | None:
        """Begun from nothing."""
        return None if self.stop() else self._seen(id_, self.afresh(id_))

    def settle_the_best(self) -> None:
        """Brought to its end, as long as that gets it on."""
        if self.best is None:
            return
        id_, _ = self.best
        rest, near = without(self.graph, id_), self.shapes[id_]
        while near is not None and not near.minimum.converged and not self.stop():
            before = near.minimum.cost
            near = lift_near(rest, KnownShape.at(near.full, near.minimum.x), self.stop)
            if near is not None and near.minimum.cost < before:
                self.shapes[id_], self.readings[id_] = near, reading_of(rest, near)
            if near is None or not near.minimum.cost < GETS_ON * before:
                return

    def lost_ones_afresh(self, whole: Reading) -> None:
        """Begun from nothing where no good shape was found nearby, until one explains the drawing.

        Where one does already, the others only if it leaves more open than one number, with which
        much is explained.
        """
        explained = self.explained(whole)
        if explained and self.best is not None and self.best[1].n_free <= whole.n_free + 1:
            return
        for id_ in list(self.shapes):
            reading = self.readings.get(id_)
            if self.stop() or (reading is not None and self._tells(reading, whole)):
                continue
            again = self.anew(id_)
            if not explained and again is not None and self._tells(again, whole):
                break

    def _seen(self, id_: str, found: Candidate | None) -> Reading | None:
        reading = None if found is None else reading_of(without(self.graph, id_), found)
        known = self.readings.get(id_)
        if reading is not None and (known is None or _is_better(reading, known)):
            self.shapes[id_], self.readings[id_] = found, reading
        self.shapes.setdefault(id_, found)
        return self.readings.get(id_)


def _is_better(one: Reading, other: Reading) -> bool:
    return best_first([("", other), ("", one)])[0][1] is one
