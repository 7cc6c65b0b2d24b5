"""What would fill the machine is refused in one line: each limit, just within and beyond it."""

from __future__ import annotations

import json
import random

import pytest

from incontext.solver import SketchError, findings, load_sketch
from incontext.solver.serialise import MAX_BYTES, sketch_from_text
from incontext.workbench.cli import main

EMPTY = {"format": "incontext/sketch", "version": 1, "photo": None, "vertices": {}, "edges": {}}
MAX_EDGES = 20_000


def path_of(n):
    """A sketch of so many edges, one after the other."""
    rng = random.Random(n)
    places = {f"v{k}": [rng.uniform(0, 1600), rng.uniform(0, 1200)] for k in range(n + 1)}
    edges = {f"e{k}": [f"v{k}", f"v{k + 1}"] for k in range(n)}
    return json.dumps({**EMPTY, "vertices": places, "edges": edges})


def refused(text):
    """The line in which a sketch is refused."""
    with pytest.raises(SketchError) as caught:
        sketch_from_text(text)
    line = str(caught.value)
    assert line
    assert "\n" not in line
    assert len(line) < 600
    return line


def test_edges():
    assert len(sketch_from_text(path_of(MAX_EDGES)).edges) == MAX_EDGES
    assert "20000 edges" in refused(path_of(MAX_EDGES + 1)).replace(",", "")


def test_bytes_of_a_file(tmp_path, capsys):
    path = tmp_path / "large.sketch.json"
    body = json.dumps(EMPTY).encode()
    with path.open("wb") as file:
        file.write(body)
        file.write(b" " * (MAX_BYTES - len(body)))
    assert load_sketch(path).edges == {}
    with path.open("ab") as file:
        file.write(b" ")
    with pytest.raises(SketchError, match="larger than 50 MB"):
        load_sketch(path)
    assert main(["check", str(path)]) == 2
    assert len(capsys.readouterr().err.splitlines()) == 1


def test_bytes_of_a_text_that_a_document_holds():
    assert "50 MB" in refused(json.dumps(EMPTY) + " " * MAX_BYTES)


@pytest.mark.parametrize("seed", range(12))
def test_nesting(seed):
    """Brackets in brackets, closed or not, in place of any value."""
    rng = random.Random(seed)
    left, right = rng.choice([("[", "]"), ('{"a":', "}")])
    depth = int(10 ** rng.uniform(1, 6))
    deep = left * depth + "1" + rng.choice([right * depth, ""])
    key = rng.choice(['"photo": null', '"vertices": {}', '"edges": {}', '"version": 1'])
    text = json.dumps(EMPTY).replace(key, f"{key.split(':')[0]}: {deep}", 1)
    refused(text)


NUMBERS = (
    "1e400", "-1e400", "NaN", "-Infinity", "1e308", "1" * 400, "9" * 5000, "1e-400", "-0.0",
    "0." + "0" * 5000 + "1", "1e+", "0x10", "1_000", "01",
)  # fmt: skip


@pytest.mark.parametrize("number", NUMBERS, ids=lambda n: n[:12])
@pytest.mark.parametrize("place", ["vertex", "width", "length", "focal"])
def test_numbers(number, place):
    """Refused, or taken as what they are: none becomes an infinity or a traceback."""
    values = {"vertex": "1.5", "width": "1600", "length": "100.0", "focal": "1500.0"}
    values[place] = number
    body = {
        **EMPTY,
        "photo": {"file": "a.jpg", "width_px": "@width", "height_px": 1200, "focal_px": "@focal"},
        "vertices": {"a": ["@vertex", 2], "b": [500, 600]},
        "edges": {"e": ["a", "b"]},
        "annotations": {"l": {"kind": "length", "edge": "e", "length_mm": "@length"}},
    }
    text = json.dumps(body)
    for name, value in values.items():
        text = text.replace(f'"@{name}"', value)
    said = ""
    try:
        graph = sketch_from_text(text)
    except SketchError as error:
        said = str(error)
    else:
        assert all("\n" not in finding.text for finding in findings(graph))
        assert abs(graph.vertices["a"][0]) < 1e9
    assert "\n" not in said
    assert len(said) < 600
