"""Faces found in 3D: the minimal planar loops of edges.

Terms
-----
corner
    Two edges that meet; every corner spans a plane.
plane
    Named by the vertices that lie in it.
loop, half-edge
    See `walks`.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from .errors import SketchError
from .geometry import cross
from .graph import Face
from .nesting import outlines, smallest_around
from .values import Array, BoolArray, FrozenDict, IntArray, frozen_mapping, kept, rows_of
from .walks import Loop, Walk, walk_round, without_dead_ends

#: Vertices within this part of the object's size of a plane lie in it.
PLANE_TOLERANCE = 1e-6
#: Where more pairs of edges meet than this, the drawing is a tangle and no object.
MAX_CORNERS = 200_000
#: Loops that enclose less than this part of the size squared are lines.
AREA_TOLERANCE = 1e-12
#: Planes whose normal and offset agree to this are tried once.
CELL = 1e-6
#: With more planes than this, those that only one or two corners span are left out first.
MANY_PLANES = 1000
#: Numbers in one table of planes by vertices, which bounds the memory.
TABLE = 4_000_000


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
    ends = _ends(tuple(vertices_mm), frozen_mapping(edges))
    corners = _corners(ends)
    if not len(corners):
        return {}
    X = rows_of(vertices_mm)
    X = X - X.mean(axis=0)
    size = float(np.ptp(X, axis=0).max())
    if not size > 0:
        return {}
    tables = [
        table
        for normals, members in _planes(X, size, corners)
        if (table := _table(X / size, ends, normals, members)) is not None
    ]
    return _named(tuple(vertices_mm), *(part for table in tables for part in table))


@kept
def _named(names: tuple[str, ...], *tables: Walk | bytes) -> dict[str, Face]:
    """The faces by name, of tables of a walk, which cycles are loops, and what lies in which."""
    found: list[tuple[Loop, tuple[Loop, ...]]] = []
    for walk, chosen, around in zip(tables[::3], tables[1::3], tables[2::3], strict=True):
        assert isinstance(walk, Walk)
        assert isinstance(chosen, bytes)
        assert isinstance(around, bytes)
        inside: dict[int, list[Loop]] = {}
        for k, outer in enumerate(np.frombuffer(around, dtype=np.int64).tolist()):
            if outer >= 0:
                inside.setdefault(outer, []).append(walk.loops[k])
        for k in np.flatnonzero(np.frombuffer(chosen, dtype=bool)).tolist():
            found.append((walk.loops[k], outlines(inside[k]) if k in inside else ()))
    found.sort(key=lambda item: (sorted(item[0]), item[0]))
    name = names.__getitem__
    return FrozenDict(
        (f"f{k}", Face(tuple(map(name, loop)), tuple(tuple(map(name, hole)) for hole in holes)))
        for k, (loop, holes) in enumerate(found, start=1)
    )


@kept
def _ends(names: tuple[str, ...], edges: Mapping[str, tuple[str, str]]) -> IntArray:
    """Vertex indices of each edge, (m, 2)."""
    index = {name: i for i, name in enumerate(names)}
    ends = np.array([index[v] for pair in edges.values() for v in pair], dtype=np.int64)
    ends.setflags(write=False)
    return ends.reshape(-1, 2)


@kept
def _corners(ends: IntArray) -> IntArray:
    """All corners: the common vertex and the two other ends, (c, 3)."""
    starts, others = ends.reshape(-1), ends[:, ::-1].reshape(-1)
    names, first, degrees = np.unique(starts, return_index=True, return_counts=True)
    if int(np.sum(degrees.astype(float) * (degrees - 1))) > 2 * MAX_CORNERS:
        raise SketchError(
            f"more than {MAX_CORNERS} pairs of edges meet", (), "list the faces in the sketch"
        )
    order = np.argsort(starts, kind="stable")
    offset = np.cumsum(degrees) - degrees
    parts, ranks = [np.zeros((0, 3), dtype=np.int64)], [np.zeros(0, dtype=np.int64)]
    for degree in np.unique(degrees[degrees > 1]).tolist():
        chosen = np.flatnonzero(degrees == degree)
        around = others[order[offset[chosen][:, None] + np.arange(degree)]]
        a, b = np.triu_indices(degree, 1)
        middle = np.repeat(names[chosen], len(a))
        parts.append(np.column_stack([middle, around[:, a].reshape(-1), around[:, b].reshape(-1)]))
        ranks.append(np.repeat(first[chosen], len(a)))
    corners = np.concatenate(parts)[np.argsort(np.concatenate(ranks), kind="stable")]
    corners.setflags(write=False)
    return corners


def _planes(X: Array, size: float, corners: IntArray) -> list[tuple[Array, BoolArray]]:
    """The planes that corners span, in tables of bounded size: normals (k, 3), members (k, n)."""
    at, a, b = X[corners[:, 0]], X[corners[:, 1]], X[corners[:, 2]]
    u, v = a - at, b - at
    normals = cross(u, v)
    lengths = np.sqrt(np.einsum("ci,ci->c", normals, normals))
    spans = lengths > 1e-9 * np.sqrt(np.einsum("ci,ci->c", u, u) * np.einsum("ci,ci->c", v, v))
    normals = normals[spans] / lengths[spans, None]
    offsets = np.einsum("ci,ci->c", normals, at[spans])
    planes = np.column_stack([normals, offsets / size])
    chosen = _distinct(planes)
    if len(chosen) > MANY_PLANES:
        shared = _spanned_thrice(planes)
        chosen = shared[_distinct(planes[shared])]
    tables, seen = [], set()
    rows = max(1, TABLE // len(X))
    for start in range(0, len(chosen), rows):
        some = chosen[start : start + rows]
        members = np.abs(normals[some] @ X.T - offsets[some, None]) <= PLANE_TOLERANCE * size
        names = [row.tobytes() for row in np.packbits(members, axis=1)]
        new = []
        for k, name in enumerate(names):
            if name not in seen:
                seen.add(name)
                new.append(k)
        tables.append((normals[some[new]], members[new]))
    return tables


def _distinct(planes: Array) -> IntArray:
    """The first of all planes (normal, offset) that fall into one cell, either way round."""
    largest = np.abs(planes[:, :3]).argmax(axis=1)
    signs = np.sign(planes[np.arange(len(planes)), largest])
    cells = np.rint(planes * signs[:, None] / CELL).astype(np.int64)
    # Mixed into one number, overflow and all: two cells meet in it once in 1e19.
    mixed = cells @ np.array([6364136223846793005, 1442695040888963407, 3935559000370003845, 1])
    return np.sort(np.unique(mixed, return_index=True)[1])


def _spanned_thrice(planes: Array) -> IntArray:
    """Planes that at least three corners may span, as every loop has so many.

    Of planes that agree, any even function agrees; those alone with their value are left out.
    """
    left = np.arange(len(planes))
    for weights in np.random.default_rng(0).normal(size=(8, 2, 4)):
        value = (planes[left] @ weights[0]) * (planes[left] @ weights[1])
        order = np.argsort(value)
        near = np.zeros(len(left), dtype=bool)
        close = np.flatnonzero(value[order[2:]] - value[order[:-2]] <= 20 * CELL)
        for k in range(3):
            near[order[close + k]] = True
        left = left[near]
    return left


def _table(
    X: Array, ends: IntArray, normals: Array, members: BoolArray
) -> tuple[Walk, bytes, bytes] | None:
    """The cycles of several planes, which of them are loops, and in which other one each lies."""
    plane, edge = np.nonzero(members[:, ends[:, 0]] & members[:, ends[:, 1]])
    walked = without_dead_ends(plane, ends[edge], len(X))
    if not len(walked.plane):
        return None
    u, v = _frames(normals)
    x, y = ((X @ w.T)[walked.start, walked.plane] for w in (u, v))
    along_x, along_y = (w.reshape(-1, 2)[:, ::-1].reshape(-1) - w for w in (x, y))
    walk = walk_round(walked, np.arctan2(along_y, along_x), len(X))
    areas = np.add.reduceat((x * along_y - y * along_x)[walk.order] / 2, walk.first)
    encloses = areas > AREA_TOLERANCE
    chosen = encloses & walk.simple
    # Each connected part of a plane has one cycle that goes round it, the other way round.
    parts = np.bincount(walk.plane[~encloses], minlength=len(normals))
    nested = chosen & (parts > 1)[walk.plane]
    around = np.zeros(0, dtype=np.int64)
    if nested.any():
        around = smallest_around(walk, np.column_stack([x, y])[walk.order], areas, nested)
    return walk, chosen.tobytes(), around.tobytes()


def _frames(normals: Array) -> tuple[Array, Array]:
    """Two directions in each plane, right-handed round the normal."""
    helpers = np.eye(3)[np.abs(normals).argmin(axis=1)]
    u = cross(helpers, normals)
    u /= np.sqrt(np.einsum("ki,ki->k", u, u))[:, None]
    return u, cross(normals, u)
