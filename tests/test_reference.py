"""The paper's own method and plain Lipson: formulas by hand, dimensions as in Figure 5, solves."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from scenes import LID, SHAPES, bookshelf, box, l_shape, photograph, photograph_turned

from incontext.solver import save_sketch
from incontext.solver.annotations import EqualLength, Length, Parallel, SymmetryPlane
from incontext.solver.graph import SketchGraph
from incontext.solver.reference import METHODS, Limits, lau2010
from incontext.solver.reference.common import View, turn, view_along_z
from incontext.solver.reference.drawing import DIAGONAL, read_drawing
from incontext.solver.reference.energies import (
    GeometricConstraints,
    equal_length_energy,
    parallel_energy,
    parallel_energy_as_printed,
    right_angle_energy,
)
from incontext.solver.solution import Status
from incontext.workbench import cli

NAMES = [make().name for make in SHAPES]
HASTY = Limits(evaluations_per_dimension=10, restarts=1)


def at(*degrees: float) -> np.ndarray:
    """Unit vectors at angles to the x axis."""
    t = np.radians(degrees)
    return np.column_stack([np.cos(t), np.sin(t), 0 * t])


def cube_photo(seed: int = 0, **noise):
    return photograph(box(100, 100, 100, "cube"), np.random.default_rng(seed), **noise)


# --- the formulas of [Lau10] 4.2 --------------------------------------------------------------


def test_right_angle_energy_is_the_square_of_degrees():
    # 60 and 100 degrees: 30^2 + 10^2.
    assert right_angle_energy(at(0, 0), 5 * at(60, 100)) == pytest.approx(1000.0)


def test_equal_length_energy_is_the_square_of_neighbours_differences():
    # Lengths 3, 5, 9: (3 - 5)^2 + (5 - 9)^2.
    vec = np.array([[3.0, 0, 0], [0, 3, 4], [0, 9, 0]])
    assert equal_length_energy(vec[:-1], vec[1:]) == pytest.approx(20.0)


def test_parallel_energy_as_printed_is_a_pole_at_right_angles_and_not_zero_for_parallels():
    assert parallel_energy_as_printed(at(0), at(60)) == pytest.approx(1 / 30**2)
    assert parallel_energy_as_printed(at(0), at(0)) == pytest.approx(1 / 8100)
    assert parallel_energy_as_printed(at(0), at(90)) > 1e9


def test_parallel_energy_is_zero_for_parallels_of_either_sense():
    assert parallel_energy(at(0), at(20)) == pytest.approx(400.0)
    assert parallel_energy(at(0), at(170)) == pytest.approx(100.0)
    assert parallel_energy(at(10, 10), at(10, 190)) == pytest.approx(0.0, abs=1e-9)


def test_weights_are_a_half_ten_and_ten():
    X = np.vstack([np.zeros(3), at(0, 80), 4 * at(0)])  # 0, then vectors at 0 and 80 degrees
    none = np.empty((0, 4), dtype=np.int64)
    pair = np.array([[0, 1, 0, 2]])
    assert GeometricConstraints(pair, none, none, none).energy(X) == pytest.approx(0.5 * 100)
    lengths = GeometricConstraints(none, np.array([[0, 1, 0, 3]]), none, none)
    assert lengths.energy(X) == pytest.approx(10 * 9)
    assert GeometricConstraints(none, none, pair, none).energy(X) == pytest.approx(10 * 6400)


@pytest.mark.parametrize("make", SHAPES, ids=NAMES)
def test_geometric_energies_are_zero_on_the_truth(make):
    photo = photograph(make(), np.random.default_rng(0))
    energy = read_drawing(photo.graph).constraints.energy
    assert energy(photo.shape.X) == pytest.approx(0.0, abs=1e-6)
    assert energy(photo.shape.X + np.random.default_rng(0).normal(size=photo.shape.X.shape)) > 0.1


def test_groups_are_compared_neighbour_by_neighbour():
    shape = box()
    said = {"eq": EqualLength(("e0", "e1", "e2")), "par": Parallel(("e0", "e2", "e4", "e6"))}
    graph = photograph(replace(shape, annotations=said), np.random.default_rng(0)).graph
    constraints = read_drawing(graph).constraints
    assert len(constraints.equal_lengths) == 2
    assert len(constraints.parallels) == 3


def test_projection_is_zero_where_the_camera_sees_the_drawing():
    photo = cube_photo()
    drawing = read_drawing(photo.graph)
    camera = photo.camera
    view = View(
        camera.position_mm, camera.rotation_cam_from_world, camera.focal_px / drawing.px_per_unit
    )
    assert view.projection_energy(photo.shape.X, drawing.p) == pytest.approx(0.0, abs=1e-15)
    shifted = drawing.p + np.array([3.0, 4.0])  # eight vertices, each 5 units off
    assert view.projection_energy(photo.shape.X, shifted) == pytest.approx(200.0)


def test_first_camera_sees_depth_zero_where_it_was_drawn():
    drawing = read_drawing(cube_photo().graph)
    flat = np.column_stack([drawing.p, np.zeros(8)])
    assert view_along_z(drawing.focal).projection_energy(flat, drawing.p) < 1e-20
    assert np.linalg.norm(np.ptp(drawing.p, axis=0)) == pytest.approx(DIAGONAL)


def test_turn_is_a_rotation_about_its_vector():
    R = turn(np.array([0.0, 0.0, np.pi / 2]))
    np.testing.assert_allclose(R, [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-15)


# --- reduced dimensions -----------------------------------------------------------------------


def test_the_papers_figure_5_goes_from_36_to_18():
    dimensions = lau2010.dimensions_of(photograph(l_shape(), np.random.default_rng(0)).graph)
    assert 3 * len(dimensions) == 36
    assert sum(dimensions.values()) == 18
    # Three of the four ground vertices have two; five corners are completed.
    assert sorted(dimensions.values()) == [0] * 5 + [2] * 3 + [3] * 4


@pytest.mark.parametrize("make", SHAPES, ids=NAMES)
def test_completed_corners_come_out_right(make):
    photo = photograph(make(), np.random.default_rng(0))
    dimensions = lau2010.reduce_dimensions(read_drawing(photo.graph))
    unknowns = photo.shape.X.reshape(-1)[dimensions.chosen]
    np.testing.assert_allclose(dimensions.vertices(unknowns), photo.shape.X, atol=1e-9)
    assert len(unknowns) == sum(dimensions.of_vertex) < 3 * len(photo.shape.X)
    computed: set[int] = set()
    for corner, *others in dimensions.completions:
        completed = {i for i in others if dimensions.of_vertex[i] == 0}
        assert completed <= computed
        computed.add(corner)


# --- whole solves -----------------------------------------------------------------------------


def test_lau2010_solves_an_exact_cube():
    photo = cube_photo()
    solution = METHODS["lau2010"](photo.graph)
    assert solution.status is Status.CONVERGED, solution.message
    assert photo.error(solution.vertices_mm) < 1e-4
    assert solution.camera.focal_px == pytest.approx(photo.camera.focal_px, rel=1e-3)
    assert solution.camera.position_mm[2] > 0
    X = np.array(list(solution.vertices_mm.values()))
    np.testing.assert_allclose(X.min(axis=0), 0.0, atol=1e-9)
    assert np.linalg.norm(X[1] - X[0]) == pytest.approx(100.0)
    assert max(solution.report.reprojection_px.values()) < 1.0
    assert solution.report.residuals.keys() == photo.graph.annotations.keys()
    seen = solution.camera.project(X) - np.array(list(photo.graph.vertices.values()))
    np.testing.assert_allclose(
        np.linalg.norm(seen, axis=1), list(solution.report.reprojection_px.values()), atol=1e-6
    )


@pytest.mark.parametrize("name", METHODS)
def test_the_same_sketch_gives_the_same_solution(name):
    graph = cube_photo(noise=0.01).graph
    first, second = (METHODS[name](graph, limits=HASTY) for _ in range(2))
    for v, x in first.vertices_mm.items():
        np.testing.assert_array_equal(x, second.vertices_mm[v])


@pytest.mark.parametrize("name", METHODS)
def test_a_search_cut_short_says_so(name):
    photo = photograph(bookshelf(), np.random.default_rng(0))
    solution = METHODS[name](photo.graph, limits=Limits(evaluations_per_dimension=2, restarts=1))
    assert solution.status is Status.NOT_CONVERGED
    assert solution.message.startswith(name)
    assert all(np.isfinite(x).all() for x in solution.vertices_mm.values())


@pytest.mark.parametrize("name", METHODS)
def test_without_ground_and_length_the_result_still_stands_upright(name):
    photo = photograph(box().without("ground", "length"), np.random.default_rng(1))
    solution = METHODS[name](photo.graph, limits=HASTY)
    assert solution.scale_assumed
    X = np.array(list(solution.vertices_mm.values()))
    np.testing.assert_allclose(X.min(axis=0), 0.0, atol=1e-9)
    longest = max(
        np.linalg.norm(solution.vertices_mm[a] - solution.vertices_mm[b])
        for a, b in photo.graph.edges.values()
    )
    assert longest == pytest.approx(100.0)


@pytest.mark.parametrize("name", METHODS)
def test_what_the_method_does_not_know_is_named(name):
    shape = box()
    said = {**shape.annotations, "mirror": SymmetryPlane(("e0",))}
    graph = photograph(replace(shape, annotations=said), np.random.default_rng(0)).graph
    solution = METHODS[name](graph, limits=HASTY)
    assert solution.status is Status.NOT_CONVERGED
    assert "mirror" in solution.message

    lid, _ = photograph_turned(LID, np.random.default_rng(0))
    solution = METHODS[name](lid)
    assert solution.status is Status.NOT_CONVERGED
    assert "c0" in solution.message
    assert not solution.vertices_mm


@pytest.mark.parametrize("name", METHODS)
def test_nothing_to_lift_is_said(name):
    line = SketchGraph(
        vertices={"a": (0.0, 0.0), "b": (5.0, 5.0), "c": (9.0, 9.0)},
        edges={"e": ("a", "b"), "f": ("b", "c")},
        annotations={"l": Length("e", 10.0)},
    )
    for graph in (SketchGraph(), line):
        assert METHODS[name](graph).status is Status.UNDERDETERMINED


@pytest.mark.parametrize("name", METHODS)
@pytest.mark.parametrize("after", [1, 3, 20])
def test_a_running_search_stops_at_once(name, after):
    asked = []

    def stop() -> bool:
        asked.append(0)
        return len(asked) >= after

    graph = cube_photo().graph
    solution = METHODS[name](graph, limits=Limits(evaluations_per_dimension=40), stop=stop)
    # What begins after that asks once and ends.
    assert len(asked) < after + 12
    assert solution.report.iterations <= 8 * after
    assert len(solution.vertices_mm) == 8
    assert all(np.isfinite(x).all() for x in solution.vertices_mm.values())


def test_a_running_search_tells_how_far_it_is():
    told = []
    limits = Limits(evaluations_per_dimension=10)
    tell = lambda done, what: told.append(done)  # noqa: E731
    METHODS["lipson1996"](cube_photo().graph, limits=limits, progress=tell)
    assert len(set(told)) > 10
    assert told == sorted(told)
    assert 0.5 < max(told) <= 1


# --- the command line -------------------------------------------------------------------------


def test_the_command_line_knows_every_method():
    assert ("ours", *METHODS) == cli.METHODS


def test_solve_takes_a_method(tmp_path, capsys):
    path = tmp_path / "cube.sketch.json"
    save_sketch(replace(cube_photo().graph, photo=None), path)
    assert cli.main(["solve", str(path), "--method", "lau2010"]) in (cli.OK, cli.BAD_SOLVE)
    body = json.loads((tmp_path / "cube.solution.json").read_text(encoding="utf-8"))
    assert len(body["vertices"]) == 8
    assert "lau2010" in body["message"]
    assert cli.main(["solve", str(path), "--method", "lipson1997"]) == cli.BAD_INPUT
    assert "lipson1996" in capsys.readouterr().err
