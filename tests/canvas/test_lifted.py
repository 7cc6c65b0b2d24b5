"""Where the lifted shape lies in the photo."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from incontext.solver import load_sketch, solve
from incontext.solver.annotations import SymmetryPlane
from incontext.solver.camera import Camera
from incontext.solver.solution import Solution, SolvedCircle, Status
from incontext.workbench.canvas.lifted import LiftedView, lifted_view

SHELF = Path(__file__).parent.parent / "data" / "shelf.sketch.json"
AHEAD = Camera(500.0, np.array([400.0, 300.0]), np.eye(3), np.zeros(3))


@pytest.fixture(scope="module")
def shelf():
    return load_sketch(SHELF)


def test_solved_sketch_lies_on_its_drawing(shelf):
    shown = lifted_view(solve(shelf))
    assert shown.edges.keys() == shelf.edges.keys()
    for edge, line in shown.edges.items():
        drawn = [shelf.vertices[v] for v in shelf.edges[edge]]
        assert np.array(line) == pytest.approx(np.array(drawn), abs=3.0)
    assert len(shown.faces) == sum(face.included for face in shelf.faces.values())


def test_copies_are_told_apart(shelf):
    edge = next(iter(shelf.edges))
    plane = {**shelf.annotations, "mirror": SymmetryPlane((edge,))}
    solution = solve(replace(shelf, annotations=plane))
    shown = lifted_view(solution)
    assert shown.edges.keys() == shelf.edges.keys()
    assert len(shown.copies) == sum("@" in e for e in solution.edges)


def test_circle_is_a_closed_ring():
    circle = SolvedCircle(np.array([0.0, 0.0, 1000.0]), 100.0)
    solution = Solution("", Status.CONVERGED, "", circles={"c1": circle}, camera=AHEAD)
    (ring,) = lifted_view(solution).circles
    assert ring[0] == pytest.approx(ring[-1])
    assert np.linalg.norm(np.array(ring) - (400, 300), axis=1) == pytest.approx(50.0)


def test_what_lies_in_the_camera_is_left_out():
    places = {"v1": np.zeros(3), "v2": np.array([0.0, 0.0, 5.0]), "v3": np.array([1.0, 0.0, 5.0])}
    edges = {"e1": ("v1", "v2"), "e2": ("v2", "v3")}
    solution = Solution("", Status.CONVERGED, "", places, edges, camera=AHEAD)
    assert lifted_view(solution).edges.keys() == {"e2"}
    assert lifted_view(None) == lifted_view(replace(solution, camera=None)) == LiftedView()
