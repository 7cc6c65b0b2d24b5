"""A person draws a box with two partitions in FreeCAD's window, taking what is suggested."""

from pathlib import Path

import pytest

from incontext.solver import load_sketch
from incontext.tests.freecad.hands import wait_until
from incontext.workbench.features import pipeline
from incontext.workbench.gallery.outcome import REPLAYED
from incontext.workbench.panels.open_tabs import open_tabs

EXAMPLE = Path(__file__).parents[2] / "resources" / "examples" / "organizer"
#: The seven corners that are seen, in the order of the tool.
BOX = ("v7", "v1", "v3", "v13", "v11", "v17", "v15")
#: The partitions' outlines; the second one stands between the first and the right wall.
PARTITIONS = (("v2", "v12", "v16", "v6", "v2"), ("v8", "v18", "v14", "v4", "v8"))
OPEN = (
    ("v11", "v12", "v16", "v17"),
    ("v12", "v13", "v14", "v18"),
    ("v18", "v14", "v15", "v16"),
)


@pytest.fixture
def photo_path():
    return EXAMPLE / "desk.jpg"


@pytest.fixture
def person(person):
    person.places = load_sketch(EXAMPLE / "organizer.sketch.json").vertices
    return person


def test_box_with_partitions_from_an_empty_sketch_to_plates(person, document):
    view = person.view
    person.press("b")
    for corner in BOX:
        person.click(corner)
    person.press("l")
    for outline in PARTITIONS:
        for corner in outline:
            person.click(corner)
    # Both ends of each line split what they lie on.
    assert (len(view.graph.vertices), len(view.graph.edges)) == (16, 28)
    (controller,) = open_tabs()
    wait_until(lambda: controller.lift is not None and controller.lift[0] is view.graph)
    assert view.suggestions
    person.press("y")
    assert document.UndoNames[0] == "Take suggestions"
    person.press("d")
    person.click("v1", "v2")
    person.type("2*35+6")
    person.press("Return")
    person.press("o")
    wait_until(lambda: "click again" in view.hint)
    for top in OPEN:
        person.click(*top)
    person.push("InContext_MakePlates")
    wait_until(lambda: document.getObject("PlateSet") is not None)
    plates = document.getObject("PlateSet")
    # Bottom, four walls, two partitions.
    assert (plates.Status, plates.PlateCount) == ("made", 7), plates.Message
    solution = pipeline.solution_of(document.getObject("PhotoSketch").Sketch)
    lengths = [a.length_mm for a in view.graph.annotations_of("length").values()]
    assert (lengths, solution.status.value) == ([76.0], "converged")
    assert person.gestures == REPLAYED["organizer"] <= 40
    assert person.complaints() == []
