"""Loops that look like faces and are none, since nothing says that they are flat.

A pentagon whose peak no annotation holds follows the drawing, inaccurate as that is, and comes out
of its plane by a hand's error, or stays loose: no face is found there, and no plate would be made.

Terms
-----
open edge
    One that bounds fewer than two faces.
off
    The largest distance of a loop's vertices from the plane that fits them best.
"""

from __future__ import annotations

import heapq
from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations, islice, pairwise

import numpy as np

from ..geometry import cross
from ..graph import Face, SketchGraph
from ..solution import Solution, Status
from ..values import Array

#: Between these parts of its size a loop is nearly flat: exact ones are faces, others not meant.
NEARLY = (1e-6, 0.06)
#: While it is looked for, vertices this part of the object's size off a corner's plane count.
REACH = 0.15
#: How much longer a way through vertices off the plane is taken to be, per size.
DETOUR = 20.0
#: Of a tangle not all corners are looked at.
MAX_CORNERS = 1000
#: More are not told at once.
MOST_TOLD = 3
#: Three edges in a corner are always flat.
_LEAST = 4
_GOOD, _OPEN = Status.CONVERGED, Status.UNDERDETERMINED


@dataclass(frozen=True, slots=True)
class NearlyFlat:
    """A loop that is no face.

    Parameters
    ----------
    loop : tuple of str
        Its vertices, around.
    off_mm : float
    """

    loop: tuple[str, ...]
    off_mm: float


def nearly_flat(graph: SketchGraph, solution: Solution) -> tuple[NearlyFlat, ...]:
    """Loops of drawn edges that are nearly flat, go along an open edge, and are no faces.

    Vertices that are loose are anywhere: all others of a loop tell how flat it is.

    Parameters
    ----------
    graph : SketchGraph
    solution : Solution
        Of this sketch; faces that it leaves out are faces.

    Returns
    -------
    tuple of NearlyFlat
        The flattest first.
    """
    loose = set(solution.report.loose)
    at = {v: solution.vertices_mm[v] for v in graph.vertices if v in solution.vertices_mm}
    traced = set(graph.construction)
    edges = {ends for e, ends in graph.edges.items() if e not in traced and at.keys() >= set(ends)}
    held = {v: x for v, x in at.items() if v not in loose}
    if not edges or not held:
        return ()
    neighbours = _neighbours(edges)
    size = float(np.ptp(np.array(list(held.values())), axis=0).max())
    found: dict[frozenset[str], NearlyFlat] = {}
    corners = (c for c in _open_corners(neighbours, solution.faces) if loose.isdisjoint(c))
    for corner in islice(corners, MAX_CORNERS):
        loop = _loop_round(corner, neighbours, held, size)
        if len(loop) < _LEAST or frozenset(loop) in found or _has_chord(loop, neighbours):
            continue
        points = np.array([held[v] for v in loop if v in held])
        off, extent = _off_mm(points), float(np.ptp(points, axis=0).max())
        is_face = len(points) == len(loop) and off <= NEARLY[0] * extent
        if not is_face and off < NEARLY[1] * extent:
            found[frozenset(loop)] = NearlyFlat(loop, off)
    return tuple(sorted(found.values(), key=lambda near: near.off_mm))


def message_with_wanting_faces(graph: SketchGraph, solution: Solution) -> str:
    """A solution's message, and which loops are no faces though they look like some."""
    near = nearly_flat(graph, solution) if solution.status in (_GOOD, _OPEN) else ()
    if not near:
        return solution.message
    if solution.status is _OPEN:
        loop = " ".join(near[0].loop)
        return f"{solution.message} Where {loop} is flat, taking it for a face would help."
    some = [" ".join(one.loop) for one in near[:MOST_TOLD]]
    loops = " and ".join(filter(None, (", ".join(some[:-1]), some[-1])))
    return (
        f"{solution.message} Not flat enough for a face: {loops}, {near[-1].off_mm:.2g} mm off: "
        "mark right angles or parallels there, or take it for a face."
    )


def _neighbours(edges: Collection[tuple[str, str]]) -> dict[str, list[str]]:
    neighbours: dict[str, list[str]] = {}
    for v, w in sorted(edges):
        neighbours.setdefault(v, []).append(w)
        neighbours.setdefault(w, []).append(v)
    return neighbours


def _open_corners(
    neighbours: Mapping[str, list[str]], faces: Mapping[str, Face]
) -> Iterator[tuple[str, str, str]]:
    """Two edges that meet and have no face in common, one of them open: ends around the middle."""
    loops = [(*loop, *loop[:2]) for face in faces.values() for loop in face.loops]
    bounds = Counter(frozenset(side) for loop in loops for side in pairwise(loop[:-1]))
    known = {
        (b, frozenset((a, c)))
        for loop in loops
        for a, b, c in zip(loop, loop[1:], loop[2:], strict=False)
    }
    for middle, around in neighbours.items():
        for a, c in combinations(around, 2):
            is_open = min(bounds[frozenset((middle, end))] for end in (a, c)) < 2
            if is_open and (middle, frozenset((a, c))) not in known:
                yield a, middle, c


def _loop_round(
    corner: tuple[str, str, str],
    neighbours: Mapping[str, list[str]],
    held: Mapping[str, Array],
    size: float,
) -> tuple[str, ...]:
    """The shortest way round from one end of a corner to the other, near its plane."""
    a, middle, c = corner
    normal = cross(held[a] - held[middle], held[c] - held[middle])
    length = float(np.linalg.norm(normal))
    if length == 0 or size == 0:
        return ()
    off = {v: abs(float((x - held[middle]) @ normal)) / (length * size) for v, x in held.items()}
    ways: list[tuple[float, tuple[str, ...]]] = [(0.0, (middle, a))]
    done = {middle}
    while ways:
        cost, way = heapq.heappop(ways)
        if way[-1] == c:
            return way
        if way[-1] in done:
            continue
        done.add(way[-1])
        for v in neighbours[way[-1]]:
            if v not in done and off.get(v, 0.0) < REACH:
                heapq.heappush(ways, (cost + 1.0 + DETOUR * off.get(v, 0.0), (*way, v)))
    return ()


def _has_chord(loop: tuple[str, ...], neighbours: Mapping[str, list[str]]) -> bool:
    """Whether an edge joins two of its vertices that are not next to each other."""
    there = set(loop)
    return any(len(there & set(neighbours[v])) > 2 for v in loop)


def _off_mm(points: Array) -> float:
    X = points - points.mean(axis=0)
    normal = np.linalg.svd(X, full_matrices=False)[2][-1]
    return float(np.abs(X @ normal).max())
