"""Angles drive a lifted model: typed, given by a spreadsheet, refused, kept in the file."""

from __future__ import annotations

import json
import math

import FreeCAD
import numpy as np
import pytest

from incontext.solver.serialise import sketch_to_text
from incontext.solver.synthetic import Views, photograph_exactly, random_camera, wedge
from incontext.solver.synthetic.shapes import hexagonal_box, house, tapered_tray
from incontext.workbench.features import pipeline
from incontext.workbench.features.dimension_names import ANGLE, Dimension, dimension_named
from incontext.workbench.features.dimensions import ANGLES, DRIVING, drive
from incontext.workbench.features.driven import driven_text
from incontext.workbench.features.lifted_model import make_lifted_model, solution_of
from incontext.workbench.features.photo_sketch import make_photo_sketch
from incontext.workbench.features.picking import corner_at
from incontext.workbench.features.plate_set import make_plate_set

SHAPES = {"gable": house, "tray": tapered_tray, "wedge": wedge, "planter": hexagonal_box}
READ_ONLY = "ReadOnly"


def lifted(document, name):
    shape = SHAPES[name]()
    graph = photograph_exactly(shape, random_camera(shape, np.random.default_rng(3), Views()))
    sketch = make_photo_sketch(document, sketch_to_text(graph))
    model = make_lifted_model(document, sketch)
    document.recompute()
    assert model.Status == "converged", model.Message
    return sketch, model


@pytest.fixture(params=SHAPES)
def any_model(request, document):
    return lifted(document, request.param)


@pytest.fixture
def gable(document):
    return lifted(document, "gable")


def slanted(model):
    """Names of the angles that are not right, the widest first."""
    names = [name for name in model.PropertiesList if name.startswith(ANGLE)]
    found = [name for name in names if abs(getattr(model, name).Value - 90) > 1]
    return sorted(found, key=lambda name: -getattr(model, name).Value)


def elements_of(model, name):
    """The two edges of the shape between which an angle lies."""
    wanted = dimension_named(name)
    elements = [f"Edge{k + 1}" for k in range(len(model.Shape.Edges))]
    pairs = ((a, b) for k, a in enumerate(elements) for b in elements[:k])
    return next(pair for pair in pairs if corner_at(model, pair) == wanted)


def measured(model, name):
    """The angle between the two edges of the shape itself, degrees."""
    edges = [model.Shape.getElement(element) for element in elements_of(model, name)]
    points = [[v.Point for v in edge.Vertexes] for edge in edges]
    at = min((p.distanceToPoint(q), p) for p in points[0] for q in points[1])[1]
    ends = [max(pair, key=lambda p: p.distanceToPoint(at)) for pair in points]
    return math.degrees((ends[0] - at).getAngle(ends[1] - at))


def holds(model, name, wanted):
    assert model.Status == "converged", model.Message
    assert getattr(model, name).Value == pytest.approx(wanted, abs=1e-9)
    assert measured(model, name) == pytest.approx(wanted, abs=1e-6)
    residuals = solution_of(model).report.residuals
    assert {*pipeline.graph_of(model.PhotoSketch.Sketch).annotations} <= set(residuals)
    assert max(r.value for r in residuals.values()) < 1e-6
    corner = "angle {} {}".format(*dimension_named(name).ids)
    assert residuals[corner].value <= 1e-9


def test_a_typed_angle_moves_the_shape_exactly_and_leaves_the_sketch(any_model, document):
    sketch, model = any_model
    text, name = sketch.Sketch, slanted(model)[0]
    before = getattr(model, name).Value
    assert (model.getGroupOfProperty(name), model.getEditorMode(name)) == (ANGLES, [READ_ONLY])
    for wanted in (before - 4.25, before + 6):
        setattr(model, name, wanted)
        document.recompute()
        holds(model, name, wanted)
        assert (model.getGroupOfProperty(name), model.getEditorMode(name)) == (DRIVING, [])
        assert sketch.Sketch == text
    drive(model, dimension_named(name), None)
    document.recompute()
    assert getattr(model, name).Value == pytest.approx(before, abs=1e-6)
    assert (model.getGroupOfProperty(name), model.SaidAngles) == (ANGLES, "")


