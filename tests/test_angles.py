"""Angles at the corners of faces: measured, and right ones said."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from incontext.solver import SketchError, load_sketch, solve
from incontext.solver.annotations import RightAngle
from incontext.solver.dimensions.angles import angles_deg, driving_angles_deg, set_angle
from incontext.solver.synthetic import Views, photograph_exactly, random_camera, wedge

DATA = Path(__file__).parent / "data"


@pytest.fixture(scope="module")
def shelf():
    return load_sketch(DATA / "shelf.sketch.json")


def test_every_corner_of_a_face_is_measured(shelf):
    solution = solve(shelf)
    angles = angles_deg(shelf, solution)
    corners = sum(len(loop) for f in solution.faces.values() for loop in f.loops)
    assert 0 < len(angles) <= corners + len(driving_angles_deg(shelf))
    assert list(angles.values()) == pytest.approx([90] * len(angles), abs=1e-9)


def test_a_right_angle_is_said_and_taken_back(shelf):
    corner = next(iter(driving_angles_deg(shelf)))
    free = set_angle(shelf, corner, None)
    assert corner not in driving_angles_deg(free)
    again = set_angle(free, corner, 90.0)
    assert driving_angles_deg(again) == driving_angles_deg(shelf)
    assert set_angle(again, corner, 90.0) == again
    assert all(
        set(a.between) <= set(again.edges)
        for a in again.annotations.values()
        if isinstance(a, RightAngle)
    )


def test_other_angles_cannot_be_said(shelf):
    corner = next(iter(driving_angles_deg(shelf)))
    with pytest.raises(SketchError, match="only right angles"):
        set_angle(shelf, corner, 80.0)
    apart = next(
        (e, f)
        for e, ends in shelf.edges.items()
        for f, others in shelf.edges.items()
        if not set(ends) & set(others)
    )
    with pytest.raises(SketchError, match="do not meet"):
        set_angle(shelf, apart, 90.0)


def test_slanted_angles_are_those_of_the_truth():
    shape = wedge()
    graph = photograph_exactly(shape, random_camera(shape, np.random.default_rng(0), Views()))
    X = dict(zip(graph.vertices, shape.X, strict=True))
    angles = angles_deg(graph, solve(graph))
    assert any(abs(angle - 90) > 1 for angle in angles.values())
    for (e, f), angle in angles.items():
        (at,) = set(graph.edges[e]) & set(graph.edges[f])
        ends = [next(v for v in graph.edges[edge] if v != at) for edge in (e, f)]
        d, c = (X[end] - X[at] for end in ends)
        cosine = d @ c / np.linalg.norm(d) / np.linalg.norm(c)
        assert angle == pytest.approx(np.degrees(np.arccos(cosine)), abs=1e-5)
