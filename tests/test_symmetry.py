"""Mirrored geometry."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from asserts import assert_solved
from scenes import box, house, photograph

from incontext.solver import solve
from incontext.solver.annotations import Ground, OnFace, RightAngle, SymmetryPlane
from incontext.solver.dragging import begin_drag, drag
from incontext.solver.editing.elements import add_vertex, delete, merge_vertices, split_edge
from incontext.solver.errors import SketchError
from incontext.solver.graph import Face, SketchGraph
from incontext.solver.model import build_model
from incontext.solver.serialise import sketch_from_text, sketch_to_text
from incontext.solver.symmetry import Geometry, mirrored
from incontext.solver.validation import findings


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


def listed_half(**said) -> SketchGraph:
    """Half of a box, all its faces listed, something said of the one with a mirrored corner."""
    graph = replace(half_of_a_box()[0], faces=None)
    faces = solve(graph).faces
    (back,) = [id_ for id_, face in faces.items() if any("@" in v for v in face.loop)]
    return replace(graph, faces={**faces, back: replace(faces[back], **said)})


def back_of(faces):
    (back,) = [face for face in faces.values() if any("@" in v for v in face.loop)]
    return back


def test_a_face_with_mirrored_corners_can_be_listed():
    graph = listed_half(included=False, thickness_mm=5.0)
    assert sketch_from_text(sketch_to_text(graph)) == graph
    assert findings(graph) == findings(replace(graph, faces=graph.drawn_faces))
    solution = solve(graph)
    assert_solved(solution)
    assert solution.faces == graph.faces
    model = build_model(solution)
    assert [f.thickness_mm for f in model.faces.values() if not f.included] == [5.0]
    moved = begin_drag(graph, solution)
    assert drag(moved, graph).solution.faces == graph.faces


def test_images_of_listed_halves_are_made_once():
    graph = listed_half()
    front = ("v0", "v1", "v5", "v4")
    fewer = {id_: f for id_, f in graph.faces.items() if set(f.loop) != set(front)}
    back = next(id_ for id_, f in fewer.items() if any("@" in v for v in f.loop))
    faces = solve(replace(graph, faces=fewer)).faces
    assert set(faces[f"{back}@mirror"].loop) == set(front)
    assert len(faces) == len(fewer) + 1


def test_names_of_mirrored_corners_follow_edits():
    graph = listed_half(included=False)
    assert graph.drawn_faces.keys() < graph.faces.keys()
    across = next(e for e, ends in graph.edges.items() if set(ends) == {"v1", "v5"})
    split, middle = split_edge(graph, across, (1.0, 1.0))
    assert f"{middle}@mirror" not in back_of(split.faces).loop
    top = next(e for e, ends in graph.edges.items() if set(ends) == {"v4", "v5"})
    split, middle = split_edge(graph, top, (1.0, 1.0))
    # The copies of v4 and v5 are v7, which is drawn, and v5@mirror.
    assert "v5@mirror" in back_of(split.faces).loop
    added, new = add_vertex(graph, (5.0, 5.0))
    merged = merge_vertices(added, "v5", new)
    kept = {v for face in merged.faces.values() for v in face.loop}
    assert not {v for v in kept if v.split("@")[0] not in merged.vertices}
    assert delete(graph, annotations=("mirror",)).faces.keys() == graph.drawn_faces.keys()
    without = delete(graph, vertices=("v5",))
    assert all("@" not in v for face in (without.faces or {}).values() for v in face.loop)


def test_names_of_copies_that_cannot_be_are_refused():
    graph = listed_half()
    for corner in ("v5@a9", "v9@mirror", "v5@", "v5@ground"):
        faces = {**graph.faces, "f9": Face(("v0", "v1", corner))}
        with pytest.raises(SketchError):
            sketch_from_text(sketch_to_text(replace(graph, faces=faces)))
    back = next(id_ for id_, f in graph.faces.items() if any("@" in v for v in f.loop))
    touching = {**graph.annotations, "a9": OnFace("v5", back)}
    with pytest.raises(SketchError, match="mirrored corners"):
        sketch_from_text(sketch_to_text(replace(graph, annotations=touching)))
