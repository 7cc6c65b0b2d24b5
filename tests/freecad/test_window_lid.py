"""A person draws the lid of a teapot in FreeCAD's window, with real mouse and keys."""

import numpy as np
import pytest

from incontext.solver.camera import Camera
from incontext.solver.synthetic import image_ellipse
from incontext.tests.freecad.hands import wait_until
from incontext.workbench.features import pipeline
from incontext.workbench.gallery.outcome import REPLAYED

UP = np.array([0.0, 0.0, 1.0])
#: Radius and height, mm: the table, the lid's bottom, its knob's top; then its side.
CIRCLES = ((70.0, 0.0), (45.0, 95.0), (12.0, 135.0))
SIDE = ((45.0, 95.0), (38.0, 108.0), (12.0, 115.0), (12.0, 135.0))


@pytest.fixture(scope="module")
def camera():
    """Looks down at the teapot from in front of it."""
    eye, target = np.array([0.0, -500.0, 330.0]), np.array([0.0, 0.0, 70.0])
    forward = (target - eye) / np.linalg.norm(target - eye)
    right = np.array([1.0, 0.0, 0.0])
    turn = np.array([right, np.cross(forward, right), forward])
    return Camera(1100.0, np.array([400.0, 300.0]), turn, -turn @ eye)


def box_of(camera, radius, height):
    """The box around a circle in the photo, by two opposite corners."""
    drawn = image_ellipse(camera, height * UP, radius)
    ends = np.array([*drawn.a, *drawn.b])
    return ends.min(axis=0), ends.max(axis=0)


def draw_lid(person, camera):
    person.press("v")
    for radius, height in CIRCLES:
        low, high = box_of(camera, radius, height)
        person.drag(person.at_px(*low), person.at_px(*high))
    for radius, height in SIDE:
        (place,) = camera.project([radius, 0.0, height])
        person.click_at(*place)
    person.press("d")
    low, high = box_of(camera, *CIRCLES[1])
    person.click_at((low[0] + high[0]) / 2, high[1])
    person.type("9 cm")
    person.press("Return")


def test_lid_from_an_empty_sketch_to_a_printable_solid(person, document, camera):
    draw_lid(person, camera)
    graph = person.view.graph
    (turned,) = graph.revolutions.values()
    assert (len(graph.circles), len(turned.profile)) == (3, 4)
    solution = pipeline.solution_of(document.getObject("PhotoSketch").Sketch)
    assert solution.status.value == "converged", solution.message
    assert person.complaints() == []
    person.push("InContext_Lift")
    person.push("InContext_MakeShell")
    wait_until(lambda: getattr(document.getObject("ShelledSolid"), "Status", ""), 60)
    solid = document.getObject("ShelledSolid")
    assert solid.Status == "made", solid.Message
    assert solid.Shape.isValid()
    assert len(solid.Shape.Solids) == 1
    size = solid.Shape.BoundBox
    assert size.XLength == pytest.approx(90, rel=0.01)
    assert size.ZLength == pytest.approx(40, rel=0.1)
    assert person.gestures == REPLAYED["teapot_lid"] <= 25
    assert person.complaints() == []
