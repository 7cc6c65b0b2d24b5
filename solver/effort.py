"""How long a solve may go on, counted in work and not in time: verdicts are the same everywhere.

A unit is about a millisecond on a usual machine. The same count tells how far a solve is.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial

from .values import Progress, Stop

#: A solve ends after so much work.
MAX_EFFORT = 2000.0
#: An iteration costs a little by itself, and more with the square of its unknowns and conditions.
ITERATION, BY_SIZE = 0.3, 1.5e-4
#: And where conditions are left, each point is put back onto them in several steps.
RESTORING = 1.0
#: The same where all else is eliminated beforehand, as where parts float.
LIGHT, BY_UNKNOWN = 0.3, 1e-4
#: To ask whether annotations agree costs a little by itself, and more with what was drawn and said.
QUESTION, BY_ELEMENT = 1.0, 0.007
MAX_ASKING = 1000.0
#: What guesses may take, and a last descent, however much was done before.
GUESSING, LAST_EFFORT = 800.0, 300.0
#: After so much work a solve is said to be halfway; few need more.
HALFWAY = 100.0
#: Progress is told after so much more work.
WORTH_TELLING = 25.0


class Effort:
    """Asked between iterations whether to stop: when somebody wants it, or after enough work.

    Parameters
    ----------
    stop : callable or None
        Whether somebody wants it.
    tell : callable or None
        Told how far the solve is.
    """

    def __init__(self, stop: Stop | None, tell: Progress | None = None) -> None:
        self._stop, self._tell = stop, tell
        self._done, self._most = 0.0, MAX_EFFORT
        self._each = ITERATION
        self._what, self._told, self._told_at = "", 0.0, 0.0
        #: Whether somebody stopped it.
        self.stopped = False

    def weigh(self, unknowns: int, conditions: int) -> None:
        """From now on iterations are over so many unknowns and conditions."""
        restoring = RESTORING if conditions else 0.0
        self._each = ITERATION + BY_SIZE * (unknowns + conditions) ** 2 + restoring

    @contextmanager
    def at_most(self, work: float) -> Iterator[None]:
        """Within, an end comes after so much more work: the rest is for what follows."""
        most, self._most = self._most, min(self._most, self._done + work)
        try:
            yield
        finally:
            self._most = most

    def allow_a_last_descent(self) -> None:
        """Where all was spent on looking around, what was found is finished all the same."""
        self._most = max(self._most, self._done + LAST_EFFORT)

    def doing(self, what: str, least: float = 0.0) -> None:
        """Say what is being done now, and how far the solve is at least."""
        self._what = what
        self._say(max(least, self._told))

    def __call__(self) -> bool:
        """Whether to stop."""
        return self.after(self._each)

    def after(self, work: float) -> bool:
        """Whether to stop, after so much work of another kind."""
        self._done += work
        if self._tell is not None and self._done > self._told_at + WORTH_TELLING:
            # The beginning and the end are told by themselves.
            self._say(max(self._told, 0.1 + 0.8 * self._done / (self._done + HALFWAY)))
        self.stopped = self.stopped or (self._stop is not None and self._stop())
        return self.stopped or self._done > self._most

    def _say(self, done: float) -> None:
        self._told, self._told_at = done, self._done
        if self._tell is not None:
            self._tell(done, self._what)


def counting(stop: Stop | None, unknowns: int) -> Stop:
    """The same, asked between iterations over so many unknowns and few conditions each."""
    if isinstance(stop, Effort):
        return partial(stop.after, LIGHT + BY_UNKNOWN * unknowns**2)
    return stop or (lambda: False)


def asking(stop: Stop | None, elements: int) -> Stop:
    """The same, asked between questions whether so many annotations and edges agree."""
    if isinstance(stop, Effort):
        return partial(stop.after, QUESTION + BY_ELEMENT * elements)
    return stop or (lambda: False)


def questions_within_reason(elements: int) -> int:
    """How often it may be asked whether annotations agree, for so many edges and annotations."""
    return max(1, int(MAX_ASKING / (QUESTION + BY_ELEMENT * elements)))
