"""Direction classes: which edges are parallel, and which classes are perpendicular.

Terms
-----
direction class
    Edges that the annotations make parallel, directly or by reasoning.
perpendicular
    A relation between two classes, annotated at a vertex or following from other relations.

Everything here follows from annotations alone; the drawing is never asked. The rules:

1. edges of one parallel annotation, or of one symmetry plane, are of one class;
2. opposite sides of a quadrilateral with four right angles are of one class (a closed chain of
   four right angles is planar);
3. A and C perpendicular to both B and Z, with B perpendicular to Z: A and C are of one class;
4. in a plane (a triangle, a face that was named, a quadrilateral with two parallel sides): what is
   perpendicular to two of its directions is perpendicular to all of them, and two edges
    perpendicular to a third one of the same plane are parallel;
5. the ground is a plane: what is square to a polygon drawn on it, or to two perpendicular edges on
   it, is vertical, and all that is vertical is parallel.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from .chains import Chains, chains
from .merging import are_among, each_once, first_members, numbered
from .named_faces import named_faces
from .topology import Topology
from .union_find import UnionFind
from .values import IntArray


@dataclass(frozen=True, slots=True, eq=False)
class Directions:
    """Classes of parallel edges.

    Parameters
    ----------
    class_of : (m,) int array
        For each edge (in the graph's order) the class, named by its first edge.
    perpendicular : mapping of class to set of classes
    contradiction : bool
        True where a class came out perpendicular to itself.
    """

    class_of: IntArray
    perpendicular: dict[int, frozenset[int]]
    contradiction: bool


class _Relations:
    """Classes that merge while perpendicularities are added: the working state of the rules."""

    def __init__(self, n: int, perpendicular: Iterable[tuple[int, int]]) -> None:
        self.sets = UnionFind(n)
        self.perp: dict[int, set[int]] = {i: set() for i in range(n)}
        self.changed = True
        for i, j in perpendicular:
            self.perp[i].add(j)
            self.perp[j].add(i)

    def merge(self, i: int, j: int) -> None:
        i, j = self.sets.find(i), self.sets.find(j)
        if not self.sets.union(i, j):
            return
        self.changed = True
        keep = self.sets.find(i)
        gone = j if keep == i else i
        across = self.perp.pop(gone)
        for other in across - {gone}:
            self.perp[other].discard(gone)
        for other in {keep if o == gone else o for o in across}:
            self.perp[keep].add(other)
            self.perp[other].add(keep)

    def relate(self, i: int, j: int) -> None:
        i, j = self.sets.find(i), self.sets.find(j)
        if j not in self.perp[i]:
            self.changed = True
            self.perp[i].add(j)
            self.perp[j].add(i)

    @property
    def contradiction(self) -> bool:
        return any(i in others for i, others in self.perp.items())


def direction_classes(topology: Topology) -> Directions:
    """Reason out the direction classes of a graph's edges."""
    n_edges = len(topology.edges)
    closed = chains(topology)
    i, j = topology.right_angles[:, 1:].T
    corners = np.minimum(i, j) * n_edges + np.maximum(i, j)
    parallel = _said_parallel(topology, closed, corners)
    # Most edges are in few classes by now: the rules go on with classes alone.
    names, small = numbered(first_members(parallel, n_edges), n_edges)
    square = each_once(small[topology.right_angles[:, 1:]])
    relations = _Relations(len(names), map(tuple, square.tolist()))
    # Most chains run through the same few classes and say the same.
    triangles = each_once(small[closed.triangles])
    quadrilaterals = each_once(small[closed.quadrilaterals])
    class_of, named = small.tolist(), named_faces(topology)
    loops = named.loop_edges() if named is not None else []
    faces = [tuple([class_of[e] for e in loop]) for loop in loops]
    ground = [tuple(set(small[edges].tolist())) for edges in _parts_of_the_ground(topology)]
    while relations.changed and not relations.contradiction:
        relations.changed = False
        _close_around_pairs(relations)
        label = np.array(relations.sets.labels(), dtype=np.int64)
        flat = label[quadrilaterals]
        flat = flat[(flat[:, 0] == flat[:, 2]) | (flat[:, 1] == flat[:, 3])]
        faces = list(dict.fromkeys(tuple(map(relations.sets.find, plane)) for plane in faces))
        chained = [*each_once(label[triangles]).tolist(), *each_once(flat).tolist()]
        for plane in [*map(tuple, chained), *faces]:
            _close_plane(relations, plane)
        _close_ground(relations, ground)
    name = names.tolist()
    return Directions(
        names[np.array(relations.sets.labels(), dtype=np.int64)][small],
        {name[i]: frozenset(name[j] for j in others) for i, others in relations.perp.items()},
        relations.contradiction,
    )


def _said_parallel(topology: Topology, closed: Chains, corners: IntArray) -> IntArray:
    """Pairs of edges made parallel by annotations and by four right angles in a chain (1, 2)."""
    n_edges = len(topology.edges)
    pairs = [np.column_stack([np.broadcast_to(p[0], p.shape), p]) for p in topology.parallels]
    around = closed.quadrilaterals
    after = around[:, [1, 2, 3, 0]]
    code = np.minimum(around, after) * n_edges + np.maximum(around, after)
    square = around[are_among(code, corners, n_edges**2).all(axis=1)]
    return np.vstack([*pairs, square[:, [0, 2]], square[:, [1, 3]]]).astype(np.int64)


def _close_around_pairs(relations: _Relations) -> None:
    """Rule 3: what is perpendicular to both of two perpendicular classes is one class."""
    for b in list(relations.perp):
        for z in list(relations.perp.get(b, ())):
            if z <= b or z not in relations.perp or b not in relations.perp:
                continue
            both = sorted(relations.perp[b] & relations.perp[z])
            for other in both[1:]:
                relations.merge(both[0], other)


def _close_plane(relations: _Relations, plane: tuple[int, ...]) -> None:
    """Rule 4, for the edges of one plane."""
    find, perp = relations.sets.find, relations.perp
    around = [find(e) for e in plane]
    classes = sorted(set(around))
    if len(classes) < 2:
        return
    if _close_across(relations, classes):
        around = [find(e) for e in plane]
        classes = sorted(set(around))
    # Two classes of one plane that are not known to be parallel span it: edges that meet do.
    for first, second in _meeting_classes(relations, around):
        for normal in sorted(perp[first] & perp[second]):
            for c in classes:
                if normal not in perp[c]:
                    relations.relate(c, normal)


def _close_across(relations: _Relations, classes: list[int]) -> bool:
    """In one plane, what is perpendicular to one class is one class; whether some became so."""
    inside, found = set(classes), False
    for third in classes:
        # Merging renames classes: the smallest name stays.
        across = relations.perp[relations.sets.find(third)] & inside
        if len(across) > 1:
            found = True
            least, *others = sorted(across)
            for other in others:
                relations.merge(least, other)
                inside.discard(other)
    return found


def _close_ground(relations: _Relations, parts: list[tuple[int, ...]]) -> None:
    """Rule 5."""
    find = relations.sets.find
    _close_across(relations, sorted({find(e) for part in parts for e in part}))
    normals: set[int] = set()
    for part in parts:
        classes = {find(e) for e in part}
        # A polygon's sides are not all parallel.
        normals |= set.intersection(*(relations.perp[c] for c in classes))
    classes = {find(e) for part in parts for e in part}
    for c in classes:
        for across in relations.perp[c] & classes:
            normals |= relations.perp[c] & relations.perp[across]
    for normal in sorted(normals):
        relations.merge(min(normals), normal)
    if normals:
        for e in sorted(classes):
            relations.relate(find(e), find(min(normals)))


def _meeting_classes(relations: _Relations, around: list[int]) -> list[tuple[int, int]]:
    """Classes of neighbouring edges that surely bend: perpendicular, or no pieces of one side."""
    pairs = {(around[k - 1], around[k]) for k in range(len(around)) if around[k - 1] != around[k]}
    # Pieces of one straight side may differ in class, but not in these: a quadrilateral with two
    # parallel sides lies in a plane.
    trapezium = len(around) == 4 and (around[0] == around[2] or around[1] == around[3])
    if len(around) == 3 or trapezium:
        return sorted(pairs)
    return sorted((i, j) for i, j in pairs if j in relations.perp[i])


def _parts_of_the_ground(topology: Topology) -> list[IntArray]:
    """Edges between ground vertices, by connected part; only parts that close a polygon."""
    on_ground = np.zeros(len(topology.vertices), dtype=bool)
    on_ground[topology.ground] = True
    edges = np.flatnonzero(on_ground[topology.ends].all(axis=1))
    part_of = first_members(topology.ends[edges], len(topology.vertices))
    parts = part_of[topology.ends[edges, 0]]
    found = [edges[parts == part] for part in np.unique(parts)]
    return [part for part in found if len(part) >= len(np.unique(topology.ends[part]))]
