"""Dimensions of a lifted model: read, typed, given by an expression, refused."""

from __future__ import annotations

import json

import FreeCAD
import pytest

from incontext.workbench.features import pipeline
from incontext.workbench.features.dimensions import (
    DRIVING,
    LENGTH,
    SHOWN,
    drive,
    driven_text,
    edge_at,
    property_name,
)
from incontext.workbench.features.lifted_model import solution_of

READ_ONLY = "ReadOnly"


def said(sketch) -> dict[str, float]:
    """The lengths that the sketch says."""
    annotations = json.loads(sketch.Sketch)["annotations"].values()
    return {a["edge"]: a["length_mm"] for a in annotations if a["kind"] == "length"}


def measured(model, edge) -> float:
    """The length of an edge of the shape itself."""
    solution = solution_of(model)
    ends = [FreeCAD.Vector(*solution.vertices_mm[v]) for v in solution.edges[edge]]
    found = [e for e in model.Shape.Edges if _joins(e, ends)]
    assert found
    return found[0].Length


def _joins(edge, ends) -> bool:
    points = [v.Point for v in edge.Vertexes]
    return any(
        all(p.distanceToPoint(q) < 1e-9 for p, q in zip(points, order, strict=True))
        for order in (ends, ends[::-1])
    )


@pytest.fixture
def driving(shelf):
    """The one edge of the shelf whose length is said."""
    ((edge, _),) = said(shelf[0]).items()
    return edge


@pytest.fixture
def free(shelf, driving):
    """An edge that is not tied to the driving one."""
    from incontext.solver.dimensions import tied_edges

    graph = pipeline.graph_of(shelf[0].Sketch)
    return next(e for e in graph.edges if e not in tied_edges(graph, driving))


def test_every_edge_has_its_length(shelf, driving):
    sketch, model, _ = shelf
    for edge in pipeline.graph_of(sketch.Sketch).edges:
        name = property_name(LENGTH, edge)
        assert getattr(model, name).Value == pytest.approx(measured(model, edge), abs=1e-6)
        assert edge in model.getDocumentationOfProperty(name)
        drives = edge == driving
        assert model.getGroupOfProperty(name) == (DRIVING if drives else SHOWN)
        assert (READ_ONLY in model.getEditorMode(name)) is not drives


def test_a_typed_length_moves_the_shape_exactly_and_stands_in_the_sketch(shelf, document, driving):
    sketch, model, plates = shelf
    volume = plates.Shape.Volume
    setattr(model, property_name(LENGTH, driving), 333.25)
    document.recompute()
    assert (model.Status, plates.Status) == ("converged", "made")
    assert measured(model, driving) == pytest.approx(333.25, abs=1e-6)
    assert said(sketch) == {driving: 333.25}
    assert plates.Shape.Volume > volume


def test_a_shown_length_is_made_driving_and_free_again(shelf, document, driving, free):
    sketch, model, _ = shelf
    name = property_name(LENGTH, free)
    length = getattr(model, name).Value
    drive(model, free, length + 10)
    document.recompute()
    assert model.Status == "converged"
    assert model.getGroupOfProperty(name) == DRIVING
    for edge, wanted in said(sketch).items():
        assert measured(model, edge) == pytest.approx(wanted, abs=1e-6)
    drive(model, free, None)
    document.recompute()
    assert list(said(sketch)) == [driving]
    assert READ_ONLY in model.getEditorMode(name)


def test_an_expression_drives_without_touching_the_sketch(shelf, document, driving):
    sketch, model, plates = shelf
    text, volume = sketch.Sketch, plates.Shape.Volume
    sheet = document.addObject("Spreadsheet::Sheet", "Sizes")
    sheet.set("A1", "500 mm")
    sheet.setAlias("A1", "width")
    document.recompute()
    model.setExpression(property_name(LENGTH, driving), "Sizes.width")
    document.recompute()
    assert measured(model, driving) == pytest.approx(500, abs=1e-6)
    assert plates.Shape.Volume > volume
    sheet.set("A1", "400 mm")
    document.recompute()
    assert measured(model, driving) == pytest.approx(400, abs=1e-6)
    assert sketch.Sketch == text
    model.setExpression(property_name(LENGTH, driving), None)
    document.recompute()
    assert measured(model, driving) == pytest.approx(said(sketch)[driving], abs=1e-6)


