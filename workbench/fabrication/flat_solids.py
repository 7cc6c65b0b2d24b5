"""Bodies of flat faces from triangles to the kernel: what lies in one plane is one face.

Terms
-----
chain
    The border of the triangles of one plane: edges, each as often as it is run through from its
    lower to its higher vertex, less often where the other way.

Booleans leave triangles of no width, films whose sides lie in one plane, and vertices on the edges
of others; the kernel's own ones fail, or make what is no solid, where many faces nearly meet. In
chains whose edges end at all vertices that lie on them all this cancels, however it is cut into
triangles, and what is left of a closed body is closed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
import shapely
from manifold3d import Manifold
from numpy.typing import NDArray
from scipy.spatial import KDTree
from shapely.geometry.polygon import orient

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
#: By how much of itself the volume may change.
_SAME = 1e-6
#: Smaller parts of a body come from rounding, in parts of its volume.
_SPECK = 1e-9
#: Edges that were split may pass vertices again, by rounding.
_ROUNDS = 10
Triangles = NDArray[np.int64]
Edge = tuple[int, int]
Chain = Mapping[Edge, int]
Ring = list[int]


class TouchingError(FabricationError):
    """A body that touches itself in edges, (n, 2, 3)."""

    def __init__(self, edges_mm: Array, ids: Sequence[str] = ()) -> None:
        super().__init__(
            "walls touch each other in an edge only, which makes no solid",
            ids,
            "a thinner or thicker wall",
        )
        self.edges_mm = edges_mm


class PartedError(FabricationError):
    """A body in parts; the corners of each, (n, 3)."""

    def __init__(self, parts_mm: Sequence[Array], ids: Sequence[str] = ()) -> None:
        super().__init__(
            f"the walls make {len(parts_mm)} solids instead of one", ids, "leave fewer faces out"
        )
        self.parts_mm = parts_mm


@dataclass(frozen=True, slots=True, eq=False)
class _Face:
    """A face: the normal that looks out of the body, and rings that turn left around it."""

    normal: Array
    rings: tuple[Ring, ...]

    @property
    def edges(self) -> Iterator[Edge]:
        """From vertex to vertex, as its rings run."""
        for ring in self.rings:
            yield from pairwise((*ring, ring[0]))


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
    TouchingError
        Where more than two faces meet in an edge.
    PartedError
        Where it is several bodies.
    FabricationError
        Where nothing is left of it.
    """
    import cadquery as cq
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Solid

    points, faces = flat_faces(body)
    shells = _shells(points, faces)
    builder, solid = BRep_Builder(), TopoDS_Solid()
    builder.MakeSolid(solid)
    for shell in shells:
        builder.Add(solid, _shell(points, shell))
    made = cq.Solid(solid)
    if not made.isValid() or abs(made.Volume() - body.volume()) > _SAME * body.volume():
        raise FabricationError(
            f"the walls have {made.Volume():.6g} mm3 instead of {body.volume():.6g}",
            (),
            "a thinner or thicker wall",
        )
    return made


def flat_faces(body: Manifold) -> tuple[Array, list[_Face]]:
    """A body's points, and its faces."""
    mesh = body.to_mesh64()
    points = np.asarray(mesh.vert_properties)[:, :3]
    raw = np.asarray(mesh.tri_verts).astype(np.int64)
    sets = UnionFind(len(points))
    for a, b in KDTree(points).query_pairs(_ON_MM, output_type="ndarray").tolist():
        sets.union(a, b)
    _, first, labels = np.unique(sets.labels(), return_index=True, return_inverse=True)
    planes = list(_planes(points[raw]))
    borders = [_border(labels.reshape(-1)[raw[own]]) for _, own in planes]
    points, chains = _split(points[first], borders, [normal for normal, _ in planes])
    faces = [
        face
        for (normal, _), chain in zip(planes, chains, strict=True)
        for face in _cells(points, chain, normal)
    ]
    return points, _straight(points, faces)


def _planes(corners: Array) -> Iterator[tuple[Array, NDArray[np.intp]]]:
    """The normal of each plane, and the triangles in it, whichever side they look to."""
    areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sizes = np.linalg.norm(areas, axis=1)
    free = np.ones(len(corners), dtype=bool)
    for seed in np.argsort(-sizes, kind="stable").tolist():
        if free[seed]:
            normal = areas[seed] / max(sizes[seed], 1e-300)
            rest = np.flatnonzero(free)
            off = np.abs((corners[rest] - corners[seed, 0]) @ normal).max(axis=1)
            own = np.union1d(rest[off < 2 * _ON_MM], [seed])
            free[own] = False
            yield normal, own


