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
   perpendicular to a third one of the same plane are parallel.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from .annotations import Annotation, Parallel, RightAngle, SymmetryPlane
from .graph import SketchGraph
from .union_find import UnionFind

#: A tangle in which everything is joined to everything has more closed chains than can be looked
#: at; an object has a few for each edge.
MAX_CYCLES = 20_000


@dataclass(frozen=True, slots=True)
class Directions:
    """Classes of parallel edges.

    Parameters
    ----------
    class_of : tuple of int
        For each edge (in the graph's order) the class, named by its first edge.
    perpendicular : mapping of class to set of classes
    contradiction : bool
        True where a class came out perpendicular to itself.
    """

    class_of: tuple[int, ...]
    perpendicular: dict[int, frozenset[int]]
    contradiction: bool


class _Relations:
    """Classes that merge while perpendicularities are added: the working state of the rules."""

    def __init__(self, n_edges: int) -> None:
        self.sets = UnionFind(n_edges)
        self.perp: dict[int, set[int]] = {i: set() for i in range(n_edges)}
        self.changed = False

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

    def are_perpendicular(self, i: int, j: int) -> bool:
        return self.sets.find(j) in self.perp[self.sets.find(i)]

    @property
    def contradiction(self) -> bool:
        return any(i in others for i, others in self.perp.items())


def direction_classes(
    graph: SketchGraph, annotations: Iterable[Annotation] | None = None
) -> Directions:
    """Reason out the direction classes of a graph's edges.

    Parameters
    ----------
    graph : SketchGraph
    annotations : iterable of Annotation, optional
        Those to use; by default all of the graph's.

    Returns
    -------
    Directions
    """
    index = {id_: i for i, id_ in enumerate(graph.edges)}
    said = tuple(graph.annotations.values() if annotations is None else annotations)
    relations = _Relations(len(index))
    corners = _say(relations, index, said)
    quadrilaterals = _quadrilaterals(graph)
    for cycle in quadrilaterals:
        if all((cycle[k], cycle[k - 1]) in corners for k in range(4)):
            relations.merge(cycle[0], cycle[2])
            relations.merge(cycle[1], cycle[3])
    planes = _triangles(graph) + _named_faces(graph, index)
    relations.changed = True
    while relations.changed and not relations.contradiction:
        relations.changed = False
        _close_around_pairs(relations)
        flat = [c for c in quadrilaterals if _has_parallel_sides(relations, c)]
        for plane in [*planes, *flat]:
            _close_plane(relations, plane)
    return Directions(
        tuple(relations.sets.labels()),
        {i: frozenset(others) for i, others in relations.perp.items()},
        relations.contradiction,
    )


def _say(
    relations: _Relations, index: dict[str, int], said: Iterable[Annotation]
) -> set[tuple[int, int]]:
    """Enter what was annotated; return the annotated corners as ordered pairs of edges."""
    corners: set[tuple[int, int]] = set()
    for annotation in said:
        if isinstance(annotation, RightAngle):
            i, j = (index[e] for e in annotation.between)
            relations.relate(i, j)
            corners |= {(i, j), (j, i)}
        elif isinstance(annotation, Parallel | SymmetryPlane):
            edges = (
                annotation.edges if isinstance(annotation, Parallel) else annotation.midpoints_of
            )
            for e in edges[1:]:
                relations.merge(index[edges[0]], index[e])
    return corners


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
    classes = sorted({relations.sets.find(e) for e in plane})
    if len(classes) < 2:
        return
    for third in classes:
        # Merging renames classes: look each up again.
        across = [c for c in classes if relations.are_perpendicular(third, c)]
        for other in across[1:]:
            relations.merge(across[0], other)
    classes = sorted({relations.sets.find(e) for e in plane})
    # Two classes of one plane that are not known to be parallel span it: edges that meet do.
    spanning = _meeting_classes(relations, plane)
    if spanning is None:
        return
    first, second = spanning
    for normal in sorted(relations.perp[first] & relations.perp[second]):
        for c in classes:
            relations.relate(relations.sets.find(c), relations.sets.find(normal))


def _meeting_classes(relations: _Relations, plane: tuple[int, ...]) -> tuple[int, int] | None:
    """Two classes of neighbouring edges that are known to be perpendicular, else just different."""
    found = None
    for k in range(len(plane)):
        i, j = relations.sets.find(plane[k - 1]), relations.sets.find(plane[k])
        if i == j:
            continue
        if relations.are_perpendicular(i, j):
            return (i, j)
        # Pieces of one straight side may differ in class; these corners are sure bends.
        if len(plane) == 3 or _has_parallel_sides(relations, plane):
            found = found or (i, j)
    return found


def _has_parallel_sides(relations: _Relations, plane: tuple[int, ...]) -> bool:
    """Whether this is a quadrilateral with two parallel sides; such a one lies in a plane."""
    find = relations.sets.find
    return len(plane) == 4 and (
        find(plane[0]) == find(plane[2]) or find(plane[1]) == find(plane[3])
    )


def _neighbours(graph: SketchGraph) -> dict[str, dict[str, int]]:
    joined: dict[str, dict[str, int]] = {v: {} for v in graph.vertices}
    for i, (v, w) in enumerate(graph.edges.values()):
        joined[v][w] = i
        joined[w][v] = i
    return joined


def _quadrilaterals(graph: SketchGraph) -> list[tuple[int, int, int, int]]:
    """Closed chains of four edges, in order around; each once."""
    joined = _neighbours(graph)
    order = {v: i for i, v in enumerate(graph.vertices)}
    cycles: list[tuple[int, int, int, int]] = []
    for a, around in joined.items():
        if len(cycles) > MAX_CYCLES:
            break
        # a is the chain's first vertex; c lies across, b and d between them.
        across: dict[str, list[str]] = {}
        for b in around:
            if order[b] > order[a]:
                for c in joined[b]:
                    if order[c] > order[a]:
                        across.setdefault(c, []).append(b)
        for c, between in across.items():
            for k, b in enumerate(between):
                for d in between[k + 1 :]:
                    cycles.append((joined[a][b], joined[b][c], joined[c][d], joined[d][a]))
    return cycles


def _triangles(graph: SketchGraph) -> list[tuple[int, ...]]:
    joined = _neighbours(graph)
    order = {v: i for i, v in enumerate(graph.vertices)}
    found: list[tuple[int, ...]] = []
    for i, (v, w) in enumerate(graph.edges.values()):
        if len(found) > MAX_CYCLES:
            break
        for u in joined[v].keys() & joined[w].keys():
            if order[u] > order[v] and order[u] > order[w]:
                found.append((i, joined[w][u], joined[u][v]))
    return sorted(found)


def _named_faces(graph: SketchGraph, index: dict[str, int]) -> list[tuple[int, ...]]:
    """The edges of each named face's outer loop, in order, where all of them are drawn."""
    joined = _neighbours(graph)
    planes = []
    for face in (graph.faces or {}).values():
        loop = face.loop
        edges = [joined[loop[k - 1]].get(loop[k]) for k in range(len(loop))]
        planes.append(tuple(e for e in edges if e is not None))
    return planes
