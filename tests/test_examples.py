"""Every shipped example, end to end against what is truly there."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from asserts import assert_annotations_hold, assert_solved

from incontext.solver import findings, load_sketch, solve

EXAMPLES = Path(__file__).parent.parent / "resources" / "examples"
THICKNESS_MM = 3.0


@pytest.mark.parametrize("folder", sorted(p.name for p in EXAMPLES.iterdir() if p.is_dir()))
def test_example_solves_with_every_annotation_exact(folder):
    graph = load_sketch(EXAMPLES / folder / f"{folder}.sketch.json")
    assert findings(graph) == ()
    assert (EXAMPLES / folder / graph.photo.file).is_file()
    solution = solve(graph)
    assert_solved(solution)
    assert_annotations_hold(solution, 500.0)


def test_bookshelf_fits_the_books():
    """The inside of the solved shelf has the books' own proportions, within 5 %."""
    folder = EXAMPLES / "bookshelf"
    books = json.loads((folder / "truth.json").read_text())["books"]
    solution = solve(load_sketch(folder / "bookshelf.sketch.json"))
    X = solution.vertices_mm
    outside_width, outside_depth, _ = X["v3"] - X["v1"]
    shelf_height = X["v5"][2]
    # Drawn faces are the outside; the shelf has its face in the middle; the front is open.
    width = outside_width - 2 * THICKNESS_MM
    depth = outside_depth - THICKNESS_MM
    height = shelf_height - 1.5 * THICKNESS_MM
    assert height / depth == pytest.approx(books["height_mm"] / books["depth_mm"], rel=0.05)
    assert height / width == pytest.approx(books["height_mm"] / books["width_mm"], rel=0.05)
    assert np.all([width, depth, height] > np.array([200.0, 170.0, 235.0]))
