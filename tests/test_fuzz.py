"""Wild sketches end in a SketchError or in a status, never in an exception, NaN or a warning."""

from __future__ import annotations

import json
import random
import warnings
from pathlib import Path

import numpy as np
import pytest
from scenes import SHAPES, photograph

from incontext.solver import SketchError, findings, solve
from incontext.solver.serialise import sketch_from_text, sketch_to_text, solution_to_text

SEEDS = range(60)
EXTREMES = [0, -1, 1e-9, 1e6, -1e6, 1e300, None, "", "v1", True, [], {}, "v0", 800, 600.5]


def wild_graph(rng: random.Random) -> str:
    """Random vertices, edges and annotations that refer to each other properly."""
    n = rng.randint(1, 12)
    grid = rng.choice([1, 50, 1000])
    vertices = {f"v{i}": [rng.randint(0, grid) * 1.0, rng.randint(0, grid) * 1.0] for i in range(n)}
    pairs = [(f"v{i}", f"v{j}") for i in range(n) for j in range(i)]
    rng.shuffle(pairs)
    edges = {f"e{k}": list(pair) for k, pair in enumerate(pairs[: rng.randint(0, 2 * n)])}
    annotations = {}
    for k in range(rng.randint(0, 12)):
        annotation = wild_annotation(rng, list(vertices), edges)
        if annotation is not None:
            annotations[f"a{k}"] = annotation
    body = {
        "format": "incontext/sketch",
        "version": 1,
        "photo": rng.choice([None, {"file": None, "width_px": 1600, "height_px": 1200}]),
        "vertices": vertices,
        "edges": edges,
        "annotations": annotations,
        "construction": rng.sample(sorted(edges), rng.randint(0, len(edges))),
    }
    return json.dumps(body)


def wild_annotation(rng, vertices, edges):
    kind = rng.choice(["right_angle", "parallel", "equal_length", "ground", "length", "symmetry"])
    names = sorted(edges)
    if kind == "right_angle":
        at = rng.choice(vertices)
        there = [e for e in names if at in edges[e]]
        if len(there) >= 2:
            return {"kind": kind, "at": at, "between": rng.sample(there, 2)}
    elif kind == "ground":
        some = rng.sample(vertices, rng.randint(1, len(vertices)))
        return {"kind": kind, "vertices": some}
    elif kind == "length" and names:
        return {"kind": kind, "edge": rng.choice(names), "length_mm": rng.choice([1e-3, 5, 1e6])}
    elif len(names) >= 3:
        some = rng.sample(names, rng.randint(2, len(names)))
        if kind == "symmetry":
            return {"kind": "symmetry_plane", "midpoints_of": some}
        return {"kind": kind, "edges": some}
    return None


def mutated(rng: random.Random, text: str) -> str:
    """A good file with a value replaced, an element taken away, or cut bytes."""
    if rng.random() < 0.2:
        cut = rng.randrange(len(text))
        return text[:cut] + text[cut + rng.randrange(1, 20) :]
    body = json.loads(text)
    for _ in range(rng.randint(1, 4)):
        place = body
        while True:
            keys = list(place) if isinstance(place, dict) else list(range(len(place)))
            if not keys:
                break
            key = rng.choice(keys)
            if isinstance(place[key], dict | list) and rng.random() < 0.8:
                place = place[key]
                continue
            if rng.random() < 0.3:
                del place[key]
            else:
                place[key] = rng.choice(EXTREMES)
            break
    return json.dumps(body)


def put_through(text: str) -> None:
    try:
        graph = sketch_from_text(text)
    except SketchError as error:
        line = str(error)
        graph = None
    if graph is None:
        assert len(line.splitlines()) == 1
        return
    assert sketch_from_text(sketch_to_text(graph)) == graph
    findings(graph)
    solution = solve(graph)
    assert solution.message
    assert all(np.isfinite(x).all() for x in solution.vertices_mm.values())
    json.loads(solution_to_text(solution))


@pytest.mark.parametrize("seed", SEEDS)
def test_wild_graphs(seed):
    rng = random.Random(seed)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for _ in range(5):
            put_through(wild_graph(rng))


@pytest.mark.parametrize("seed", SEEDS)
def test_mutated_files(seed):
    rng = random.Random(seed)
    shape = rng.choice(SHAPES[:8])()
    text = sketch_to_text(photograph(shape, np.random.default_rng(seed), noise=0.01).graph)
    example = Path(__file__).parent.parent / "resources/examples/bookshelf/bookshelf.sketch.json"
    for source in (text, example.read_text()):
        for _ in range(3):
            put_through(mutated(rng, source))
