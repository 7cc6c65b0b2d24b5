"""How long a solve may go on, counted in work and not in time: verdicts are the same everywhere.

A unit is about a millisecond on a usual machine.
"""

from __future__ import annotations

from .values import Stop

#: A solve ends after so much work.
MAX_EFFORT = 1500.0
#: An iteration costs a little by itself, and more with the square of its unknowns and conditions.
ITERATION, BY_SIZE = 0.3, 1.5e-4
#: To ask whether annotations agree costs a little by itself, and more with what was drawn and said.
QUESTION, BY_ELEMENT = 1.0, 0.007
MAX_ASKING = 1000.0


class Effort:
    """Asked between iterations whether to stop: when somebody wants it, or after enough work."""

    def __init__(self, stop: Stop | None) -> None:
        self._stop = stop
        self._done = 0.0
        self._each = ITERATION

    def weigh(self, size: int) -> None:
        """From now on iterations are over so many unknowns and conditions."""
        self._each = ITERATION + BY_SIZE * size**2

    def __call__(self) -> bool:
        """Whether to stop."""
        self._done += self._each
        return self._done > MAX_EFFORT or (self._stop is not None and self._stop())


def questions_within_reason(elements: int) -> int:
    """How often it may be asked whether annotations agree, for so many edges and annotations."""
    return max(1, int(MAX_ASKING / (QUESTION + BY_ELEMENT * elements)))
