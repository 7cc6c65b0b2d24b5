"""Faces found in 3D: the minimal planar loops of edges.

Terms
-----
plane
    Named by the vertices that lie in it; candidates are spanned by every two edges that meet.
half-edge
    An edge walked in one direction; walking always to the next half-edge in turn goes round a
    minimal loop.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from .errors import SketchError
from .geometry import cross
from .graph import Face
from .union_find import UnionFind
from .values import Array

#: Vertices within this part of the object's size of a plane lie in it.
PLANE_TOLERANCE = 1e-6
#: Where more pairs of edges meet than this, the drawing is a tangle and no object.
MAX_CORNERS = 50_000


def find_faces(
    vertices_mm: Mapping[str, Array], edges: Mapping[str, tuple[str, str]]
) -> dict[str, Face]:
    """All minimal planar loops of edges, as faces f1, f2, ...

    Parameters
    ----------
    vertices_mm : mapping of vertex id to (3,) array
    edges : mapping of edge id to (vertex id, vertex id)

    Returns
    -------
    dict
        Faces in the order of the vertices that they touch; a loop within another one of the same
        plane, which does not touch it, is a hole in it (and a face of its own).

    Raises
    ------
    SketchError
        Where too many edges meet for faces to be looked for.
    """
    names = list(vertices_mm)
    index = {v: i for i, v in enumerate(names)}
    X = np.array([vertices_mm[v] for v in names], dtype=float).reshape(-1, 3)
    ends = [(index[v], index[w]) for v, w in edges.values()]
    found: list[tuple[tuple[int, ...], tuple[tuple[int, ...], ...]]] = []
    for normal, in_plane in _planes(X, ends):
        kept = set(in_plane)
        chosen = [(i, j) for i, j in ends if i in kept and j in kept]
        loops = _loops(_flatten(X, normal), chosen)
        found += _with_holes(_flatten(X, normal), loops)
    found.sort(key=lambda item: (sorted(item[0]), item[0]))
    named = [
        Face(tuple(names[i] for i in loop), tuple(tuple(names[i] for i in h) for h in holes))
        for loop, holes in found
    ]
    return {f"f{k}": face for k, face in enumerate(named, start=1)}


def _planes(X: Array, ends: list[tuple[int, int]]) -> list[tuple[Array, tuple[int, ...]]]:
    """The planes that hold at least two meeting edges: normals and vertices."""
    size = float(np.ptp(X, axis=0).max()) if len(X) else 0.0
    around: dict[int, list[int]] = {}
    for i, j in ends:
        around.setdefault(i, []).append(j)
        around.setdefault(j, []).append(i)
    if sum(len(others) ** 2 for others in around.values()) > 2 * MAX_CORNERS:
        raise SketchError(
            f"more than {MAX_CORNERS} pairs of edges meet", (), "list the faces in the sketch"
        )
    seen: dict[tuple[int, ...], Array] = {}
    tested: set[tuple[int, int, int]] = set()
    for i, others in around.items():
        for a in range(len(others)):
            for b in range(a + 1, len(others)):
                if (i, min(others[a], others[b]), max(others[a], others[b])) in tested:
                    continue
                u, v = X[others[a]] - X[i], X[others[b]] - X[i]
                normal = cross(u, v)
                length = float(np.linalg.norm(normal))
                if length <= 1e-9 * float(np.linalg.norm(u) * np.linalg.norm(v)):
                    continue
                normal /= length
                members = np.flatnonzero(np.abs((X - X[i]) @ normal) <= PLANE_TOLERANCE * size)
                key = tuple(int(m) for m in members)
                seen.setdefault(key, normal)
                _mark_tested(key, around, tested)
    return [(normal, key) for key, normal in seen.items()]


def _mark_tested(
    members: tuple[int, ...], around: dict[int, list[int]], tested: set[tuple[int, int, int]]
) -> None:
    """Pairs of edges of a plane that is known span no other plane."""
    inside = set(members)
    for i in members:
        others = sorted(inside.intersection(around.get(i, ())))
        tested.update(
            (i, others[a], others[b]) for a in range(len(others)) for b in range(a + 1, len(others))
        )


def _flatten(X: Array, normal: Array) -> Array:
    """Positions in the plane's own frame, (n, 2), right-handed round the normal."""
    helper = np.eye(3)[int(np.argmin(np.abs(normal)))]
    u = cross(helper, normal)
    u /= np.linalg.norm(u)
    return np.asarray(np.column_stack([X @ u, X @ cross(normal, u)]))


