"""Which plates leave which others along which way.

Terms
-----
way
    A direction along which something is taken off in a straight line.
blocked
    A plate is blocked by another along a way if it would pass through it.
group
    Plates that block one another in a circle along a way: they can leave only together.

Of all ways along which two plates in contact can part, some lie where two planes of contacts
meet: on the sphere of ways, a corner of a cell touches no more contacts than the cell does. So
these ways are tried, and the plates' normals. What faces one another tells most blocks at once; a
sweep decides only what is left.

Source: R. H. Wilson, J.-C. Latombe, Geometric reasoning about mechanical assembly (1994): the
blocking graph of a way, and its strongly connected components.
"""

from __future__ import annotations

import heapq
from collections.abc import Sequence

import manifold3d
import numpy as np
from numpy.typing import NDArray

from ...solver.values import Array
from .facing import facings
from .plates import Plate
from .sweeps import swept, together

#: Plates may touch so much while they move, mm3.
TOUCH_MM3 = 1e-3
#: By so much of a plate a group counts as smaller that leaves square to a plate: less than one.
_SQUARE = 0.5


class Blocking:
    """Which plate is blocked by which along which way, as it becomes known.

    Parameters
    ----------
    plates : sequence of Plate
    """

    def __init__(self, plates: Sequence[Plate]) -> None:
        points = np.vstack([plate.corners_mm for plate in plates])
        self._plates = plates
        self._far_mm = 2.0 * float(np.linalg.norm(np.ptp(points, axis=0)))
        self._bodies = [together(swept(plate, np.zeros(3))) for plate in plates]
        found = facings(plates)
        normals = np.array([plate.world_from_plate[:3, 2] for plate in plates])
        self.ways = _ways(normals, found.normals)
        self._squareness = np.abs(self.ways @ normals.T)
        #: What is known to be blocked: (ways, plates, plates).
        self._blocked = found.blocked(self.ways, len(plates))
        self._free: set[tuple[int, int, int]] = set()
        self._sweeps: dict[tuple[int, int], list[manifold3d.Manifold]] = {}

    def loose(self, plates: Sequence[int]) -> tuple[int, tuple[int, ...]] | None:
        """A way, and the fewest plates that can leave along it together; None where locked.

        A plate that leaves square to itself is preferred, and is seen at once.
        """
        some = np.asarray(plates)
        square = np.flatnonzero((self._squareness[:, some] > 1 - 1e-9).any(axis=1))
        found = self._smallest(square, some, most=1 - _SQUARE + 1e-6)
        return found or self._smallest(np.arange(len(self.ways)), some, most=len(some))

    def _smallest(
        self, ways: NDArray[np.int_], some: Array, most: float
    ) -> tuple[int, tuple[int, ...]] | None:
        """The smallest group that can leave along one of these ways, if it is that small.

        Groups are tried the smallest first. What then blocks one makes it larger, never smaller.
        """
        waiting = self._groups(ways, some)
        heapq.heapify(waiting)
        while waiting and waiting[0][0] < most:
            _, way, group = heapq.heappop(waiting)
            rest = [n for n in some.tolist() if n not in group]
            if not any(self._hits(way, one, other) for one in group for other in rest):
                return way, group
            for entry in self._groups(np.array([way]), some):
                heapq.heappush(waiting, entry)
        return None

    def _groups(
        self, ways: NDArray[np.int_], some: Array
    ) -> list[tuple[float, int, tuple[int, ...]]]:
        """The smallest group of each way that is not everything: size, way, plates.

        Of groups of one size that counts as smaller whose plate leaves more square to itself.
        """
        reach = self._blocked[np.ix_(ways, some, some)] | np.eye(len(some), dtype=bool)
        for n in range(len(some)):
            reach |= reach[:, :, n, None] & reach[:, None, n, :]
        # What a plate reaches has to leave with it.
        counts = reach.sum(axis=2)
        sizes = counts - _SQUARE * self._squareness[np.ix_(ways, some)]
        first = sizes.argmin(axis=1)
        groups = []
        for row in np.flatnonzero(counts.min(axis=1) < len(some)).tolist():
            group = tuple(some[reach[row, first[row]]].tolist())
            groups.append((float(sizes[row, first[row]]), int(ways[row]), group))
        return groups

    def _hits(self, way: int, one: int, other: int) -> bool:
        """Whether a plate would pass through another."""
        if self._blocked[way, one, other]:
            return True
        if (way, one, other) in self._free:
            return False
        hits = self._swept_into(way, one, other)
        if hits:
            self._blocked[way, one, other] = self._blocked[way ^ 1, other, one] = True
        else:
            self._free |= {(way, one, other), (way ^ 1, other, one)}
        return hits

    def _swept_into(self, way: int, one: int, other: int) -> bool:
        move, body = self.ways[way] * self._far_mm, self._bodies[other]
        a, b = (np.array(self._bodies[n].bounding_box()) for n in (one, other))
        low, high = a[:3] + np.minimum(move, 0.0), a[3:] + np.maximum(move, 0.0)
        if (np.minimum(high, b[3:]) - np.maximum(low, b[:3])).min() < 1e-6:
            return False
        if (way, one) not in self._sweeps:
            self._sweeps[way, one] = swept(self._plates[one], move)
        # Mostly one part says it; to join them all takes ten times longer.
        shared = []
        for part in self._sweeps[way, one]:
            c = np.array(part.bounding_box())
            if (np.minimum(c[3:], b[3:]) - np.maximum(c[:3], b[:3])).min() > 0.0:
                common = part ^ body
                if common.volume() > TOUCH_MM3:
                    return True
                shared.append(common)
        if sum(common.volume() for common in shared) <= TOUCH_MM3:
            return False
        return bool(together(shared).volume() > TOUCH_MM3)


def _ways(normals: Array, faced: Array) -> Array:
    """The normals of plates and the lines in which planes meet, each both ways."""
    planes = _distinct(np.vstack([normals, faced]))
    first, second = np.triu_indices(len(planes), 1)
    lines = _distinct(np.vstack([normals, np.cross(planes[first], planes[second])]))
    upwards = np.where(lines[:, 2:] >= 0, lines, -lines)
    return np.stack([upwards, -upwards], axis=1).reshape(-1, 3)


def _distinct(vectors: Array) -> Array:
    """Unit vectors along these; of those along one line the first."""
    units = vectors / np.linalg.norm(vectors, axis=1)[:, None]
    rounded = np.round(units, 6) + 0.0
    signs = np.sign(rounded[np.arange(len(units)), (rounded != 0).argmax(axis=1)])
    _, first = np.unique(rounded * signs[:, None], axis=0, return_index=True)
    return np.asarray(units[np.sort(first)])
