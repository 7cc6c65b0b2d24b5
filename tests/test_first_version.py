"""Files of version 1 open for ever: these were written by it and are never written anew."""

from __future__ import annotations

from pathlib import Path

import pytest

from incontext.solver import load_sketch, load_solution, solve
from incontext.solver.annotations import ANNOTATIONS
from incontext.solver.serialise import sketch_from_text, sketch_to_text, solution_to_text
from incontext.workbench.cli import main

DATA = Path(__file__).parent / "data"
SKETCH = DATA / "everything-1.sketch.json"
SOLUTION = DATA / "box-1.solution.json"


def test_a_sketch_with_every_key_opens():
    graph = load_sketch(SKETCH)
    assert {a.kind for a in graph.annotations.values()} == set(ANNOTATIONS)
    assert graph.vertices["v2"] == (100.0, 0.5)
    assert graph.edges["e4"] == ("v4", "v5")
    assert graph.revolutions["r1"].profile == ("v4", "v5", "v6")
    assert graph.faces["f1"].thickness_mm == 3.0
    assert graph.construction == ("e3", "c1")
    assert graph.camera.focal_px == 1000.0
    assert graph.photo.principal_point_px == (800.0, 600.0)
    assert sketch_from_text(sketch_to_text(graph)) == graph
    assert solve(graph).message


def test_a_solution_opens():
    solution = load_solution(SOLUTION)
    assert solution.status.value == "converged"
    assert len(solution.vertices_mm) == 8
    assert len(solution.faces) == 6
    assert solution.report.residuals["length"].unit == "mm"
    assert solution_to_text(solution) == SOLUTION.read_text(encoding="utf-8")


@pytest.mark.parametrize("path", sorted(DATA.glob("*.sketch.json")), ids=lambda p: p.name)
def test_check_reads_each_sketch_of_the_tests(path, capsys):
    assert main(["check", str(path)]) in (0, 2)
    said = capsys.readouterr()
    assert not said.err
    assert all(line.startswith(("error: ", "warning: ")) for line in said.out.splitlines())
