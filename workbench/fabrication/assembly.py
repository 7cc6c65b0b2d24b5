"""The order in which plates go together, found by taking them apart.

The words are those of `blocking`; plates that block one another along every way are locked.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from ...solver.values import Array
from .blocking import Blocking
from .errors import FabricationError
from .plates import Plate


class LockedError(FabricationError):
    """The plates cannot be put together; its ids are those that lock each other."""


@dataclass(frozen=True, slots=True, eq=False)
class Step:
    """Plates that are put on together.

    Parameters
    ----------
    plate_ids : tuple of str
    way : (3,) array
        The direction in which they move into their place, in the world.
    onto : tuple of str
        The plates that are there already; empty for the first.
    """

    plate_ids: tuple[str, ...]
    way: Array
    onto: tuple[str, ...]

    @property
    def words(self) -> str:
        """One line about it."""
        what = " and ".join(self.plate_ids)
        if not self.onto:
            return f"begin with {what}"
        x, y, z = (np.round(self.way, 2) + 0.0).tolist()
        return f"put {what} on, moving along ({x:+.2f}, {y:+.2f}, {z:+.2f})"


def assembly_steps(plates: Sequence[Plate]) -> tuple[Step, ...]:
    """The order in which plates go together.

    Parameters
    ----------
    plates : sequence of Plate

    Returns
    -------
    tuple of Step
        Each puts one plate, or a group put together before, onto what is there.

    Raises
    ------
    LockedError
        Naming plates that lock each other.
    """
    blocking = Blocking(plates)
    ids = [plate.id for plate in plates]
    steps: list[Step] = []

    def take_apart(some: Sequence[int]) -> None:
        """Add the last steps first: what leaves last is what one begins with."""
        rest = list(some)
        while len(rest) > 1:
            found = blocking.loose(rest)
            if found is None:
                raise _locked(blocking, ids, rest)
            way, group = found
            rest = [n for n in rest if n not in group]
            names, onto = (tuple(ids[n] for n in part) for part in (group, rest))
            steps.append(Step(names, -blocking.ways[way], onto))
            if len(group) > 1:
                take_apart(group)
        steps.append(Step(tuple(ids[n] for n in rest), np.zeros(3), ()))

    take_apart(range(len(plates)))
    return tuple(reversed(steps))


def exploded(
    plates: Sequence[Plate], steps: Sequence[Step], gap_mm: float | None = None
) -> tuple[Plate, ...]:
    """The plates moved apart the way they come off.

    Parameters
    ----------
    plates : sequence of Plate
    steps : sequence of Step
        What `assembly_steps` said of them.
    gap_mm : float or None
        How far each group moves from what it was on; None takes a fifth of the whole size.

    Returns
    -------
    tuple of Plate
        In the same order, with other places in the world.
    """
    points = np.vstack([plate.corners_mm for plate in plates])
    gap = 0.2 * float(np.ptp(points, axis=0).max()) if gap_mm is None else gap_mm
    moves = {plate.id: np.zeros(3) for plate in plates}
    for step in steps:
        for id_ in step.plate_ids if step.onto else ():
            moves[id_] = moves[id_] - gap * step.way
    result = []
    for plate in plates:
        place = plate.world_from_plate.copy()
        place[:3, 3] += moves[plate.id]
        result.append(replace(plate, world_from_plate=place))
    return tuple(result)


def _locked(blocking: Blocking, ids: Sequence[str], some: Sequence[int]) -> LockedError:
    """The fewest plates that lock each other, as an error."""
    for size in (2, 3):
        for few in combinations(some, size):
            if blocking.loose(few) is None:
                return _locked_error([ids[n] for n in few])
    return _locked_error([ids[n] for n in some])


def _locked_error(ids: Sequence[str]) -> LockedError:
    words = f"{', '.join(ids[:-1])} and {ids[-1]}"
    return LockedError(
        f"cannot be put together: {words} lock each other", (), "a butt joint between them"
    )
