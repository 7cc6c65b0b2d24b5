"""Dimensions of a lifted model: read, typed, given by an expression, refused."""

from __future__ import annotations

import json

import FreeCAD
import numpy as np
import pytest

from incontext.workbench.features import pipeline
from incontext.workbench.features.dimension_names import (
    ANGLE,
    DIAMETER,
    HEIGHT,
    LENGTH,
    Dimension,
    dimension_named,
    property_name,
)
from incontext.workbench.features.dimensions import ANGLES, DRIVING, SHOWN, drive
from incontext.workbench.features.driven import driven_text
from incontext.workbench.features.lifted_model import make_lifted_model, solution_of
from incontext.workbench.features.photo_sketch import make_photo_sketch
from incontext.workbench.features.picking import dimension_at

READ_ONLY = "ReadOnly"


def said(sketch) -> dict[str, float]:
    """The lengths that the sketch says."""
    annotations = json.loads(sketch.Sketch)["annotations"].values()
    return {a["edge"]: a["length_mm"] for a in annotations if a["kind"] == "length"}


def length_of(edge) -> Dimension:
    return Dimension(LENGTH, (edge,))


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
    from incontext.solver.dimensions.lengths import tied_edges

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
    drive(model, length_of(free), length + 10)
    document.recompute()
    assert model.Status == "converged"
    assert model.getGroupOfProperty(name) == DRIVING
    for edge, wanted in said(sketch).items():
        assert measured(model, edge) == pytest.approx(wanted, abs=1e-6)
    drive(model, length_of(free), None)
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
    from incontext.solver.dimensions.lengths import tied_edges

    sketch, model, _ = shelf
    tied = tied_edges(pipeline.graph_of(sketch.Sketch), driving)
    assert len(tied) > 1
    for edge in tied:
        drive(model, length_of(edge), said(sketch)[driving])
    document.recompute()
    setattr(model, property_name(LENGTH, tied[-1]), 300)
    document.recompute()
    assert model.Status == "converged"
    assert said(sketch) == dict.fromkeys(tied, 300)
    for edge in tied:
        assert measured(model, edge) == pytest.approx(300, abs=1e-6)


def test_lengths_that_disagree_are_named_and_the_last_shape_stays(shelf, document, driving):
    from incontext.solver.dimensions.lengths import tied_edges

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
    from incontext.solver.editing.elements import delete
    from incontext.solver.serialise import sketch_to_text

    graph = delete(pipeline.graph_of(sketch.Sketch), edges=(free,))
    sketch.Sketch = sketch_to_text(graph)
    document.recompute()
    assert model.Status == "converged"
    assert property_name(LENGTH, free) not in model.PropertiesList


def test_elements_of_the_shape_are_known_by_what_they_measure(shelf, driving):
    _, model, _ = shelf
    edges = {dimension_at(model, f"Edge{k + 1}") for k in range(len(model.Shape.Edges))}
    assert length_of(driving) in edges
    assert {one.prefix for one in edges} == {LENGTH}
    corners = {dimension_at(model, f"Vertex{k + 1}") for k in range(len(model.Shape.Vertexes))}
    heights = {n for n in model.PropertiesList if n.startswith(HEIGHT)}
    assert {one.name for one in corners - {None}} == heights
    assert dimension_at(model, "Face1") is None


def top_of(model) -> str:
    """The property of the greatest height."""
    heights = [name for name in model.PropertiesList if name.startswith(HEIGHT)]
    return max(heights, key=lambda name: getattr(model, name).Value)


def test_every_height_above_the_ground_is_there_once(shelf):
    _, model, _ = shelf
    solution = solution_of(model)
    heights = {
        round(getattr(model, n).Value, 6) for n in model.PropertiesList if n.startswith(HEIGHT)
    }
    places = {round(float(p[2]), 6) for p in solution.vertices_mm.values()}
    assert heights == places - {0.0}
    assert top_of(model) in model.PropertiesList


def test_a_height_drives_by_an_upright_edge(shelf, document):
    sketch, model, plates = shelf
    name, others = top_of(model), len(pipeline.graph_of(sketch.Sketch).annotations)
    assert (model.getGroupOfProperty(name), READ_ONLY in model.getEditorMode(name)) == (SHOWN, True)
    drive(model, dimension_named(name), 222.5)
    document.recompute()
    assert (model.Status, plates.Status) == ("converged", "made")
    assert model.Shape.BoundBox.ZLength == pytest.approx(222.5, abs=1e-6)
    assert getattr(model, name).Value == 222.5
    assert (model.getGroupOfProperty(name), model.getEditorMode(name)) == (DRIVING, [])
    assert len(pipeline.graph_of(sketch.Sketch).annotations) == others + 1
    setattr(model, name, 199)
    document.recompute()
    assert model.Shape.BoundBox.ZLength == pytest.approx(199, abs=1e-6)
    drive(model, dimension_named(name), None)
    document.recompute()
    assert model.getGroupOfProperty(name) == SHOWN
    assert len(pipeline.graph_of(sketch.Sketch).annotations) == others


def test_an_expression_drives_a_height(shelf, document):
    sketch, model, _ = shelf
    text, name = sketch.Sketch, top_of(model)
    model.setExpression(name, "150 mm + 5 cm")
    document.recompute()
    assert model.Shape.BoundBox.ZLength == pytest.approx(200, abs=1e-6)
    assert sketch.Sketch == text