def test_a_spreadsheet_drives_an_angle_and_the_plates_follow(gable, document):
    sketch, model = gable
    plates = make_plate_set(document, model)
    name = slanted(model)[0]
    sheet = document.addObject("Spreadsheet::Sheet", "Sizes")
    sheet.set("A1", "135 deg")
    sheet.setAlias("A1", "eave")
    document.recompute()
    text, volume = sketch.Sketch, plates.Shape.Volume
    model.setExpression(name, "Sizes.eave")
    document.recompute()
    holds(model, name, 135.0)
    assert plates.Status == "made", plates.Message
    assert plates.Shape.Volume != pytest.approx(volume, rel=1e-4)
    # A bare number means degrees.
    for wanted, unit in ((118, " deg"), (90, " deg"), (121.5, ""), (2.1 * 180 / math.pi, "")):
        sheet.set("A1", f"={wanted!r}{unit}")
        document.recompute()
        holds(model, name, wanted)
    assert (sketch.Sketch, model.SaidAngles) == (text, "")


def test_an_expression_that_is_no_angle_is_told_and_the_last_shape_stays(gable, document):
    _, model = gable
    name, area = slanted(model)[0], model.Shape.Area
    for absurd in ("0 deg", "180 deg", "-12 deg", "400 deg"):
        model.setExpression(name, absurd)
        document.recompute()
        assert model.Status == "unreadable"
        assert "degrees" in model.Message
        assert all(id_ in model.Message for id_ in dimension_named(name).ids)
        assert model.Shape.Area == area
    model.setExpression(name, None)
    model.touch()
    document.recompute()
    assert model.Status == "converged"


def test_angles_that_cannot_all_hold_are_named_and_the_last_shape_stays(document):
    _, model = lifted(document, "wedge")
    # The widest and the narrowest: those of the other triangle are the same two.
    first, *_, second = slanted(model)
    corners = {dimension_named(name).ids for name in (first, second)}
    setattr(model, first, 62)
    document.recompute()
    holds(model, first, 62)
    area = model.Shape.Area
    model.setExpression(second, "30 deg")
    document.recompute()
    assert model.Status == "conflicting"
    assert all("angle {} {}".format(*corner) in model.Message for corner in corners)
    assert model.Shape.Area == area
    model.setExpression(second, "28 deg")
    document.recompute()
    holds(model, second, 28)


def test_a_typed_angle_that_cannot_be_is_refused_at_once(gable, document):
    sketch, model = gable
    slope = slanted(model)[0]
    setattr(model, slope, 130)
    document.recompute()
    text, said, area = sketch.Sketch, model.SaidAngles, model.Shape.Area
    right = next(
        n
        for n in model.PropertiesList
        if n.startswith(ANGLE) and abs(getattr(model, n).Value - 90) < 1e-9
    )
    for name, absurd in ((slope, 0), (slope, 180), (slope, 1e6), (right, 80)):
        before = getattr(model, name).Value
        setattr(model, name, absurd)
        document.recompute()
        assert model.Status == "converged"
        assert getattr(model, name).Value == pytest.approx(before, abs=1e-9)
        assert (sketch.Sketch, model.SaidAngles, model.Shape.Area) == (text, said, area)


def test_equal_angles_are_one(gable, document):
    _, model = gable
    name = slanted(model)[0]
    before = getattr(model, name).Value
    same = [n for n in slanted(model) if abs(getattr(model, n).Value - before) < 1e-6]
    setattr(model, name, 133)
    document.recompute()
    moved = [n for n in same if getattr(model, n).Value == pytest.approx(133, abs=1e-9)]
    other = next(n for n in moved if n != name)
    setattr(model, other, 122)
    document.recompute()
    holds(model, other, 122)
    assert measured(model, name) == pytest.approx(122, abs=1e-6)
    assert [[*dimension_named(other).ids, 122]] == json.loads(model.SaidAngles)


def test_an_angle_that_was_typed_right_can_be_typed_anew(gable, document):
    sketch, model = gable
    text, name = sketch.Sketch, slanted(model)[0]
    for wanted in (120, 90, 110):
        setattr(model, name, wanted)
        document.recompute()
        holds(model, name, wanted)
    assert sketch.Sketch == text


def test_undo_and_redo_bring_angle_and_shape_back(gable, document):
    _, model = gable
    name = slanted(model)[0]
    before, area = getattr(model, name).Value, model.Shape.Area
    document.openTransaction("Edit")
    setattr(model, name, 131)
    document.recompute()
    document.commitTransaction()
    assert model.Shape.Area != pytest.approx(area, rel=1e-4)
    document.undo()
    document.recompute()
    assert (getattr(model, name).Value, model.SaidAngles) == (before, "")
    assert model.Shape.Area == pytest.approx(area, rel=1e-9)
    document.redo()
    document.recompute()
    holds(model, name, 131)


