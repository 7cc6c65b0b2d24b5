"""Angles said beside a sketch: they hold to the last digits, count by name, and clash by name."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from incontext.solver import SketchError, redundant_annotations, solve
from incontext.solver.annotations import Angle, RightAngle
from incontext.solver.dimensions.angles import angles_deg, driving_angles_deg, with_angle
from incontext.solver.said_angles import angle_id, with_angles
from incontext.solver.serialise import sketch_from_text, sketch_to_text
from incontext.solver.solution import Status
from incontext.solver.synthetic import (
    LID,
    Views,
    photograph_exactly,
    photograph_turned,
    random_camera,
    wedge,
)
from incontext.solver.synthetic.photographs import with_noise
from incontext.solver.synthetic.shapes import hexagonal_box, house, tapered_tray

SHAPES = {"gable": house, "tray": tapered_tray, "wedge": wedge, "planter": hexagonal_box}


def drawn(name, seed=0, noise=0.0):
    rng = np.random.default_rng(seed)
    shape = SHAPES[name]()
    graph = photograph_exactly(shape, random_camera(shape, rng, Views()))
    return with_noise(graph, noise, rng) if noise else graph


def slanted(graph, solution):
    """Corners that are not right, with their angles."""
    return {c: a for c, a in angles_deg(graph, solution).items() if abs(a - 90) > 1}


def measured(graph, solution, corner):
    """The angle of a corner, by the cosine."""
    (at,) = set(graph.edges[corner[0]]) & set(graph.edges[corner[1]])
    ends = [next(v for v in graph.edges[edge] if v != at) for edge in corner]
    u, v = (solution.vertices_mm[end] - solution.vertices_mm[at] for end in ends)
    return np.degrees(np.arccos(u @ v / np.linalg.norm(u) / np.linalg.norm(v)))


@pytest.mark.parametrize("noise", [0.0, 0.005])
@pytest.mark.parametrize("name", SHAPES)
def test_a_said_angle_holds_exactly_and_so_does_all_else(name, noise):
    graph = drawn(name, noise=noise)
    before = solve(graph)
    corner, angle = next(iter(slanted(graph, before).items()))
    for wanted in (angle + 3, angle - 11.5, 75.0):
        solution = solve(graph, angles_deg={corner: wanted})
        assert solution.status is Status.CONVERGED
        assert angles_deg(graph, solution)[corner] == pytest.approx(wanted, abs=1e-9)
        assert measured(graph, solution, corner) == pytest.approx(wanted, abs=1e-9)
        report = solution.report
        assert {angle_id(corner), *graph.annotations} == set(report.residuals)
        assert max(r.value for r in report.residuals.values()) < 1e-6
        assert report.residuals[angle_id(corner)].unit == "deg"
        assert solution.sketch is graph


def test_what_is_said_as_it_is_drawn_changes_nothing():
    graph = drawn("gable", seed=2)
    before = solve(graph)
    said = slanted(graph, before)
    after = solve(graph, angles_deg=said)
    for v, x in before.vertices_mm.items():
        assert after.vertices_mm[v] == pytest.approx(x, abs=1e-6)
    assert set(redundant_annotations(with_angles(graph, said), after)) >= {
        angle_id(corner) for corner in said
    }


def test_the_drawing_is_left_no_further_than_the_angle_asks():
    graph = drawn("gable", seed=2)
    before = solve(graph)
    corner, angle = next(iter(slanted(graph, before).items()))
    off = []
    for wanted in (angle + 1, angle + 4, angle + 16):
        report = solve(graph, angles_deg={corner: wanted}).report
        off.append(np.sqrt(np.mean(np.square([*report.reprojection_px.values()]))))
    diagonal = np.linalg.norm(np.ptp(graph.positions_px, axis=0))
    assert all(a < b for a, b in pairwise(off))
    # A degree turns a roof by a sixtieth of its own length at most.
    assert off[0] < diagonal / 60


def test_equal_corners_change_together():
    graph = drawn("planter")
    solution = solve(graph)
    sides = [c for c in slanted(graph, solution) if c[0] in {f"e{k}" for k in range(6)}]
    lifted = solve(graph, angles_deg={sides[0]: 110.0})
    top = [c for c, a in angles_deg(graph, lifted).items() if a == pytest.approx(110, abs=1e-9)]
    assert len(top) >= 2


def test_an_angle_fixes_what_was_free():
    """A wedge of which no right angle is said upright: the slope decides its height."""
    graph = drawn("wedge")
    corner, angle = next(iter(slanted(graph, solve(graph)).items()))
    loose = {
        k: a
        for k, a in graph.annotations.items()
        if not isinstance(a, RightAngle) or not set(a.between) & set(corner)
    }
    free = replace(graph, annotations=loose)
    without, with_it = solve(free), solve(free, angles_deg={corner: angle})
    assert with_it.report.degrees_of_freedom <= without.report.degrees_of_freedom
    assert angle_id(corner) in with_it.report.residuals


def test_angles_of_a_triangle_that_do_not_add_up_are_named():
    graph = drawn("wedge")
    corners = list(slanted(graph, solve(graph)))[:2]
    said = dict(zip(corners, (30.0, 61.0), strict=True))
    solution = solve(graph, angles_deg=said)
    assert solution.status is Status.CONFLICTING
    assert {angle_id(c) for c in corners} <= set(solution.report.conflicts)
    assert angle_id(corners[0]) in solution.message
    fits = solve(graph, angles_deg=dict(zip(corners, (30.0, 60.0), strict=True)))
    assert fits.status is Status.CONVERGED


def test_angles_of_a_pentagon_that_do_not_add_up_are_named():
    graph = drawn("gable")
    three = [c for c in slanted(graph, solve(graph)) if set(c) <= {f"e{k}" for k in range(5)}]
    assert len(three) == 3
    solution = solve(graph, angles_deg=dict.fromkeys(three, 125.0))
    assert solution.status is Status.CONFLICTING
    assert solution.report.conflicts
    assert set(solution.report.conflicts) <= {angle_id(c) for c in three}
    assert solution.report.conflicts[0] in solution.message


def test_a_right_corner_cannot_be_another():
    graph = drawn("gable")
    corner = next(iter(driving_angles_deg(graph)))
    solution = solve(graph, angles_deg={corner: 80.0})
    assert solution.status is Status.CONFLICTING
    assert angle_id(corner) in solution.report.conflicts
    with pytest.raises(SketchError, match="cannot hold") as raised:
        with_angle(graph, {}, corner, 80.0)
    assert angle_id(corner) in raised.value.ids
    assert any(id_ in graph.annotations for id_ in raised.value.ids)


def test_a_right_angle_may_be_said_as_well():
    graph = drawn("gable")
    square = next(iter(driving_angles_deg(graph)))
    same = solve(graph, angles_deg={square: 90.0})
    assert same.status is Status.CONVERGED
    assert angle_id(square) in redundant_annotations(with_angles(graph, {square: 90.0}), same)
    corner = next(iter(slanted(graph, solve(graph))))
    lifted = solve(graph, angles_deg={corner: 90.0})
    assert lifted.status is Status.CONVERGED
    assert angles_deg(graph, lifted)[corner] == pytest.approx(90, abs=1e-9)


def test_of_one_angle_one_number_is_kept():
    graph = drawn("gable")
    corners = slanted(graph, solve(graph))
    first = next(iter(corners))
    same = [
        c for c in corners if c != first and set(with_angle(graph, {first: 100.0}, c, 110.0)) == {c}
    ]
    # Front and back of an extruded shape.
    assert len(same) == 1
    clash = solve(graph, angles_deg={first: 100.0, same[0]: 110.0})
    assert clash.status is Status.CONFLICTING
    assert {angle_id(first), angle_id(same[0])} <= set(clash.report.conflicts)


@pytest.mark.parametrize("absurd", [0.0, 180.0, -5.0, 720.0, 1e300, float("nan"), float("inf")])
def test_what_is_no_angle_is_refused_with_a_reason(absurd):
    graph = drawn("wedge")
    with pytest.raises(SketchError, match=r"between 0\.1 and 179\.9 degrees"):
        solve(graph, angles_deg={("e0", "e1"): absurd})


def test_edges_that_do_not_meet_or_are_not_there_are_refused():
    graph = drawn("gable")
    with pytest.raises(SketchError, match="do not meet"):
        solve(graph, angles_deg={("e0", "e7"): 60.0})
    with pytest.raises(SketchError, match="no such element"):
        solve(graph, angles_deg={("e0", "e99"): 60.0})


def test_sides_of_surfaces_of_revolution_take_none():
    graph, _ = photograph_turned(LID, np.random.default_rng(0))
    first, second, *_ = graph.edges
    with pytest.raises(SketchError, match="surface of revolution"):
        solve(graph, angles_deg={(first, second): 120.0})


def test_a_known_camera_stays_where_it_is():
    shape = house()
    rng = np.random.default_rng(5)
    camera = random_camera(shape, rng, Views())
    graph = replace(photograph_exactly(shape, camera), camera=camera)
    before = solve(graph)
    corner = next(iter(slanted(graph, before)))
    after = solve(graph, angles_deg={corner: 118.0})
    assert after.status is Status.CONVERGED
    assert angles_deg(graph, after)[corner] == pytest.approx(118, abs=1e-9)
    assert after.camera.rotation_cam_from_world == pytest.approx(camera.rotation_cam_from_world)
    assert abs(after.vertices_mm["v0"] - before.vertices_mm["v0"]).max() < 5


def test_without_any_length_the_rest_stays_as_large_as_it_is():
    shape = house().without("length")
    graph = photograph_exactly(shape, random_camera(shape, np.random.default_rng(5), Views()))
    corner = next(iter(slanted(graph, solve(graph))))
    after = solve(graph, angles_deg={corner: 118.0})
    assert (after.status, after.scale_assumed) == (Status.CONVERGED, True)
    assert angles_deg(graph, after)[corner] == pytest.approx(118, abs=1e-9)


def test_sketch_files_have_no_such_words():
    graph = drawn("wedge")
    assert not any(
        isinstance(a, Angle) for a in sketch_from_text(sketch_to_text(graph)).annotations
    )
    said = with_angles(graph, {("e0", "e2"): 40.0})
    assert isinstance(said.annotations["angle e0 e2"], Angle)
    with pytest.raises(KeyError):
        sketch_to_text(said)