def test_angles_are_shown_and_right_ones_stay_right(shelf, document):
    sketch, model, _ = shelf
    angles = [name for name in model.PropertiesList if name.startswith(ANGLE)]
    assert len(angles) >= 4 * len(solution_of(model).faces) / 2
    for name in angles:
        assert getattr(model, name).Value == pytest.approx(90, abs=1e-9)
        assert (model.getGroupOfProperty(name), model.getEditorMode(name)) == (ANGLES, [READ_ONLY])
    text = sketch.Sketch
    setattr(model, angles[0], 80)
    document.recompute()
    assert sketch.Sketch == text
    assert getattr(model, angles[0]).Value == pytest.approx(90, abs=1e-9)
    shape = model.Shape.Area
    model.setExpression(angles[0], "80 deg")
    document.recompute()
    assert model.Status == "conflicting"
    assert "angle {} {}".format(*dimension_named(angles[0]).ids) in model.Message
    assert model.Shape.Area == shape
    model.setExpression(angles[0], None)
    model.touch()
    document.recompute()
    assert model.Status == "converged"


def test_a_right_angle_is_said_by_its_property(shelf, document):
    sketch, model, _ = shelf
    said_of = annotations(sketch, "right_angle")
    edges = said_of[0][1]["between"]
    order = list(pipeline.graph_of(sketch.Sketch).edges)
    corner = Dimension(ANGLE, tuple(sorted(edges, key=order.index)))
    assert "right" in model.getDocumentationOfProperty(corner.name)
    drive(model, corner, None)
    document.recompute()
    assert model.Status == "converged"
    assert len(annotations(sketch, "right_angle")) == len(said_of) - 1
    assert "follows" in model.getDocumentationOfProperty(corner.name)
    setattr(model, corner.name, 90)
    document.recompute()
    assert model.Status == "converged"
    assert len(annotations(sketch, "right_angle")) == len(said_of)


def annotations(sketch, kind):
    body = json.loads(sketch.Sketch)["annotations"]
    return [(id_, a) for id_, a in body.items() if a["kind"] == kind]


@pytest.fixture
def lid(document):
    """The lifted model of a lid: three circles and a side."""
    from incontext.solver.serialise import sketch_to_text
    from incontext.solver.synthetic import LID, photograph_turned

    graph, _ = photograph_turned(LID, np.random.default_rng(0))
    model = make_lifted_model(document, make_photo_sketch(document, sketch_to_text(graph)))
    document.recompute()
    assert model.Status == "converged", model.Message
    return model


def test_diameters_drive_and_show(lid, document):
    (said_of,) = (a["circle"] for _, a in annotations(lid.PhotoSketch, "diameter"))
    solution = solution_of(lid)
    for id_, circle in solution.circles.items():
        name = property_name(DIAMETER, id_)
        assert getattr(lid, name).Value == pytest.approx(2 * circle.radius_mm, abs=1e-9)
        assert lid.getGroupOfProperty(name) == (DRIVING if id_ == said_of else SHOWN)
    setattr(lid, property_name(DIAMETER, said_of), 77.5)
    document.recompute()
    assert 2 * solution_of(lid).circles[said_of].radius_mm == pytest.approx(77.5, abs=1e-6)
    other = next(id_ for id_ in solution.circles if id_ != said_of)
    lid.setExpression(property_name(DIAMETER, other), "33.25 mm")
    document.recompute()
    assert lid.Status == "converged", lid.Message
    circles = solution_of(lid).circles
    assert 2 * circles[other].radius_mm == pytest.approx(33.25, abs=1e-6)
    assert 2 * circles[said_of].radius_mm == pytest.approx(77.5, abs=1e-6)


def test_round_edges_of_the_shape_are_known_by_their_circles(lid):
    found = [dimension_at(lid, f"Edge{k + 1}") for k in range(len(lid.Shape.Edges))]
    round_ones = {one.ids[0] for one in found if one is not None and one.prefix == DIAMETER}
    assert round_ones == set(pipeline.graph_of(lid.PhotoSketch.Sketch).circles)


def test_heights_of_circles_are_shown_and_say_why_they_cannot_drive(lid, document):
    from incontext.solver import SketchError

    solution = solution_of(lid)
    names = [name for name in lid.PropertiesList if name.startswith(HEIGHT)]
    assert len(names) == 2
    for name in names:
        (id_,) = dimension_named(name).ids
        height = solution.circles[id_].center_mm[2]
        assert getattr(lid, name).Value == pytest.approx(height, abs=1e-9)
        assert "upright edge" in lid.getDocumentationOfProperty(name)
        with pytest.raises(SketchError, match=id_):
            drive(lid, dimension_named(name), 50.0)


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
    ids = ["e1", "e_1", "e-1", "e_x2d_1", "e1@a5", "\u00e9", "e__1", "_and_", "and", "x2d"]
    ones = [Dimension(LENGTH, (id_,)) for id_ in ids]
    ones += [Dimension(ANGLE, (a, b)) for a in ids for b in ids]
    names = [one.name for one in ones]
    assert len(set(names)) == len(ones)
    assert all(name.isascii() and name.isidentifier() for name in names)
    assert [dimension_named(name) for name in names] == ones
    assert dimension_named("Kerf") is None
