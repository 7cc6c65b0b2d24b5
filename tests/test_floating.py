"""Parts that float, and what a drawing leaves to expectation."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from asserts import assert_annotations_hold, assert_solved
from scenes import FAMILIES, Hand, box, organizer, photograph, tapered_tray

from incontext.solver import solve
from incontext.solver.annotations import EqualLength, SymmetryPlane
from incontext.solver.starting.floating import n_floats
from incontext.solver.structure import build_structure


def floats(shape):
    return n_floats(build_structure(photograph(shape, np.random.default_rng(0)).graph))


def test_only_the_size_is_open_where_all_hangs_together():
    assert floats(box()) == 1
    assert floats(organizer()) == 1


def test_a_trays_rim_floats():
    assert floats(tapered_tray()) == 2


def with_equal_slants(shape):
    """A tray of which is said that its slanted edges are equal, and no symmetry."""
    kept = {k: a for k, a in shape.annotations.items() if not isinstance(a, SymmetryPlane)}
    slants = [f"e{k}" for k, (a, b) in enumerate(shape.edges) if (a < 4) != (b < 4)]
    return replace(shape, annotations={**kept, "equal": EqualLength(tuple(slants))})


@pytest.mark.parametrize("seed", range(8))
def test_equal_slants_alone_place_a_trays_rim(seed):
    """A sheared box, whose slants are equal too, fits some of these to a few px."""
    rng = np.random.default_rng([seed, 5])
    shape = with_equal_slants(FAMILIES["tapered tray"](rng))
    photo = photograph(shape, rng)
    solution = solve(photo.graph)
    assert_solved(solution)
    assert photo.error(solution.vertices_mm) < 1e-9
    assert_annotations_hold(solution, float(np.ptp(shape.X)))


def test_leaning_drawings_are_not_taken_for_views_from_afar():
    person = Hand(0.003, (3.0, 10.0), 0.05)
    errors = []
    for k, name in enumerate(FAMILIES):
        for seed in range(2):
            rng = np.random.default_rng([seed, k])
            photo = photograph(FAMILIES[name](rng), rng, hand=person)
            errors.append(photo.error(solve(photo.graph).vertices_mm))
    assert np.max(errors) < 0.25
    assert np.quantile(errors, 0.9) < 0.12


def test_an_exact_view_from_afar_keeps_its_own_focal_length():
    for seed in (32, 40, 65):
        rng = np.random.default_rng([seed, 5])
        photo = photograph(FAMILIES["hexagonal box"](rng), rng)
        solution = solve(photo.graph)
        assert solution.camera.focal_px == pytest.approx(photo.camera.focal_px, rel=1e-7)
