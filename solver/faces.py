"""Faces found in 3D: the minimal planar loops of edges.

Terms
-----
corner
    Two edges that meet, a two-path; every corner spans a plane.
plane
    Named by the vertices that lie in it.
loop, half-edge
    See `walks`.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from .blas_threads import one_blas_thread
from .errors import SketchError
from .geometry import cross, cross_columns
from .graph import Face
from .nesting import outlines, smallest_around
from .topology import edge_ends
from .two_paths import TwoPaths, two_paths
from .values import (
    Array,
    Awaited,
    BoolArray,
    FrozenDict,
    IntArray,
    frozen_mapping,
    kept,
    rows_of,
)
from .walks import Walk, connected_parts, walk_round, without_dead_ends

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
    names = tuple(vertices_mm)
    ends = _ends_of_no_tangle(names, edges)
    corners = two_paths(ends, len(names), MAX_CORNERS)
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
    return _named(names, *(part for table in tables for part in table))


def awaited_faces(
    vertices_mm: Mapping[str, Array], edges: Mapping[str, tuple[str, str]]
) -> Mapping[str, Face]:
    """What `find_faces` finds, looked for when it is first asked for; it raises at once."""
    _ends_of_no_tangle(tuple(vertices_mm), edges)

    def found() -> Mapping[str, Face]:
        with one_blas_thread, np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            return find_faces(vertices_mm, edges)

    return Awaited(found)


def _ends_of_no_tangle(names: tuple[str, ...], edges: Mapping[str, tuple[str, str]]) -> IntArray:
    """Vertex indices of each edge; raises SketchError where too many edges meet."""
    ends = edge_ends(names, frozen_mapping(edges))
    degrees = np.bincount(ends.reshape(-1))
    if int(degrees @ (degrees - 1)) > 2 * MAX_CORNERS:
        raise SketchError(
            f"more than {MAX_CORNERS} pairs of edges meet", (), "list the faces in the sketch"
        )
    return ends


@kept
def _named(names: tuple[str, ...], *tables: Walk | bytes) -> dict[str, Face]:
    """The faces by name, of tables of a walk, which cycles are loops, and what lies in which."""
    found: list[tuple[tuple[str, ...], tuple[tuple[str, ...], ...]]] = []
    least = [np.zeros((0, 4), dtype=np.int64)]
    for walk, chosen, around in zip(tables[::3], tables[1::3], tables[2::3], strict=True):
        assert isinstance(walk, Walk)
        assert isinstance(chosen, bytes)
        assert isinstance(around, bytes)
        cycles = np.flatnonzero(np.frombuffer(chosen, dtype=bool))
        holes = _holes(names, walk, np.frombuffer(around, dtype=np.int64))
        loops = walk.runs(tuple([names[v] for v in walk.vertices.tolist()]), cycles)
        found += [(loop, holes.get(k, ())) for k, loop in zip(cycles.tolist(), loops, strict=True)]
        least.append(walk.least_vertices(cycles))
    in_order = _in_order(names, np.concatenate(least), [loop for loop, _ in found])
    return FrozenDict((f"f{k}", Face(*found[i])) for k, i in enumerate(in_order, start=1))


def _holes(
    names: tuple[str, ...], walk: Walk, around: IntArray
) -> dict[int, tuple[tuple[str, ...], ...]]:
    """The outlines of what lies in each cycle, for those with something in them."""
    inside: dict[int, list[int]] = {}
    for k, outer in enumerate(around.tolist()):
        if outer >= 0:
            inside.setdefault(outer, []).append(k)
    vertices = tuple(walk.vertices.tolist()) if inside else ()
    return {
        outer: tuple(
            tuple([names[v] for v in outline])
            for outline in outlines(walk.runs(vertices, np.array(inner)))
        )
        for outer, inner in inside.items()
    }


def _in_order(names: tuple[str, ...], least: IntArray, loops: list[tuple[str, ...]]) -> list[int]:
    """The order of loops by the vertices that they touch, the least ones first."""
    code = (least + 1) @ (1 << 15 * np.arange(4, dtype=np.int64)[::-1])
    order = np.argsort(code, kind="stable")
    if (np.diff(code[order]) > 0).all():
        return [int(k) for k in order]
    # Four vertices do not always tell.
    place = {name: i for i, name in enumerate(names)}
    numbers = [[place[v] for v in loop] for loop in loops]
    return sorted(range(len(loops)), key=lambda k: (sorted(numbers[k]), numbers[k]))


def _planes(X: Array, size: float, corners: TwoPaths) -> list[tuple[Array, BoolArray]]:
    """The planes that corners span, in tables of bounded size: normals (k, 3), members (k, n)."""
    columns = np.ascontiguousarray(X.T)
    at = columns.take(corners.middle, axis=1)
    u, v = columns.take(corners.a, axis=1) - at, columns.take(corners.c, axis=1) - at
    normals = cross_columns(u, v)
    squares, of_u, of_v = (np.einsum("ic,ic->c", w, w) for w in (normals, u, v))
    spans = np.flatnonzero(squares > 1e-18 * of_u * of_v)
    normals = normals[:, spans] / np.sqrt(squares[spans])
    offsets = np.einsum("ic,ic->c", normals, at[:, spans])
    planes = np.vstack([normals, offsets / size])
    chosen = _distinct(planes)
    if len(chosen) > MANY_PLANES:
        shared = _spanned_thrice(planes.T)
        chosen = shared[_distinct(planes[:, shared])]
    tables, seen = [], set()
    rows = max(1, TABLE // len(X))
    for start in range(0, len(chosen), rows):
        some = chosen[start : start + rows]
        across = normals[:, some].T
        members = np.abs(across @ columns - offsets[some, None]) <= PLANE_TOLERANCE * size
        names = [row.tobytes() for row in np.packbits(members, axis=1)]
        new = []
        for k, name in enumerate(names):
            if name not in seen:
                seen.add(name)
                new.append(k)
        tables.append((across[new], members[new]))
    return tables


def _distinct(planes: Array) -> IntArray:
    """The first of all planes (normal, offset) that fall into one cell, either way round."""
    largest = np.abs(planes[:3]).argmax(axis=0)
    signs = np.sign(planes[largest, np.arange(planes.shape[1])])
    cells = np.rint(planes * (signs / CELL)).astype(np.int64)
    # Mixed into one number, overflow and all: two cells meet in it once in 1e19.
    mixed = np.array([6364136223846793005, 1442695040888963407, 3935559000370003845, 1]) @ cells
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
    v, w = ends.T
    plane, edge = np.nonzero(members.take(v, axis=1) & members.take(w, axis=1))
    walked = without_dead_ends(plane, ends[edge], len(X))
    if not len(walked.plane):
        return None
    x, y = ((X @ axis.T)[walked.start, walked.plane] for axis in _frames(normals))
    along_x, along_y = (at.reshape(-1, 2)[:, ::-1].reshape(-1) - at for at in (x, y))
    walk = walk_round(walked, np.arctan2(along_y, along_x), len(X))
    areas = np.add.reduceat((x * along_y - y * along_x)[walk.order] / 2, walk.first)
    encloses = areas > AREA_TOLERANCE
    chosen = encloses & walk.simple
    # Each connected part of a plane has one cycle that goes round it, the other way round.
    parts = np.bincount(walk.plane[~encloses], minlength=len(normals))
    nested = chosen & (parts > 1)[walk.plane]
    around = np.zeros(0, dtype=np.int64)
    if nested.any():
        connected = connected_parts(walked, walk, len(X))
        positions = np.column_stack([x, y])[walk.order]
        around = smallest_around(walk, connected, positions, areas, nested)
    return walk, chosen.tobytes(), around.tobytes()


def _frames(normals: Array) -> tuple[Array, Array]:
    """Two directions in each plane, right-handed round the normal."""
    helpers = np.eye(3)[np.abs(normals).argmin(axis=1)]
    u = cross(helpers, normals)
    u /= np.sqrt(np.einsum("ki,ki->k", u, u))[:, None]
    return u, cross(normals, u)
