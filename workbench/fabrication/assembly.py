"""The order in which plates go together, found by taking them apart.

Terms
-----
way
    A direction along which something is taken off in a straight line.
blocked
    A plate is blocked by another along a way if it would pass through it.
group
    Plates that block one another in a circle along a way: they can leave only together, and are
    taken apart by themselves afterwards.
locked
    Plates that block one another along every way.

Source: R. H. Wilson, J.-C. Latombe, Geometric reasoning about mechanical assembly (1994): the
blocking graph of a way, and its strongly connected components.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import manifold3d
import numpy as np
import shapely
import shapely.affinity
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import connected_components

from ...solver.values import Array
from .errors import FabricationError
from .plates import Plate
from .prisms import prism

#: Plates may touch so much while they move, mm3.
TOUCH_MM3 = 1e-3
_SHRINK_MM = 5e-3


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


@dataclass(slots=True, eq=False)
class _Apart:
    """Which plate is blocked by which along which way, as it becomes known."""

    plates: Sequence[Plate]
    bodies: list[manifold3d.Manifold]
    ways: Array
    known: dict[tuple[int, int, int], bool]
    sweeps: dict[tuple[int, int], list[manifold3d.Manifold]]
    far_mm: float

    def blocked(self, way: int, one: int, other: int) -> bool:
        """Whether a plate would pass through another."""
        key = (way, one, other)
        if key not in self.known:
            back = (way ^ 1, other, one)
            self.known[key] = self.known[back] = self._hits(way, one, other)
        return self.known[key]

    def _hits(self, way: int, one: int, other: int) -> bool:
        move, body = self.ways[way] * self.far_mm, self.bodies[other]
        a, b = (np.array(self.bodies[n].bounding_box()) for n in (one, other))
        low, high = a[:3] + np.minimum(move, 0.0), a[3:] + np.maximum(move, 0.0)
        if (np.minimum(high, b[3:]) - np.maximum(low, b[:3])).min() < 1e-6:
            return False
        if (way, one) not in self.sweeps:
            self.sweeps[way, one] = _swept(self.plates[one], move)
        # Mostly one part says it; to join them all takes ten times longer.
        shared = []
        for part in self.sweeps[way, one]:
            c = np.array(part.bounding_box())
            if (np.minimum(c[3:], b[3:]) - np.maximum(c[:3], b[:3])).min() > 0.0:
                common = part ^ body
                if common.volume() > TOUCH_MM3:
                    return True
                shared.append(common)
        return bool(_together(shared).volume() > TOUCH_MM3)

    def free(self, plates: Sequence[int]) -> tuple[int, tuple[int, ...]] | None:
        """A plate that can leave square to itself, which is seen at once, and its way."""
        for one in plates:
            normal = self.plates[one].world_from_plate[:3, 2]
            for way in np.flatnonzero(np.abs(self.ways @ normal) > 1 - 1e-9).tolist():
                if not any(self.blocked(way, one, other) for other in plates if other != one):
                    return way, (one,)
        return None

    def loose(self, plates: Sequence[int]) -> tuple[int, tuple[int, ...]] | None:
        """A way, and the fewest plates that can leave along it together; None where locked."""
        best: tuple[int, int, tuple[int, ...]] | None = None
        for way in range(len(self.ways)):
            if self._all_tied(way, plates):
                continue
            edges = np.array(
                [[i != j and self.blocked(way, i, j) for j in plates] for i in plates], dtype=bool
            )
            group = _sink(edges)
            if best is None or len(group) < best[0]:
                best = (len(group), way, tuple(plates[n] for n in group))
                if len(group) == 1:
                    break
        return None if best is None else (best[1], best[2])

    def _all_tied(self, way: int, plates: Sequence[int]) -> bool:
        """Whether all block one another in a circle: from the first all are reached, both ways.

        Of most ways few plates' moves tell that already; to try all takes many times longer. What
        blocks a plate is what it would pass through on the way back.
        """
        for there in (way, way ^ 1):
            left, reached = list(plates[1:]), list(plates[:1])
            for one in reached:
                for other in tuple(left):
                    if self.blocked(there, one, other):
                        reached.append(other)
                        left.remove(other)
            if left:
                return False
        return True


def _sink(edges: NDArray[np.bool_]) -> list[int]:
    """The smallest group that nothing outside of it blocks."""
    count, labels = connected_components(csr_matrix(edges), directed=True, connection="strong")
    free = [
        label for label in range(count) if not edges[np.ix_(labels == label, labels != label)].any()
    ]
    label = min(free, key=lambda n: (int((labels == n).sum()), -int(np.argmax(labels == n))))
    return np.flatnonzero(labels == label).tolist()


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
    return tuple(reversed([step for step, _ in _taken_apart(plates)]))


def exploded(plates: Sequence[Plate], gap_mm: float | None = None) -> tuple[Plate, ...]:
    """The plates moved apart the way they come off.

    Parameters
    ----------
    plates : sequence of Plate
    gap_mm : float or None
        How far each group moves from what it was on; None takes a fifth of the whole size.

    Returns
    -------
    tuple of Plate
        In the same order, with other places in the world.

    Raises
    ------
    LockedError
    """
    points = np.vstack([_corners(plate) for plate in plates])
    gap = 0.2 * float(np.ptp(points, axis=0).max()) if gap_mm is None else gap_mm
    moves = {plate.id: np.zeros(3) for plate in plates}
    for step, _ in _taken_apart(plates):
        for id_ in step.plate_ids if step.onto else ():
            moves[id_] = moves[id_] - gap * step.way
    result = []
    for plate in plates:
        place = plate.world_from_plate.copy()
        place[:3, 3] += moves[plate.id]
        result.append(replace(plate, world_from_plate=place))
    return tuple(result)


def _taken_apart(plates: Sequence[Plate]) -> list[tuple[Step, int]]:
    """The steps of taking everything apart, the last first to be put together."""
    apart = _apart(plates)
    steps: list[tuple[Step, int]] = []

    def split(some: list[int], level: int) -> None:
        if len(some) == 1:
            return
        found = apart.free(some) or apart.loose(some)
        if found is None:
            raise _locked(apart, some)
        way, group = found
        rest = [n for n in some if n not in group]
        ids, onto = (tuple(plates[n].id for n in part) for part in (group, rest))
        steps.append((Step(ids, -apart.ways[way], onto), level))
        split(list(group), level + 1)
        if len(rest) > 1:
            split(rest, level)
        else:
            steps.append((Step(onto, np.zeros(3), ()), level))

    everything = list(range(len(plates)))
    split(everything, 0)
    if len(plates) == 1:
        steps.append((Step((plates[0].id,), np.zeros(3), ()), 0))
    return steps


def _locked(apart: _Apart, some: Sequence[int]) -> LockedError:
    """The fewest plates that lock each other, as an error."""
    for size in (2, 3):
        for few in combinations(some, size):
            if apart.loose(few) is None:
                return _locked_error([apart.plates[n].id for n in few])
    return _locked_error([apart.plates[n].id for n in some])


def _locked_error(ids: Sequence[str]) -> LockedError:
    words = f"{', '.join(ids[:-1])} and {ids[-1]}"
    return LockedError(
        f"cannot be put together: {words} lock each other", (), "a butt joint between them"
    )


def _corners(plate: Plate) -> Array:
    flat = np.column_stack([plate.outline, np.zeros(len(plate.outline))])
    both = np.vstack([flat, np.add(flat, [0.0, 0.0, plate.thickness_mm])])
    return np.asarray(both @ plate.world_from_plate[:3, :3].T + plate.world_from_plate[:3, 3])


def _apart(plates: Sequence[Plate]) -> _Apart:
    points = np.vstack([_corners(plate) for plate in plates])
    far = 2.0 * float(np.linalg.norm(np.ptp(points, axis=0)))
    bodies = [_together(_swept(plate, np.zeros(3))) for plate in plates]
    return _Apart(plates, bodies, _ways(plates), {}, {}, far)


def _ways(plates: Sequence[Plate]) -> Array:
    """The normals of all plates and the lines in which they meet, each both ways."""
    normals: list[Array] = []
    for plate in plates:
        _add(normals, plate.world_from_plate[:3, 2])
    ways = list(normals)
    for one, two in combinations(normals, 2):
        across = np.cross(one, two)
        _add(ways, across / np.linalg.norm(across))
        for sign in (1.0, -1.0):
            _add(ways, (one + sign * two) / np.linalg.norm(one + sign * two))
    both = [sign * way for way in ways for sign in ((1.0, -1.0) if way[2] >= 0 else (-1.0, 1.0))]
    return np.array(both)


def _add(ways: list[Array], way: Array) -> None:
    if not any(abs(abs(float(way @ known)) - 1) < 1e-6 for known in ways):
        ways.append(np.asarray(way))


def _together(parts: Sequence[manifold3d.Manifold]) -> manifold3d.Manifold:
    return manifold3d.Manifold.batch_boolean(parts, manifold3d.OpType.Add)


def _swept(plate: Plate, move: Array) -> list[manifold3d.Manifold]:
    """What a plate passes through on a straight way; a little thinner, for it may touch.

    In parts that may overlap.
    """
    polygon = plate.polygon.buffer(-_SHRINK_MM, join_style="mitre")
    thin = plate.thickness_mm - 2 * _SHRINK_MM
    rotation = plate.world_from_plate[:3, :3]
    local = rotation.T @ move
    if abs(local[2]) < 1e-9 * max(1.0, float(np.abs(local).max())) or not move.any():
        low, area = _SHRINK_MM, _swept_area(polygon, local[:2])
        return [prism(area, low, low + thin).transform(plate.world_from_plate[:3])]
    if np.abs(local[:2]).max() < 1e-9 * abs(local[2]):
        low = _SHRINK_MM + min(0.0, float(local[2]))
        body = prism(polygon, low, low + thin + abs(float(local[2])))
        return [body.transform(plate.world_from_plate[:3])]
    rings = [
        np.array(ring.coords)[:-1]
        for part in map(shapely.geometry.polygon.orient, shapely.get_parts(polygon))
        for ring in (part.exterior, *part.interiors)
    ]
    corners, hulls = np.vstack(rings), []
    for triangle in np.asarray(manifold3d.triangulate(rings), dtype=int):
        flat = corners[triangle]
        ends = np.vstack(
            [np.column_stack([flat, np.full(3, z)]) for z in (_SHRINK_MM, _SHRINK_MM + thin)]
        )
        hulls.append(manifold3d.Manifold.hull_points(np.vstack([ends, ends + local])))
    return [hull.transform(plate.world_from_plate[:3]) for hull in hulls]


def _swept_area(polygon: shapely.Polygon, move: Array) -> shapely.Geometry:
    """What a polygon passes over on a straight way in its plane."""
    if not move.any():
        return polygon
    parts = [polygon, shapely.affinity.translate(polygon, *move.tolist())]
    for ring in (polygon.exterior, *polygon.interiors):
        for a, b in zip(ring.coords[:-1], ring.coords[1:], strict=True):
            p, q = np.array(a), np.array(b)
            strip = shapely.Polygon([p, q, q + move, p + move])
            if strip.area > 1e-9:
                parts.append(strip.buffer(0))
    return shapely.union_all(parts)
