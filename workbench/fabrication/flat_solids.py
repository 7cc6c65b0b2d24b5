"""Bodies of flat faces from triangles to the kernel: what hangs together in a plane is one face.

The kernel's own booleans fail, or make what is no solid, where many faces nearly meet. Triangles
that close stay closed: faces share their edges and vertices here, nothing is sewn.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from manifold3d import Manifold
from numpy.typing import NDArray
from scipy.spatial import KDTree

from ...solver.union_find import UnionFind
from ...solver.values import Array
from .errors import FabricationError
from .frame import newell

if TYPE_CHECKING:
    import cadquery as cq

#: Corners so near to a plane or a line lie on it.
_ON_MM = 1e-6
#: The kernel's own tolerance.
_LEAST_MM = 1e-7
#: Smaller parts of a body come from rounding, in parts of its volume.
_SPECK = 1e-9
#: Triangles of no width may lie beside others.
_ROUNDS = 50
Triangles = NDArray[np.int64]
Ring = list[int]


class InvalidSolidError(FabricationError):
    """A body that the kernel does not take; its ids are faces that may be at fault."""

    def __init__(self, ids: Sequence[str] = ()) -> None:
        super().__init__(
            "the walls touch each other in single edges or corners, which makes no solid",
            ids,
            "a wall 1 % thinner or thicker",
        )


def kernel_solid(body: Manifold) -> cq.Solid:
    """A body of flat faces as a solid of the kernel.

    Parameters
    ----------
    body : manifold3d.Manifold

    Returns
    -------
    cadquery.Solid
        A closed hollow in it is a shell of its own.

    Raises
    ------
    InvalidSolidError
    """
    import cadquery as cq
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Solid

    if body.is_empty():
        raise InvalidSolidError
    points, parts = whole_parts(body)
    builder, solid = BRep_Builder(), TopoDS_Solid()
    builder.MakeSolid(solid)
    for triangles in parts:
        builder.Add(solid, _shell(points, _straight(points, list(_faces(points, triangles)))))
    made = cq.Solid(solid)
    if not made.isValid() or abs(made.Volume() - body.volume()) > _ON_MM * body.volume():
        raise InvalidSolidError
    return made


def whole_parts(body: Manifold) -> tuple[Array, list[Triangles]]:
    """A body's points, and the triangles of each closed surface, the largest first."""
    points, triangles = _welded(body)
    sets = UnionFind(len(points))
    for a, b, c in triangles.tolist():
        sets.union(a, b)
        sets.union(a, c)
    labels = np.array(sets.labels())[triangles[:, 0]]
    parts = [triangles[labels == label] for label in np.unique(labels)]
    corners = points - points.mean(axis=0)
    volumes = [float(np.linalg.det(corners[part]).sum() / 6) for part in parts]
    order = sorted(range(len(parts)), key=lambda n: -volumes[n])
    return points, [parts[n] for n in order if abs(volumes[n]) > _SPECK * volumes[order[0]]]


def _welded(body: Manifold) -> tuple[Array, Triangles]:
    """A body's points and triangles, those so near to each other that rounding parts them one."""
    mesh = body.to_mesh64()
    points = np.asarray(mesh.vert_properties)[:, :3]
    triangles = np.asarray(mesh.tri_verts).astype(np.int64)
    sets = UnionFind(len(points))
    for a, b in KDTree(points).query_pairs(_ON_MM, output_type="ndarray").tolist():
        sets.union(a, b)
    triangles = np.array(sets.labels())[triangles]
    a, b, c = triangles.T
    triangles = _closed(triangles[(a != b) & (b != c) & (c != a)])
    for _ in range(_ROUNDS):
        triangles, changed = _turned(points, triangles)
        if not changed:
            break
        triangles = _closed(triangles)
    return points, triangles


def _closed(triangles: Triangles) -> Triangles:
    """Triangles without those that lie on each other, back to back; each edge has two then."""
    count: dict[frozenset[int], list[int]] = {}
    for n, triangle in enumerate(triangles.tolist()):
        count.setdefault(frozenset(triangle), []).append(n)
    folded = [pair for pair in count.values() if len(pair) == 2]
    kept = np.delete(triangles, np.array(folded, dtype=np.int64).ravel(), axis=0)
    edges = _beside(kept)
    if len(edges) < 3 * len(kept) or any((b, a) not in edges for a, b in edges):
        raise InvalidSolidError
    return kept


