"""A person draws the saucer of the example in FreeCAD's window: camera from the marker, then V."""

from pathlib import Path

import numpy as np
import pytest

from incontext.solver import load_sketch
from incontext.tests.freecad.hands import wait_until
from incontext.tests.freecad.test_window_camera import answer
from incontext.workbench import host
from incontext.workbench.examples import load_example
from incontext.workbench.features import pipeline
from incontext.workbench.gallery.outcome import REPLAYED

EXAMPLE = Path(__file__).parents[2] / "resources" / "examples" / "cup_saucer"
#: Where a person clicks for the marker's corners, in the upright photo, px.
MARKER = ((621, 1222), (943, 1142), (818, 908), (522, 973))


@pytest.fixture
def photo_path():
    return EXAMPLE / "table.jpg"


def test_saucer_by_the_marker_from_an_empty_sketch_to_a_printable_solid(person, document):
    drawn, truth = load_sketch(EXAMPLE / "cup_saucer.sketch.json"), load_example("cup_saucer").truth
    sketch = document.getObject("PhotoSketch")
    # What was told last is not asked for where the photo shows the marker.
    host.preferences().SetString("RectangleKind", "A5 sheet")
    person.press("w")
    answer(lambda window: window.accept())
    for corner in MARKER:
        person.click_at(*corner)
    wait_until(lambda: pipeline.graph_of(sketch.Sketch).camera is not None)
    # The window that asks for the size, and takes the marker's.
    person.gestures += 1
    person.press("v")
    for circle in drawn.circles.values():
        ends = np.array([*circle.a, *circle.b])
        person.drag(person.at_px(*ends.min(axis=0)), person.at_px(*ends.max(axis=0)))
    for vertex in drawn.revolutions["r1"].profile:
        person.click_at(*drawn.vertices[vertex])
    (turned,) = person.view.graph.revolutions.values()
    assert len(turned.profile) == 3
    person.push("InContext_Lift")
    person.push("InContext_MakeShell")
    wait_until(lambda: document.getObject("ShelledSolid") is not None)
    solid = document.getObject("ShelledSolid")
    assert solid.Status == "made", solid.Message
    solution = pipeline.solution_of(sketch.Sketch)
    assert solution.status.value == "converged", solution.message
    foot = 2 * solution.circles[turned.bottom].radius_mm
    assert foot == pytest.approx(truth["cup"]["foot_diameter_mm"], rel=0.02)
    assert solution.camera.focal_px == pytest.approx(truth["camera"]["focal_px"], rel=0.02)
    assert person.gestures == REPLAYED["cup_saucer"]
    assert person.complaints() == []
