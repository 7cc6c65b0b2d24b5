"""The wall of a print, put together from prisms and convex pieces.

Terms
-----
normal
    Of a face: towards its wall. An edge or vertex is reflex where the wall lies all around it.
prism
    A face, its copy moved by the wall's thickness, and what lies between.
gusset
    What prisms leave open along an edge: between those of two faces at a reflex edge, up to the
    line in which their moved planes meet, and between a face's and the plane of a mouth.
core
    What prisms and gussets leave open at a vertex whose moved planes meet in no point.

All that lies nearer to a face than the wall is thick is in a piece: it is nearest to the face
itself (prism), to one of its edges (gusset) or to one of its vertices (core). So the wall is
nowhere thinner than asked. Where the moved planes of each vertex meet in one point, or all of its
edges are of one kind, the wall ends in these planes exactly; at other vertices it is thicker.

Pieces that touch keep films of rounding between them, which `flat_solids` takes away.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import manifold3d
import numpy as np
from manifold3d import Manifold

from ...solver.union_find import UnionFind
from ...solver.values import Array
from .booleans import hull, united
from .enclosed import triangulated
from .frame import newell
from .polyhedra import Loop, Polyhedron

#: Moved planes meet in one point if they miss it by less, mm.
_ONE_POINT_MM = 1e-6
#: Sine of the angle up to which two faces lie in one plane.
_FLAT = 1e-6
#: Half the size of the cube from which cores are cut, in walls: they reach less far.
_FAR = 200.0
#: A smaller core comes from rounding, in walls cubed.
_LEAST = 1e-9
Edge = tuple[str, str]


@dataclass(frozen=True, slots=True, eq=False)
class _Corner:
    """A vertex with the faces around it; of a vertex in which two bodies touch, those of one.

    `ways` are its edges' directions, `move_mm` the least move into all moved planes (those of
    mouths stay), None where they meet in no point.
    """

    at_mm: Array
    faces: tuple[str, ...]
    normals: Array
    ways: Array
    reflex: bool
    move_mm: Array | None


@dataclass(frozen=True, slots=True, eq=False)
class _Gusset:
    """A gusset, and its section at both ends: from the edge's end around it."""

    body: Manifold
    sections: Mapping[str, Array]


def built_wall(
    body: Polyhedron,
    block: Manifold,
    outwards: Mapping[str, Array],
    mouths: Sequence[str],
    low_mm: float,
    high_mm: float,
) -> Manifold:
    """The wall of a body between two copies of its faces, made of pieces.

    Parameters
    ----------
    body : Polyhedron
    block : manifold3d.Manifold
        What it encloses.
    outwards : mapping of face id to (3,) array
        Unit normals that look away from the object.
    mouths : sequence of face ids
        They get no wall; the walls beside them end in their planes, or square.
    low_mm, high_mm : float
        How far the copies lie from the faces, at most and at least 0: outwards where positive.

    Returns
    -------
    manifold3d.Manifold
    """
    moves = [move for move in (low_mm, high_mm) if move]
    walls = [Pieces(body, block, outwards, mouths, move).wall() for move in moves]
    return united(walls)


