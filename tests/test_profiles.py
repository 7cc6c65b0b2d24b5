"""What is said of the sides of surfaces of revolution holds, and the rest follows plausibly."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scenes import LID, Turned, photograph_turned

from incontext.solver import solve
from incontext.solver.annotations import Diameter, EqualLength, Ground, Length, RightAngle
from incontext.solver.model import turned_profile
from incontext.solver.solution import Status

BOWL = Turned(
    "bowl",
    ((40.0, 0.0), (40.0, 0.0), (90.0, 60.0)),
    ((40.0, 0.0), (60.0, 15.0), (80.0, 40.0), (90.0, 60.0)),
)
CONE = Turned("cone", LID.circles, (LID.profile[0], LID.profile[-1]))
TURNED = {turned.name: turned for turned in (LID, BOWL, CONE)}


def sides_of(turned):
    return [float(np.hypot(b[0] - a[0], b[1] - a[1])) for a, b in pairwise(turned.profile)]


def saying(graph, **more):
    return replace(graph, annotations={**graph.annotations, **more})


def profile_of(solution):
    return turned_profile(solution.sketch.revolutions["r1"], solution).profile_rz_mm


@pytest.mark.parametrize("name", TURNED)
def test_a_true_length_leaves_an_exact_drawing_exact(name):
    turned = TURNED[name]
    graph, _ = photograph_turned(turned, np.random.default_rng(3))
    for k, length in enumerate(sides_of(turned)):
        solution = solve(saying(graph, side=Length(f"s{k}", length)))
        assert solution.message == "Solved."
        assert solution.report.residuals["side"].value < 1e-9
        np.testing.assert_allclose(profile_of(solution), turned.profile, atol=1e-8)


@pytest.mark.parametrize("name", TURNED)
@pytest.mark.parametrize("factor", [0.6, 1.5])
def test_a_length_typed_on_the_side_holds_beside_a_diameter(name, factor):
    turned = TURNED[name]
    graph, _ = photograph_turned(turned, np.random.default_rng(5), noise=0.003, focal_known=True)
    before = profile_of(solve(graph))
    wished = factor * sides_of(turned)[-1]
    last = f"s{len(turned.profile) - 2}"
    solution = solve(saying(graph, side=Length(last, wished)))
    assert solution.status is Status.CONVERGED
    assert solution.report.conflicts == ("side",)
    assert "side contradicts the drawing" in solution.message
    assert max(r.value for r in solution.report.residuals.values()) < 1e-6
    after = profile_of(solution)
    assert np.linalg.norm(after[-1] - after[-2]) == pytest.approx(wished, abs=1e-6)
    # What is below stays at its height, and what is above goes along.
    np.testing.assert_allclose(after[:-1, 1], before[:-1, 1], atol=0.5)
    assert (after[-1, 1] > before[-1, 1]) == (factor > 1)


def test_a_side_begun_at_the_end_of_an_axis_is_as_long_as_is_said():
    graph, _ = photograph_turned(LID, np.random.default_rng(3))
    # Where the tools begin it: not quite where the side plane meets the circle.
    drawn = graph.circles["c1"]
    end = max(drawn.a, key=lambda p: -np.hypot(*np.subtract(p, graph.vertices["p0"])))
    graph = replace(graph, vertices={**graph.vertices, "p0": end})
    solution = solve(saying(graph, side=Length("s0", 18.0)))
    profile = profile_of(solution)
    assert solution.report.residuals["side"].value < 1e-6
    assert np.linalg.norm(profile[1] - profile[0]) == pytest.approx(18.0, abs=1e-6)


def test_a_side_that_cannot_be_so_short_is_told():
    graph, _ = photograph_turned(CONE, np.random.default_rng(3))
    sizes = {"low": Diameter("c1", 90.0), "high": Diameter("c2", 24.0)}
    solution = solve(saying(graph, side=Length("s0", 20.0), **sizes))
    assert solution.status is Status.CONFLICTING
    assert solution.report.conflicts == ("side",)
    assert max(solution.report.residuals[id_].value for id_ in ("wide", "low", "high")) < 1e-6
    two = saying(graph, one=Length("s0", 50.0), two=Length("s0", 60.0))
    assert set(solve(two).report.conflicts) == {"one", "two"}


def test_equal_and_square_sides_hold():
    graph, _ = photograph_turned(LID, np.random.default_rng(3))
    for said in (EqualLength(("s0", "s1")), RightAngle("p1", ("s0", "s1"))):
        solution = solve(saying(graph, said=said))
        assert solution.status is Status.CONVERGED
        assert solution.report.residuals["said"].value < 1e-6


@pytest.mark.parametrize("circle", ["c1", "c2"])
@pytest.mark.parametrize("factor", [0.7, 1.4])
def test_a_circle_of_another_size_takes_the_side_along(circle, factor):
    graph, camera = photograph_turned(LID, np.random.default_rng(3))
    k = int(circle[1])
    solution = solve(saying(graph, wish=Diameter(circle, 2 * factor * LID.circles[k][0])))
    assert solution.status is Status.CONVERGED
    assert "wish" in solution.report.conflicts
    # Heights and the camera are those of the drawing.
    for c, (_, height) in zip(("c0", "c1", "c2"), LID.circles, strict=True):
        assert solution.circles[c].center_mm[2] == pytest.approx(height, abs=1e-6)
    assert solution.camera.focal_px == pytest.approx(camera.focal_px, rel=1e-6)
    # The middle follows affinely: by its part of the height between the ends.
    part = (110.0 - 95.0) / (135.0 - 95.0)
    wider = (factor - 1) * LID.circles[k][0] * (part if circle == "c2" else 1 - part)
    radius, height = profile_of(solution)[1]
    assert (radius, height) == pytest.approx((38.0 + wider, 110.0), abs=1e-6)
    ends = [solution.vertices_mm[v] for v in ("p0", "p2")]
    radii = [solution.circles[c].radius_mm for c in ("c1", "c2")]
    np.testing.assert_allclose([np.hypot(*p[:2]) for p in ends], radii, atol=1e-6)


def test_a_slim_neck_stays_on_its_side_of_the_axis():
    vase = Turned("vase", ((60.0, 0.0), (60.0, 0.0), (50.0, 100.0)), (
        (60.0, 0.0), (8.0, 60.0), (50.0, 100.0)))  # fmt: skip
    graph, _ = photograph_turned(vase, np.random.default_rng(3))
    solution = solve(saying(graph, wish=Diameter("c2", 40.0)))
    assert solution.status is Status.CONVERGED
    radius, _ = profile_of(solution)[1]
    assert 1.0 < radius < 8.0


def test_a_traced_circle_stays_where_a_side_is_given_a_length():
    graph, _ = photograph_turned(LID, np.random.default_rng(3))
    traced = replace(graph, construction=("c2",))
    before, after = solve(traced), solve(saying(traced, side=Length("s1", 50.0)))
    assert after.report.residuals["side"].value < 1e-6
    high = before.circles["c2"]
    assert after.circles["c2"].radius_mm == pytest.approx(high.radius_mm, rel=1e-9)
    assert after.circles["c2"].center_mm[2] == pytest.approx(high.center_mm[2], rel=1e-9)


def test_a_known_camera_tells_the_size_and_stays():
    graph, camera = photograph_turned(LID, np.random.default_rng(3))
    graph = replace(graph, annotations={}, camera=camera)
    solution = solve(saying(graph, side=Length("s1", 50.0)))
    assert solution.status is Status.CONVERGED
    assert solution.report.residuals["side"].value < 1e-6
    np.testing.assert_allclose(solution.camera.position_mm, camera.position_mm, atol=1e-6)
    assert solution.circles["c0"].radius_mm == pytest.approx(70.0, abs=1e-6)


def test_a_side_without_edges_yet_takes_what_is_said_of_its_vertices():
    graph, _ = photograph_turned(LID, np.random.default_rng(1))
    bare = saying(replace(graph, edges={}), low=Ground(("p1",)))
    solution = solve(bare)
    assert solution.circles["c0"].radius_mm == pytest.approx(LID.circles[0][0], rel=1e-8)