def test_tied_lengths_change_together(shelf, document, driving):
    from incontext.solver.dimensions import tied_edges

    sketch, model, _ = shelf
    tied = tied_edges(pipeline.graph_of(sketch.Sketch), driving)
    assert len(tied) > 1
    for edge in tied:
        drive(model, edge, said(sketch)[driving])
    document.recompute()
    setattr(model, property_name(LENGTH, tied[-1]), 300)
    document.recompute()
    assert model.Status == "converged"
    assert said(sketch) == dict.fromkeys(tied, 300)
    for edge in tied:
        assert measured(model, edge) == pytest.approx(300, abs=1e-6)


def test_lengths_that_disagree_are_named_and_the_last_shape_stays(shelf, document, driving):
    from incontext.solver.dimensions import tied_edges

    sketch, model, plates = shelf
    tied = tied_edges(pipeline.graph_of(sketch.Sketch), driving)
    state = (model.Shape.Area, plates.Shape.Volume)
    body = json.loads(sketch.Sketch)
    body["annotations"]["other"] = {"kind": "length", "edge": tied[-1], "length_mm": 17.0}
    sketch.Sketch = json.dumps(body)
    document.recompute()
    assert model.Status == "conflicting"
    assert "other" in model.Message
    assert (model.Shape.Area, plates.Shape.Volume) == state


def test_a_length_of_nothing_is_refused(shelf, document, driving):
    sketch, model, _ = shelf
    text, length = sketch.Sketch, said(sketch)[driving]
    setattr(model, property_name(LENGTH, driving), 0)
    document.recompute()
    assert sketch.Sketch == text
    assert getattr(model, property_name(LENGTH, driving)).Value == length
    assert measured(model, driving) == pytest.approx(length, abs=1e-6)


def test_undo_and_redo_bring_dimension_and_sketch_back(shelf, document, driving):
    sketch, model, _ = shelf
    name, before = property_name(LENGTH, driving), said(sketch)[driving]
    document.openTransaction("Edit")
    setattr(model, name, 301)
    document.commitTransaction()
    document.recompute()
    document.undo()
    assert (getattr(model, name).Value, said(sketch)[driving]) == (before, before)
    document.redo()
    assert (getattr(model, name).Value, said(sketch)[driving]) == (301, 301)


def test_an_edge_that_goes_takes_its_dimension_along(shelf, document, free):
    sketch, model, _ = shelf
    from incontext.solver.editing import delete
    from incontext.solver.serialise import sketch_to_text

    graph = delete(pipeline.graph_of(sketch.Sketch), edges=(free,))
    sketch.Sketch = sketch_to_text(graph)
    document.recompute()
    assert model.Status == "converged"
    assert property_name(LENGTH, free) not in model.PropertiesList


def test_edges_of_the_shape_are_known_by_their_ids(shelf, driving):
    _, model, _ = shelf
    known = {edge_at(model, f"Edge{k + 1}") for k in range(len(model.Shape.Edges))}
    assert driving in known
    assert None not in known


def test_recomputing_twice_changes_nothing(shelf, document):
    sketch, model, _ = shelf
    text, solution = sketch.Sketch, pipeline.solution_of(sketch.Sketch)
    names = model.PropertiesList
    model.touch()
    document.recompute()
    assert (sketch.Sketch, driven_text(model)) == (text, text)
    assert model.PropertiesList == names
    assert pipeline.solution_of(text) is solution


def test_names_differ_for_different_ids():
    ids = ["e1", "e_1", "e-1", "e_x2d_1", "e1@a5", "é", "e__1"]
    names = [property_name(LENGTH, id_) for id_ in ids]
    assert len(set(names)) == len(ids)
    assert all(name.isascii() and name.isidentifier() for name in names)
