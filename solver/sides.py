"""The profiles of surfaces of revolution as numbers: unknowns in the side plane, and conditions.

Terms
-----
q
    What radii and heights of profiles' vertices, and of the circles at their ends, change by.
condition
    What is said of the profiles' edges: no shared coordinate holds it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from .annotations import Annotation, Diameter, EqualLength, Ground, Length, Parallel, RightAngle
from .elastic import gentlest_step
from .energies import ENERGIES
from .graph import Revolution, SketchGraph
from .revolution import SidePlane
from .values import Array
from .world import Lifted

#: In one step sizes change by so much, logarithm of the ratio; Newton steps onto them, at each.
STRIDE, MAX_STEPS = 0.2, 12
#: What is left of a condition that holds (radians, parts of a length).
HELD = 1e-10
#: More strides than these lead nowhere; of more conditions than these nobody says.
MOST_STRIDES, MOST_CONDITIONS = 60, 200
#: Circles and bars no larger than this part of the shape are as stiff as those.
LEAST_BAR = 0.02

Planes = Mapping[str, SidePlane]


@dataclass(frozen=True, slots=True)
class Condition:
    """One row (three for parallels): vertices by id, None for the unit; the lengths wanted."""

    owner: str
    energy: str
    vertices: tuple[str | None, ...]
    wanted: tuple[float, float] = (1.0, 1.0)


_UNIT: tuple[None, None] = (None, None)


def conditions_on_sides(
    graph: SketchGraph, said: Mapping[str, Annotation], unit_mm: float | None
) -> Iterator[Condition]:
    edges = graph.edges
    reference, first = _UNIT, unit_mm
    for id_, a in said.items():
        if isinstance(a, Length) and first is None:
            reference, first = edges[a.edge], a.length_mm  # type: ignore[assignment]
        elif isinstance(a, Length) and first is not None:
            wanted = (first, a.length_mm)
            yield Condition(id_, "length_ratio", (*reference, *edges[a.edge]), wanted)
        elif isinstance(a, EqualLength | Parallel):
            energy = "parallel" if isinstance(a, Parallel) else "length_ratio"
            for e in a.edges[1:]:
                yield Condition(id_, energy, (*edges[a.edges[0]], *edges[e]))
        elif isinstance(a, RightAngle):
            far = [v for e in a.between for v in edges[e] if v != a.at]
            yield Condition(id_, "right_angle", (a.at, far[0], a.at, far[1]))
        elif isinstance(a, Ground):
            yield from (Condition(id_, "ground", (v,)) for v in a.vertices)


class Sides:
    """Positions of all vertices, linear in q: what the profiles and their circles change by."""

    def __init__(
        self,
        graph: SketchGraph,
        core: SketchGraph,
        shape: Lifted,
        planes: Planes,
        on_circles: frozenset[str],
    ) -> None:
        self.graph, self.core, self.base = graph, core, shape
        self.names = {v: k for k, v in enumerate(graph.vertices)}
        self.column: dict[tuple[str, str], int] = {}
        self.up = next(iter(planes.values())).up
        self.level = float(shape.centres[next(iter(graph.revolutions.values())).ground] @ self.up)
        self._X = np.array([shape.vertices[v] for v in graph.vertices])
        moves: list[tuple[int, int, Array]] = []
        hoops: list[tuple[int, float]] = []
        seen: set[str] = set()
        for id_, r in graph.revolutions.items():
            plane = planes[id_]
            for v in dict.fromkeys(r.profile):
                if v in core.vertices or v in seen:
                    continue
                seen.add(v)
                k, (x, _) = self.names[v], plane.local(shape.vertices[v])
                across, along = self._numbers_of(r, v)
                sign = 1.0 if x >= 0 else -1.0
                if v in on_circles:
                    self._X[k] = self._on_circle(r, v, plane, sign)
                outward = sign if v in (r.profile[0], r.profile[-1]) else 1.0
                moves += [(k, c, d) for c, d in ((across, outward * plane.side), (along, plane.up))
                          if c >= 0]  # fmt: skip
                hoops += [(across, abs(float(x)))] if across >= 0 else []
        self.free = sorted({k for k, _, _ in moves})
        self.size = float(np.linalg.norm(np.ptp(self._all_points(), axis=0)))
        self.B = np.zeros((len(self._X), 3, len(self.column)))
        for k, c, d in moves:
            self.B[k, :, c] = d
        self.strain = self._strain(hoops)

    def _all_points(self) -> Array:
        return np.vstack([self._X, *self.base.centres.values()])

    def _numbers_of(self, r: Revolution, v: str) -> tuple[int, int]:
        """Columns of a vertex's x and z, those of its circle for an end; -1 for what is fixed."""
        ends = {r.profile[0]: r.bottom, r.profile[-1]: r.top}
        if v not in ends:
            return self._new((v, "x")), self._new((v, "z"))
        c = ends[v]
        graph = self.graph
        sized = any(isinstance(a, Diameter) and a.circle == c for a in graph.annotations.values())
        stands = any(other.ground == c for other in graph.revolutions.values())
        fixed = c in graph.construction
        across = -1 if sized or fixed else self._new((c, "radius"))
        return across, -1 if stands or fixed else self._new((c, "height"))

    def _new(self, key: tuple[str, str]) -> int:
        return self.column.setdefault(key, len(self.column))

    def _on_circle(self, r: Revolution, v: str, plane: SidePlane, sign: float) -> Array:
        c = r.bottom if v == r.profile[0] else r.top
        return np.asarray(self.base.centres[c] + sign * self.base.radii[c] * plane.side)

    def _strain(self, hoops: list[tuple[int, float]]) -> Array:
        """Rows of strains by q: of edges, hoops, and the bars from the ground to the bottom."""
        least = LEAST_BAR * self.size
        rows = []
        for e, (v, w) in self.graph.edges.items():
            if e not in self.core.edges:
                i, j = self.names[v], self.names[w]
                length = max(float(np.linalg.norm(self._X[j] - self._X[i])), least)
                rows.append((self.B[j] - self.B[i]) / np.sqrt(length))
        for c, radius in hoops:
            rows.append(np.eye(len(self.column))[c : c + 1] / np.sqrt(max(radius, least)))
        for r in self.graph.revolutions.values():
            c = self.column.get((r.bottom, "height"), -1)
            if c >= 0:
                bar = self.base.centres[r.bottom] - self.base.centres[r.ground]
                length = max(float(np.linalg.norm(bar)), least)
                rows.append(np.eye(len(self.column))[c : c + 1] / np.sqrt(length))
        return np.vstack(rows) if rows else np.zeros((0, len(self.column)))

    def points(self, q: Array) -> Array:
        """All vertices, (n, 3)."""
        return np.asarray(self._X + self.B @ q)

    def evaluate(self, q: Array, conditions: list[Condition]) -> tuple[Array, Array]:
        """What is left of conditions, and the derivatives by q."""
        n = len(self._X)
        # The unit stands behind the vertices.
        X = np.vstack([self.points(q), np.zeros(3), np.array([1.0, 0.0, 0.0])])
        B = np.concatenate([self.B, np.zeros((2, 3, len(q)))])
        h: list[Array] = []
        H: list[Array] = []
        for c in conditions:
            unit = iter((n, n + 1))
            items = [next(unit) if v is None else self.names[v] for v in c.vertices]
            if c.energy == "ground":
                h.append(np.array([(X[items[0]] @ self.up - self.level) / self.size]))
                H.append((self.up @ B[items[0]])[None] / self.size)
                continue
            extra = (np.array([c.wanted]),) if c.energy == "length_ratio" else ()
            at = ENERGIES[c.energy](X, np.array([items]), *extra)
            by_q = np.zeros((len(at.residual), len(q)))
            np.add.at(by_q, at.row, np.einsum("ti,tij->tj", at.value, B[at.vertex]))
            h.append(at.residual)
            H.append(by_q)
        return np.concatenate(h), np.vstack(H)

    def shape(self, q: Array) -> Lifted:
        """The shape, its circles with it."""
        vertices = dict(zip(self.names, self.points(q), strict=True))
        centres, radii = dict(self.base.centres), dict(self.base.radii)
        for (id_, what), k in self.column.items():
            if what == "radius":
                radii[id_] += float(q[k])
            elif what == "height":
                centres[id_] = centres[id_] + q[k] * self.up
        return Lifted(vertices, centres, radii)


