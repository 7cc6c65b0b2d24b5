"""Lens distortion in FreeCAD's window: said beside the annotations, taken out by one command."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide import QtGui

from incontext.solver.serialise import sketch_to_text
from incontext.tests.freecad.hands import wait_until
from incontext.tests.rectangles import SMALL, camera_at, corners_mm, seen
from incontext.workbench.features import pipeline
from incontext.workbench.lens import Lens
from incontext.workbench.panels import messages
from incontext.workbench.panels.open_tabs import open_tabs

BEND, PAPER = 0.05, (300.0, 280.0)
CAMERA = camera_at(50, -75, 560, 900, photo=SMALL)
TRUE = CAMERA.project(corners_mm(PAPER))


@pytest.fixture(scope="module")
def photo_path(tmp_path_factory):
    """A sheet of paper as a lens with a barrel sees it."""
    path = tmp_path_factory.mktemp("photo") / "table.png"
    rng = np.random.default_rng(2)
    grey = seen(CAMERA, SMALL, rng, paper_mm=PAPER, bend=BEND).astype(np.uint8)
    image = QtGui.QImage(grey.tobytes(), 800, 600, 800, QtGui.QImage.Format_Grayscale8)
    assert image.save(str(path))
    return path


def traced(sketch, document):
    """Have the paper's border traced as construction."""
    bent = Lens(np.array([400.0, 300.0]), 500.0, BEND, 0.0, {}).bent(TRUE)
    graph = replace(
        pipeline.graph_of(sketch.Sketch),
        vertices={f"v{k}": tuple(p) for k, p in enumerate(bent.tolist())},
        edges={f"e{k}": (f"v{k}", f"v{(k + 1) % 4}") for k in range(4)},
        construction=("e0", "e1", "e2", "e3"),
    )
    document.openTransaction("Trace")
    sketch.Sketch = sketch_to_text(graph)
    document.recompute()
    document.commitTransaction()


def test_bent_lines_are_said_and_the_photo_is_straightened(person, document, monkeypatch):
    sketch = document.getObject("PhotoSketch")
    controller = open_tabs()[0]
    traced(sketch, document)
    wait_until(lambda: "the lens distorts" in controller.lens_watch.words)
    before = Path(sketch.Photo).read_bytes()
    person.push("InContext_StraightenPhoto")
    wait_until(lambda: controller.lens_watch.words == "")
    graph = pipeline.graph_of(sketch.Sketch)
    np.testing.assert_allclose([*graph.vertices.values()], TRUE, atol=0.5)
    assert graph.photo.file == "table-straight.jpg"
    assert Path(sketch.Photo).read_bytes() != before
    assert controller.tab.view.has_photo

    said = []
    monkeypatch.setattr(messages, "mention", said.append)
    person.push("InContext_StraightenPhoto")
    assert "nothing to straighten" in said[0]

    person.press("ctrl+z")
    assert Path(sketch.Photo).read_bytes() == before
    wait_until(lambda: "the lens distorts" in controller.lens_watch.words)


def test_with_nothing_drawn_the_photos_own_edges_tell(person, document):
    sketch = document.getObject("PhotoSketch")
    person.push("InContext_StraightenPhoto")
    assert pipeline.graph_of(sketch.Sketch).photo.file == "table-straight.jpg"


def test_where_no_straight_thing_is_seen_it_says_what_to_do(
    person, document, monkeypatch, tmp_path
):
    told = []
    monkeypatch.setattr(messages, "tell", told.append)
    image = QtGui.QImage(800, 600, QtGui.QImage.Format_RGB888)
    image.fill(QtGui.QColor(120, 120, 120))
    assert image.save(str(tmp_path / "fog.png"))
    document.getObject("PhotoSketch").Photo = str(tmp_path / "fog.png")
    person.push("InContext_StraightenPhoto")
    assert "construction" in told[0]
