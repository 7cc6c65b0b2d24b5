"""A camera known beforehand: it gives the frame and the size."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from asserts import assert_annotations_hold, assert_solved
from scenes import LID, bookshelf, box, photograph, photograph_turned, v, with_traced_box

from incontext.solver import solve
from incontext.solver.annotations import Length, RightAngle
from incontext.solver.dimensions.lengths import set_size
from incontext.solver.solution import Status
from incontext.solver.synthetic.shapes import from_loops, tapered_tray, wedge


def pyramid():
    """A tip over a base without any right angle."""
    X = [[0, 0, 0], [200, 0, 0], [230, 160, 0], [-20, 140, 0], [100, 80, 150]]
    return from_loops("tip", X, [(0, 1, 2, 3), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)])


@pytest.mark.parametrize("make", [box, bookshelf])
@pytest.mark.parametrize("seed", range(3))
def test_the_world_is_the_cameras_and_the_size_follows(make, seed):
    shape = make()
    photo = photograph(shape.without("length"), np.random.default_rng(seed))
    solution = solve(replace(photo.graph, camera=photo.camera))
    assert_solved(solution)
    assert not solution.scale_assumed
    found = np.array([solution.vertices_mm[v(i)] for i in range(len(shape.X))])
    np.testing.assert_allclose(found, shape.X, atol=1e-6)
    assert solution.camera.to_json() == photo.camera.to_json()


@pytest.mark.parametrize(
    ("make", "freedoms"),
    [(tapered_tray, 0), (wedge, 2), (pyramid, 1)],
    ids=["tray", "wedge", "tip"],
)
def test_the_ground_is_the_cameras_where_nothing_is_square(make, freedoms):
    shape = make()
    said = {k: a for k, a in shape.annotations.items() if not isinstance(a, RightAngle | Length)}
    plain = replace(shape, annotations=said)
    photo = photograph(plain, np.random.default_rng(4))
    solution = solve(replace(photo.graph, camera=photo.camera))
    assert solution.report.degrees_of_freedom == freedoms
    assert not solution.scale_assumed
    assert solution.camera.to_json() == photo.camera.to_json()
    # What stands on the ground is known; what does not goes along its ray at most.
    on_ground = [i for i, p in enumerate(shape.X) if freedoms == 0 or p[2] == 0]
    found = np.array([solution.vertices_mm[v(i)] for i in on_ground])
    np.testing.assert_allclose(found, shape.X[on_ground], atol=1e-6)


def test_a_careless_sketch_keeps_camera_and_right_angles():
    shape = box().without("length")
    photo = photograph(shape, np.random.default_rng(2), noise=0.01)
    solution = solve(replace(photo.graph, camera=photo.camera))
    assert_solved(solution)
    assert_annotations_hold(solution, 200.0)
    assert solution.camera.to_json() == photo.camera.to_json()
    found = np.array([solution.vertices_mm[v(i)] for i in range(8)])
    assert np.abs(found - shape.X).max() < 15


def test_lengths_come_before_the_cameras_height():
    photo = photograph(box(), np.random.default_rng(2), noise=0.01)
    solution = solve(replace(photo.graph, camera=photo.camera))
    assert_solved(solution)
    assert_annotations_hold(solution, 200.0)
    focal = solution.camera.focal_px
    assert focal == pytest.approx(photo.camera.focal_px, rel=1e-12)


@pytest.mark.parametrize("make", [box, bookshelf])
def test_a_length_and_the_camera_hold_together_where_they_agree(make):
    photo = photograph(make(), np.random.default_rng(4))
    solution = solve(replace(photo.graph, camera=photo.camera))
    assert_solved(solution)
    assert_annotations_hold(solution, 200.0)
    assert "camera" not in solution.message
    np.testing.assert_allclose(
        solution.camera.translation_cam_from_world_mm,
        photo.camera.translation_cam_from_world_mm,
        rtol=1e-8,
    )
    found = np.array([solution.vertices_mm[v(i)] for i in range(len(photo.shape.X))])
    np.testing.assert_allclose(found, photo.shape.X, atol=1e-6)


def sketched(shape):
    """A careless sketch whose camera is known; no size is said."""
    photo = photograph(shape.without("length"), np.random.default_rng(3), noise=0.005)
    return replace(photo.graph, camera=photo.camera)


@pytest.mark.parametrize("factor", [0.3, 0.9, 1.02, 1.1, 2.0])
@pytest.mark.parametrize("make", [box, bookshelf])
def test_a_size_changes_that_size_alone_and_the_camera_stays(make, factor):
    """The marker tells the scale: a size is no scale, but what the new object is to have."""
    drawn = solve(sketched(make()))
    before = along(drawn, "e0")
    direction, wished = before / np.linalg.norm(before), factor * np.linalg.norm(before)
    solution = solve(set_size(drawn.sketch, "e0", wished))
    assert solution.status is Status.CONVERGED, solution.message
    assert not solution.scale_assumed
    assert solution.camera.to_json() == drawn.camera.to_json()
    moved = {v: x - drawn.vertices_mm[v] for v, x in solution.vertices_mm.items()}
    assert along(solution, "e0") == pytest.approx(wished * direction, abs=1e-3)
    # All moved along that size only, and as far one way as the other: it stands where it stood.
    moves = np.array(list(moved.values()))
    way = moves @ direction
    np.testing.assert_allclose(moves - np.outer(way, direction), 0.0, atol=1e-3)
    assert way.max() + way.min() == pytest.approx(0.0, abs=0.02 * abs(wished - wished / factor))


def along(solution, edge):
    v, w = solution.sketch.edges[edge]
    return solution.vertices_mm[w] - solution.vertices_mm[v]


def test_a_size_far_from_the_drawn_one_is_named():
    drawn = sketched(box())
    assert solve(set_size(drawn, "e0", 210.0)).report.conflicts == ()
    named = solve(set_size(drawn, "e0", 500.0))
    (conflict,) = named.report.conflicts
    assert conflict in named.message
    assert named.status is Status.CONVERGED


def test_a_length_of_a_traced_thing_sets_the_scale_before_the_camera_does():
    """It was measured; it holds, and how far the camera is off is said."""
    photo = photograph(box().without("length"), np.random.default_rng(4))
    traced = with_traced_box(photo, np.random.default_rng(1), trace_px=0.5)
    graph = replace(traced.graph, camera=photo.camera)
    plain = solve(graph)
    edge = graph.construction[0]
    longer = 1.1 * float(np.linalg.norm(along(plain, edge)))
    solution = solve(set_size(graph, edge, longer))
    assert_solved(solution)
    off = 0.1 * photo.camera.position_mm[2]
    assert f"{off:.3g} mm (10 %)" in solution.message
    # What is then said of the new object changes that alone.
    wished = 1.2 * float(np.linalg.norm(along(solution, "e0")))
    both = solve(set_size(solution.sketch, "e0", wished))
    assert np.linalg.norm(along(both, "e0")) == pytest.approx(wished, abs=1e-6)
    np.testing.assert_allclose(
        [along(both, e) for e in graph.construction],
        [along(solution, e) for e in graph.construction],
        atol=0.05,
    )


def test_a_lid_under_a_known_camera():
    graph, camera = photograph_turned(LID, np.random.default_rng(1))
    solution = solve(replace(graph, annotations={}, camera=camera))
    assert_solved(solution)
    assert not solution.scale_assumed
    radii = [solution.circles[c].radius_mm for c in ("c0", "c1", "c2")]
    np.testing.assert_allclose(radii, [r for r, _ in LID.circles], rtol=1e-8)
    np.testing.assert_allclose(solution.circles["c0"].center_mm, [70, 70, 0], atol=1e-6)
