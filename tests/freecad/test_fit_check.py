"""The fit check and the fit test as document objects."""

import pytest

from incontext.solver.serialise import sketch_from_text, sketch_to_text
from incontext.tests.tracing import with_block
from incontext.workbench.features.fit_check import make_fit_check
from incontext.workbench.features.fit_test import export_fit_test, make_fit_test
from incontext.workbench.features.shelled_solid import make_shelled_solid


@pytest.fixture
def crowded(shelf, document):
    """The shelf with a book in it, and a box that is in the way of its left side."""
    sketch, model, plates = shelf
    graph = with_block(sketch_from_text(sketch.Sketch), (150, 20), (60, 120, 200), "b")
    graph = with_block(graph, (-40, 60), (60, 80, 120), "d")
    sketch.Sketch = sketch_to_text(graph)
    document.recompute()
    assert model.Status == "converged", model.Message
    return model, plates


def test_things_are_there_and_what_is_in_the_way_is_red(crowded, document):
    _, plates = crowded
    check = make_fit_check(document, plates)
    document.recompute()
    assert check.Status == "in_the_way"
    assert check.Message == "1 of 2 things are in the way; it stands"
    assert [bool(fits) for fits in check.Fits] == [True, False]
    assert len(check.Shape.Solids) == 2
    assert check.Shape.Volume == pytest.approx(60 * 120 * 200 + 60 * 80 * 120, rel=1e-6)
    # 3 mm of the left side, from the bottom plate's top to the box's.
    assert check.Overlap.Volume == pytest.approx(80 * (3 * 117 + 20 * 3), rel=1e-6)
    assert "20.0 mm into f4" in check.Things[1]
    assert check.Stands
    assert check.CentreOfMass.z > 0
    assert len(check.Support) == 4


def test_it_follows_what_it_checks(crowded, document):
    _, plates = crowded
    check = make_fit_check(document, plates)
    document.recompute()
    before = check.Things[0]
    plates.Thickness = 9
    document.recompute()
    assert check.Things[0] != before
    assert "9.0 mm higher" in check.Things[0]


def test_a_solid_is_checked_too(crowded, document):
    model, _ = crowded
    solid = make_shelled_solid(document, model)
    check = make_fit_check(document, solid)
    document.recompute()
    assert check.Status == "in_the_way"
    assert "20.0 mm into solid" in check.Things[1]


def test_nothing_traced_is_said(shelf, document):
    check = make_fit_check(document, shelf[2])
    document.recompute()
    assert check.Status == "good"
    assert check.Message == "nothing is traced on the photo to fit to; it stands"


def test_it_waits_for_what_is_not_made(shelf, document):
    plates = shelf[2]
    check = make_fit_check(document, plates)
    document.recompute()
    plates.Thickness = 90
    document.recompute()
    assert plates.Status == "not_made"
    assert check.Status == "waiting"
    assert plates.Label in check.Message


def test_the_fit_test_has_the_settings_of_its_plates(shelf, document, tmp_path):
    plates = shelf[2]
    fit_test = make_fit_test(document, plates)
    document.recompute()
    assert fit_test.Status == "made"
    assert len(fit_test.Shape.Solids) == 2
    assert fit_test.Plays == pytest.approx([-0.1, -0.05, 0.0, 0.05, 0.1])
    assert fit_test.Shape.BoundBox.YMax < plates.Shape.BoundBox.YMin
    plates.Play = 0.2
    plates.Thickness = 5
    document.recompute()
    assert fit_test.Plays == pytest.approx([0.1, 0.15, 0.2, 0.25, 0.3])
    assert fit_test.Shape.BoundBox.ZLength == pytest.approx(5.0)
    names = {path.name for path in export_fit_test(fit_test, tmp_path, "shelf")}
    assert names == {path.name for path in tmp_path.iterdir()}
    assert names == {"shelf.coupon.dxf", "shelf.coupon.svg"}
