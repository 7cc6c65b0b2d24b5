"""Edges that meet an ellipse at an end of its axes meet the circle in space."""

from dataclasses import replace

import numpy as np
import pytest

from incontext.solver import begin_drag, drag, solve
from incontext.solver.editing.rounds import move
from incontext.solver.rims import Rims
from incontext.solver.synthetic import Views, photograph_exactly, random_camera, with_noise
from incontext.solver.synthetic.shapes import box
from incontext.solver.synthetic.turned import image_ellipse

#: A corner on the ground, and one on top, of a box of 200 x 150 x 120 mm.
CORNERS = {"ground": "v2", "top": "v6"}
RADIUS_MM = 47.0


def ends_of(ellipse):
    return [*ellipse.a, *ellipse.b]


def on_plane(camera, point_px, height_mm):
    """The point at a height that is seen at a place."""
    at = (np.array(point_px) - camera.principal_point_px) / camera.focal_px
    ray = camera.rotation_cam_from_world.T @ [*at, 1.0]
    eye = camera.position_mm
    return eye + ray * (height_mm - eye[2]) / ray[2]


def circle_at(camera, place, end):
    """Centre and image of a circle of which one axis end is seen where a point of it is."""
    centre = place + np.array([RADIUS_MM, 0, 0])
    for _ in range(60):
        ellipse = image_ellipse(camera, centre, RADIUS_MM)
        centre = centre + place - on_plane(camera, ends_of(ellipse)[end], place[2])
    return centre, image_ellipse(camera, centre, RADIUS_MM)


def connected(graph, ellipse, end, vertex):
    """The graph with a circle, one axis end of which is a vertex."""
    ends = ends_of(ellipse)
    ends[end] = graph.vertices[vertex]
    met = replace(ellipse, a=tuple(ends[:2]), b=tuple(ends[2:]))
    return replace(graph, circles={**graph.circles, f"c{len(graph.circles)}": met})


def scene(seed, where="top", end=0):
    rng = np.random.default_rng(seed)
    shape = box()
    camera = random_camera(shape, rng, Views())
    vertex = CORNERS[where]
    place = shape.X[int(vertex[1:])]
    centre, ellipse = circle_at(camera, place, end)
    graph = connected(photograph_exactly(shape, camera), ellipse, end, vertex)
    return graph, centre - place


@pytest.mark.parametrize("where", CORNERS)
@pytest.mark.parametrize("end", range(4))
def test_a_circle_is_where_a_corner_meets_its_axis_end(where, end):
    for seed in (1, 2, 3):
        graph, away = scene(seed, where, end)
        solution = solve(graph)
        assert solution.status.value == "converged", solution.message
        assert solution.report.degrees_of_freedom == 0
        circle = solution.circles["c0"]
        assert circle.radius_mm == pytest.approx(RADIUS_MM, rel=1e-8)
        met = circle.center_mm - solution.vertices_mm[CORNERS[where]]
        assert np.hypot(*met[:2]) == pytest.approx(RADIUS_MM, rel=1e-9)
        assert np.hypot(*met[:2]) == pytest.approx(np.hypot(*away[:2]), rel=1e-8)
        assert met[2] == pytest.approx(0, abs=1e-9)


def test_beside_it_a_circle_floats():
    graph, _ = scene(1)
    (a, other), b = graph.circles["c0"].a, graph.circles["c0"].b
    beside = replace(graph.circles["c0"], a=((a[0] + 0.01, a[1]), other), b=b)
    solution = solve(replace(graph, circles={"c0": beside}))
    assert solution.report.degrees_of_freedom == 1
    assert "c0" in solution.report.loose


def shaken(graph, seed, noise=0.005):
    """Vertices moved, and what lies on them."""
    moved = with_noise(graph, noise, np.random.default_rng(seed))
    return move(graph, moved.vertices)


def holds(solution, vertex, circle="c0"):
    c = solution.circles[circle]
    met = c.center_mm - solution.vertices_mm[vertex]
    assert np.hypot(*met[:2]) == pytest.approx(c.radius_mm, rel=1e-9)
    assert met[2] == pytest.approx(0, abs=1e-8)


def test_it_holds_in_an_inexact_drawing_too_and_while_it_is_dragged():
    graph, _ = scene(5)
    drawn = shaken(graph, 5)
    solution = solve(drawn)
    assert solution.status.value == "converged", solution.message
    assert solution.circles["c0"].radius_mm == pytest.approx(RADIUS_MM, rel=0.25)
    holds(solution, "v6")
    state = begin_drag(drawn, solution)
    u, v = drawn.vertices["v6"]
    for k in range(1, 4):
        state = drag(state, move(drawn, {"v6": (u + 3 * k, v - 2 * k)}))
    c = state.solution.circles["c0"]
    met = c.center_mm - state.solution.vertices_mm["v6"]
    assert np.linalg.norm(met) == pytest.approx(c.radius_mm, rel=1e-6)
    # Moved elsewhere they stay together, and are solved from nothing.
    holds(solve(state.graph), "v6")


def test_a_vertex_lies_on_two_circles_that_meet_in_it():
    graph, _ = scene(7)
    shape = box()
    camera = random_camera(shape, np.random.default_rng(7), Views())
    _, ellipse = circle_at(camera, shape.X[6], 3)
    both = connected(graph, ellipse, 3, "v6")
    solution = solve(both)
    assert solution.report.degrees_of_freedom == 0
    for circle in ("c0", "c1"):
        assert solution.circles[circle].radius_mm == pytest.approx(RADIUS_MM, rel=1e-8)
        holds(solution, "v6", circle)


def test_the_derivatives_are_those_of_the_residuals():
    rng = np.random.default_rng(0)
    g = rng.uniform(0.5, 2.0, 9)
    # The second vertex shares a coordinate with its centre.
    rims = Rims(np.array([[[0, 1], [2, 3]], [[4, 3], [2, 3]]]), np.array([7, 8]))
    _, H = rims.evaluate(g)
    step = 1e-6
    for k in range(len(g)):
        ahead, behind = g.copy(), g.copy()
        ahead[k] += step
        behind[k] -= step
        slope = (rims.evaluate(ahead)[0] - rims.evaluate(behind)[0]) / (2 * step)
        assert H[:, k] == pytest.approx(slope, abs=1e-8)