def _turned(points: Array, triangles: Triangles) -> tuple[Triangles, bool]:
    """Triangles of no width made part of what lies beyond their longest side."""
    corners = points[triangles]
    spans = np.roll(corners, -1, axis=1) - corners
    lengths = np.linalg.norm(spans, axis=2)
    sizes = np.linalg.norm(np.cross(spans[:, 0], spans[:, 1]), axis=1)
    thin = np.flatnonzero(sizes < _ON_MM * lengths.max(axis=1))
    result, touched = triangles.copy(), set[int]()
    beside = _beside(triangles) if len(thin) else {}
    for n in thin[np.argsort(-lengths[thin].max(axis=1), kind="stable")].tolist():
        k = int(lengths[n].argmax())
        a, b, c = np.roll(triangles[n], -k).tolist()
        other = beside[b, a]
        d = int(next(v for v in triangles[other].tolist() if v not in (a, b)))
        if touched & {n, other} or (c, d) in beside or (d, c) in beside:
            continue
        touched |= {n, other}
        result[n], result[other] = (a, d, c), (d, b, c)
    return result, bool(touched)


def _beside(triangles: Triangles) -> dict[tuple[int, int], int]:
    """The triangle at each edge as it turns."""
    return {
        edge: n
        for n, (a, b, c) in enumerate(triangles.tolist())
        for edge in ((a, b), (b, c), (c, a))
    }


def _faces(points: Array, triangles: Triangles) -> Iterator[list[Ring]]:
    """The rings of each face: triangles that hang together in one plane."""
    corners = points[triangles]
    areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sizes = np.linalg.norm(areas, axis=1)
    beside = _beside(triangles)
    face_of = np.full(len(triangles), -1)
    for seed in np.argsort(-sizes, kind="stable").tolist():
        if face_of[seed] >= 0:
            continue
        normal = areas[seed] / max(sizes[seed], 1e-300)
        flat = np.abs((corners - corners[seed, 0]) @ normal).max(axis=1) < 2 * _ON_MM
        flat &= areas @ normal > 0.0
        face_of[seed] = seed
        waiting = [seed]
        while waiting:
            a, b, c = triangles[waiting.pop()].tolist()
            for edge in ((b, a), (c, b), (a, c)):
                n = beside[edge]
                if face_of[n] < 0 and flat[n]:
                    face_of[n] = seed
                    waiting.append(n)
        own = np.flatnonzero(face_of == seed).tolist()
        border = {
            (a, b)
            for n in own
            for a, b in pairwise((*triangles[n].tolist(), triangles[n, 0].item()))
            if face_of[beside[b, a]] != seed
        }
        yield list(_rings(border, points, normal))


def _rings(border: set[tuple[int, int]], points: Array, normal: Array) -> Iterator[Ring]:
    """The border of a face as rings that touch themselves nowhere, the face on their left."""
    ways: dict[int, list[int]] = {}
    for a, b in sorted(border):
        ways.setdefault(a, []).append(b)
    ring: Ring = []
    while ways or ring:
        if not ring:
            ring = [next(iter(ways))]
        v = ring[-1]
        if len(ring) > 1:
            u = ring[-2]
            turns = [_turn(points[[u, v, w]], normal) for w in ways[v]]
            ways[v].append(ways[v].pop(int(np.argmax(turns))))
        w = ways[v].pop()
        if not ways[v]:
            del ways[v]
        if w in ring:
            start = ring.index(w)
            yield ring[start:]
            ring = ring[: start + 1] if start else []
        else:
            ring.append(w)


def _turn(run: Array, normal: Array) -> float:
    """By which angle a line of three points turns to the left."""
    one, two = run[1] - run[0], run[2] - run[1]
    return float(np.arctan2(np.cross(one, two) @ normal, one @ two))