def met(sides: Sides, conditions: list[Condition]) -> Array | None:
    """The gentlest q with which all conditions hold, reached in strides; None where none is."""
    q = np.zeros(len(sides.column))
    if not conditions or not len(q):
        return q
    if len(conditions) > MOST_CONDITIONS:
        return None
    measured = {c: _measured(sides, c) for c in conditions if c.energy == "length_ratio"}
    farthest = max((abs(math.log(m)) for m in measured.values()), default=0.0)
    strides = 1 + int(min(farthest / STRIDE, MOST_STRIDES))
    for k in range(1, strides + 1):
        left = 1 - k / strides
        way = [
            replace(c, wanted=(c.wanted[0], c.wanted[1] * measured[c] ** left))
            if c in measured
            else c
            for c in conditions
        ]
        q = _onto(sides, way, q)
    worst = float(np.abs(sides.evaluate(q, conditions)[0]).max())
    slim = min(sides.shape(q).radii.values()) <= 0
    return None if not worst < HELD or slim or _turned_over(sides, q) else q


def _onto(sides: Sides, conditions: list[Condition], q: Array) -> Array:
    for _ in range(MAX_STEPS):
        h, H = sides.evaluate(q, conditions)
        if float(np.abs(h).max()) < 1e-15:
            break
        step = gentlest_step(h, H, sides.strain)
        if not np.isfinite(step).all():
            break
        q = q + step
    return q


def _measured(sides: Sides, c: Condition) -> float:
    """How long the second edge is drawn, in parts of what is wanted."""
    h = float(sides.evaluate(np.zeros(len(sides.column)), [c])[0][0])
    # h = (p - q) / (p + q) for the two lengths in parts of those wanted.
    return max(1 - h, 1e-12) / max(1 + h, 1e-12)


def _turned_over(sides: Sides, q: Array) -> bool:
    """Whether an edge points the other way: lengths do not tell, people do."""
    before, after = sides.points(0 * q), sides.points(q)
    named = [sides.names[v] for ends in sides.graph.edges.values() for v in ends]
    # A side may have no edge yet.
    ends = np.array(named, dtype=np.int64).reshape(-1, 2)
    old, new = (X[ends[:, 1]] - X[ends[:, 0]] for X in (before, after))
    return bool((np.einsum("ij,ij->i", old, new) < 0).any())


def worst_first(sides: Sides, conditions: list[Condition]) -> tuple[str, ...]:
    """Whose conditions the drawing misses most, and those that come near to it."""
    q = np.zeros(len(sides.column))
    off: dict[str, float] = {}
    for c in conditions:
        missed = float(np.abs(sides.evaluate(q, [c])[0]).max())
        off[c.owner] = max(off.get(c.owner, 0.0), missed)
    worst = max(off.values())
    return tuple(sorted((i for i in off if off[i] > worst / 2), key=lambda i: -off[i]))
