"""Mirrored geometry."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from asserts import assert_solved
from scenes import box, house, photograph

from incontext.solver import solve
from incontext.solver.annotations import Ground, OnFace, RightAngle, SymmetryPlane
from incontext.solver.graph import Face, SketchGraph
from incontext.solver.symmetry import Geometry, mirrored


def half_of_a_box(noise=0.0) -> tuple[SketchGraph, object]:
    """The front, the left and the three edges going back; the back's own edges are not drawn."""
    shape = box(200, 150, 120)
    photo = photograph(shape, np.random.default_rng(1), noise=noise)
    graph = photo.graph
    deep = [
        e
        for e, (a, b) in graph.edges.items()
        if {a, b} in ({"v0", "v3"}, {"v1", "v2"}, {"v4", "v7"})
    ]
    front = [e for e, ends in graph.edges.items() if set(ends) <= {"v0", "v1", "v4", "v5"}]
    kept = set(deep + front)
    annotations = {
        k: a
        for k, a in graph.annotations.items()
        if not isinstance(a, RightAngle) or set(a.between) <= kept
    }
    annotations["ground"] = Ground(("v0", "v1", "v2", "v3"))
    annotations["mirror"] = SymmetryPlane(tuple(deep))
    used = {v for e in kept for v in graph.edges[e]}
    drawn = replace(
        graph,
        vertices={v: p for v, p in graph.vertices.items() if v in used},
        edges={e: ends for e, ends in graph.edges.items() if e in kept},
        annotations=annotations,
    )
    return drawn, photo


def test_the_hidden_corner_and_edges_are_made():
    graph, _ = half_of_a_box()
    solution = solve(graph)
    assert_solved(solution)
    assert "v5@mirror" in solution.vertices_mm
    assert set(solution.vertices_mm) - set(graph.vertices) == {"v5@mirror"}
    # v5@mirror is the box's v6: on the far side, above v2.
    true = solution.vertices_mm["v2"] + solution.vertices_mm["v4"] - solution.vertices_mm["v0"]
    np.testing.assert_allclose(solution.vertices_mm["v5@mirror"], true, atol=1e-9)
    assert sum("@mirror" in e for e in solution.edges) == 4
    assert all(v in solution.vertices_mm for ends in solution.edges.values() for v in ends)
    # The edges across the plane on which nothing was drawn stay out: the box's top is open.
    assert any({"v5@mirror"} <= set(face.loop) for face in solution.faces.values())


def test_a_symmetric_shape_gets_no_copies():
    shape = house()
    graph = photograph(shape, np.random.default_rng(1)).graph
    across = [
        e for e, (a, b) in graph.edges.items()
        if abs(int(a[1:]) - int(b[1:])) == 5
    ]  # fmt: skip
    said = {**graph.annotations, "mirror": SymmetryPlane(tuple(across))}
    solution = solve(replace(graph, annotations=said))
    assert_solved(solution)
    assert set(solution.vertices_mm) == set(graph.vertices)
    assert set(solution.edges) == set(graph.edges)


def test_the_plane_holds_exactly_on_a_careless_sketch():
    graph, _ = half_of_a_box(noise=0.01)
    solution = solve(graph)
    assert_solved(solution)
    assert solution.report.residuals["mirror"].value < 1e-9


def test_a_vertex_is_measured_against_a_face_of_mirrored_vertices():
    graph, _ = half_of_a_box()
    faces = solve(graph).faces
    mirrored = next(id_ for id_, face in faces.items() if "v5@mirror" in face.loop)
    said = {**graph.annotations, "on": OnFace("v0", mirrored)}
    residuals = solve(replace(graph, annotations=said)).report.residuals
    assert residuals["on"].value > 1.0


def test_a_face_whose_hole_would_fold_has_no_copy():
    low = {
        "a": (0.0, 0.0), "b": (90.0, 0.0), "c": (0.0, 90.0),
        "e": (10.0, 10.0), "f": (10.0, 10.1), "g": (30.0, 10.0),
    }  # fmt: skip
    at = {v: np.array([*xy, 0.0]) for v, xy in low.items()}
    # What is nearest to the images of both e and f.
    at |= {"d": np.array([0.0, 0.0, 20.0]), "h": np.array([10.0, 10.0, 20.0])}
    graph = SketchGraph(
        vertices=dict.fromkeys(at, (0.0, 0.0)),
        edges={"e1": ("a", "d")},
        annotations={"mirror": SymmetryPlane(("e1",))},
    )
    folding, whole = Face(("a", "b", "c"), (("e", "f", "g"),)), Face(("a", "b", "g"))
    drawn = Geometry(at, graph.edges, {"f1": folding, "f2": whole})
    assert set(mirrored(graph, drawn)[0].faces) == {"f1", "f2", "f2@mirror"}
