"""The document objects, without any window: what is made, and what follows a change."""

import json
from pathlib import Path

import FreeCAD
import numpy as np
import pytest

from incontext.solver import load_sketch, solve
from incontext.solver.model import turned_profile
from incontext.workbench.features import pipeline
from incontext.workbench.features.examples import import_sketch
from incontext.workbench.features.lifted_model import make_lifted_model
from incontext.workbench.features.plate_set import plates_of

EXAMPLES = Path(__file__).parents[2] / "resources" / "examples"


def test_photo_is_kept_inside_the_document(shelf, shelf_path):
    sketch, _, _ = shelf
    assert Path(sketch.Photo).read_bytes() == (shelf_path.parent / "shelf.jpg").read_bytes()


def test_model_has_the_included_faces(shelf):
    _, model, _ = shelf
    assert model.Status == "converged"
    assert len(model.Shape.Faces) == 9
    assert not model.ScaleAssumed
    assert model.Shape.BoundBox.XLength == pytest.approx(220, abs=1e-6)


def test_plates_are_valid_solids_that_overlap_nowhere(shelf):
    _, _, plates = shelf
    solids = plates.Shape.Solids
    assert len(solids) == plates.PlateCount == 6
    assert plates.Shape.isValid()
    for i, one in enumerate(solids):
        for other in solids[:i]:
            assert one.common(other).Volume == pytest.approx(0, abs=1e-3)


def test_a_lifted_lid_is_the_surface_that_its_side_makes(document):
    """By Pappus: each piece of the side times the way of its middle."""
    (lid,) = (EXAMPLES / "teapot_lid").glob("*.sketch.json")
    model = make_lifted_model(document, import_sketch(document, lid))
    document.recompute()
    graph = load_sketch(lid)
    (revolution,) = graph.revolutions.values()
    profile = turned_profile(revolution, solve(graph)).profile_rz_mm
    lengths = np.linalg.norm(np.diff(profile, axis=0), axis=1)
    area = 2 * np.pi * ((profile[1:, 0] + profile[:-1, 0]) / 2) @ lengths
    assert (model.Status, model.Shape.isValid()) == ("converged", True)
    assert model.Shape.Area == pytest.approx(area, rel=1e-6)


def test_solids_have_the_volume_of_the_outlines(shelf):
    _, _, plates = shelf
    expected = [plate.polygon.area * plate.thickness_mm for plate in plates_of(plates)]
    found = [solid.Volume for solid in plates.Shape.Solids]
    assert found == pytest.approx(expected, rel=1e-9)


def test_change_of_the_sketch_flows_to_the_plates(shelf, document):
    sketch, model, plates = shelf
    area, volume = model.Shape.Area, plates.Shape.Volume
    body = json.loads(sketch.Sketch)
    body["annotations"]["length"]["length_mm"] *= 2
    sketch.Sketch = json.dumps(body)
    document.recompute()
    assert model.Shape.Area == pytest.approx(4 * area, rel=1e-9)
    assert plates.Shape.Volume > 3 * volume


def test_thickness_solves_nothing_again(shelf, document):
    _, model, plates = shelf
    sketch = model.PhotoSketch
    volume, solved = plates.Shape.Volume, pipeline.known_solution_of(sketch.Sketch)
    plates.Thickness = 6
    document.recompute()
    assert plates.Shape.Volume > 1.8 * volume
    assert pipeline.known_solution_of(sketch.Sketch) is solved is not None
    assert "Up-to-date" in model.State


def test_kerf_changes_no_solid(shelf, document):
    _, _, plates = shelf
    volume, made = plates.Shape.Volume, pipeline._joined.cache_info().misses
    plates.Kerf = 0.2
    document.recompute()
    assert plates.Shape.Volume == volume
    assert pipeline._joined.cache_info().misses == made


def test_failed_solve_keeps_the_last_shape_and_says_why(shelf, document):
    sketch, model, plates = shelf
    area, volume = model.Shape.Area, plates.Shape.Volume
    body = json.loads(sketch.Sketch)
    body["annotations"] = {"ground": body["annotations"]["ground"]}
    sketch.Sketch = json.dumps(body)
    document.recompute()
    assert model.Status != "converged"
    assert model.Message
    assert plates.Status == "waiting"
    assert (model.Shape.Area, plates.Shape.Volume) == (area, volume)


def test_text_that_is_no_sketch_is_told(shelf, document):
    sketch, model, _ = shelf
    area = model.Shape.Area
    sketch.Sketch = "{"
    document.recompute()
    assert sketch.Status == "unreadable"
    assert "JSON" in sketch.Message
    assert model.Shape.Area == area


def test_setting_out_of_range_is_told(shelf, document):
    _, _, plates = shelf
    plates.Thickness = 0
    document.recompute()
    assert plates.Status == "not_made"
    assert "thickness" in plates.Message


def test_plates_too_thick_are_told_and_the_last_ones_stay(shelf, document):
    _, _, plates = shelf
    volume = plates.Shape.Volume
    plates.Thickness = 150
    document.recompute()
    assert plates.Status == "not_made"
    assert plates.Shape.Volume == volume


def test_undo_brings_back_sketch_and_shapes(shelf, document):
    sketch, _, plates = shelf
    text, volume = sketch.Sketch, plates.Shape.Volume
    document.openTransaction("Longer")
    body = json.loads(text)
    body["annotations"]["length"]["length_mm"] = 400
    sketch.Sketch = json.dumps(body)
    document.recompute()
    document.commitTransaction()
    assert plates.Shape.Volume > volume
    document.undo()
    assert sketch.Sketch == text
    assert plates.Shape.Volume == volume


def test_object_of_an_older_version_gets_what_it_lacks(shelf):
    _, _, plates = shelf
    plates.removeProperty("Kerf")
    plates.Proxy.__setstate__({"version": 0})
    plates.Proxy.onDocumentRestored(plates)
    assert plates.Kerf == FreeCAD.Units.Quantity("0 mm")
    assert plates.Proxy.dumps() == {"version": 1}


def test_thickness_can_be_an_expression(shelf, document):
    _, _, plates = shelf
    sheet = document.addObject("Spreadsheet::Sheet", "Sizes")
    sheet.set("A1", "4 mm")
    sheet.setAlias("A1", "board")
    plates.setExpression("Thickness", "Sizes.board")
    document.recompute()
    assert plates.Thickness.Value == 4
    assert {plate.thickness_mm for plate in plates_of(plates)} == {4.0}
