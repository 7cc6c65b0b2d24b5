"""Plates are solids like any other: FreeCAD's own workbenches measure, cut, mesh and mill them."""

from __future__ import annotations

import contextlib
import importlib
import shutil
import warnings

import FreeCAD
import MeshPart
import pytest

from incontext.workbench.features.plate_set import plates_of

#: Where the shelf's uprights are cut, mm above the ground.
LEVEL = 60.0


def made_by(*names):
    """The first of FreeCAD's modules that this version has."""
    with warnings.catch_warnings():
        # They are older than their Python.
        warnings.simplefilter("ignore")
        for name in names:
            with contextlib.suppress(ModuleNotFoundError):
                return importlib.import_module(name)
    raise AssertionError(f"this FreeCAD has none of {names}")


def cut_area(plates):
    """What a level cut must leave of the walls, mm2, by the plates' outlines."""
    total = 0.0
    for solid in plates.Shape.Solids:
        box = solid.BoundBox
        if box.ZMin < LEVEL < box.ZMax:
            assert not min(box.XLength, box.YLength) > 10
            total += box.XLength * box.YLength
    return total


def test_a_section_is_the_walls(shelf, document):
    _, _, plates = shelf
    plane = document.addObject("Part::Box", "Below")
    plane.Length = plane.Width = 4000
    plane.Height = 1000
    plane.Placement.Base = FreeCAD.Vector(-2000, -2000, LEVEL - 1000)
    below = document.addObject("Part::Common", "Section")
    below.Base, below.Tool = plates, plane
    document.recompute()
    assert below.isValid()
    faces = [f for f in below.Shape.Faces if abs(f.CenterOfMass.z - LEVEL) < 1e-6]
    # A finger's depth may be missing at the ends.
    assert sum(face.Area for face in faces) == pytest.approx(cut_area(plates), rel=0.05)
    before = below.Shape.Volume
    plates.Thickness = 5
    document.recompute()
    assert below.isValid()
    assert below.Shape.Volume > before


def test_a_measure_reads_an_edge_and_follows_it(shelf, document):
    _, _, plates = shelf
    if FreeCAD.Version()[0] == "0":
        pytest.skip("0.20 measures without document objects")
    made_by("Measure")
    measure = document.addObject("Measure::MeasureLength", "Length")
    short = next(k for k, e in enumerate(plates.Shape.Edges, 1) if abs(e.Length - 3) < 1e-9)
    measure.Elements = [(plates, f"Edge{short}")]
    document.recompute()
    assert measure.Length.Value == pytest.approx(3)
    plates.Thickness = 4
    document.recompute()
    assert measure.Length.Value == pytest.approx(4)


def test_a_mesh_for_calculations_has_the_plates_volume(shelf):
    _, _, plates = shelf
    for solid, plate in zip(plates.Shape.Solids, plates_of(plates), strict=True):
        mesh = MeshPart.meshFromShape(Shape=solid, MaxLength=40)
        assert mesh.isSolid()
        assert mesh.Volume == pytest.approx(plate.polygon.area * plate.thickness_mm, rel=1e-3)


def test_a_building_part_has_the_plates_volume(shelf, document):
    _, _, plates = shelf
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        part = made_by("Arch").makeComponent(plates)
        document.recompute()
    assert part.Shape.Volume == pytest.approx(plates.Shape.Volume)


def test_a_milling_job_takes_the_plates_and_follows(shelf, document):
    _, _, plates = shelf
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        job = made_by("Path.Main.Job", "PathScripts.PathJob").Create("Job", [plates], None)
        document.recompute()
        (model,) = job.Model.Group
        assert model.Shape.Volume == pytest.approx(plates.Shape.Volume)
        stock = job.Stock.Shape.BoundBox
        assert stock.isInside(plates.Shape.BoundBox)
        plates.Thickness = 4
        document.recompute()
    assert model.Shape.Volume == pytest.approx(plates.Shape.Volume)


@pytest.mark.skipif(shutil.which("gmsh") is None, reason="no gmsh beside this FreeCAD")
def test_a_plate_is_meshed_for_finite_elements(shelf, document):
    _, _, plates = shelf
    tools, objects = made_by("femmesh.gmshtools"), made_by("ObjectsFem")
    plate = document.addObject("Part::Feature", "OnePlate")
    plate.Shape = plates.Shape.Solids[0]
    mesh = objects.makeMeshGmsh(document, "Mesh")
    setattr(mesh, "Shape" if hasattr(mesh, "Shape") else "Part", plate)
    mesh.CharacteristicLengthMax = 20.0
    mesh.ElementOrder = "1st"
    document.recompute()
    tools.GmshTools(mesh).create_mesh()
    places, elements = mesh.FemMesh.Nodes, mesh.FemMesh.Volumes
    assert len(elements) > 100
    whole = 0.0
    for element in elements:
        a, b, c, d = (places[node] for node in mesh.FemMesh.getElementNodes(element))
        whole += abs((b - a).cross(c - a).dot(d - a)) / 6
    assert whole == pytest.approx(plate.Shape.Volume, rel=1e-6)
