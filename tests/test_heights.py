"""Heights above the ground: read, said by an upright edge, freed."""

from __future__ import annotations

from pathlib import Path

import pytest

from incontext.solver import SketchError, load_sketch, solve
from incontext.solver.dimensions.heights import driving_heights_mm, heights_mm, levels, set_height
from incontext.solver.editing.elements import delete
from incontext.solver.graph import SketchGraph

DATA = Path(__file__).parent / "data"


@pytest.fixture(scope="module")
def shelf():
    return load_sketch(DATA / "shelf.sketch.json")


def test_levels_hold_what_is_as_high(shelf):
    solution = solve(shelf)
    heights = heights_mm(shelf, solution)
    for id_, level in levels(shelf).items():
        for v in level.members:
            assert solution.vertices_mm[v][2] == pytest.approx(heights[id_], abs=1e-9)
    assert len(heights) == len({round(float(p[2]), 6) for p in solution.vertices_mm.values()}) - 1


def test_a_height_without_an_edge_gets_one_as_construction(shelf):
    top = max(heights_mm(shelf, solve(shelf)).items(), key=lambda pair: pair[1])[0]
    said = set_height(shelf, top, 341.0)
    (edge,) = set(said.edges) - set(shelf.edges)
    assert edge in said.construction
    assert driving_heights_mm(said) == {top: 341.0}
    solution = solve(said)
    assert heights_mm(said, solution)[top] == pytest.approx(341, abs=1e-6)
    freed = set_height(said, top, None)
    assert freed.annotations == shelf.annotations
    again = set_height(freed, top, 300.0)
    assert set(again.edges) == set(said.edges)


def test_the_height_of_one_edge_is_its_length(shelf):
    heights = heights_mm(shelf, solve(shelf))
    lowest = min(heights, key=heights.__getitem__)
    said = set_height(shelf, lowest, 240.0)
    assert set(said.edges) == set(shelf.edges)
    assert set_height(said, lowest, 241.0).annotations.keys() == said.annotations.keys()


def test_what_has_nothing_below_it_cannot_be_said(shelf):
    id_, level = next(iter(levels(shelf).items()))
    feet = {next(iter(lvl.upright)) for lvl in levels(shelf).values() if lvl.upright}
    bare = delete(shelf, vertices=tuple(feet))
    while bare.vertices and any(lvl.upright for lvl in levels(bare).values()):
        bare = delete(bare, vertices=[lvl.upright[0] for lvl in levels(bare).values()][:1])
    for name in levels(bare):
        with pytest.raises(SketchError, match=name):
            set_height(bare, name, 100.0)
    assert level.members[0] == id_
    assert levels(SketchGraph()) == {}


@pytest.mark.parametrize("height", [0.0, -1.0, float("nan"), float("inf")])
def test_no_height_is_refused(shelf, height):
    with pytest.raises(SketchError, match="above 0"):
        set_height(shelf, next(iter(levels(shelf))), height)
