"""Said angles that cannot hold, whatever the drawing: by reasoning about directions alone."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from .annotations import Angle
from .directions import Directions
from .said_angles import RIGHT_DEG, SAME_ANGLE_DEG
from .topology import Topology
from .values import BoolArray, IntArray

Pair = tuple[int, int]


def angles_clash(
    topology: Topology, directions: Directions, edge_axis: IntArray, edge_across: BoolArray
) -> bool:
    """Whether an angle is said of edges that are parallel or square, two of one, or of a triangle.

    Parameters
    ----------
    topology : Topology
    directions : Directions
    edge_axis, edge_across : arrays
        As in Structure.
    """
    said: list[Angle] = [a for _, a in topology.by_kind["angle"]]
    if not said:
        return False
    known = _Known(topology, directions, edge_axis, edge_across)
    for a in said:
        e, f = (topology.edges[edge] for edge in a.between)
        if not known.take(e, f, a.angle_deg):
            return True
    return any(_differ([180.0], sum(angles)) for angles in _of_triangles(topology, said, known))


class _Known:
    """Angles between edges, by the classes of their directions."""

    def __init__(
        self,
        topology: Topology,
        directions: Directions,
        edge_axis: IntArray,
        edge_across: BoolArray,
    ) -> None:
        self._class = directions.class_of.tolist()
        self._square = directions.perpendicular
        self._axis = edge_axis.tolist()
        self._across = edge_across
        self._by_classes: dict[Pair, float] = {}
        self._of: dict[Pair, float] = {}

    def take(self, e: int, f: int, angle_deg: float) -> bool:
        """Note an angle; False where another one is known."""
        first, second = sorted((self._class[e], self._class[f]))
        if first == second or (self._axis[e] >= 0 and self._axis[e] == self._axis[f]):
            return False
        if self._are_square(e, f):
            return not _differ([RIGHT_DEG], angle_deg)
        before = self._by_classes.setdefault((first, second), angle_deg)
        same = self._of.setdefault((min(e, f), max(e, f)), angle_deg)
        # Between parallels the angle is the same one or what is left of 180 degrees.
        return not (_differ([before, 180.0 - before], angle_deg) or _differ([same], angle_deg))

    def of(self, e: int, f: int) -> float | None:
        """The angle where two edges meet, degrees; None where it is not known."""
        if self._are_square(e, f):
            return RIGHT_DEG
        return self._of.get((min(e, f), max(e, f)))

    def _are_square(self, e: int, f: int) -> bool:
        k, m = self._axis[e], self._axis[f]
        by_axes = (k >= 0 and self._across[f, k]) or (m >= 0 and self._across[e, m])
        return bool(by_axes) or self._class[f] in self._square.get(self._class[e], ())


def _of_triangles(
    topology: Topology, said: Iterable[Angle], known: _Known
) -> Iterator[tuple[float, float, float]]:
    """The three angles of triangles of which all are known."""
    joining = {frozenset(ends): e for e, ends in enumerate(topology.ends.tolist())}
    for a in said:
        e, f = (topology.edges[edge] for edge in a.between)
        third = joining.get(frozenset(topology.ends[e].tolist()) ^ set(topology.ends[f].tolist()))
        if third is None:
            continue
        others = known.of(e, third), known.of(f, third)
        if others[0] is not None and others[1] is not None:
            yield a.angle_deg, others[0], others[1]


def _differ(possible: list[float], angle_deg: float) -> bool:
    return all(abs(one - angle_deg) > SAME_ANGLE_DEG for one in possible)
