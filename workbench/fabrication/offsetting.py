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
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np

from ...solver.values import Array
from .errors import FabricationError

Loops = Sequence[Sequence[str]]
#: Planes meet in one point if they miss it by less, mm.
_ONE_POINT_MM = 1e-6
#: How far a clipped plane reaches, in parts of the largest move.
_FAR = 1e5


def moved_out(
    vertices: Mapping[str, Array],
    loops: Mapping[str, Loops],
    inwards: Mapping[str, Array],
    moves: Mapping[str, float],
) -> dict[str, tuple[Array, ...]]:
    """The rings of faces after their planes were moved outwards.

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
    dict of face id to rings
        One for each loop, (n, 3) each.

    Raises
    ------
    FabricationError
        Naming the faces that meet in a vertex which cannot be split.
    """
    corners = {
        v: _corners(v, faces, vertices, loops, inwards, moves)
        for v, faces in _faces_at(loops, inwards).items()
    }
    return {
        id_: tuple(
            np.vstack(
                [
                    _placed(corners[v][id_], before, after, vertices[v])
                    for before, v, after in _around(loop, vertices)
                ]
            )
            for loop in loops[id_]
        )
        for id_ in inwards
    }


def _faces_at(loops: Mapping[str, Loops], shown: Mapping[str, Array]) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for id_ in shown:
        for v in dict.fromkeys(v for loop in loops[id_] for v in loop):
            found.setdefault(v, []).append(id_)
    return found


def _around(loop: Sequence[str], vertices: Mapping[str, Array]) -> list[tuple[Array, str, Array]]:
    """Each vertex of a loop with the places before and after it."""
    places = [vertices[v] for v in loop]
    return [(places[k - 1], v, places[(k + 1) % len(loop)]) for k, v in enumerate(loop)]


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
    """Where a vertex goes, for each of its faces, (n, 3)."""
    move = _common_move(faces, inwards, moves)
    if move is None:  # an opening need not be kept to
        move = _common_move([f for f in faces if moves[f] > 0], inwards, moves)
    if move is not None:
        return dict.fromkeys(faces, np.array([vertices[v] + move]))
    return _split(v, faces, vertices, loops, inwards, moves)


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
    """The corners of the cone that a vertex's moved planes bound."""
    normals = np.array([-inwards[f] for f in faces])
    wished = np.array([moves[f] for f in faces])
    sense = _sense(v, faces, vertices, loops, normals)
    found = {}
    for k, face in enumerate(faces):
        others = np.arange(len(faces)) != k
        chain = _chain(normals[k], wished[k], sense * normals[others], sense * wished[others])
        if not sense or not len(chain):
            raise FabricationError(
                f"where these {len(faces)} faces meet in {v}, material cannot lie outside of "
                "them or in their middle: their planes, moved, meet in no point",
                faces,
                "side inside, or one thickness for all of them",
            )
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
