"""Findings before a solve."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scenes import box, photograph

from incontext.solver import findings
from incontext.solver.annotations import Parallel
from incontext.solver.graph import Ellipse, Face, SketchGraph

GRAPH = photograph(box(), np.random.default_rng(0)).graph
FIRST = next(iter(GRAPH.vertices.values()))


def said(graph):
    return [(f.severity.value, f.text) for f in findings(graph)]


def test_a_good_sketch_has_no_findings():
    assert findings(GRAPH) == ()


@pytest.mark.parametrize(
    ("graph", "severity", "words"),
    [
        (SketchGraph(), "error", "nothing is drawn"),
        (
            replace(GRAPH, circles={"c1": Ellipse(((0, 0), (2, 0)), ((1, 0), (1, 0)))}),
            "error",
            "circle c1 has no width",
        ),
        (
            replace(GRAPH, annotations={**GRAPH.annotations, "x": Parallel(("e0", "e1"))}),
            "error",
            "cannot all hold",
        ),
        (
            replace(GRAPH, vertices={**GRAPH.vertices, "alone": (9.0, 9.0)}),
            "warning",
            "without edges (alone)",
        ),
        (
            replace(GRAPH, vertices={**GRAPH.vertices, "twin": (FIRST[0] + 1, FIRST[1])}),
            "warning",
            "almost in one place (twin, v0)",
        ),
        (
            replace(GRAPH, vertices={**GRAPH.vertices, "far": (90000.0, 9.0)}),
            "warning",
            "outside the photo (far)",
        ),
        (replace(GRAPH, annotations={}), "warning", "no right angle"),
        (replace(GRAPH, annotations={}), "warning", "no vertex stands on the ground"),
        (replace(GRAPH, annotations={}), "warning", "no length"),
        (
            replace(
                GRAPH,
                vertices={**GRAPH.vertices, "p": (9.0, 9.0), "q": (99.0, 9.0)},
                edges={**GRAPH.edges, "pq": ("p", "q")},
            ),
            "warning",
            "2 parts that nothing joins (p, q",
        ),
        (replace(GRAPH, faces={"f": Face(("v0", "v2", "v5"))}), "warning", "not drawn (v0-v2"),
    ],
)
def test_findings(graph, severity, words):
    assert any(s == severity and words in text for s, text in said(graph)), said(graph)


def test_errors_come_first():
    graph = replace(GRAPH, annotations={"x": Parallel(("e0", "e1"))}, circles={})
    severities = [s for s, _ in said(graph)]
    assert severities == sorted(severities)
