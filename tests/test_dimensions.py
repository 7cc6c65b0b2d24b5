"""Sizes of a sketch as numbers: which are tied, and what setting one does."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from incontext.solver import SketchError, load_sketch, solve
from incontext.solver.annotations import EqualLength
from incontext.solver.dimensions.lengths import driving_sizes_mm, set_size, sizes_mm, tied_edges

DATA = Path(__file__).parent / "data"


@pytest.fixture(scope="module")
def shelf():
    return load_sketch(DATA / "shelf.sketch.json")


def test_tied_edges_are_as_long_as_each_other(shelf):
    sizes = sizes_mm(solve(shelf))
    for edge in shelf.edges:
        tied = tied_edges(shelf, edge)
        assert edge in tied
        assert [sizes[e] for e in tied] == pytest.approx([sizes[edge]] * len(tied), rel=1e-9)


def test_opposite_sides_and_marked_edges_are_tied(shelf):
    (driving,) = driving_sizes_mm(shelf)
    tied = tied_edges(shelf, driving)
    other = next(e for e in shelf.edges if e not in tied)
    assert len(tied) >= 4
    marked = replace(
        shelf, annotations={**shelf.annotations, "same": EqualLength((driving, other))}
    )
    assert set(tied_edges(marked, driving)) == {*tied, *tied_edges(shelf, other)}


def test_a_size_that_is_set_comes_out_exactly(shelf):
    (driving,) = driving_sizes_mm(shelf)
    other = next(e for e in shelf.edges if e not in tied_edges(shelf, driving))
    changed = set_size(set_size(shelf, driving, 123.4), other, 321.0)
    sizes = sizes_mm(solve(changed))
    assert sizes[driving] == pytest.approx(123.4, abs=1e-6)
    assert sizes[other] == pytest.approx(321.0, abs=1e-6)
    assert set_size(changed, other, None).annotations.keys() == shelf.annotations.keys()


def test_what_is_said_of_tied_edges_changes_together(shelf):
    (driving,) = driving_sizes_mm(shelf)
    tied = tied_edges(shelf, driving)
    graph = shelf
    for edge in tied:
        graph = set_size(graph, edge, 200.0)
    assert driving_sizes_mm(set_size(graph, tied[-1], 90.0)) == dict.fromkeys(tied, 90.0)


@pytest.mark.parametrize("size", [0.0, -1.0, float("inf"), float("nan")])
def test_a_size_that_cannot_be_is_refused(shelf, size):
    with pytest.raises(SketchError, match="above 0"):
        set_size(shelf, next(iter(shelf.edges)), size)
