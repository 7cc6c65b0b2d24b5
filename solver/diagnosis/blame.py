"""Who is to blame when a sketch does not fit together: solved again without each suspect.

Terms
-----
reading
    A solve with some of the annotations: how far it stays from the drawing, with how many freedoms.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np
from scipy.special import fdtrc

from .suspects import HAND_SIGMA

#: Suspects that are tried: always, at most, and where none of these explains the drawing. What
#: says much may be given up instead of what says little and is false: both are asked.
LEAST_TRIED, MAX_TRIED, MOST_TRIED = 2, 4, 12
COMPARABLE = 0.25
#: An annotation counts as contradicting the drawing where chance would do as much with this
#: probability, and the drawing is missed by at least this part of its diagonal (RMS): half a pixel.
#: Where how people draw is counted in, this is the chance that any one of all does so.
CHANCE, CHANCE_AS_DRAWN = 1e-5, 0.01
NOTICEABLE = 0.005
#: Among many vertices as well a few that are off: as much as eight would be by that.
NOTICEABLE_FALL = 8 * NOTICEABLE**2
#: Less is noticed, down to a tenth of a pixel, where the drawing is met so many times better
#: without.
LEAST_NOTICEABLE, CLEARLY = 0.0001, 2.0
#: Of two readings the one with more freedoms follows a drawing better; by chance alone so much
#: better with at least this probability.
USUAL_CHANCE = 0.01
#: How many observations the knowledge of how people draw counts for.
USUAL_COUNT = 6
#: A careless hand strays so far.
CARELESS = 0.012
#: Drawings are no better than this, in parts of their diagonal.
FINEST = 1e-5


@dataclass(frozen=True, slots=True, eq=False)
class Reading:
    """A solve and how well it follows the drawing.

    Parameters
    ----------
    misfit : float
        Sum of squares in parts of the drawing's diagonal.
    n_observed : int
        Numbers drawn.
    n_free : int
        Numbers that were free to follow them.
    plausible : bool
        False where it is seen from below, sinks into the ground or did not end well.
    converged : bool
    """

    misfit: float
    n_observed: int
    n_free: int
    plausible: bool
    converged: bool

    @property
    def rms(self) -> float:
        """Distance from the drawing, RMS over the vertices, in parts of its diagonal."""
        return float(np.sqrt(2 * self.misfit / max(1, self.n_observed)))

    @property
    def explains(self) -> bool:
        """Whether the drawing is followed as well as a hand can be expected to draw."""
        return self.plausible and self.rms < CARELESS

    @property
    def information(self) -> float:
        """Bayesian information: small for readings that follow the drawing with few freedoms."""
        n = self.n_observed
        floor = n * FINEST**2
        return float(n * np.log((self.misfit + floor) / n) + self.n_free * np.log(max(2, n)))


def convict(
    suspects: Iterable[tuple[str, float]],
    attempt: Callable[[str], Reading | None],
    *,
    afresh: bool = False,
) -> list[tuple[str, Reading]]:
    """Try suspects in turn; the best readings first.

    Parameters
    ----------
    suspects : iterable of (annotation id, weight)
        The most suspicious first; of equals the first stays first. One that weighs much less than
        the first is tried only if those before it were not to blame.
    attempt : callable
        Solves without one annotation.
    afresh : bool
        Whether attempts are soon over where they lead nowhere, so that more may be made.
    """
    tried: list[tuple[str, Reading]] = []
    heaviest = 0.0
    for k, (id_, weight) in enumerate(list(suspects)[: MOST_TRIED if afresh else MAX_TRIED]):
        heaviest = max(heaviest, weight)
        late = (weight < COMPARABLE * heaviest and k >= LEAST_TRIED) or k >= MAX_TRIED
        if late and any(r.explains for _, r in tried):
            break
        reading = attempt(id_)
        if reading is not None:
            tried.append((id_, reading))
    return best_first(tried)


def best_first(tried: Iterable[tuple[str, Reading]]) -> list[tuple[str, Reading]]:
    """Readings that can be before others; those that follow with least freedom first."""
    return sorted(tried, key=lambda t: (not t[1].plausible, t[1].information))


def contradicts(whole: Reading, part: Reading, among: int) -> bool:
    """Whether leaving an annotation out brings more than chance would (F tests).

    The misfit without it is measured against what is left over, and, as small sketches leave little
    over, against how people draw.

    Parameters
    ----------
    whole, part : Reading
        With it and without.
    among : int
        How many annotations might have been left out: of many some one fits better by chance.
    """
    freed = max(1, part.n_free - whole.n_free)
    spare = part.n_observed - part.n_free
    fall = max(whole.misfit - part.misfit, 0.0)
    seen = (
        whole.rms > NOTICEABLE
        or fall > NOTICEABLE_FALL
        or whole.rms > max(LEAST_NOTICEABLE, CLEARLY * part.rms)
    )
    if not part.plausible or spare < 1 or not seen:
        return False
    gain = fall / freed
    left = part.misfit + part.n_observed * FINEST**2
    usual = (HAND_SIGMA**2 / 2 * USUAL_COUNT + left) / (USUAL_COUNT + spare)
    by_itself = fdtrc(freed, spare, gain / (left / spare))
    as_drawn = fdtrc(freed, USUAL_COUNT + spare, gain / usual)
    return bool(by_itself < CHANCE or as_drawn < CHANCE_AS_DRAWN / max(1, among))


def as_well(less: Reading, more: Reading) -> bool:
    """Whether a reading with fewer freedoms follows a drawing as well as chance lets one expect."""
    freed, spare = more.n_free - less.n_free, more.n_observed - more.n_free
    if freed < 1 or spare < 1 or not less.plausible:
        return False
    left = more.misfit + more.n_observed * FINEST**2
    gain = max(less.misfit - more.misfit, 0.0) / freed
    return bool(fdtrc(freed, spare, gain / (left / spare)) > USUAL_CHANCE)