def _loops(P: Array, edges: list[tuple[int, int]]) -> list[tuple[int, ...]]:
    """Minimal loops of a planar drawing, counter-clockwise."""
    edges = _without_dead_ends(edges)
    around: dict[int, list[int]] = {}
    for i, j in edges:
        around.setdefault(i, []).append(j)
        around.setdefault(j, []).append(i)
    for i, others in around.items():
        offsets = P[others] - P[i]
        angles = np.arctan2(offsets[:, 1], offsets[:, 0])
        around[i] = [others[k] for k in np.argsort(angles, kind="stable")]
    loops, walked = [], set()
    for start in [*edges, *((j, i) for i, j in edges)]:
        if start in walked:
            continue
        loop, (i, j) = [], start
        while (i, j) not in walked:
            walked.add((i, j))
            loop.append(i)
            turn = around[j]
            # The next half-edge clockwise from where we came keeps the loop's inside on the left.
            i, j = j, turn[turn.index(i) - 1]
        if len(set(loop)) == len(loop) and _signed_area(P[loop]) > 0:
            loops.append(_canonical(loop))
    return loops


def _without_dead_ends(edges: list[tuple[int, int]]) -> list[tuple[int, int]]:
    while True:
        degree: dict[int, int] = {}
        for ends in edges:
            for i in ends:
                degree[i] = degree.get(i, 0) + 1
        kept = [(i, j) for i, j in edges if degree[i] > 1 and degree[j] > 1]
        if len(kept) == len(edges):
            return kept
        edges = kept


def _canonical(loop: list[int]) -> tuple[int, ...]:
    k = loop.index(min(loop))
    return tuple(loop[k:] + loop[:k])


def _signed_area(polygon: Array) -> float:
    # Plain numbers: most loops have four vertices, too few for arrays.
    points = polygon.tolist()
    ahead = points[1:] + points[:1]
    return float(sum(x * v - u * y for (x, y), (u, v) in zip(points, ahead, strict=True))) / 2


def _with_holes(
    P: Array, loops: list[tuple[int, ...]]
) -> list[tuple[tuple[int, ...], tuple[tuple[int, ...], ...]]]:
    """Give each loop that lies within another, apart from it, to the smallest such as a hole.

    Touching loops within the same outer loop make one hole: their common outline.
    """
    part = _parts(loops)
    if len(set(part)) < 2:
        return [(loop, ()) for loop in loops]
    areas = [_signed_area(P[list(loop)]) for loop in loops]
    inside: dict[int, list[int]] = {}
    for k, loop in enumerate(loops):
        outer = [
            o
            for o, other in enumerate(loops)
            if part[o] != part[k] and areas[o] > areas[k] and _contains(P[list(other)], P[loop[0]])
        ]
        if outer:
            inside.setdefault(min(outer, key=lambda o: areas[o]), []).append(k)
    return [
        (loop, _outlines([loops[i] for i in inside.get(k, [])])) for k, loop in enumerate(loops)
    ]


def _parts(loops: list[tuple[int, ...]]) -> list[int]:
    """For each loop the connected part of the drawing that it belongs to."""
    sets = UnionFind(1 + max((max(loop) for loop in loops), default=0))
    for loop in loops:
        for i in loop[1:]:
            sets.union(loop[0], i)
    return [sets.find(loop[0]) for loop in loops]


def _outlines(loops: list[tuple[int, ...]]) -> tuple[tuple[int, ...], ...]:
    """The common outlines of loops: half-edges whose reverse is not walked by another loop."""
    walked = {(a, b) for loop in loops for a, b in zip(loop, loop[1:] + loop[:1], strict=True)}
    following = {a: b for a, b in sorted(walked) if (b, a) not in walked}
    outlines = []
    while following:
        start = min(following)
        outline = [start]
        while (nxt := following.pop(outline[-1], start)) != start:
            outline.append(nxt)
        outlines.append(tuple(outline))
    return tuple(outlines)


def _contains(polygon: Array, point: Array) -> bool:
    """Whether the point is inside, by the crossing number."""
    a, b = polygon, np.roll(polygon, -1, axis=0)
    crosses = (a[:, 1] > point[1]) != (b[:, 1] > point[1])
    with np.errstate(divide="ignore", invalid="ignore"):
        at = a[:, 0] + (point[1] - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
    return bool(np.count_nonzero(crosses & (at > point[0])) % 2)
