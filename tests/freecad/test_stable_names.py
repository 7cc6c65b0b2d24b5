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


def driving_name(model):
    """The length that drives."""
    names = [n for n in model.PropertiesList if n.startswith(LENGTH)]
    return next(n for n in names if model.getGroupOfProperty(n) == DRIVING)


def corner_of(shape, number):
    """Which plate an edge is on, and at which corner of it."""
    edge = shape.Edges[number - 1]
    holds = [any(e.isSame(edge) for e in solid.Edges) for solid in shape.Solids]
    (plate,) = [k for k, is_here in enumerate(holds) if is_here]
    offset = edge.CenterOfMass - shape.Solids[plate].BoundBox.Center
    return plate, [round(x, 3) > 0 for x in offset]


@pytest.mark.parametrize(("kind", "factor"), [("Part::Fillet", 1.6), ("Part::Chamfer", 0.6)])
def test_fillets_stay_where_they_are_with_another_number_of_fingers(shelf, document, kind, factor):
    """On the first and the last plate: the numbers of the last one's edges change most."""
    _, model, plates = shelf
    solids = plates.Shape.Solids
    edges = [upright_corner(plates.Shape, solids[k]) for k in (0, -1)]
    built = document.addObject(kind, "Built")
    built.Base = plates
    built.Edges = [(edge, 0.5, 0.5) for edge in edges]
    document.recompute()
    assert built.isValid()
    removed = plates.Shape.Volume - built.Shape.Volume
    where = [corner_of(plates.Shape, edge) for edge in edges]
    setattr(model, driving_name(model), factor * getattr(model, driving_name(model)).Value)
    document.recompute()
    assert [len(s.Edges) for s in plates.Shape.Solids] != [len(s.Edges) for s in solids]
    now = [edge for edge, *_ in built.Edges]
    assert now[-1] != edges[-1]
    assert built.isValid(), built.State
    assert [corner_of(plates.Shape, edge) for edge in now] == where
    assert plates.Shape.Volume - built.Shape.Volume == pytest.approx(removed, rel=1e-6)


def upright_corner(shape, solid):
    """The number of the edge along the thickness that is at the end of the plate's outline."""
    short = [e for e in solid.Edges if abs(e.Length - THICKNESS) < 1e-6]
    middle = solid.BoundBox.Center
    far = max(
        short, key=lambda e: (round(e.CenterOfMass.distanceToPoint(middle), 3), e.CenterOfMass.x)
    )
    return 1 + next(k for k, e in enumerate(shape.Edges) if e.isSame(far))


def test_what_hangs_on_faces_and_edges_follows(shelf, document):
    """A datum plane on the last plate's face, a line binder on an edge; on one that goes, words."""
    _, model, plates = shelf
    face = len(plates.Shape.Faces)
    plane = document.addObject("Part::Plane", "Plane")
    support = "AttachmentSupport" if hasattr(plane, "AttachmentSupport") else "Support"
    setattr(plane, support, [(plates, f"Face{face}")])
    plane.MapMode = "FlatFace"
    document.recompute()
    before = plates.Shape.Faces[face - 1]
    off = before.normalAt(0, 0)
    model_length = driving_name(model)
    setattr(model, model_length, 1.6 * getattr(model, model_length).Value)
    document.recompute()
    (_, (name,)) = getattr(plane, support)[0]
    now = plates.Shape.Faces[int(name[4:]) - 1]
    assert name != f"Face{face}"
    assert now.Area > 2000
    assert now.normalAt(0, 0).dot(off) == pytest.approx(1)
    assert plane.Shape.Faces[0].normalAt(0, 0).cross(off).Length == pytest.approx(0, abs=1e-9)


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
