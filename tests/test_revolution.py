"""Circles and surfaces of revolution on scenes whose truth is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from asserts import assert_solved
from scenes import LID, box, image_ellipse, photograph, photograph_turned
from scipy.spatial.transform import Rotation

from incontext.solver import solve
from incontext.solver.annotations import Diameter, RightAngle
from incontext.solver.energies.circle import circle_support, ellipse_support
from incontext.solver.sizes import proportional_diameters
from incontext.solver.solution import Status
from incontext.solver.structure import build_structure


def ratios(solution):
    """(r, z) of the circles and of the profile."""
    circles = [solution.circles[c] for c in ("c0", "c1", "c2")]
    assert all(np.hypot(*c.center_mm[:2]) < 1e-9 for c in circles)
    profile = [solution.vertices_mm[f"p{k}"] for k in range(3)]
    return (
        np.array([(c.radius_mm, c.center_mm[2]) for c in circles]),
        np.array([(np.hypot(p[0], p[1]), p[2]) for p in profile]),
    )


@pytest.mark.parametrize("seed", range(4))
def test_exact_lid_gives_the_exact_shape(seed):
    graph, camera = photograph_turned(LID, np.random.default_rng(seed))
    solution = solve(graph)
    assert_solved(solution)
    circles, profile = ratios(solution)
    np.testing.assert_allclose(circles, LID.circles, atol=1e-8)
    np.testing.assert_allclose(profile, LID.profile, atol=1e-8)
    assert solution.camera.focal_px == pytest.approx(camera.focal_px, rel=1e-8)
    assert solution.report.residuals["wide"].value < 1e-9
    assert max(solution.report.reprojection_px.values()) < 1e-6


def test_careless_lids_are_near_the_truth():
    far = 0
    for seed in range(12):
        graph, _ = photograph_turned(
            LID, np.random.default_rng(seed), noise=0.005, focal_known=True
        )
        circles, profile = ratios(solve(graph))
        error = max(
            np.abs(circles - LID.circles).max(), np.abs(profile - np.array(LID.profile)).max()
        )
        far += error / 140 > 0.03
    assert far <= 1


def test_without_a_diameter_the_widest_circle_is_told_as_assumed():
    graph, _ = photograph_turned(LID, np.random.default_rng(0))
    solution = solve(replace(graph, annotations={}))
    assert_solved(solution)
    assert solution.scale_assumed


def test_a_circle_without_width_is_said():
    graph, _ = photograph_turned(LID, np.random.default_rng(0))
    flat = replace(graph.circles["c1"], b=((5.0, 5.0), (5.0, 5.0)))
    solution = solve(replace(graph, circles={**graph.circles, "c1": flat}))
    assert solution.status is Status.UNDERDETERMINED
    assert "c1" in solution.message


DIRECTIONS = np.stack([np.cos(np.arange(8) * 0.7), np.sin(np.arange(8) * 0.7)], axis=1)


def supports(C, r, turn, log_focal):
    n = Rotation.from_rotvec(turn).as_matrix() @ np.array([0.1, -0.8, -0.59])
    n /= np.linalg.norm(n)
    return circle_support(
        C[:, None], np.array([r]), n, np.exp(log_focal) * DIRECTIONS.T[:, None]
    ), n


def test_support_of_a_circle_equals_that_of_its_image():
    _, camera = photograph_turned(LID, np.random.default_rng(3))
    centre, radius = np.array([3.0, -5.0, 20.0]), 50.0
    ellipse = image_ellipse(camera, centre, radius)
    a, b = (np.subtract(*axis)[::1] / 2 for axis in (ellipse.a, ellipse.b))
    middle = np.mean(ellipse.a, axis=0) - camera.principal_point_px
    R, t = camera.rotation_cam_from_world, camera.translation_cam_from_world_mm
    found = circle_support(
        (R @ centre + t)[:, None],
        np.array([radius]),
        R[:, 2],
        camera.focal_px * DIRECTIONS.T[:, None],
    )
    assert found.visible
    np.testing.assert_allclose(found.h[0], ellipse_support(a, b, middle, DIRECTIONS), rtol=1e-9)


def test_derivatives_of_the_support_equal_central_differences():
    C, r, f = np.array([0.2, -0.1, 5.0]), 0.8, 0.4
    found, n = supports(C, r, np.zeros(3), f)
    at = found.slopes()
    step = 1e-6
    for k in range(3):
        d = np.eye(3)[k] * step
        by_centre = (supports(C + d, r, d * 0, f)[0].h - supports(C - d, r, d * 0, f)[0].h) / 2e-6
        np.testing.assert_allclose(at.by_centre[k], by_centre, atol=1e-8)
        by_turn = (supports(C, r, d, f)[0].h - supports(C, r, -d, f)[0].h) / 2e-6
        np.testing.assert_allclose(np.cross(n, at.by_normal, axisb=0)[..., k], by_turn, atol=1e-8)
    zero = np.zeros(3)
    by_radius = (supports(C, r + step, zero, f)[0].h - supports(C, r - step, zero, f)[0].h) / 2e-6
    np.testing.assert_allclose(at.by_radius, by_radius, atol=1e-8)
    by_focal = (supports(C, r, zero, f + step)[0].h - supports(C, r, zero, f - step)[0].h) / 2e-6
    np.testing.assert_allclose(at.by_log_focal, by_focal, atol=1e-8)


def test_several_diameters_hold_together():
    graph, _ = photograph_turned(LID, np.random.default_rng(5), noise=0.003)
    said = {"wide": Diameter("c0", 140.0), "low": Diameter("c1", 88.0), "top": Diameter("c2", 25.0)}
    solution = solve(replace(graph, annotations=said))
    assert_solved(solution)
    for annotation in said.values():
        radius = solution.circles[annotation.circle].radius_mm
        assert 2 * radius == pytest.approx(annotation.diameter_mm, abs=1e-6)


def test_a_length_and_a_diameter_hold_together():
    photo = photograph(box(200, 150, 120), np.random.default_rng(6))
    ring = image_ellipse(photo.camera, np.array([100.0, 75.0, 120.0]), 40.0)
    said = {**photo.shape.annotations, "ring": Diameter("c", 84.0)}
    graph = replace(photo.graph, circles={"c": ring}, annotations=said)
    solution = solve(graph)
    assert_solved(solution)
    assert 2 * solution.circles["c"].radius_mm == pytest.approx(84.0, abs=1e-6)
    assert solution.report.residuals["length"].value < 1e-6


def test_diameters_that_disagree_are_named():
    graph, _ = photograph_turned(LID, np.random.default_rng(5))
    said = {"one": Diameter("c0", 140.0), "two": Diameter("c0", 150.0)}
    solution = solve(replace(graph, annotations=said))
    assert solution.status is Status.CONFLICTING
    assert set(solution.report.conflicts) == {"one", "two"}


def test_derivatives_of_proportional_diameters_equal_central_differences():
    photo = photograph(box(), np.random.default_rng(6))
    ring = image_ellipse(photo.camera, np.array([100.0, 75.0, 120.0]), 40.0)
    said = {**photo.shape.annotations, "ring": Diameter("c", 84.0)}
    graph = replace(photo.graph, circles={"c": ring}, annotations=said)
    structure = build_structure(graph)
    diameters = proportional_diameters(graph, structure)
    g = np.random.default_rng(0).uniform(1, 2, structure.n_coordinates)
    _, H = diameters.evaluate(g, structure.coordinate)
    for i, d in enumerate(1e-6 * np.eye(len(g))):
        ahead, _ = diameters.evaluate(g + d, structure.coordinate)
        behind, _ = diameters.evaluate(g - d, structure.coordinate)
        np.testing.assert_allclose(H[:, i], (ahead - behind) / 2e-6, atol=1e-8)


def test_circles_alone_are_lifted_while_the_side_is_still_to_come():
    graph, _ = photograph_turned(LID, np.random.default_rng(3))
    circles = replace(graph, vertices={}, edges={}, revolutions={}, annotations={})
    for count in (1, 2, 3):
        fewer = replace(circles, circles=dict(list(graph.circles.items())[:count]))
        solution = solve(fewer)
        assert set(solution.circles) == set(fewer.circles)
        assert solution.camera.rotation_cam_from_world[2, 2] < 0


@pytest.mark.parametrize("seed", [6, 13, 28])
def test_a_circle_lies_as_the_ground_does_where_no_axis_is_known_to_be_square_to_it(seed):
    photo = photograph(box(180, 130, 150), np.random.default_rng(seed))
    ring = image_ellipse(photo.camera, np.array([90.0, 65.0, 150.0]), 40.0)
    # Two of the axes are told by the top alone, the upright ones by corners far from it.
    corners = {("v7", 3, 4), ("v7", 6, 4), ("v6", 2, 7), ("v0", 3, 4), ("v0", 1, 4)}
    said = {k: a for k, a in photo.shape.annotations.items() if k in ("ground", "length")}
    edges = {frozenset(pair): f"e{k}" for k, pair in enumerate(photo.shape.edges)}
    for v, *ends in sorted(corners):
        pair = tuple(edges[frozenset((int(v[1:]), end))] for end in ends)
        said[f"{v}-{ends[0]}"] = RightAngle(v, pair)
    graph = replace(photo.graph, circles={"c": ring}, annotations=said)
    solution = solve(graph)
    assert solution.report.conflicts == ()
    assert solution.status is Status.UNDERDETERMINED
    assert solution.report.degrees_of_freedom == 2
    assert set(solution.report.loose) == {"v5", "c"}
