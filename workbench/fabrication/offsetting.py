"""Faces moved outwards: where their corners go.

Terms
-----
move
    How far a face's plane goes outwards, mm.
regular
    A vertex whose planes, moved, still meet in one point: always so where three planes meet.
split
    What becomes of another vertex: several corners with short edges between them, those of the
    cone that its moved planes bound. A face then has a chain of corners in its place.
mixed
    A vertex where some edges look outwards and others inwards, so that no such cone is bounded:
    each face ends in its own corner there, where it meets its two neighbours.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np

from ...solver.values import Array

Loops = Sequence[Sequence[str]]
#: Planes meet in one point if they miss it by less, mm.
_ONE_POINT_MM = 1e-6
#: How far a clipped plane reaches, in parts of the largest move.
_FAR = 1e5
#: Cosine from which two faces lie in one plane.
_ONE_PLANE = 1 - 1e-9


def moved_corners(
    vertices: Mapping[str, Array],
    loops: Mapping[str, Loops],
    inwards: Mapping[str, Array],
    moves: Mapping[str, float],
) -> dict[str, tuple[list[Array], ...]]:
    """The corners of faces after their planes were moved outwards.

    Parameters
    ----------
    vertices : mapping of vertex id to (3,) array
    loops : mapping of face id to loops
        Outer loop and holes.
    inwards : mapping of face id to (3,) array
        Unit normals to the inside, of the faces to be moved.
    moves : mapping of face id to mm
        0 for openings, which need not be kept to.

    Returns
    -------
    dict of face id to loops
        For each vertex of each loop the corners that it becomes, (n, 3).
    """
    at = _faces_at(loops, inwards)
    corners = {v: _corners(v, at[v], vertices, loops, inwards, moves) for v in at}
    beside = _beside(loops, inwards)
    result: dict[str, tuple[list[Array], ...]] = {}
    for id_ in inwards:
        rings: list[list[Array]] = []
        for loop in loops[id_]:
            chains = []
            for n, v in enumerate(loop):
                before, after = loop[n - 1], loop[(n + 1) % len(loop)]
                chain = corners[v].get(id_)
                if chain is None:
                    ends = (beside.get((before, v)), beside.get((v, after)))
                    neighbours = [f for pair in ends for f in (pair or ()) if f != id_]
                    move = _own_move(id_, neighbours, inwards, moves)
                    chain = np.array([vertices[v] + move])
                chains.append(_placed(chain, *(vertices[w] for w in (before, after, v))))
            rings.append(chains)
        result[id_] = tuple(rings)
    return result


def mixed_vertices(
    vertices: Mapping[str, Array],
    loops: Mapping[str, Loops],
    inwards: Mapping[str, Array],
    moves: Mapping[str, float],
) -> dict[str, list[str]]:
    """The mixed vertices of faces, with the faces that meet there; see `moved_corners`."""
    found = {}
    for v, faces in _faces_at(loops, inwards).items():
        if _common_move(faces, inwards, moves) is None:
            normals = np.array([-inwards[f] for f in faces])
            if _sense(v, faces, vertices, loops, normals) == 0:
                found[v] = faces
    return found


def _faces_at(loops: Mapping[str, Loops], shown: Mapping[str, Array]) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for id_ in shown:
        for v in dict.fromkeys(v for loop in loops[id_] for v in loop):
            found.setdefault(v, []).append(id_)
    return found


def _beside(
    loops: Mapping[str, Loops], shown: Mapping[str, Array]
) -> dict[tuple[str, str], list[str]]:
    """The faces at each edge, both ways."""
    found: dict[tuple[str, str], list[str]] = {}
    for id_ in shown:
        for loop in loops[id_]:
            for v, w in pairwise((*loop, loop[0])):
                found.setdefault((v, w), []).append(id_)
                found.setdefault((w, v), []).append(id_)
    return found


def _placed(chain: Array, before: Array, after: Array, at: Array) -> Array:
    """A chain in the loop's direction."""
    if len(chain) < 2:
        return chain
    back, on = before - at, after - at
    way = back / np.linalg.norm(back) - on / np.linalg.norm(on)
    return chain if (chain[0] - chain[-1]) @ way > 0 else chain[::-1]


def _corners(
    v: str,
    faces: Sequence[str],
    vertices: Mapping[str, Array],
    loops: Mapping[str, Loops],
    inwards: Mapping[str, Array],
    moves: Mapping[str, float],
) -> dict[str, Array]:
    """Where a vertex goes, for each of its faces, (n, 3); nothing for a mixed one."""
    move = _common_move(faces, inwards, moves)
    if move is None:  # an opening need not be kept to
        move = _common_move([f for f in faces if moves[f] > 0], inwards, moves)
    if move is not None:
        return dict.fromkeys(faces, np.array([vertices[v] + move]))
    return _split(v, faces, vertices, loops, inwards, moves)


