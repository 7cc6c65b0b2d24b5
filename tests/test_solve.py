"""The solve on scenes whose truth is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from asserts import assert_annotations_hold, assert_camera_sees, assert_solved
from scenes import SHAPES, Views, bookshelf, box, photograph

from incontext.solver import findings, solve
from incontext.solver.annotations import EqualLength, Ground, Length, Parallel, RightAngle
from incontext.solver.camera import Camera
from incontext.solver.graph import Ellipse, Face, SketchGraph
from incontext.solver.solution import Status

NAMES = [make().name for make in SHAPES]


@pytest.mark.parametrize("make", SHAPES, ids=NAMES)
@pytest.mark.parametrize("seed", range(3))
def test_exact_sketch_gives_the_exact_shape(make, seed):
    shape = make()
    photo = photograph(shape, np.random.default_rng(seed))
    solution = solve(photo.graph)
    assert_solved(solution)
    assert photo.error(solution.vertices_mm) < 1e-10
    assert_annotations_hold(solution, float(np.ptp(shape.X)))
    assert_camera_sees(solution, photo.graph, 1e-6)
    assert solution.camera.focal_px == pytest.approx(photo.camera.focal_px, rel=1e-8)
    assert not solution.scale_assumed


@pytest.mark.parametrize("make", SHAPES, ids=NAMES)
def test_careless_sketch_keeps_every_annotation_exactly(make):
    shape = make()
    photo = photograph(shape, np.random.default_rng(11), noise=0.005)
    solution = solve(photo.graph)
    assert_solved(solution)
    assert_annotations_hold(solution, float(np.ptp(shape.X)))


@pytest.mark.parametrize("make", SHAPES, ids=NAMES)
def test_careless_sketch_with_known_focal_length_is_near_the_truth(make):
    errors = []
    for seed in range(5):
        photo = photograph(make(), np.random.default_rng(seed), noise=0.005, focal_known=True)
        errors.append(photo.error(solve(photo.graph).vertices_mm))
    assert np.median(errors) < 0.015


def test_world_is_upright_and_stands_on_the_ground():
    solution = solve(photograph(box(), np.random.default_rng(5)).graph)
    X = np.array(list(solution.vertices_mm.values()))
    np.testing.assert_allclose(X.min(axis=0), 0.0, atol=1e-9)
    assert all(solution.vertices_mm[v][2] == 0.0 for v in ("v0", "v1", "v2", "v3"))
    assert all(solution.vertices_mm[v][2] > 0 for v in ("v4", "v5", "v6", "v7"))
    R = solution.camera.rotation_cam_from_world
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(R) > 0
    assert solution.camera.position_mm[2] > 0
    # x points to the right in the photo, y away from the camera.
    assert R[0, 0] > 0
    assert R[2, 1] > 0


def test_ground_decides_between_the_necker_twins():
    wrong = 0
    for seed in range(30):
        rng = np.random.default_rng(seed)
        photo = photograph(box(), rng, noise=0.01, views=Views(fov_deg=(20, 30)))
        solution = solve(photo.graph)
        wrong += solution.camera.position_mm[2] <= 0 or photo.error(solution.vertices_mm) > 0.25
    assert wrong == 0


def test_without_a_length_the_longest_edge_is_100_mm():
    photo = photograph(box().without("length"), np.random.default_rng(0))
    solution = solve(photo.graph)
    assert_solved(solution)
    assert solution.scale_assumed
    X = solution.vertices_mm
    longest = max(np.linalg.norm(X[a] - X[b]) for a, b in solution.edges.values())
    assert longest == pytest.approx(100.0, abs=1e-9)


def test_several_lengths_hold_together():
    shape = box(200, 99, 77)
    said = {**shape.annotations, "deep": Length("e1", 99.0), "high": Length("e8", 77.0)}
    photo = photograph(replace(shape, annotations=said), np.random.default_rng(3), noise=0.005)
    solution = solve(photo.graph)
    assert_solved(solution)
    assert_annotations_hold(solution, 200.0)


def test_equal_lengths_make_a_cube_of_a_careless_box():
    shape = box(100, 100, 100)
    said = {**shape.annotations, "equal": EqualLength(("e0", "e1", "e8"))}
    photo = photograph(replace(shape, annotations=said), np.random.default_rng(4), noise=0.02)
    solution = solve(photo.graph)
    assert_solved(solution)
    X = solution.vertices_mm
    lengths = [np.linalg.norm(X[a] - X[b]) for a, b in solution.edges.values()]
    np.testing.assert_allclose(lengths, lengths[0], rtol=1e-12)


def test_contradictory_lengths_are_named():
    shape = box()
    said = {**shape.annotations, "too_long": Length("e2", 250.0)}  # opposite the 200 mm of e0
    solution = solve(photograph(replace(shape, annotations=said), np.random.default_rng(1)).graph)
    assert solution.status is Status.CONFLICTING
    assert set(solution.report.conflicts) == {"length", "too_long"}
    assert solution.message


def test_annotations_that_clash_by_reasoning_are_a_smallest_set():
    shape = box()
    # e0 and e1 are perpendicular sides of the bottom.
    said = {**shape.annotations, "wrong": Parallel(("e0", "e1"))}
    solution = solve(photograph(replace(shape, annotations=said), np.random.default_rng(1)).graph)
    assert solution.status is Status.CONFLICTING
    conflicts = solution.report.conflicts
    assert "wrong" in conflicts
    assert len(conflicts) == 2
    other = next(c for c in conflicts if c != "wrong")
    assert isinstance(said[other], RightAngle)


def test_missing_annotations_are_counted_and_located():
    shape = box()
    # Nothing ties the four upper vertices' depths: only the bottom and one wall are square.
    keep = {k: a for k, a in shape.annotations.items() if k in ("ground", "length")}
    photo = photograph(replace(shape, annotations=keep), np.random.default_rng(1))
    solution = solve(photo.graph)
    assert solution.status is Status.UNDERDETERMINED
    assert solution.report.degrees_of_freedom > 0
    assert solution.report.loose
    assert all(np.isfinite(x).all() for x in solution.vertices_mm.values())


def test_a_loose_wire_is_found():
    shape = bookshelf()
    photo = photograph(shape, np.random.default_rng(2))
    graph = replace(
        photo.graph,
        vertices={**photo.graph.vertices, "free": (400.0, 300.0)},
        edges={**photo.graph.edges, "wire": ("v8", "free")},
    )
    solution = solve(graph)
    assert solution.status is Status.UNDERDETERMINED
    assert solution.report.degrees_of_freedom == 1
    assert solution.report.loose == ("free",)


@pytest.mark.parametrize(
    "graph",
    [
        SketchGraph(),
        SketchGraph(vertices={"a": (1.0, 1.0)}),
        SketchGraph(vertices={"a": (1.0, 1.0), "b": (5.0, 5.0)}, edges={"e": ("a", "b")}),
        SketchGraph(
            vertices={f"v{i}": (10.0 * i, 20.0 * i) for i in range(5)},
            edges={f"e{i}": (f"v{i}", f"v{i + 1}") for i in range(4)},
        ),
        SketchGraph(
            vertices={f"v{i}": (7.0, 7.0) for i in range(3)},
            edges={"e0": ("v0", "v1"), "e1": ("v1", "v2")},
            annotations={"g": Ground(("v0", "v1", "v2"))},
        ),
    ],
    ids=["empty", "one vertex", "one edge", "all on a line", "all in one place"],
)
def test_nothing_to_lift_is_said_in_a_sentence(graph):
    solution = solve(graph)
    assert solution.status is Status.UNDERDETERMINED
    assert len(solution.message) > 20


def test_a_solve_can_be_stopped():
    photo = photograph(box(), np.random.default_rng(0))
    solution = solve(photo.graph, stop=lambda: True)
    assert solution.status is not Status.CONVERGED


def test_the_same_graph_gives_the_same_solution():
    graph = photograph(bookshelf(), np.random.default_rng(0), noise=0.01).graph
    first, second = solve(graph), solve(graph)
    for v, x in first.vertices_mm.items():
        np.testing.assert_array_equal(x, second.vertices_mm[v])


def frontal_box():
    """A box seen straight on: one direction runs to a vanishing point, two stay parallel."""
    shape = box()
    camera = Camera(
        1500.0, [800, 600], [[1, 0, 0], [0, 0, -1], [0, 1, 0]], [-100.0, 60.0 + 90.0, 500.0]
    )
    drawn = camera.project(shape.X)
    graph = photograph(shape, np.random.default_rng(0)).graph
    vertices = {f"v{i}": (float(p[0]), float(p[1])) for i, p in enumerate(drawn)}
    return shape, replace(graph, vertices=vertices)


def test_a_frontal_view_says_that_its_focal_length_is_assumed():
    _, graph = frontal_box()
    solution = solve(graph)
    assert_solved(solution)
    assert "focal length assumed" in solution.message


def test_a_frontal_view_is_exact_with_the_focal_length_from_exif():
    shape, graph = frontal_box()
    solution = solve(replace(graph, photo=replace(graph.photo, focal_px=1500.0)))
    assert_solved(solution)
    assert solution.message == "Solved."
    found = np.array([solution.vertices_mm[f"v{i}"] for i in range(8)])
    np.testing.assert_allclose(found, shape.X, atol=0.5)


def test_a_face_without_drawn_sides_is_no_trouble():
    graph = SketchGraph(
        vertices={"a": (0.0, 0.0), "b": (100.0, 0.0), "c": (50.0, 80.0)},
        circles={"c1": Ellipse(((310, 420), (510, 420)), ((410, 380), (410, 460)))},
        faces={"f1": Face(("a", "b", "c"))},
    )
    assert all(f.severity == "warning" for f in findings(graph))
    assert solve(graph).status is Status.UNDERDETERMINED
