"""``incontext marker`` and ``incontext camera``."""

from __future__ import annotations

import json
import sys

import numpy as np
import pytest
from PIL import Image
from rectangles import SMALL, camera_at, corners_mm, seen

from incontext.solver import load_sketch, save_sketch, solve
from incontext.solver.graph import SketchGraph
from incontext.workbench.cli import main

CAMERA = camera_at(40, -70, 500, 900, photo=SMALL)


@pytest.fixture
def photo(tmp_path):
    """The printed marker on a table."""
    path = tmp_path / "desk.jpg"
    grey = seen(CAMERA, SMALL, np.random.default_rng(3))
    Image.fromarray(grey.astype(np.uint8)).save(path, quality=92)
    return path


def clicks() -> list[str]:
    places = CAMERA.project(corners_mm((100.0, 100.0))) + np.array(
        [[2, 1], [-2, 1], [1, -2], [2, 2]]
    )
    return [f"{u:.1f},{v:.1f}" for u, v in places]


def run(capsys, *arguments):
    status = main([str(argument) for argument in arguments])
    caught = capsys.readouterr()
    assert "Traceback" not in caught.err
    return status, caught.out, caught.err


def test_marker_writes_a_file(tmp_path, capsys):
    out = tmp_path / "new" / "marker.pdf"
    status, printed, _ = run(capsys, "marker", "--out", out, "--size", 80)
    assert (status, printed.strip()) == (0, str(out))
    assert out.read_bytes().startswith(b"%PDF-1.4")
    status, _, said = run(capsys, "marker", "--out", tmp_path / "marker.doc")
    assert (status, len(said.splitlines())) == (2, 1)


def test_camera_of_a_photo_is_printed_or_becomes_a_sketch(photo, tmp_path, capsys):
    status, printed, said = run(capsys, "camera", photo, "--size", 100, "--corners", *clicks())
    assert status == 0
    found = json.loads(printed)
    assert found["focal_px"] == pytest.approx(900, rel=0.03)
    assert "above the ground" in said
    sketch = tmp_path / "desk.sketch.json"
    status, printed, _ = run(
        capsys, "camera", photo, "--size", 100, "--corners", *clicks(), "-o", sketch
    )
    assert (status, printed.count("\n")) == (0, 2)
    graph = load_sketch(sketch)
    assert graph.photo.file == "desk.jpg"
    assert graph.camera.position_mm[2] == pytest.approx(CAMERA.position_mm[2], rel=0.02)


def test_camera_of_a_sketch_is_written_into_it(photo, capsys):
    pytest.importorskip("cv2")
    path = photo.with_name("desk.sketch.json")
    before = SketchGraph(photo=SMALL.__class__("desk.jpg", 800, 600), vertices={"v1": (1.0, 2.0)})
    save_sketch(before, path)
    status, printed, _ = run(capsys, "camera", path, "--size", "100x100")
    assert status == 0
    assert "corners found in the photo" in printed
    after = load_sketch(path)
    assert after.vertices == before.vertices
    assert after.camera is not None


def test_a_sketch_over_a_marker_needs_no_length(photo, capsys):
    """A square of 60 mm drawn on the table beside the marker."""
    sketch = photo.with_name("desk.sketch.json")
    run(capsys, "camera", photo, "--size", 100, "--corners", *clicks(), "-o", sketch)
    body = json.loads(sketch.read_text())
    drawn = CAMERA.project([[60, -30, 0], [120, -30, 0], [120, 30, 0], [60, 30, 0]])
    names = ["a", "b", "c", "d"]
    body["vertices"] = dict(zip(names, drawn.tolist(), strict=True))
    body["edges"] = {f"e{k}": [names[k], names[(k + 1) % 4]] for k in range(4)}
    body["annotations"] = {"g": {"kind": "ground", "vertices": names}}
    for k in range(4):
        between = [f"e{(k - 1) % 4}", f"e{k}"]
        body["annotations"][f"r{k}"] = {"kind": "right_angle", "at": names[k], "between": between}
    sketch.write_text(json.dumps(body))
    assert run(capsys, "check", sketch)[:2] == (0, "")
    X = solve(load_sketch(sketch)).vertices_mm
    assert np.linalg.norm(X["b"] - X["a"]) == pytest.approx(60, rel=0.02)
    assert np.linalg.norm(X["c"] - X["b"]) == pytest.approx(60, rel=0.02)


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["--size", "q"], "'q' is no size"),
        (["--size", "0", "--corners", "1,1", "9,1", "9,9", "1,9"], "is none"),
        (["--size", "100", "--corners", "1,1", "9,1", "9,9", "x"], "'x' is no place"),
        (["--size", "100", "--corners", "1,1", "2,2", "3,3", "4,4"], "one place"),
        (["--size", "100", "--focal", "-3"], "-3 px"),
    ],
)
def test_bad_input_is_one_line_and_status_2(photo, capsys, words, says):
    status, printed, said = run(capsys, "camera", photo, *words)
    assert (status, printed, len(said.splitlines())) == (2, "", 1)
    assert says in said
    assert "try:" in said


def test_without_opencv_the_corners_are_asked_for(photo, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "cv2", None)
    status, _, said = run(capsys, "camera", photo, "--size", 100)
    assert (status, len(said.splitlines())) == (2, 1)
    assert "opencv-python-headless" in said
    assert "--corners" in said
