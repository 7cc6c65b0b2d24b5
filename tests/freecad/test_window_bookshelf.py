"""A person draws the bookshelf in FreeCAD's window, with real mouse and keys, to its plates."""

from pathlib import Path

import numpy as np
import pytest

from incontext.solver import load_sketch, solve
from incontext.tests.freecad.hands import wait_until
from incontext.workbench.features import pipeline
from incontext.workbench.gallery.outcome import REPLAYED

EXAMPLE = Path(__file__).parents[2] / "resources" / "examples" / "bookshelf"
BOTTOM, TOP, SHELF = (
    ["v1", "v2", "v3", "v4", "v1"],
    ["v9", "v10", "v11", "v12", "v9"],
    ["v5", "v6", "v7", "v8", "v5"],
)
UPRIGHTS = (("v1", "v9"), ("v2", "v10"), ("v3", "v11"), ("v4", "v12"))
#: The bottom, three walls, two parts of walls below the shelf, the shelf: what makes all square.
SQUARE = (
    ("v1", "v2", "v3", "v4"),
    ("v1", "v4", "v12", "v9"),
    ("v2", "v3", "v11", "v10"),
    ("v4", "v3", "v11", "v12"),
    ("v1", "v4", "v8", "v5"),
    ("v1", "v2", "v6", "v5"),
    ("v5", "v6", "v7", "v8"),
)
OPEN = (("v1", "v2", "v6", "v5"), ("v5", "v6", "v10", "v9"))
#: Width, depth and height, mm, of the example.
SIZE = (210.0, 183.0, 323.0)
#: The shelf's height in parts of the whole.
SHELF_AT = 0.6


@pytest.fixture
def photo_path():
    return EXAMPLE / "desk.jpg"


def corners():
    """Where the bookshelf's corners are in the photo."""
    example = load_sketch(EXAMPLE / "bookshelf.sketch.json")
    solution = solve(example)
    places = dict(example.vertices)
    for corner, (low, high) in zip(SHELF, UPRIGHTS, strict=False):
        a, b = (solution.vertices_mm[v] for v in (low, high))
        (places[corner],) = solution.camera.project(a + SHELF_AT * (b - a))
    return places


@pytest.fixture
def person(person):
    """With the bookshelf's corners in mind."""
    person.places = corners()
    return person


def draw(person):
    person.press("l")
    for line in (BOTTOM, TOP, *UPRIGHTS, SHELF):
        person.drag_along(*line)


def annotate(person):
    person.press("a")
    for loop in SQUARE:
        person.click(*loop)
    person.press("g")
    person.click(*SQUARE[0])
    person.press("d")
    person.click("v1", "v2")
    person.type("210")
    person.press("Return")
    # A person sees when it is solved; faces are known from then on.
    person.press("o")
    wait_until(lambda: "click again" in person.view.hint)
    for loop in OPEN:
        person.click(*loop)


def test_bookshelf_from_an_empty_document_to_plates(person, document):
    draw(person)
    graph = person.view.graph
    assert (len(graph.vertices), len(graph.edges)) == (12, 20)
    annotate(person)
    person.push("InContext_MakePlates")
    wait_until(lambda: getattr(document.getObject("PlateSet"), "Status", ""))
    solution = pipeline.solution_of(document.getObject("PhotoSketch").Sketch)
    assert solution.status.value == "converged", solution.message
    found = np.ptp(np.array(list(solution.vertices_mm.values())), axis=0)
    assert found == pytest.approx(SIZE, rel=0.015)
    assert [face.included for face in solution.faces.values()].count(False) == 2
    plates = document.getObject("PlateSet")
    assert plates.Status == "made", plates.Message
    # Bottom, shelf, top, left, right, back; the front is open.
    assert plates.PlateCount == 6
    assert person.complaints() == []
    assert person.gestures == REPLAYED["bookshelf"] <= 40
