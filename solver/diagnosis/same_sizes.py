"""Sizes that cannot all hold, whatever the drawing: edges that are equally long, said to differ."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from ..structure import Structure
from ..topology import Topology
from ..union_find import UnionFind

#: Sizes that differ by less than this part are the same, typed in other units.
SAME_SIZE = 1e-9


def sizes_clash(topology: Topology, structure: Structure) -> bool:
    """Whether two sizes are said of what is equally large.

    Edges are equally long where it is said, and where they join the same two shared coordinates
    along one axis, as opposite sides of a rectangle do.

    Parameters
    ----------
    topology : Topology
    structure : Structure
        Of it.
    """
    diameters = [(a.circle, a.diameter_mm) for _, a in topology.by_kind["diameter"]]
    if _differ(diameters):
        return True
    lengths = [(a.edge, a.length_mm) for _, a in topology.by_kind["length"]]
    if len({mm for _, mm in lengths}) < 2:
        return False
    same = _equally_long(topology, structure)
    return _differ((same[topology.edges[e]], mm) for e, mm in lengths)


def _differ(sizes: Iterable[tuple[object, float]]) -> bool:
    """Whether one thing has two sizes."""
    first: dict[object, float] = {}
    return any(
        abs(mm - first.setdefault(name, mm)) > SAME_SIZE * max(mm, first[name])
        for name, mm in sizes
    )


def _equally_long(topology: Topology, structure: Structure) -> list[int]:
    """A number for each edge, the same for edges that are equally long."""
    n = len(topology.edges)
    axis = structure.edge_axis
    along = axis >= 0
    joined = np.sort(structure.coordinate[topology.ends, axis[:, None]], axis=1)
    names = np.where(along, joined @ (structure.n_coordinates, 1), -1 - np.arange(n))
    _, part = np.unique(names, return_inverse=True)
    part = part.reshape(-1)
    same = UnionFind(n)
    for _, a in topology.by_kind["equal_length"]:
        first, *others = (int(part[topology.edges[e]]) for e in a.edges)
        for other in others:
            same.union(first, other)
    return [same.find(k) for k in part.tolist()]
