"""The faces that a sketch lists, as numbers: all their loops, one after the other.

Terms
-----
touching
    A vertex that an annotation puts on a face.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .topology import Topology, indices
from .values import BoolArray, IntArray, kept


@dataclass(frozen=True, slots=True, eq=False)
class NamedFaces:
    """Listed faces of which a loop is known.

    Parameters
    ----------
    ids : tuple of str
    loops : (t,) int array
        Vertices of their outer loops.
    edges : (t,) int array
        The edge that joins each of those to the one before it, -1 where none is drawn.
    first : (f,) int array
        Where each loop begins.
    holes, touching : (k, 2) int arrays
        Face and vertex of all holes' vertices and of all that touches.
    touching_ids : tuple of str
        The annotations that say so.
    """

    ids: tuple[str, ...]
    loops: IntArray
    edges: IntArray
    first: IntArray
    holes: IntArray
    touching: IntArray
    touching_ids: tuple[str, ...]

    @property
    def face(self) -> IntArray:
        """Of each vertex of the loops, (t,)."""
        sizes = np.diff(self.first, append=len(self.loops))
        return np.repeat(np.arange(len(self.first)), sizes)

    def shared(self, label: IntArray) -> BoolArray:
        """Of which axes (f, 3) all vertices of a loop have one label; labels are (n, 3)."""
        of_loops = label[self.loops]
        least = np.minimum.reduceat(of_loops, self.first, axis=0)
        return np.asarray(least == np.maximum.reduceat(of_loops, self.first, axis=0))

    def loop_edges(self) -> list[tuple[int, ...]]:
        """The drawn edges of each outer loop, in order."""
        edges, first = self.edges.tolist(), [*self.first.tolist(), len(self.edges)]
        return [
            tuple([e for e in edges[first[k] : first[k + 1]] if e >= 0])
            for k in range(len(self.ids))
        ]


@kept
def named_faces(topology: Topology) -> NamedFaces | None:
    """The listed faces of a sketch; None where it lists none."""
    known = {id_: face for id_, face in (topology.faces or {}).items() if face.loop}
    if not known:
        return None
    place = dict(zip(known, range(len(known)), strict=True))
    sizes = [len(face.loop) for face in known.values()]
    loops = indices(topology.vertices, [v for face in known.values() for v in face.loop])
    first = np.cumsum([0, *sizes[:-1]])
    before = np.arange(-1, len(loops) - 1)
    before[first] += sizes
    holes = [(k, v) for k, f in enumerate(known.values()) for hole in f.holes for v in hole]
    touching = [
        (id_, place[a.face], a.vertex) for id_, a in topology.by_kind["on_face"] if a.face in place
    ]
    return NamedFaces(
        tuple(known),
        loops,
        _edges_between(topology, loops[before], loops),
        first,
        _rows(topology, holes),
        _rows(topology, [(k, v) for _, k, v in touching]),
        tuple(id_ for id_, _, _ in touching),
    )


def _rows(topology: Topology, found: list[tuple[int, str]]) -> IntArray:
    rows = [(k, topology.vertices[v]) for k, v in found]
    return np.array(rows, dtype=np.int64).reshape(-1, 2)


def _edges_between(topology: Topology, v: IntArray, w: IntArray) -> IntArray:
    """The edges that join vertices v to w, -1 where there is none."""
    ends, n = topology.ends, len(topology.vertices)
    if not len(ends):
        return np.full(len(v), -1)
    code = ends.min(axis=1) * n + ends.max(axis=1)
    wanted = np.minimum(v, w) * n + np.maximum(v, w)
    order = np.argsort(code, kind="stable")
    at = order[np.minimum(np.searchsorted(code, wanted, sorter=order), len(code) - 1)]
    return np.where(code[at] == wanted, at, -1)
