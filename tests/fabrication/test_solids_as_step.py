"""Plates as STEP: another program's reader finds each by its name, in its place and exact."""

import cadquery as cq
import numpy as np
import pytest
from fabrication import shapes
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPCAFControl import STEPCAFControl_Reader
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDF import TDF_LabelSequence
from OCP.TDocStd import TDocStd_Document
from OCP.XCAFDoc import XCAFDoc_DocumentTool, XCAFDoc_ShapeTool

from incontext.workbench.fabrication import assemble, make_plates
from incontext.workbench.fabrication.plates import Plate
from incontext.workbench.fabrication.solids import plates_step_bytes


def read(data, tmp_path):
    """The whole's name, and the parts as they are put: (name, solid)."""
    path = tmp_path / "plates.step"
    path.write_bytes(data)
    document = TDocStd_Document(TCollection_ExtendedString("plates"))
    reader = STEPCAFControl_Reader()
    reader.SetNameMode(True)
    assert reader.ReadFile(str(path)) == IFSelect_RetDone
    assert reader.Transfer(document)
    tool, found = XCAFDoc_DocumentTool.ShapeTool_s(document.Main()), TDF_LabelSequence()
    tool.GetFreeShapes(found)
    (whole,) = (found.Value(k + 1) for k in range(found.Length()))
    parts = TDF_LabelSequence()
    XCAFDoc_ShapeTool.GetComponents_s(whole, parts)
    labels = [parts.Value(k + 1) for k in range(parts.Length())]
    shapes_there = [cq.Shape.cast(XCAFDoc_ShapeTool.GetShape_s(one)) for one in labels]
    return name_of(whole), list(zip(map(name_of, labels), shapes_there, strict=True))


def name_of(label):
    attribute = TDataStd_Name()
    assert label.FindAttribute(TDataStd_Name.GetID_s(), attribute)
    return attribute.Get().ToExtString()


@pytest.mark.parametrize(
    "model",
    [shapes.tray(), shapes.bookshelf(turned=4), shapes.l_box(left_out=("top",), turned=2)],
    ids=["tray", "bookshelf", "l_box"],
)
def test_each_plate_is_there_by_its_name_and_exactly_in_its_place(model, tmp_path):
    plates = make_plates(model)
    name, parts = read(plates_step_bytes(plates, "whole"), tmp_path)
    assert name == "whole"
    assert [one for one, _ in parts] == [plate.id for plate in plates]
    for plate, meant, (_, solid) in zip(plates, assemble(plates).Solids(), parts, strict=True):
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(plate.polygon.area * plate.thickness_mm, rel=1e-9)
        assert corners_of(solid) == pytest.approx(corners_of(meant), abs=1e-9)


def corners_of(shape):
    points = np.round([vertex.toTuple() for vertex in shape.Vertices()], 6)
    return points[np.lexsort(points.T)]


def test_holes_thin_numbers_and_any_name(tmp_path):
    """A plate like a frame, far off and tiny in one direction, called as nobody would."""
    outline, hole = [[0, 0], [40, 0], [40, 30], [0, 30]], [[10, 10], [10, 20], [20, 20], [20, 10]]
    place = np.eye(4)
    place[:3, 3] = 1e-7, -1e6, 12.0
    id_ = "it's a \\ \u00e9\u68da\U0001f4d0"
    plate = Plate(id_, ("f1",), 0.00005, outline, (hole,), place)
    data = plates_step_bytes([plate], id_)
    name, ((part, solid),) = read(data, tmp_path)
    assert (name, part) == (id_, id_)
    assert solid.Volume() == pytest.approx(1100 * 0.00005, rel=1e-6)
    assert solid.isValid()


def test_the_same_plates_are_the_same_bytes():
    one, two = (plates_step_bytes(make_plates(shapes.tray()), "tray") for _ in range(2))
    assert one == two
