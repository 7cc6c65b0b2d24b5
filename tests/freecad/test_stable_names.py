"""What is built on an edge or face of a plate is still there when a dimension changes.

A view on a page: `test_window_drawing`.
"""

from __future__ import annotations

import pytest

from incontext.workbench.features.dimension_names import LENGTH
from incontext.workbench.features.dimensions import DRIVING

THICKNESS = 3.0


def short_edges(shape):
    """Numbers of the edges that are as long as the plates are thick."""
    return [k for k, e in enumerate(shape.Edges, start=1) if abs(e.Length - THICKNESS) < 1e-6]


def test_a_chamfer_on_a_plate_survives_new_sizes(shelf, document):
    _, model, plates = shelf
    edge = short_edges(plates.Shape)[0]
    chamfer = document.addObject("Part::Chamfer", "Chamfer")
    chamfer.Base = plates
    chamfer.Edges = [(edge, 0.5, 0.5)]
    document.recompute()
    assert chamfer.isValid()
    removed = plates.Shape.Volume - chamfer.Shape.Volume
    assert removed == pytest.approx(0.5 * 0.5 / 2 * THICKNESS, rel=1e-6)
    where = place_of(plates.Shape.Edges[edge - 1], plates.Shape)
    names = [n for n in model.PropertiesList if n.startswith(LENGTH)]
    driving = next(n for n in names if model.getGroupOfProperty(n) == DRIVING)
    for factor in (1.01, 0.99):
        setattr(model, driving, factor * getattr(model, driving).Value)
        document.recompute()
        assert chamfer.isValid()
        assert plates.Shape.Volume - chamfer.Shape.Volume == pytest.approx(removed, rel=1e-6)
        assert place_of(plates.Shape.Edges[edge - 1], plates.Shape) == pytest.approx(
            where, abs=0.02
        )


def place_of(edge, shape):
    """Where an edge's middle is in the shape's box, each from 0 to 1."""
    box, middle = shape.BoundBox, edge.CenterOfMass
    return [
        (middle.x - box.XMin) / box.XLength,
        (middle.y - box.YMin) / box.YLength,
        (middle.z - box.ZMin) / box.ZLength,
    ]


@pytest.mark.parametrize("setting", ["Kerf", "Margin", "SheetWidth", "CuttingSpeed"])
def test_settings_of_the_cutting_rename_nothing(shelf, document, setting):
    _, _, plates = shelf
    before = [edge.CenterOfMass for edge in plates.Shape.Edges]
    setattr(plates, setting, 0.2 if setting == "Kerf" else 900)
    if setting == "Margin":
        setattr(plates, setting, 7)
    document.recompute()
    after = [edge.CenterOfMass for edge in plates.Shape.Edges]
    assert all(a.distanceToPoint(b) < 1e-9 for a, b in zip(before, after, strict=True))