def _border(triangles: Triangles) -> Chain:
    """The chain of triangles."""
    edges = np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    chain = Counter[Edge]()
    for a, b in edges.tolist():
        chain[min(a, b), max(a, b)] += (a < b) - (b < a)
    return {edge: count for edge, count in chain.items() if count}


def _split(
    points: Array, chains: Sequence[Chain], normals: Sequence[Array]
) -> tuple[Array, Sequence[Chain]]:
    """Chains whose edges end at all vertices that lie on them, and where they cross."""
    count = len(points)
    for _ in range(_ROUNDS):
        edges = sorted({edge for chain in chains for edge in chain})
        runs = _runs(points, np.array(edges, dtype=np.int64).reshape(-1, 2), count)
        if any(len(run) > 2 for run in runs.values()):
            chains = [_along(chain, runs) for chain in chains]
            continue
        pairs = zip(chains, normals, strict=True)
        crossings = [_crossings(points, chain, normal) for chain, normal in pairs if chain]
        more = np.vstack([np.empty((0, 3)), *crossings])
        if not len(more):
            break
        points = np.vstack([points, more])
    return points, chains


def _crossings(points: Array, chain: Chain, normal: Array) -> Array:
    """Where edges of a chain cross."""
    axes = np.linalg.svd(normal[None])[2][1:]
    origin = points[next(iter(chain))[0]]
    flat = (points[np.array(list(chain))] - origin) @ axes.T
    nodes = shapely.get_coordinates(shapely.node(shapely.multilinestrings(list(flat))))
    nodes = np.unique(nodes, axis=0)
    away = KDTree(flat.reshape(-1, 2)).query(nodes)[0] > _ON_MM
    return np.asarray(origin + nodes[away] @ axes)


def _runs(points: Array, edges: Triangles, first_new: int) -> dict[Edge, list[int]]:
    """For each edge the vertices on it, from its first to its last one."""
    found = {}
    names = np.union1d(edges, np.arange(first_new, len(points)))
    spots = points[names]
    for a, b in edges.tolist():
        span = points[b] - points[a]
        length = float(np.linalg.norm(span))
        arms = spots - points[a]
        along = arms @ (span / length)
        near = np.flatnonzero((along > 0) & (along < length))
        off = np.linalg.norm(arms[near] - np.outer(along[near], span / length), axis=1)
        on = near[off < _ON_MM]
        between = names[on[np.argsort(along[on], kind="stable")]].tolist()
        found[a, b] = [a, *(v for v in between if v not in (a, b)), b]
    return found


def _along(chain: Chain, runs: Mapping[Edge, Sequence[int]]) -> Chain:
    """A chain along runs in place of its edges."""
    result = Counter[Edge]()
    for edge, count in chain.items():
        for a, b in pairwise(runs[edge]):
            result[min(a, b), max(a, b)] += count if a < b else -count
    return {edge: count for edge, count in result.items() if count}


def _cells(points: Array, chain: Chain, normal: Array) -> Iterator[_Face]:
    """The faces that a chain bounds."""
    if not chain:
        return
    axes = np.linalg.svd(normal[None])[2][1:]
    axes = axes if np.cross(*axes) @ normal > 0 else axes[::-1]
    edges = np.array(list(chain))
    flat = points @ axes.T
    lines, counts = flat[edges], np.array(list(chain.values()))
    names = {tuple(flat[v]): v for v in np.unique(edges).tolist()}
    for cell in shapely.get_parts(shapely.polygonize(shapely.linestrings(lines))):
        turns = _turns(cell.representative_point(), lines, counts)
        if turns:
            whole = orient(cell, np.sign(turns))
            rings = [ring.coords[:-1] for ring in (whole.exterior, *whole.interiors)]
            yield _Face(normal * np.sign(turns), tuple([names[p] for p in ring] for ring in rings))


def _turns(spot: shapely.Point, lines: Array, counts: Array) -> int:
    """How often a chain winds around a point."""
    low, high = lines[:, 0, 1] <= spot.y, lines[:, 1, 1] <= spot.y
    share = (spot.y - lines[:, 0, 1]) / np.where(low != high, lines[:, 1, 1] - lines[:, 0, 1], 1.0)
    at = lines[:, 0, 0] + share * (lines[:, 1, 0] - lines[:, 0, 0])
    beyond = (low != high) & (at > spot.x)
    return int((counts * beyond * (low.astype(int) - high)).sum())


def _straight(points: Array, faces: Sequence[_Face]) -> list[_Face]:
    """Rings without points at which a side only goes on."""
    beside: dict[int, set[int]] = {}
    for a, b in (edge for face in faces for edge in face.edges):
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
    kept = [[[v for v in ring if v not in gone] for ring in face.rings] for face in faces]
    return [_Face(face.normal, tuple(rings)) for face, rings in zip(faces, kept, strict=True)]


