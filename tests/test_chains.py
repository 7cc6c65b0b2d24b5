"""Short closed chains of edges."""

from __future__ import annotations

from itertools import combinations, permutations

import numpy as np
import pytest

from incontext.solver.chains import chains
from incontext.solver.graph import SketchGraph
from incontext.solver.topology import topology_of


def graph_of(edges) -> SketchGraph:
    n = 1 + max(map(max, edges))
    return SketchGraph(
        vertices={f"v{i}": (float(i), 0.0) for i in range(n)},
        edges={f"e{k}": (f"v{a}", f"v{b}") for k, (a, b) in enumerate(edges)},
    )


@pytest.mark.parametrize("seed", range(6))
def test_all_triangles_and_quadrilaterals_are_found_once(seed):
    rng = np.random.default_rng(seed)
    pairs = list(combinations(range(8), 2))
    edges = [pairs[k] for k in rng.permutation(len(pairs))[:16]]
    edges = [e if rng.random() < 0.5 else e[::-1] for e in edges]
    number = {frozenset(e): k for k, e in enumerate(edges)}

    def closed(size):
        found = set()
        for loop in permutations(range(8), size):
            sides = [frozenset((loop[k - 1], loop[k])) for k in range(size)]
            if all(side in number for side in sides):
                found.add(frozenset(number[side] for side in sides))
        return found

    found = chains(topology_of(graph_of(edges)))
    for rows, size in ((found.triangles, 3), (found.quadrilaterals, 4)):
        assert len(rows) == len({frozenset(row) for row in rows.tolist()})
        assert {frozenset(row) for row in rows.tolist()} == closed(size)
        for row in rows.tolist():
            ends = [set(edges[e]) for e in row]
            assert all(ends[k - 1] & ends[k] for k in range(size))


def test_two_edges_between_the_same_vertices_close_nothing():
    found = chains(topology_of(graph_of([(0, 1), (1, 0), (1, 2)])))
    assert not len(found.triangles)
    assert not len(found.quadrilaterals)
