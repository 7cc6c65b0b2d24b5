"""The command line on sketches whose annotations disagree: exit status, words, solution file."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from scenes import box, photograph

from incontext.solver import save_sketch
from incontext.solver.annotations import (
    EqualLength,
    Ground,
    Length,
    OnFace,
    Parallel,
    RightAngle,
    SymmetryPlane,
)
from incontext.solver.graph import Face
from incontext.workbench import cli

#: What cannot be true of a box, whatever its sizes; e0 and e1 meet, e0 and e2 are opposite sides.
CONTRADICTIONS = {
    "right_angle": {"right": RightAngle("v0", ("e0", "e3")), "wrong": Parallel(("e0", "e3"))},
    "parallel": {"wrong": Parallel(("e0", "e1"))},
    "equal_length": {
        "one": Length("e1", 150.0),
        "other": Length("e9", 120.0),
        "wrong": EqualLength(("e1", "e9")),
    },
    "ground": {"wrong": Ground(("v5",))},
    "symmetry_plane": {"wrong": SymmetryPlane(("e0", "e1"))},
    "length": {"wrong": Length("e2", 90.0)},
    "on_face": {"wrong": OnFace("v6", "bottom")},
}


def saved(tmp_path, more):
    shape = box()
    said = {**shape.annotations, **more}
    graph = photograph(replace(shape, annotations=said), np.random.default_rng(0)).graph
    graph = replace(graph, photo=replace(graph.photo, file=None))
    if any(isinstance(a, OnFace) for a in more.values()):
        graph = replace(graph, faces={"bottom": Face(("v0", "v1", "v2", "v3"))})
    path = tmp_path / "box.sketch.json"
    save_sketch(graph, path)
    return path


@pytest.mark.parametrize("kind", CONTRADICTIONS)
def test_what_cannot_hold_ends_with_status_3_and_is_named(kind, tmp_path, capsys):
    path = saved(tmp_path, CONTRADICTIONS[kind])
    assert cli.main(["solve", str(path)]) == cli.BAD_SOLVE
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("incontext: conflicting: ")
    body = json.loads((tmp_path / "box.solution.json").read_text(encoding="utf-8"))
    assert body["status"] == "conflicting"
    named = body["report"]["conflicts"]
    assert named[0] in line
    assert set(named) & set(CONTRADICTIONS[kind])
    assert cli.main(["check", str(path)]) == cli.BAD_INPUT
    assert named[0] in capsys.readouterr().out


def test_a_length_that_the_drawing_speaks_against_is_said(tmp_path, capsys):
    path = saved(tmp_path, {"deep": Length("e1", 150.0), "high": Length("e8", 160.0)})
    assert cli.main(["solve", str(path)]) == cli.OK
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("warning: Solved, but high contradicts the drawing")
    body = json.loads((tmp_path / "box.solution.json").read_text(encoding="utf-8"))
    assert body["status"] == "converged"
    assert body["report"]["conflicts"][0] == "high"
    assert cli.main(["check", str(path)]) == cli.OK
    assert "warning: Solved, but high contradicts" in capsys.readouterr().out


UNITS = {
    "right_angle": "deg",
    "parallel": "deg",
    "equal_length": "mm",
    "ground": "mm",
    "symmetry_plane": "mm",
    "length": "mm",
    "on_face": "mm",
}


@pytest.mark.parametrize("kind", UNITS)
def test_every_residual_has_its_unit_and_every_vertex_its_error(kind, tmp_path):
    path = saved(tmp_path, CONTRADICTIONS[kind])
    cli.main(["solve", str(path)])
    body = json.loads((tmp_path / "box.solution.json").read_text(encoding="utf-8"))
    sketch = json.loads(path.read_text(encoding="utf-8"))
    residuals = body["report"]["residuals"]
    assert residuals.keys() == sketch["annotations"].keys()
    for id_, said in sketch["annotations"].items():
        assert residuals[id_]["unit"] == UNITS[said["kind"]]
    assert body["report"]["reprojection_px"].keys() == sketch["vertices"].keys()
    # What cannot hold does not, and by how much is told.
    assert max(residuals[id_]["value"] for id_ in body["report"]["conflicts"]) > 1
