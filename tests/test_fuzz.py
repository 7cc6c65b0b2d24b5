"""Wild files end in a SketchError or in a status, never in an exception, NaN or a warning.

A sample of the cases that `fuzzing.py` runs by the hundred thousand.
"""

from __future__ import annotations

import json
import random
from contextlib import suppress

import numpy as np
import pytest
from fuzzing import KINDS, flipped, good_sketch, put_through, replace_somewhere
from wild_sketches import wild_sketch

from incontext.solver import SketchError, findings, solve
from incontext.solver.model import build_model
from incontext.solver.serialise import (
    sketch_from_text,
    solution_from_text,
    solution_to_text,
)
from incontext.workbench.cli import main

SEEDS = range(20)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", SEEDS)
def test_wild_sketches_end_in_an_error_or_a_status(kind, seed):
    rng = random.Random(seed)
    for _ in range(3):
        put_through(KINDS[kind](rng))


@pytest.mark.parametrize("seed", SEEDS)
def test_hostile_solution_files_end_in_an_error_or_a_solution(seed):
    rng = random.Random(seed)
    graph = sketch_from_text(good_sketch(rng))
    text = solution_to_text(solve(graph))
    for _ in range(30):
        body = json.loads(text)
        replace_somewhere(rng, body)
        for hostile in (json.dumps(body), flipped(rng, text)):
            with suppress(SketchError):
                solution = solution_from_text(hostile)
                assert all(np.isfinite(x).all() for x in solution.vertices_mm.values())
                solution_from_text(solution_to_text(solution))
                build_model(solution, revolutions=graph.revolutions)


@pytest.mark.parametrize("seed", range(12))
def test_check_tells_what_is_wrong_of_every_file_in_single_lines(seed, tmp_path, capsys):
    rng = random.Random(seed)
    path = tmp_path / "wild.sketch.json"
    for make in (wild_sketch, *KINDS.values()):
        path.write_bytes(make(rng).encode("utf-8", errors="surrogateescape"))
        status = main(["check", str(path)])
        said = capsys.readouterr()
        assert status in (0, 2)
        assert "Traceback" not in said.err
        assert len(said.err.splitlines()) <= 1
        assert all(line.startswith(("error: ", "warning: ")) for line in said.out.splitlines())


def scattered(n):
    rng = random.Random(n)
    return {f"v{i}": [rng.uniform(0, 1600), rng.uniform(0, 1200)] for i in range(n)}


def path_of(n):
    return {f"e{i}": [f"v{i}", f"v{i + 1}"] for i in range(n - 1)}


def star_of(n):
    return {f"e{i}": ["v0", f"v{i}"] for i in range(1, n)}


def complete(n):
    return {f"e{i}_{j}": [f"v{i}", f"v{j}"] for i in range(n) for j in range(i)}


def right_angles_at(edges):
    """A right angle wherever an edge of the list meets the next one."""
    found = {}
    for k, (e, f) in enumerate(zip(edges, list(edges)[1:], strict=False)):
        (at,) = set(edges[e]) & set(edges[f])
        found[f"a{k}"] = {"kind": "right_angle", "at": at, "between": [e, f]}
    return found


TANGLES = {
    "complete": (150, complete(150), {}),
    "star": (15_000, star_of(15_000), {}),
    "square star": (15_000, star_of(15_000), right_angles_at(star_of(15_000))),
    "path": (15_000, path_of(15_000), {}),
    "square path": (15_000, path_of(15_000), right_angles_at(path_of(15_000))),
    "all on the ground": (
        15_000,
        path_of(15_000),
        {"g": {"kind": "ground", "vertices": [f"v{i}" for i in range(15_000)]}},
    ),
    "thirty mirrors": (
        60,
        path_of(60),
        {f"m{k}": {"kind": "symmetry_plane", "midpoints_of": [f"e{k}"]} for k in range(30)},
    ),
    "all equal": (
        200,
        path_of(200),
        {"a": {"kind": "equal_length", "edges": [f"e{k}" for k in range(199)]}},
    ),
    "all parallel and square": (
        100,
        complete(100),
        {
            "p": {"kind": "parallel", "edges": list(complete(100))[1:4000]},
            "q": {"kind": "parallel", "edges": list(complete(100))[2500:]},
            "r": {"kind": "right_angle", "at": "v99", "between": ["e99_1", "e99_2"]},
        },
    ),
    "vertices alone": (40_000, path_of(5), {}),
}


@pytest.mark.parametrize("name", TANGLES)
def test_tangles_end_in_a_status(name):
    n, edges, annotations = TANGLES[name]
    body = {
        "format": "incontext/sketch",
        "version": 1,
        "photo": None,
        "vertices": scattered(n),
        "edges": edges,
        "annotations": annotations,
    }
    graph = sketch_from_text(json.dumps(body))
    assert len(findings(graph)) > 0
    assert solve(graph).message


@pytest.mark.parametrize(("key", "n"), [("vertices", 40_001), ("circles", 1_001)])
def test_more_than_a_sketch_has_is_refused(key, n):
    body = {"format": "incontext/sketch", "version": 1, "photo": None, "vertices": {}, "edges": {}}
    point = [1.0, 2.0]
    one = point if key == "vertices" else {"a": [point, point], "b": [point, point]}
    body[key] = {f"x{k}": one for k in range(n)}
    with pytest.raises(SketchError, match=f"more than {n - 1} {key}"):
        sketch_from_text(json.dumps(body))