def test_said_angles_are_kept_in_the_file(gable, document, tmp_path):
    _, model = gable
    name = slanted(model)[0]
    setattr(model, name, 130.123456789012)
    document.recompute()
    area, label = model.Shape.Area, model.Name
    path = str(tmp_path / "gable.FCStd")
    document.saveCopy(path)
    again = FreeCAD.openDocument(path)
    try:
        opened = again.getObject(label)
        assert opened.Shape.Area == pytest.approx(area, rel=1e-12)
        opened.touch()
        again.recompute()
        holds(opened, name, 130.123456789012)
        assert opened.getGroupOfProperty(name) == DRIVING
        drive(opened, dimension_named(name), None)
        again.recompute()
        assert opened.SaidAngles == ""
    finally:
        FreeCAD.closeDocument(again.Name)


def test_an_edge_that_goes_takes_its_angle_along(gable, document):
    from incontext.solver.editing.elements import delete

    sketch, model = gable
    name = slanted(model)[0]
    setattr(model, name, 130)
    document.recompute()
    edge = dimension_named(name).ids[0]
    graph = delete(pipeline.graph_of(sketch.Sketch), edges=(edge,))
    sketch.Sketch = sketch_to_text(graph)
    document.recompute()
    assert model.Status == "converged", model.Message
    assert name not in model.PropertiesList
    assert "angles" not in driven_text(model)


@pytest.mark.parametrize(
    "text", ["[", "{}", '[["e0"]]', '[["e0", "e1", "x"]]', "[" * 9999, '[["a b", "e1", 3]]', "null"]
)
def test_hostile_angles_are_told(gable, document, text):
    _, model = gable
    area = model.Shape.Area
    model.SaidAngles = text
    document.recompute()
    assert (model.Status, model.Shape.Area) == ("unreadable", area)
    model.SaidAngles = '[["e0", "e77", 50.0], ["e0", "e0", 40.0]]'
    document.recompute()
    assert model.Status == "converged"


def test_the_methods_of_papers_say_that_they_know_no_angles(gable, document):
    _, model = gable
    name = slanted(model)[0]
    setattr(model, name, 130)
    document.recompute()
    model.Method = "Lipson 1996"
    document.recompute()
    assert model.Status == "unreadable"
    assert all(id_ in model.Message for id_ in dimension_named(name).ids)


def test_only_edges_that_meet_have_a_corner(gable):
    _, model = gable
    graph = pipeline.graph_of(model.PhotoSketch.Sketch)
    elements = [f"Edge{k + 1}" for k in range(len(model.Shape.Edges))]
    corners = {corner_at(model, (a, b)) for k, a in enumerate(elements) for b in elements[:k]}
    for corner in corners - {None}:
        assert isinstance(corner, Dimension)
        assert set(graph.edges[corner.ids[0]]) & set(graph.edges[corner.ids[1]])
    assert len(corners) > 10
    assert corner_at(model, elements[:1]) is None


def test_a_chamfer_on_a_plate_survives_other_angles(gable, document):
    _, model = gable
    plates = make_plate_set(document, model)
    document.recompute()
    edge = next(k for k, e in enumerate(plates.Shape.Edges, 1) if abs(e.Length - 3) < 1e-6)
    chamfer = document.addObject("Part::Chamfer", "Chamfer")
    chamfer.Base = plates
    chamfer.Edges = [(edge, 0.5, 0.5)]
    document.recompute()
    assert chamfer.isValid()
    plate = plate_with(plates.Shape, edge)
    name = slanted(model)[0]
    for wanted in (132, 119, 104):
        setattr(model, name, wanted)
        document.recompute()
        assert (model.Status, plates.Status) == ("converged", "made"), plates.Message
        assert chamfer.isValid()
        now = chamfer.Edges[0][0]
        assert plate_with(plates.Shape, now) == plate
        removed = plates.Shape.Volume - chamfer.Shape.Volume
        assert removed == pytest.approx(0.5 * 0.5 / 2 * 3, rel=1e-6)


def plate_with(shape, number):
    """Which plate has an edge."""
    edge = shape.Edges[number - 1]
    holds = [any(e.isSame(edge) for e in solid.Edges) for solid in shape.Solids]
    return holds.index(True)
