"""Parts that float, and what a drawing leaves to expectation."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from asserts import assert_annotations_hold, assert_solved
from scenes import FAMILIES, Hand, Views, box, from_loops, organizer, photograph, tapered_tray, v

from incontext.solver import solve
from incontext.solver.annotations import EqualLength, RightAngle, SymmetryPlane
from incontext.solver.solution import Status
from incontext.solver.starting.floating import n_floats
from incontext.solver.structure import build_structure


def floats(shape):
    return n_floats(build_structure(photograph(shape, np.random.default_rng(0)).graph))


def test_only_the_size_is_open_where_all_hangs_together():
    assert floats(box()) == 1
    assert floats(organizer()) == 1


def test_a_trays_rim_floats_where_no_symmetry_puts_it_over_the_bottom():
    assert floats(with_equal_slants(tapered_tray())) == 2
    assert floats(tapered_tray()) == 1


def spice_rack():
    """Two shelves between cheeks cut off in front, where only equal lengths hold the cheeks."""
    cheek = [(0, 0), (90, 0), (90, 100), (90, 200), (40, 200), (0, 120), (0, 100)]
    X = [[x, y, z] for x in (0, 260) for y, z in cheek]
    quads = [(0, 1, 8, 7), (1, 2, 9, 8), (2, 3, 10, 9), (6, 2, 9, 13), (0, 1, 2, 6), (7, 8, 9, 13)]
    cut = [(2, 3, 4, 5, 6), (9, 10, 11, 12, 13)]
    shape = from_loops("rack", X, [*quads, *cut])
    edge = {pair: f"e{k}" for k, pair in enumerate(shape.edges)}
    front = {edge[5, 6], edge[12, 13], edge[4, 5], edge[11, 12]}
    kept = {
        key: a
        for key, a in shape.annotations.items()
        if not (isinstance(a, RightAngle) and front.intersection(a.between))
    }
    kept["tops"] = EqualLength((edge[3, 4], edge[10, 11]))
    kept["fronts"] = EqualLength((edge[5, 6], edge[12, 13]))
    return replace(shape, annotations=kept)


@pytest.mark.parametrize("seed", [6, 9, 13, 27])
def test_a_part_that_floats_leaves_the_rest_its_size(seed):
    """The lift must not shrink what the drawing misses beside what it cannot miss."""
    from_the_side = Views(elevation_deg=(25, 25), azimuth_deg=(-30, -30), fov_deg=(56, 56))
    rng = np.random.default_rng(seed)
    graph = photograph(spice_rack(), rng, noise=0.006, views=from_the_side).graph
    solution = solve(graph)
    assert (solution.status, solution.report.conflicts) == (Status.UNDERDETERMINED, ())
    assert solution.report.degrees_of_freedom == 1
    assert solution.report.loose == (v(5), v(12))


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
