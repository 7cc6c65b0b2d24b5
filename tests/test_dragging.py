"""Dragging: the shape follows a moved vertex as a solve from nothing would find it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from asserts import assert_annotations_hold

from incontext.solver import solve
from incontext.solver.annotations import EqualLength, Length, SymmetryPlane
from incontext.solver.camera import Camera
from incontext.solver.dimensions.lengths import set_size, sizes_mm
from incontext.solver.dragging import begin_drag, drag
from incontext.solver.graph import SketchGraph
from incontext.solver.problem import build_problem
from incontext.solver.starting.warm_start import pose_from
from incontext.solver.structure import build_structure
from incontext.solver.synthetic import LID, SHAPES, box, photograph, photograph_turned, table


def moved(graph: SketchGraph, vertex: str, by: tuple[float, float]) -> SketchGraph:
    x, y = graph.vertices[vertex]
    return replace(graph, vertices={**graph.vertices, vertex: (x + by[0], y + by[1])})


def greatest_difference(a, b) -> float:
    """Of two solutions' vertices, in parts of the object's size."""
    X, Y = (np.array([s.vertices_mm[v] for v in a.vertices_mm]) for s in (a, b))
    return float(np.abs(X - Y).max() / np.ptp(Y, axis=0).max())


def dragged(graph: SketchGraph, vertex: str, by: tuple[float, float], steps: int = 12):
    now = begin_drag(graph)
    for k in range(1, steps + 1):
        now = drag(now, moved(graph, vertex, (by[0] * k / steps, by[1] * k / steps)))
    return now


@pytest.mark.parametrize("make", SHAPES)
def test_the_shape_follows_as_a_solve_from_nothing_would(make):
    shape = make()
    graph = photograph(shape, np.random.default_rng(8), noise=0.003).graph
    vertex = list(graph.vertices)[-1]
    now = dragged(graph, vertex, (9.0, -6.0))
    assert greatest_difference(now.solution, solve(graph)) > 1e-4
    assert greatest_difference(now.solution, solve(now.graph)) < 1e-3


def test_annotations_hold_exactly_while_dragging():
    shape = box(100, 104, 97)
    said = {**shape.annotations, "equal": EqualLength(("e0", "e1", "e8"))}
    shape = replace(shape, annotations=said)
    graph = photograph(shape, np.random.default_rng(4), noise=0.004).graph
    now = begin_drag(graph)
    for k in range(6):
        now = drag(now, moved(graph, "v6", (3.0 * k, 2.0 * k)))
        X = now.solution.vertices_mm
        lengths = [np.linalg.norm(X[a] - X[b]) for a, b in now.solution.edges.values()]
        np.testing.assert_allclose(lengths, lengths[0], rtol=1e-9)
        assert now.solution.sketch_digest == now.graph.digest


def test_the_report_tells_the_new_distances():
    graph = photograph(box(), np.random.default_rng(2)).graph
    now = drag(begin_drag(graph), moved(graph, "v6", (20.0, 0.0)))
    assert max(now.solution.report.reprojection_px.values()) > 1.0
    assert now.solution.faces.keys() == begin_drag(graph).solution.faces.keys()


def test_mirrored_copies_follow():
    shape = box()
    graph = photograph(shape, np.random.default_rng(5)).graph
    half = replace(graph, annotations={**graph.annotations, "plane": SymmetryPlane(("e0",))})
    now = dragged(half, "v6", (6.0, 4.0))
    assert greatest_difference(now.solution, solve(now.graph)) < 1e-3


def test_circles_can_be_dragged():
    graph, _ = photograph_turned(LID, np.random.default_rng(3))
    start = begin_drag(graph)
    id_ = list(graph.circles)[-1]
    circle = graph.circles[id_]

    def shifted(points):
        return tuple((x, y - 4.0) for x, y in points)

    raised = replace(
        graph,
        circles={
            **graph.circles,
            id_: replace(circle, a=shifted(circle.a), b=shifted(circle.b)),
        },
    )
    now = start
    for _ in range(6):
        now = drag(now, raised)
    cold = solve(raised)
    for c, solved in cold.circles.items():
        assert now.solution.circles[c].radius_mm == pytest.approx(solved.radius_mm, rel=1e-3)


def test_what_is_more_than_a_move_is_solved_from_nothing():
    graph = photograph(box(), np.random.default_rng(2)).graph
    start = begin_drag(graph)
    longer = replace(graph, annotations={**graph.annotations, "length": Length("e0", 400.0)})
    now = drag(start, longer)
    assert now.solution.report.residuals["length"].value < 1e-6
    assert_annotations_hold(now.solution, 400.0)


def test_what_cannot_be_lifted_does_not_stop_the_hand():
    line = SketchGraph(
        vertices={"a": (0.0, 0.0), "b": (10.0, 10.0)}, edges={"e": ("a", "b")}, annotations={}
    )
    now = drag(begin_drag(line), moved(line, "b", (5.0, 0.0)))
    assert now.solution.vertices_mm == {}


@pytest.mark.parametrize("make", [box, table])
def test_a_solution_gives_its_pose_back(make):
    graph = photograph(make(), np.random.default_rng(6)).graph
    solution = solve(graph)
    problem = build_problem(graph, build_structure(graph))
    pose = pose_from(solution, graph, problem)
    seen = pose.g[problem.structure.coordinate] @ pose.R.T
    projected = np.exp(pose.log_focal) * seen[:, :2] / seen[:, 2:]
    np.testing.assert_allclose(projected, problem.points, atol=1e-9)


def test_no_pose_for_what_the_solution_does_not_know():
    graph = photograph(box(), np.random.default_rng(6)).graph
    solution = solve(graph)
    problem = build_problem(graph, build_structure(graph))
    bare = replace(solution, vertices_mm={}, edges={}, faces={})
    assert pose_from(bare, graph, problem) is None
    behind = Camera(
        focal_px=1000.0,
        principal_point_px=np.zeros(2),
        rotation_cam_from_world=np.diag([1.0, -1.0, -1.0])
        @ solution.camera.rotation_cam_from_world,
        translation_cam_from_world_mm=-solution.camera.translation_cam_from_world_mm,
    )
    assert pose_from(replace(solution, camera=behind), graph, problem) is None


def test_a_changed_length_starts_from_the_last_shape():
    shape = box()
    said = {**shape.annotations, "high": Length("e8", 120.0)}
    graph = photograph(replace(shape, annotations=said), np.random.default_rng(3)).graph
    before = solve(graph)
    taller = replace(graph, annotations={**said, "high": Length("e8", 150.0)})
    near, cold = solve(taller, start=before), solve(taller)
    assert_annotations_hold(near, 200.0)
    assert greatest_difference(near, cold) < 1e-6
    assert near.report.iterations <= cold.report.iterations


def test_a_start_that_leads_nowhere_is_left():
    graph = photograph(box(), np.random.default_rng(3)).graph
    other = solve(photograph(box(90, 300, 40), np.random.default_rng(20)).graph)
    assert greatest_difference(solve(graph, start=other), solve(graph)) < 1e-9
    nothing = solve(SketchGraph())
    assert greatest_difference(solve(graph, start=nothing), solve(graph)) == 0.0


@pytest.mark.parametrize("factor", [0.7, 1.3])
def test_under_a_known_camera_a_size_stays_and_so_does_the_camera(factor):
    photo = photograph(box().without("length"), np.random.default_rng(4), noise=0.004)
    graph = replace(photo.graph, camera=photo.camera)
    size = factor * sizes_mm(solve(graph))["e0"]
    now = dragged(set_size(graph, "e0", size), "v6", (9.0, -6.0))
    assert now.solution.camera.to_json() == photo.camera.to_json()
    assert sizes_mm(now.solution)["e0"] == pytest.approx(size, abs=1e-6)
    assert greatest_difference(now.solution, solve(now.graph)) < 1e-3
