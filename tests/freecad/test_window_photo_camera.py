"""The window on the photo's camera: what is known, and the middle of a cropped photo."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image
from PySide import QtGui

from incontext.solver.camera import Camera
from incontext.solver.graph import SketchGraph
from incontext.solver.perspective.marker import camera_from_rectangle
from incontext.solver.serialise import sketch_to_text
from incontext.solver.synthetic import bookshelf, photograph_exactly
from incontext.tests.freecad.hands import pump
from incontext.tests.rectangles import camera_at, corners_mm
from incontext.workbench.examples import load_example
from incontext.workbench.features import pipeline
from incontext.workbench.features.examples import import_sketch
from incontext.workbench.features.known_rectangle import marker_text
from incontext.workbench.features.photo_sketch import make_photo_sketch
from incontext.workbench.panels import camera_dialog
from incontext.workbench.panels.camera_dialog import CameraDialog

EXIF = 0x8769


#: Cut away at the left and at the top.
CROP = np.array([300, 150])
TOWARDS = (500.0, 450.0)


@pytest.fixture
def cropped(window, document, tmp_path):
    """A shelf traced all over a photo of 1600 x 1200 px of which 1300 x 1050 are left."""
    shape = bookshelf()
    middle = (shape.X.min(axis=0) + shape.X.max(axis=0)) / 2
    graph = photograph_exactly(replace(shape, X=shape.X - middle), camera_at(35, -50, 550, 900))
    drawn = np.array([*graph.vertices.values()]) - CROP
    drawn = drawn + np.random.default_rng(4).normal(0, 0.5, drawn.shape)
    path, exif = tmp_path / "cropped.jpg", Image.Exif()
    exif.get_ifd(EXIF).update({0xA002: 1600, 0xA003: 1200})
    Image.new("RGB", (1300, 1050), "grey").save(path, exif=exif)
    graph = replace(
        graph,
        photo=replace(graph.photo, file=path.name, width_px=1300, height_px=1050),
        vertices=dict(zip(graph.vertices, map(tuple, drawn.tolist()), strict=True)),
        construction=tuple(graph.edges),
    )
    sketch = make_photo_sketch(document, sketch_to_text(graph), path)
    document.recompute()
    return sketch


def answering(monkeypatch, answer):
    """Have a person answer the window, which is seen."""

    def shown(dialog):
        dialog.show()
        pump(0.3)
        said = answer(dialog)
        dialog.hide()
        return said

    monkeypatch.setattr(camera_dialog, "shown", shown)


def test_a_cropped_photo_is_told_and_the_lines_say_where_it_looked(cropped, monkeypatch):
    sketch, told = cropped, []
    before = sketch.Sketch

    def by_the_lines(dialog):
        told.append(dialog.words)
        dialog.lines_button.click()
        return True

    answering(monkeypatch, by_the_lines)
    CameraDialog(sketch).show_until_answered()
    assert "seems cropped" in told[0]
    assert "The traced lines say" in told[0]
    found = pipeline.graph_of(sketch.Sketch).photo.principal_point_px
    assert np.linalg.norm(np.subtract(found, TOWARDS)) < 40
    sketch.Document.undo()
    assert sketch.Sketch == before


def test_the_middle_and_the_focal_length_can_be_typed(cropped, monkeypatch):
    sketch, (u, v) = cropped, TOWARDS

    def typed(dialog):
        dialog.focal_field.setText("nonsense")
        ok = dialog._buttons.button(QtGui.QDialogButtonBox.Ok)
        assert not ok.isEnabled()
        dialog.focal_field.setText("40")
        dialog.u_field.setText(f"{u:.1f}".replace(".", ","))
        dialog.v_field.setText(f"{v:.1f}")
        assert ok.isEnabled()
        return True

    answering(monkeypatch, typed)
    CameraDialog(sketch).show_until_answered()
    photo = pipeline.graph_of(sketch.Sketch).photo
    assert photo.principal_point_px == pytest.approx((u, v), abs=0.06)
    # Of the whole photo, whose diagonal is 2000 px.
    assert photo.focal_px == pytest.approx(40 / np.hypot(36, 24) * 2000)

    def middle_again(dialog):
        dialog.middle_button.click()
        dialog.focal_field.clear()
        return True

    answering(monkeypatch, middle_again)
    CameraDialog(sketch).show_until_answered()
    photo = pipeline.graph_of(sketch.Sketch).photo
    assert (photo.principal_point_px, photo.focal_px) == (None, None)


def test_rectangle_and_drawing_tell_the_camera_together(window, document, monkeypatch):
    """The bookshelf, as if a marker had told a camera that is 4 % off."""
    example = load_example("bookshelf")
    sketch = import_sketch(document, example.sketch_path)
    graph, truth = pipeline.graph_of(sketch.Sketch), example.truth["camera"]
    names = ("focal_px", "principal_point_px", "rotation_cam_from_world")
    camera = Camera(*(truth[n] for n in names), truth["translation_cam_from_world_mm"])
    corners = camera.project(corners_mm((100.0, 100.0)) + np.array([100.0, -110.0, 0.0]))
    corners += np.array([[0.6, 0.0], [-0.4, 0.3], [0.2, -0.5], [0.1, 0.4]])
    view = camera_from_rectangle(graph.photo, corners, (100.0, 100.0), corner_sigma_px=0.3)
    said = {id_: a for id_, a in graph.annotations.items() if a.kind != "length"}
    sketch.Sketch = sketch_to_text(replace(graph, annotations=said, camera=view.camera))
    sketch.Marker = marker_text(view.corners_px.tolist(), (100.0, 100.0))
    document.recompute()
    said = []

    def refine(dialog):
        assert dialog.refine_button.isVisible()
        dialog.refine_button.click()
        said.append(dialog.words)
        return False

    answering(monkeypatch, refine)
    CameraDialog(sketch).show_until_answered()
    refined = pipeline.graph_of(sketch.Sketch).camera
    assert abs(refined.focal_px / camera.focal_px - 1) < abs(
        view.camera.focal_px / camera.focal_px - 1
    )
    assert "The focal length was" in said[0]


def test_without_a_photo_it_says_so(window, document, monkeypatch):
    from incontext.workbench.commands.photo_camera import PhotoCamera
    from incontext.workbench.panels import messages

    told = []
    monkeypatch.setattr(messages, "tell", told.append)
    make_photo_sketch(document, sketch_to_text(SketchGraph()))
    document.recompute()
    PhotoCamera().Activated()
    assert told == ["There is no photo: choose one first."]
