"""Sketch files: what is read is what was written, and every error is one clear line."""

from __future__ import annotations

import copy
import json

import numpy as np
import pytest
from scenes import SHAPES, box, photograph

from incontext.solver import (
    SketchError,
    load_sketch,
    load_solution,
    save_sketch,
    save_solution,
    solve,
)
from incontext.solver.errors import SketchFileError, SketchReferenceError, SketchVersionError
from incontext.solver.serialise import sketch_from_text, sketch_to_text

GOOD = {
    "format": "incontext/sketch",
    "version": 1,
    "photo": {"file": "desk.jpg", "width_px": 1600, "height_px": 1200, "focal_px": 1500.0},
    "vertices": {"v1": [0, 0], "v2": [100, 0.5], "v3": [100, 100], "v9": [50, 50]},
    "edges": {"e1": ["v1", "v2"], "e2": ["v2", "v3"], "e3": ["v3", "v1"]},
    "circles": {"c1": {"a": [[310, 420], [510, 420]], "b": [[410, 380], [410, 460]]}},
    "revolutions": {"r1": {"ground": "c1", "bottom": "c1", "top": "c1", "profile": ["v1", "v2"]}},
    "faces": {"f1": {"loop": ["v1", "v2", "v3"], "holes": [], "included": True, "thickness_mm": 3}},
    "annotations": {
        "a1": {"kind": "right_angle", "at": "v2", "between": ["e1", "e2"]},
        "a2": {"kind": "equal_length", "edges": ["e1", "e2"]},
        "a3": {"kind": "parallel", "edges": ["e1", "e3"]},
        "a4": {"kind": "ground", "vertices": ["v1", "v2", "v3"]},
        "a5": {"kind": "symmetry_plane", "midpoints_of": ["e1", "e2", "e3"]},
        "a6": {"kind": "length", "edge": "e1", "length_mm": 240.0},
        "a7": {"kind": "diameter", "circle": "c1", "diameter_mm": 90.0},
        "a8": {"kind": "on_face", "vertex": "v9", "face": "f1"},
    },
    "construction": ["e3", "c1"],
    "camera": {
        "focal_px": 1000,
        "principal_point_px": [800, 600],
        "rotation_cam_from_world": [[1, 0, 0], [0, 0, -1], [0, 1, 0]],
        "translation_cam_from_world_mm": [0, 0, 500],
    },
}  # fmt: skip


def edited(*path, to=None, drop=False):
    body = copy.deepcopy(GOOD)
    *way, last = path
    place = body
    for key in way:
        place = place[key]
    if drop:
        del place[last]
    else:
        place[last] = to
    return body


def test_everything_in_the_contract_is_read_and_written_back():
    graph = sketch_from_text(json.dumps(GOOD))
    assert json.loads(sketch_to_text(graph)) == GOOD
    assert sketch_from_text(sketch_to_text(graph)) == graph


def test_optional_parts_may_be_missing():
    body = copy.deepcopy(GOOD)
    for key in ("circles", "revolutions", "faces", "annotations", "construction", "camera"):
        del body[key]
    graph = sketch_from_text(json.dumps(body))
    assert graph.faces is None
    assert graph.annotations == {}


@pytest.mark.parametrize("make", SHAPES, ids=lambda make: make().name)
def test_graphs_survive_the_file(make, tmp_path):
    graph = photograph(make(), np.random.default_rng(0)).graph
    save_sketch(graph, tmp_path / "x.sketch.json")
    again = load_sketch(tmp_path / "x.sketch.json")
    assert again == graph
    assert list(again.vertices) == list(graph.vertices)


def test_solutions_survive_the_file(tmp_path):
    solution = solve(photograph(box(), np.random.default_rng(0)).graph)
    save_solution(solution, tmp_path / "x.solution.json")
    again = load_solution(tmp_path / "x.solution.json")
    assert again.to_json() == solution.to_json()


