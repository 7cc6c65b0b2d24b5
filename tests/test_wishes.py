"""Sizes that contradict the drawing are held, and change nothing that need not change."""

from __future__ import annotations

from pathlib import Path

import pytest

from incontext.solver import load_sketch, solve
from incontext.solver.dimensions.heights import heights_mm, set_height
from incontext.solver.dimensions.lengths import set_size, sizes_mm, tied_edges
from incontext.solver.solution import Status

DATA = Path(__file__).parent / "data"


@pytest.fixture(scope="module")
def shelf():
    return load_sketch(DATA / "shelf.sketch.json")


@pytest.fixture(scope="module")
def drawn(shelf):
    return solve(shelf)


@pytest.mark.parametrize("factor", [0.1, 0.6, 0.9, 1.2, 3.0])
def test_a_wished_height_leaves_width_and_depth(shelf, drawn, factor):
    before = heights_mm(shelf, drawn)
    top = max(before, key=before.__getitem__)
    wished = round(factor * before[top], 3)
    graph = set_height(shelf, top, wished)
    solution = solve(graph)
    assert solution.status is Status.CONVERGED, solution.message
    after = heights_mm(graph, solution)
    assert after[top] == pytest.approx(wished, abs=1e-6)
    # What lies between goes along in proportion.
    for id_, height in after.items():
        assert height / wished == pytest.approx(before[id_] / before[top], rel=0.01)
    for v, point in drawn.vertices_mm.items():
        assert solution.vertices_mm[v][:2] == pytest.approx(point[:2], abs=0.05)
    assert solution.camera.focal_px == pytest.approx(drawn.camera.focal_px, rel=1e-3)


def test_all_sizes_at_once(shelf, drawn):
    sizes, graph, wished = sizes_mm(drawn), shelf, {}
    for k, edge in enumerate(shelf.edges):
        if not any(edge in tied_edges(shelf, other) for other in wished):
            wished[edge] = round(sizes[edge] * (0.6, 1.5, 0.8)[k % 3], 2)
            graph = set_size(graph, edge, wished[edge])
    assert len(wished) > 3
    solution = solve(graph)
    assert solution.status is Status.CONVERGED, solution.message
    after = sizes_mm(solution)
    for edge, size in wished.items():
        for tied in tied_edges(shelf, edge):
            assert after[tied] == pytest.approx(size, abs=1e-6)


def test_sizes_that_clash_with_each_other_are_named(shelf):
    edge = next(iter(shelf.edges))
    tied = tied_edges(shelf, edge)
    graph = set_size(shelf, edge, 100.0)
    from incontext.solver.editing.annotating import set_length

    solution = solve(set_length(graph, tied[-1], 130.0))
    assert solution.status is Status.CONFLICTING
    assert any(id_ in solution.message for id_ in solution.report.conflicts)