class Pieces:
    """The pieces of a wall.

    Parameters
    ----------
    body : Polyhedron
    block : manifold3d.Manifold
        What it encloses.
    outwards : mapping of face id to (3,) array
        Unit normals that look away from the object.
    mouths : sequence of face ids
        They get no wall; the walls beside them end in their planes.
    move_mm : float
        How far the wall's other surface lies from the drawn one; outwards where positive.
    """

    def __init__(
        self,
        body: Polyhedron,
        block: Manifold,
        outwards: Mapping[str, Array],
        mouths: Sequence[str],
        move_mm: float,
    ) -> None:
        self.block, self.mouths, self.wall_mm = block, frozenset(mouths), abs(move_mm)
        self.outside = move_mm > 0
        self._at = body.vertices_mm
        self.normals = {id_: n if self.outside else -n for id_, n in outwards.items()}
        self._loops = {
            id_: _turning(body, loops, self.normals[id_]) for id_, loops in body.skin.items()
        }
        self.rings = {
            id_: [body.points(loop) for loop in loops] for id_, loops in self._loops.items()
        }
        self._face_at = {
            pair: id_
            for id_, loops in self._loops.items()
            for loop in loops
            for pair in pairwise((*loop, loop[0]))
        }
        points = np.array(list(self._at.values()))
        self.last = [id_ for id_ in self._loops if self._is_last(id_, points)]
        self._corners = self._all_corners()

    def together(self) -> Manifold:
        """All pieces."""
        made = dict(self._gussets())
        pieces = [self.prism(id_) for id_ in self._loops if id_ not in self.mouths]
        pieces += [gusset.body for gusset in made.values()]
        pieces += self._cores(made)
        return united(pieces)

    def wall(self) -> Manifold:
        """All pieces on their side of the drawn faces."""
        every = self.together()
        if not self.outside:
            return every ^ self.block
        # Planes come after the block: the other way round a film stays over mouths.
        wall = every - self.block
        for id_ in self.last:
            move = 0.0 if id_ in self.mouths else self.wall_mm
            wall = _behind(wall, self.rings[id_][0][0], self.normals[id_], move)
        return wall

    def prism(self, id_: str) -> Manifold:
        """A face's prism."""
        return prism(self.rings[id_], self.wall_mm * self.normals[id_])

    def _is_last(self, id_: str, points: Array) -> bool:
        """Whether the wall ends in a face's moved plane: nothing lies beyond it.

        A mouth in whose plane a face is made elsewhere is none: that face has its wall there.
        """
        origin, normal = self.rings[id_][0][0], self.normals[id_]
        near = _FLAT * float(np.ptp(points, axis=0).max())
        shared = id_ in self.mouths and any(
            np.abs((np.vstack(rings) - origin) @ normal).max() < near
            for other, rings in self.rings.items()
            if other not in self.mouths
        )
        heights = (points - origin) @ normal
        return self.outside and not shared and float(heights.max()) < near

    def _beside(self, edge: Edge) -> Array:
        """The direction at an edge away from its face, in the face's plane."""
        v, w = edge
        beside = np.cross(self._at[w] - self._at[v], self.normals[self._face_at[edge]])
        return np.asarray(beside / np.linalg.norm(beside))

    def _gussets(self) -> Iterator[tuple[Edge, _Gusset]]:
        """By the edge as its first face turns around it."""
        for edge, one in self._face_at.items():
            other = self._face_at[edge[::-1]]
            if one in self.mouths or (other not in self.mouths and edge > edge[::-1]):
                continue
            a, b, beside = self.normals[one], self.normals[other], self._beside(edge)
            slope = float(b @ beside)
            if other in self.mouths:
                # At an edge that looks away from the mouth the wall ends square.
                flush = slope < -_FLAT or (slope > _FLAT and self.outside)
                lean = -float(b @ a) / slope if flush else 0.0
                arms = [a, a + lean * beside] if lean > _FLAT else []
            else:
                arms = [a, (a + b) / (1 + a @ b), b] if slope > _FLAT else []
            if arms:
                yield edge, self._gusset(edge, self.wall_mm * np.array(arms))

    def _gusset(self, edge: Edge, arms: Array) -> _Gusset:
        """The gusset at an edge; `arms` go from there to the corners of its section."""
        one, sections = self._face_at[edge], {}
        ends = [self._corners[v][one] for v in edge]
        for v, corner in zip(edge, ends, strict=True):
            sections[v] = np.vstack([corner.at_mm, corner.at_mm + arms])
            if corner.move_mm is not None:
                sections[v][2] = corner.at_mm + corner.move_mm
        made = hull(np.vstack(list(sections.values())))
        for corner in ends:
            if corner.reflex:
                made = _cut(made, corner, corner.normals, self.wall_mm)
        return _Gusset(made, sections)

    def _cores(self, made: Mapping[Edge, _Gusset]) -> Iterator[Manifold]:
        for v, around in self._corners.items():
            for corner in {id(corner): corner for corner in around.values()}.values():
                if corner.move_mm is not None:
                    if corner.reflex:  # it reaches into all gussets there
                        open_ = [f for f in corner.faces if f not in self.mouths]
                        feet = [self.wall_mm * self.normals[f] for f in open_]
                        tips = np.array([0 * corner.move_mm, corner.move_mm, *feet])
                        yield hull(corner.at_mm + tips)
                elif not self.mouths.issuperset(corner.faces):
                    sections = [
                        gusset.sections[v]
                        for edge, gusset in made.items()
                        if v in edge and self._face_at[edge] in corner.faces
                    ]
                    yield from self._core(corner, sections)

    def _core(self, corner: _Corner, sections: Sequence[Array]) -> Iterator[Manifold]:
        """The core of a vertex in which gussets end with some sections."""
        size = 2 * _FAR * self.wall_mm
        core = Manifold.cube([size] * 3, center=True).translate(corner.at_mm.tolist())
        core = _cut(core, corner, corner.ways, self.wall_mm if corner.reflex else 0.0)
        core = _cut(core, corner, corner.normals, self.wall_mm)
        if core.volume() < _LEAST * self.wall_mm**3:
            return
        if corner.reflex:
            yield core
            return
        points = np.asarray(core.to_mesh64().vert_properties)[:, :3]
        reach = float(np.linalg.norm(points - corner.at_mm, axis=1).max())
        spot = corner.at_mm + (points.mean(axis=0) - corner.at_mm) * 1e-3 * self.wall_mm / reach
        if _encloses(self.block, spot) == self.outside:
            return
        feet = [self.wall_mm * self.normals[f] for f in corner.faces if f not in self.mouths]
        yield hull(np.vstack([points, corner.at_mm + feet, *sections]))

    def _all_corners(self) -> dict[str, dict[str, _Corner]]:
        """For each vertex and face there, the corner that they belong to."""
        spots = list(dict.fromkeys((v, f) for edge, f in self._face_at.items() for v in edge))
        number = {spot: n for n, spot in enumerate(spots)}
        sets = UnionFind(len(spots))
        for edge, face in self._face_at.items():
            for v in edge:
                sets.union(number[v, face], number[v, self._face_at[edge[::-1]]])
        groups: dict[int, list[tuple[str, str]]] = {}
        for spot, label in zip(spots, sets.labels(), strict=True):
            groups.setdefault(label, []).append(spot)
        result: dict[str, dict[str, _Corner]] = {}
        for group in groups.values():
            v, faces = group[0][0], tuple(f for _, f in group)
            result.setdefault(v, {}).update(dict.fromkeys(faces, self._corner(v, faces)))
        return result

    def _corner(self, v: str, faces: tuple[str, ...]) -> _Corner:
        edges = [edge for edge, f in self._face_at.items() if edge[0] == v and f in faces]
        bends = [
            float(self._beside(edge) @ self.normals[self._face_at[edge[::-1]]]) for edge in edges
        ]
        ways = np.array([self._at[w] - self._at[v] for _, w in edges])
        normals = np.array([self.normals[f] for f in faces])
        limits = np.array([0.0 if f in self.mouths else self.wall_mm for f in faces])
        move = np.linalg.lstsq(normals, limits, rcond=1e-6)[0]
        meets = np.abs(normals @ move - limits).max() < _ONE_POINT_MM
        return _Corner(
            at_mm=self._at[v],
            faces=faces,
            normals=normals,
            ways=ways / np.linalg.norm(ways, axis=1)[:, None],
            reflex=min(bends) > -_FLAT,
            move_mm=move if meets else None,
        )