BAD = {
    "unknown key": (edited("colour", to="red"), "colour"),
    "unknown key in a face": (edited("faces", "f1", "x", to=1), "faces.f1"),
    "missing key": (edited("vertices", drop=True), "vertices"),
    "other format": (edited("format", to="dxf"), "dxf"),
    "version text": (edited("version", to="1"), "version"),
    "version zero": (edited("version", to=0), "version"),
    "vertices a list": (edited("vertices", to=[]), "vertices"),
    "vertex of one number": (edited("vertices", "v1", to=[1]), "v1"),
    "vertex of text": (edited("vertices", "v1", to=["a", 2]), "v1"),
    "vertex true": (edited("vertices", "v1", to=[True, 2]), "v1"),
    "huge coordinate": (edited("vertices", "v1", to=[1e300, 0]), "v1"),
    "edge to a missing vertex": (edited("edges", "e1", to=["v1", "v77"]), "v77"),
    "edge from a vertex to itself": (edited("edges", "e1", to=["v1", "v1"]), "e1"),
    "two edges between two vertices": (edited("edges", "e4", to=["v2", "v1"]), "e4"),
    "edge of three": (edited("edges", "e1", to=["v1", "v2", "v3"]), "e1"),
    "unknown kind": (edited("annotations", "a1", "kind", to="glue"), "glue"),
    "right angle away from its vertex": (edited("annotations", "a1", "at", to="v1"), "a1"),
    "right angle of one edge": (edited("annotations", "a1", "between", to=["e1"]), "a1"),
    "equal length of missing edge": (edited("annotations", "a2", "edges", to=["e1", "e8"]), "e8"),
    "equal length twice the same": (edited("annotations", "a2", "edges", to=["e1", "e1"]), "a2"),
    "ground of nothing": (edited("annotations", "a4", "vertices", to=[]), "a4"),
    "negative length": (edited("annotations", "a6", "length_mm", to=-1), "a6"),
    "zero length": (edited("annotations", "a6", "length_mm", to=0), "a6"),
    "diameter of missing circle": (edited("annotations", "a7", "circle", to="c7"), "c7"),
    "on missing face": (edited("annotations", "a8", "face", to="f7"), "f7"),
    "face with a missing vertex": (edited("faces", "f1", "loop", to=["v1", "v2", "v7"]), "v7"),
    "face through a vertex twice": (
        edited("faces", "f1", "loop", to=["v1", "v2", "v3", "v2"]), "v2"),
    "face thickness zero": (edited("faces", "f1", "thickness_mm", to=0), "f1"),
    "included not a bool": (edited("faces", "f1", "included", to=1), "included"),
    "photo without a size": (edited("photo", "width_px", drop=True), "width_px"),
    "photo of no size": (edited("photo", "width_px", to=0), "width_px"),
    "photo of half a pixel": (edited("photo", "width_px", to=10.5), "width_px"),
    "construction of nothing": (edited("construction", to=["e9"]), "e9"),
    "id with a space": (edited("vertices", "v 5", to=[1, 2]), "v 5"),
    "id of a mirrored copy": (edited("vertices", "v5@a1", to=[1, 2]), "v5@a1"),
    "camera that mirrors": (
        edited("camera", "rotation_cam_from_world", to=[[1, 0, 0], [0, 1, 0], [0, 0, -1]]),
        "rotation",
    ),
    "revolution of missing circle": (edited("revolutions", "r1", "top", to="c5"), "c5"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_bad_sketches_are_refused_in_one_line_that_names_the_place(name):
    body, place = BAD[name]
    with pytest.raises(SketchError) as caught:
        sketch_from_text(json.dumps(body))
    text = str(caught.value)
    assert place in text
    assert "\n" not in text
    assert "try: " in text


@pytest.mark.parametrize(
    "text",
    ["", "   ", "hello", "{", json.dumps(GOOD)[:300], "[]", "null", "3", "[" * 200_000,
     json.dumps(GOOD).replace("100, 0.5", "NaN, 0.5"),
     json.dumps(GOOD).replace("100, 0.5", "Infinity, 0.5"),
     json.dumps(GOOD).replace("100, 0.5", "1e999, 0.5"),
     json.dumps(GOOD).replace("100, 0.5", "9" * 5000 + ", 0.5"),
     '{"format": "incontext/sketch", "format": "incontext/sketch"}'],
    ids=["empty", "blank", "words", "brace", "cut off", "list", "null", "number", "nested",
         "NaN", "Infinity", "overflow", "many digits", "key twice"],
)  # fmt: skip
def test_texts_that_are_no_sketch_are_refused_in_one_line(text):
    with pytest.raises(SketchError) as caught:
        sketch_from_text(text)
    assert len(str(caught.value).splitlines()) == 1


def test_newer_version_says_so():
    with pytest.raises(SketchVersionError, match=r"newer.*update"):
        sketch_from_text(json.dumps(edited("version", to=2)))


def test_reference_errors_carry_the_ids():
    with pytest.raises(SketchReferenceError) as caught:
        sketch_from_text(json.dumps(edited("edges", "e1", to=["v1", "v77"])))
    assert caught.value.ids == ("v77",)
    assert isinstance(caught.value, KeyError)


def test_a_folder_and_a_missing_file_are_refused(tmp_path):
    with pytest.raises(SketchFileError, match="folder"):
        load_sketch(tmp_path)
    with pytest.raises(SketchFileError, match="cannot read"):
        load_sketch(tmp_path / "none.sketch.json")
    (tmp_path / "x.sketch.json").write_bytes(b"\xff\xfe\x00{")
    with pytest.raises(SketchError, match="UTF-8"):
        load_sketch(tmp_path / "x.sketch.json")


def test_a_write_that_fails_leaves_nothing_behind(tmp_path):
    graph = sketch_from_text(json.dumps(GOOD))
    (tmp_path / "taken").mkdir()
    with pytest.raises(SketchFileError, match="cannot write"):
        save_sketch(graph, tmp_path / "taken")
    (tmp_path / "file").write_text("x")
    with pytest.raises(SketchFileError, match="cannot write"):
        save_sketch(graph, tmp_path / "file" / "x.sketch.json")
    assert sorted(p.name for p in tmp_path.rglob("*")) == ["file", "taken"]
