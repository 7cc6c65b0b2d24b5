"""On which side of each face the object lies.

Terms
-----
barrier
    A flat polygon that closes the object off: a face (made or left out) or a cap.
cap
    A polygon put into a flat loop of free edges, an opening for which no face was drawn.
inside
    What cannot be reached from far away without crossing a barrier.
partition
    A face with inside on both sides.

Points close to both sides of each face, some in between and some far away are nodes; two nodes
that see each other past all barriers are connected. What is connected to a far one is outside.
The test is exact for closed objects of any form. Right-angled ones are flooded cell by cell, which
is the same and takes a hundredth of the time. Where the object does not close (a bracket of
two faces), the inside is the side on which the rest of the object lies.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import Polygon

from ...solver.values import Array
from .flooding import flooded
from .frame import newell
from .openings import caps

Loops = tuple[Array, ...]


@dataclass(frozen=True, slots=True, eq=False)
class _Barrier:
    origin: Array
    axes: Array  # rows: two directions in the plane, then the normal
    rings: tuple[Array, ...]  # slightly enlarged, in the plane, (n, 2) each

    @property
    def extent(self) -> float:
        """Area of the box around it, mm2."""
        return float(np.prod(np.ptp(np.vstack(self.rings), axis=0)))

    def signed(self, points: Array) -> Array:
        return np.asarray((points - self.origin) @ self.axes[2])

    def blocks(self, start: Array, end: Array, at_start: Array, at_end: Array) -> NDArray[np.bool_]:
        """Whether each segment crosses this polygon; `at_*` are the signed distances."""
        blocked = np.zeros(len(start), dtype=bool)
        crossing = np.flatnonzero((at_start * at_end <= 0) & (at_start != at_end))
        share = at_start[crossing] / (at_start[crossing] - at_end[crossing])
        hits = start[crossing] + share[:, None] * (end[crossing] - start[crossing])
        blocked[crossing] = _in_rings((hits - self.origin) @ self.axes[:2].T, self.rings)
        return blocked


def face_sides(faces: Mapping[str, Loops], made: Sequence[str]) -> dict[str, int]:
    """Towards which side of each face the object lies.

    Parameters
    ----------
    faces : mapping of face id to loops
        Outer loop and holes, (n, 3) each, mm; faces left out included.
    made : sequence of face ids
        The faces to answer for.

    Returns
    -------
    dict of face id to int
        1: where the normal of the loop (Newell) points, -1: the other way, 0: a partition.
    """
    loops = list(faces.values())
    points = np.vstack([loop for face in loops for loop in face])
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    closing = [(cap,) for cap in caps(loops, size)]
    shares = flooded(faces, closing, made)
    if shares is None:
        shares = _seen(faces, closing, made, size)
    return {id_: _side(np.array(shares[id_]), faces[id_][0], points, 1e-3 * size) for id_ in made}


def _seen(
    faces: Mapping[str, Loops], closing: Sequence[Loops], made: Sequence[str], size: float
) -> dict[str, tuple[float, float]]:
    """How much of each face has inside below it and above it, at any angles."""
    loops = list(faces.values())
    points = np.vstack([loop for face in loops for loop in face])
    barriers = [_barrier(face, 1e-7 * size) for face in loops]
    barriers += [_barrier(cap, 1e-7 * size) for cap in closing]
    # Large ones first: they block most views, which the others need not look at then.
    barriers.sort(key=lambda barrier: -barrier.extent)
    samples = {id_: _samples(faces[id_], 1e-4 * size) for id_ in made}
    nodes = np.vstack([*(pair.reshape(-1, 3) for pair in samples.values()), _between(points)])
    outside = _reached(nodes, _far(points, size), barriers)
    shares, start = {}, 0
    for id_ in made:
        count = len(samples[id_][0])
        inside = ~outside[start : start + 2 * count].reshape(2, count)
        start += 2 * count
        below, above = inside.mean(axis=1).tolist()
        shares[id_] = below, above
    return shares


def _side(inside: Array, loop: Array, points: Array, tolerance: float) -> int:
    below, above = inside >= 0.5
    if below or above:
        return int(above) - int(below)
    normal = newell(loop)
    heights = (points - loop[0]) @ normal / np.linalg.norm(normal)
    has_below, has_above = heights.min() < -tolerance, heights.max() > tolerance
    if not has_below and not has_above:
        # A single board: hang it below the drawn face (or behind it).
        return -1 if tuple(np.round(normal[::-1], 9)) > (0.0, 0.0, 0.0) else 1
    return int(has_above) - int(has_below)


def _plane(loop: Array) -> tuple[Array, Array]:
    normal = newell(loop)
    normal = normal / np.linalg.norm(normal)
    spans = loop - loop[0]
    along = spans[int(np.argmax(np.linalg.norm(spans, axis=1)))]
    along = along - normal * (along @ normal)
    along = along / np.linalg.norm(along)
    return loop[0], np.array([along, np.cross(normal, along), normal])


def _barrier(loops: Loops, grow: float) -> _Barrier:
    origin, axes = _plane(loops[0])
    flat = [(loop - origin) @ axes[:2].T for loop in loops]
    # Enlarged a little, so that no view slips through between two faces with a common edge.
    polygon = shapely.make_valid(Polygon(flat[0], flat[1:])).buffer(grow, join_style="mitre")
    rings = [
        np.array(ring.coords)[:-1]
        for part in shapely.get_parts(polygon)
        for ring in (part.exterior, *part.interiors)
    ]
    return _Barrier(origin, axes, tuple(rings))


def _in_rings(points: Array, rings: Sequence[Array]) -> NDArray[np.bool_]:
    """Even-odd test of (m, 2) points against closed rings."""
    odd = np.zeros(len(points), dtype=bool)
    for ring in rings:
        for (x0, y0), (x1, y1) in zip(ring, np.roll(ring, -1, axis=0), strict=True):
            if y0 == y1:
                continue
            rows = (y0 > points[:, 1]) != (y1 > points[:, 1])
            odd ^= rows & (points[:, 0] < (x1 - x0) * (points[:, 1] - y0) / (y1 - y0) + x0)
    return odd


def _samples(loops: Loops, step: float) -> Array:
    """Points close below and above a face, (2, k, 3)."""
    origin, axes = _plane(loops[0])
    flat = [(loop - origin) @ axes[:2].T for loop in loops]
    polygon = shapely.make_valid(Polygon(flat[0], flat[1:]))
    low, high = flat[0].min(axis=0), flat[0].max(axis=0)
    # Irrational shares keep the lines of view off edges and off other planes.
    shares = np.array([(0.317, 0.291), (0.723, 0.337), (0.276, 0.744), (0.681, 0.671)])
    spots = low + np.vstack([shares, [(0.4931, 0.5127)]]) * (high - low)
    spots = spots[shapely.contains_xy(polygon, spots[:, 0], spots[:, 1])]
    some = polygon.representative_point()
    spots = np.vstack([spots, [(some.x + 0.0137 * step, some.y + 0.0071 * step)]])
    centre = origin + spots @ axes[:2]
    return np.stack([centre - step * axes[2], centre + step * axes[2]])


def _between(points: Array) -> Array:
    low, high = points.min(axis=0), points.max(axis=0)
    shares = np.random.default_rng(2010).uniform(-0.3, 1.3, size=(40, 3))
    return np.asarray(low + shares * (high - low))


def _far(points: Array, size: float) -> Array:
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    ways = np.array(np.meshgrid(*3 * [(-1.0, 0.017, 1.0)])).reshape(3, -1).T
    ways = np.delete(ways, 13, axis=0)
    return np.asarray(middle + 4.03 * size * ways / np.linalg.norm(ways, axis=1, keepdims=True))


def _reached(nodes: Array, far: Array, barriers: Sequence[_Barrier]) -> NDArray[np.bool_]:
    """Which nodes are connected to a far one by lines of view."""
    every = np.vstack([far, nodes])
    heights = [barrier.signed(every) for barrier in barriers]
    outside = np.zeros(len(every), dtype=bool)
    outside[: len(far)] = True
    frontier = np.arange(len(far))
    while len(frontier):
        unknown = np.flatnonzero(~outside)
        start, end = (grid.ravel() for grid in np.meshgrid(frontier, unknown, indexing="ij"))
        for barrier, height in zip(barriers, heights, strict=True):
            blocked = barrier.blocks(every[start], every[end], height[start], height[end])
            start, end = start[~blocked], end[~blocked]
        frontier = np.unique(end)
        outside[frontier] = True
    return outside[len(far) :]
