"""Rectangle and drawing tell the camera together: sizes beside a marker are within 2 %."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from rectangles import corners_mm

from incontext.solver import load_sketch, solve
from incontext.solver.camera import Camera
from incontext.solver.graph import SketchGraph
from incontext.solver.perspective.marker import camera_from_rectangle
from incontext.solver.perspective.refining import refined_camera
from incontext.workbench.examples import load_example
from incontext.workbench.gallery.table import with_marker

MARKER = (100.0, 100.0)
#: As corners are found in photos.
SIGMA_PX = 0.15


@pytest.fixture(scope="module")
def shelf():
    """The bookshelf as it is drawn, with no length; its truth; the camera that took the photo."""
    example = load_example("bookshelf")
    graph, told = load_sketch(example.sketch_path), example.truth["camera"]
    said = {id_: a for id_, a in graph.annotations.items() if a.kind != "length"}
    names = ("focal_px", "principal_point_px", "rotation_cam_from_world")
    camera = Camera(*(told[n] for n in names), told["translation_cam_from_world_mm"])
    return replace(graph, annotations=said), example.truth, camera


def view_of_marker(graph, camera, rng):
    """The marker on the desk in front of the books, its corners found in the photo."""
    corners = camera.project(corners_mm(MARKER) + np.array([100.0, -110.0, 0.0]))
    seen = corners + rng.normal(0, SIGMA_PX, (4, 2))
    return camera_from_rectangle(graph.photo, seen, MARKER, corner_sigma_px=SIGMA_PX)


def test_with_a_marker_the_books_proportions_are_within_two_percent():
    """Each draw, where the marker's corners alone leave one in four outside."""
    offs = with_marker(12)
    assert offs.shape == (12, 2)
    assert np.abs(offs).max() < 0.02


def test_the_size_comes_from_the_marker(shelf):
    """Nobody typed a length."""
    graph, _, camera = shelf
    refined = refined_camera(graph, view_of_marker(graph, camera, np.random.default_rng(7)))
    assert abs(refined.focal_px / camera.focal_px - 1) < 0.03
    solution = solve(replace(graph, camera=refined))
    assert not solution.scale_assumed
    assert 205 < np.linalg.norm(solution.vertices_mm["v2"] - solution.vertices_mm["v1"]) < 215


def test_the_world_stays_the_rectangles(shelf):
    graph, _, camera = shelf
    view = view_of_marker(graph, camera, np.random.default_rng(1))
    refined = refined_camera(graph, view)
    assert np.abs(refined.project(view.corners_mm) - view.corners_px).max() < 1.0


def test_a_drawing_that_says_nothing_refines_nothing(shelf):
    graph, _, camera = shelf
    view = view_of_marker(graph, camera, np.random.default_rng(1))
    assert refined_camera(SketchGraph(photo=graph.photo), view) is None
    loose = replace(graph, annotations={})
    assert refined_camera(loose, view) is None