def _own_move(
    face: str,
    neighbours: Sequence[str],
    inwards: Mapping[str, Array],
    moves: Mapping[str, float],
) -> Array:
    """How a face's own corner moves: in its moved plane, onto the lines of its neighbours."""
    own = -inwards[face]
    # Neighbours in the same plane say nothing about where the corner goes.
    others = [f for f in neighbours if abs(float(inwards[f] @ own)) < _ONE_PLANE]
    normals = np.array([own, *(-inwards[f] for f in others)])
    wished = np.array([moves[f] for f in (face, *others)])
    move: Array = np.linalg.lstsq(normals, wished, rcond=1e-6)[0]
    return move + (moves[face] - float(own @ move)) * own


def _common_move(
    faces: Sequence[str], inwards: Mapping[str, Array], moves: Mapping[str, float]
) -> Array | None:
    """The least move of a vertex that moves all its planes outwards as wished."""
    if not faces:
        return np.zeros(3)
    normals = -np.array([inwards[f] for f in faces])
    wished = np.array([moves[f] for f in faces])
    move: Array = np.linalg.lstsq(normals, wished, rcond=1e-6)[0]
    return move if np.abs(normals @ move - wished).max() < _ONE_POINT_MM else None


def _split(
    v: str,
    faces: Sequence[str],
    vertices: Mapping[str, Array],
    loops: Mapping[str, Loops],
    inwards: Mapping[str, Array],
    moves: Mapping[str, float],
) -> dict[str, Array]:
    """The corners of the cone that a vertex's moved planes bound; nothing of a mixed vertex."""
    normals = np.array([-inwards[f] for f in faces])
    wished = np.array([moves[f] for f in faces])
    sense = _sense(v, faces, vertices, loops, normals)
    found = {}
    for k, face in enumerate(faces):
        others = np.arange(len(faces)) != k
        chain = _chain(normals[k], wished[k], sense * normals[others], sense * wished[others])
        if not sense or not len(chain):
            return {}
        found[face] = vertices[v] + chain
    return found


def _sense(
    v: str,
    faces: Sequence[str],
    vertices: Mapping[str, Array],
    loops: Mapping[str, Loops],
    normals: Array,
) -> int:
    """1 where all edges at a vertex are convex, -1 where all are concave, 0 otherwise."""
    ways = [
        vertices[w] - vertices[v]
        for f in faces
        for loop in loops[f]
        for a, b in pairwise((*loop, loop[0]))
        for w in ((b,) if a == v else (a,) if b == v else ())
    ]
    heights = np.array(ways) @ normals.T
    size = 1e-6 * float(np.abs(np.array(ways)).max())
    coplanar = (normals @ normals.T > 1 - 1e-9).sum() > len(faces)
    if coplanar:
        return 0
    return 1 if heights.max() < size else -1 if heights.min() > -size else 0


def _chain(normal: Array, move: float, others: Array, wished: Array) -> Array:
    """The corners of a moved plane among half-spaces ``others @ x <= wished``, in their order."""
    helper = np.eye(3)[int(np.abs(normal).argmin())]
    u = np.cross(helper, normal)
    u = u / np.linalg.norm(u)
    axes = np.array([u, np.cross(normal, u)])
    middle = move * normal
    far = _FAR * max(1.0, float(np.abs(wished).max()))
    ring = far * np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
    for other, limit in zip(others @ axes.T, wished - others @ middle, strict=True):
        ring = _clipped(ring, other, float(limit))
    if not len(ring):
        return np.zeros((0, 3))
    near = np.abs(ring).max(axis=1) < far / 2
    # The chain begins after the last corner that is far away.
    start = int(np.flatnonzero(~near)[-1]) + 1 if not near.all() else 0
    order = (np.arange(len(ring)) + start) % len(ring)
    chain = ring[order][near[order]]
    if len(chain) > 1:
        apart = np.linalg.norm(np.diff(chain, axis=0), axis=1) > _ONE_POINT_MM
        chain = chain[np.concatenate([[True], apart])]
    return np.asarray(middle + chain @ axes)


def _clipped(ring: Array, normal: Array, limit: float) -> Array:
    """A convex ring where ``normal @ p <= limit`` (Sutherland and Hodgman)."""
    kept: list[Array] = []
    heights = ring @ normal - limit if len(ring) else np.zeros(0)
    for k in range(len(ring)):
        a, b, high_a, high_b = ring[k - 1], ring[k], heights[k - 1], heights[k]
        if (high_a > 0) != (high_b > 0):
            kept.append(a + (b - a) * high_a / (high_a - high_b))
        if high_b <= 0:
            kept.append(b)
    return np.array(kept).reshape(-1, 2)