def _shells(points: Array, faces: Sequence[_Face]) -> list[list[_Face]]:
    """Faces that hang together by edges: the one that encloses all else first, then hollows."""
    count = Counter(edge for face in faces for edge in face.edges)
    wrong = [edge for edge in count if count[edge] != 1 or count[edge[::-1]] != 1]
    if wrong:
        raise TouchingError(points[np.array(sorted({(min(e), max(e)) for e in wrong}))])
    sets, first = UnionFind(len(faces)), dict[Edge, int]()
    for n, face in enumerate(faces):
        for a, b in face.edges:
            sets.union(n, first.setdefault((min(a, b), max(a, b)), n))
    groups: dict[int, list[_Face]] = {}
    for face, label in zip(faces, sets.labels(), strict=True):
        groups.setdefault(label, []).append(face)
    volumes = {label: _volume(points, group) for label, group in groups.items()}
    least = _SPECK * max(volumes.values(), default=0.0)
    order = [
        label
        for label in sorted(groups, key=lambda label: -volumes[label])
        if abs(volumes[label]) > least
    ]
    parts = [label for label in order if volumes[label] > 0]
    if not parts:
        raise FabricationError("nothing is left of the walls", (), "a thicker wall")
    if len(parts) > 1:
        corners = [sorted({v for f in groups[n] for edge in f.edges for v in edge}) for n in parts]
        raise PartedError([points[part] for part in corners])
    return [groups[label] for label in order]


def _volume(points: Array, faces: Sequence[_Face]) -> float:
    """What faces enclose; less than 0 of a hollow."""
    middle = points.mean(axis=0)
    return sum(
        float(newell(points[ring]) @ (points[ring[0]] - middle)) / 3
        for face in faces
        for ring in face.rings
    )


def _shell(points: Array, faces: Sequence[_Face]) -> Any:
    """Faces that share their edges, as a closed shell."""
    from OCP.BRep import BRep_Builder
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
    from OCP.gp import gp_Dir, gp_Pln, gp_Pnt
    from OCP.TopoDS import TopoDS_Shell

    planes = [_plane(points, face) for face in faces]
    off: dict[int, float] = {}
    for (middle, normal), face in zip(planes, faces, strict=True):
        for v in (v for ring in face.rings for v in ring):
            off[v] = max(off.get(v, _LEAST_MM), 2 * abs(float((points[v] - middle) @ normal)))
    edges = _edges(points, faces, off)
    builder, shell = BRep_Builder(), TopoDS_Shell()
    builder.MakeShell(shell)
    for (middle, normal), face in zip(planes, faces, strict=True):
        plane = gp_Pln(gp_Pnt(*middle.tolist()), gp_Dir(*normal.tolist()))
        outer, *holes = (_wire(ring, edges) for ring in face.rings)
        made = BRepBuilderAPI_MakeFace(plane, outer, False)
        for hole in holes:
            made.Add(hole)
        builder.Add(shell, made.Face())
    shell.Closed(True)
    return shell


def _plane(points: Array, face: _Face) -> tuple[Array, Array]:
    """A point and the normal of the plane that fits a face best."""
    every = points[[v for ring in face.rings for v in ring]]
    area = np.sum([newell(points[ring]) for ring in face.rings], axis=0)
    return every.mean(axis=0), area / np.linalg.norm(area)


def _edges(points: Array, faces: Sequence[_Face], off: dict[int, float]) -> dict[Edge, Any]:
    """The kernel's edge for each pair of points, both ways."""
    from OCP.BRep import BRep_Builder
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
    from OCP.gp import gp_Pnt
    from OCP.TopoDS import TopoDS, TopoDS_Vertex

    builder, corners = BRep_Builder(), {}
    for v, tolerance in off.items():
        corners[v] = TopoDS_Vertex()
        builder.MakeVertex(corners[v], gp_Pnt(*points[v].tolist()), tolerance)
    edges: dict[Edge, Any] = {}
    for a, b in (edge for face in faces for edge in face.edges):
        if (a, b) not in edges:
            edge = BRepBuilderAPI_MakeEdge(corners[a], corners[b]).Edge()
            builder.UpdateEdge(edge, max(off[a], off[b]))
            edges[a, b], edges[b, a] = edge, TopoDS.Edge_s(edge.Reversed())
    return edges


def _wire(ring: Ring, edges: dict[Edge, Any]) -> Any:
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Wire

    builder, wire = BRep_Builder(), TopoDS_Wire()
    builder.MakeWire(wire)
    for pair in pairwise((*ring, ring[0])):
        builder.Add(wire, edges[pair])
    wire.Closed(True)
    return wire
