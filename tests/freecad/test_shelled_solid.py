"""The hollow solid: from cadquery's kernel into FreeCAD's."""

import pytest

from incontext.workbench.features.brep_bridge import brep_text, shape_from_brep
from incontext.workbench.features.shelled_solid import make_shelled_solid


@pytest.fixture
def solid(shelf, document):
    solid = make_shelled_solid(document, shelf[1])
    document.recompute()
    return solid


def test_shape_crosses_between_kernels_exactly():
    import cadquery

    box = cadquery.Workplane().box(30, 20, 10).edges("|Z").fillet(2).val()
    shape = shape_from_brep(brep_text(box))
    assert shape.isValid()
    assert shape.Volume == pytest.approx(box.Volume(), rel=1e-12)


def test_solid_has_the_outer_size_and_the_walls(solid, shelf):
    assert solid.Status == "made"
    assert solid.Shape.isValid()
    assert len(solid.Shape.Solids) == 1
    for size in ("XLength", "YLength", "ZLength"):
        outer = getattr(shelf[1].Shape.BoundBox, size)
        assert getattr(solid.Shape.BoundBox, size) == pytest.approx(outer, abs=1e-6)
    volume, area = solid.Shape.Volume, shelf[1].Shape.Area
    assert 0.9 * 2 * area < volume < 2 * area


def test_thicker_wall_needs_more(solid, document):
    volume = solid.Shape.Volume
    solid.Wall = 4
    document.recompute()
    assert solid.Shape.Volume > 1.8 * volume


def test_wall_that_cannot_be_is_told(solid, document):
    volume = solid.Shape.Volume
    solid.Wall = 0
    document.recompute()
    assert solid.Status == "not_made"
    assert "wall" in solid.Message
    assert solid.Shape.Volume == volume