def prism(rings: Sequence[Array], way: Array) -> Manifold:
    """What a polygon (outer ring and holes), turning left around `way`, leaves on its way."""
    flat = np.vstack(rings)
    count = len(flat)
    low = triangulated(rings)
    starts = np.cumsum([0, *map(len, rings)])
    here = np.arange(count)
    after = np.concatenate([np.roll(here[a:b], -1) for a, b in pairwise(starts.tolist())])
    sides = [np.array([here, after, after + count]), np.array([here, after + count, here + count])]
    triangles = np.vstack([low[:, ::-1], low + count, *(side.T for side in sides)])
    points = np.vstack([flat, flat + way])
    return Manifold(manifold3d.Mesh64(points, triangles.astype(np.uint64)))


def _turning(body: Polyhedron, loops: Sequence[Loop], normal: Array) -> tuple[Loop, ...]:
    """Loops that turn left around a normal, holes right."""
    senses = [float(newell(body.points(loop)) @ normal) > 0 for loop in loops]
    return tuple(
        loop if sense == (n == 0) else loop[::-1]
        for n, (loop, sense) in enumerate(zip(loops, senses, strict=True))
    )


def _cut(made: Manifold, corner: _Corner, normals: Array, limit: float) -> Manifold:
    """What of a body lies up to `limit` along normals from a corner."""
    for normal in normals:
        made = _behind(made, corner.at_mm, normal, limit)
    return made


def _behind(made: Manifold, at: Array, normal: Array, limit: float) -> Manifold:
    """What of a body lies up to `limit` along a normal from a point."""
    return made.trim_by_plane((-normal).tolist(), float(-normal @ at) - limit)


def _encloses(block: Manifold, point: Array) -> bool:
    """Whether a point lies in a body: the solid angles of its triangles add up to 4 pi."""
    mesh = block.to_mesh64()
    corners = np.asarray(mesh.vert_properties)[:, :3][np.asarray(mesh.tri_verts)] - point
    a, b, c = corners.swapaxes(0, 1)
    sizes = np.linalg.norm(corners, axis=2)
    high = np.einsum("ij,ij->i", a, np.cross(b, c))
    low = sizes.prod(axis=1) + sizes[:, 2] * (a * b).sum(axis=1)
    low += sizes[:, 0] * (b * c).sum(axis=1) + sizes[:, 1] * (a * c).sum(axis=1)
    return bool(2 * np.arctan2(high, low).sum() > 2 * np.pi)