def _straight(points: Array, faces: Sequence[list[Ring]]) -> list[list[Ring]]:
    """Rings without points at which a side only goes on."""
    beside: dict[int, set[int]] = {}
    for a, b in (pair for rings in faces for ring in rings for pair in pairwise((*ring, ring[0]))):
        beside.setdefault(a, set()).add(b)
        beside.setdefault(b, set()).add(a)
    gone = set()
    for v, around in list(beside.items()):
        if len(around) != 2:
            continue
        a, b = around
        span, arm = points[b] - points[a], points[v] - points[a]
        length = float(np.linalg.norm(span))
        off = float(np.linalg.norm(np.cross(span, arm))) / max(length, _ON_MM)
        if off < _ON_MM and 0 < arm @ span < length**2 and b not in beside[a]:
            gone.add(v)
            beside[a] = beside[a] - {v} | {b}
            beside[b] = beside[b] - {v} | {a}
    kept = [[[v for v in ring if v not in gone] for ring in rings] for rings in faces]
    whole = [[ring for ring in rings if len(ring) > 2] for rings in kept]
    return [rings for rings in whole if rings]


def _shell(points: Array, faces: Sequence[list[Ring]]) -> Any:
    """Faces that share their edges, as a closed shell."""
    from OCP.BRep import BRep_Builder
    from OCP.gp import gp_Dir, gp_Pln, gp_Pnt
    from OCP.TopoDS import TopoDS_Shell

    planes = [_plane(points, rings) for rings in faces]
    off: dict[int, float] = {}
    for (middle, normal), rings in zip(planes, faces, strict=True):
        for v in (v for ring in rings for v in ring):
            off[v] = max(off.get(v, _LEAST_MM), 2 * abs(float((points[v] - middle) @ normal)))
    edges = _edges(points, faces, off)
    builder, shell = BRep_Builder(), TopoDS_Shell()
    builder.MakeShell(shell)
    for (middle, normal), rings in zip(planes, faces, strict=True):
        plane = gp_Pln(gp_Pnt(*middle.tolist()), gp_Dir(*normal.tolist()))
        for face in _kernel_faces(plane, normal, rings, points, edges):
            builder.Add(shell, face)
    shell.Closed(True)
    return shell


def _plane(points: Array, rings: Sequence[Ring]) -> tuple[Array, Array]:
    """A point and the normal of the plane of a face."""
    every = points[[v for ring in rings for v in ring]]
    area = np.sum([newell(points[ring]) for ring in rings], axis=0)
    return every.mean(axis=0), area / np.linalg.norm(area)


def _edges(
    points: Array, faces: Sequence[list[Ring]], off: dict[int, float]
) -> dict[tuple[int, int], Any]:
    """The kernel's edge for each pair of points, both ways."""
    from OCP.BRep import BRep_Builder
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
    from OCP.gp import gp_Pnt
    from OCP.TopoDS import TopoDS, TopoDS_Vertex

    builder, corners = BRep_Builder(), {}
    for v, tolerance in off.items():
        corners[v] = TopoDS_Vertex()
        builder.MakeVertex(corners[v], gp_Pnt(*points[v].tolist()), tolerance)
    edges: dict[tuple[int, int], Any] = {}
    for a, b in (pair for rings in faces for ring in rings for pair in pairwise((*ring, ring[0]))):
        if (a, b) not in edges:
            edge = BRepBuilderAPI_MakeEdge(corners[a], corners[b]).Edge()
            builder.UpdateEdge(edge, max(off[a], off[b]))
            edges[a, b], edges[b, a] = edge, TopoDS.Edge_s(edge.Reversed())
    return edges


def _kernel_faces(
    plane: Any,
    normal: Array,
    rings: Sequence[Ring],
    points: Array,
    edges: dict[tuple[int, int], Any],
) -> Iterator[Any]:
    """The faces that rings bound in a plane: more than one where they touch in a point only."""
    import shapely
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace

    outer = [ring for ring in rings if newell(points[ring]) @ normal > 0]
    holes = [ring for ring in rings if newell(points[ring]) @ normal <= 0]
    axes = np.linalg.svd(normal[None])[2][1:]
    for ring in outer:
        face = BRepBuilderAPI_MakeFace(plane, _wire(ring, edges), False)
        area = shapely.Polygon(points[ring] @ axes.T) if len(outer) > 1 else None
        for hole in holes:
            spot = shapely.Polygon(points[hole] @ axes.T).representative_point()
            if area is None or area.contains(spot):
                face.Add(_wire(hole, edges))
        yield face.Face()


def _wire(ring: Ring, edges: dict[tuple[int, int], Any]) -> Any:
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Wire

    builder, wire = BRep_Builder(), TopoDS_Wire()
    builder.MakeWire(wire)
    for pair in pairwise((*ring, ring[0])):
        builder.Add(wire, edges[pair])
    wire.Closed(True)
    return wire
