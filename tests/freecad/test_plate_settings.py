"""Every choice about plates and prints as a property, and mistakes told in words."""

import Part
import pytest

from incontext.workbench.fabrication import FabricationError
from incontext.workbench.features.exports import export_plates, export_print
from incontext.workbench.features.plate_set import joined_of
from incontext.workbench.features.shelled_solid import make_shelled_solid


def some_joint(plates):
    return next(joint for joint in joined_of(plates).joints if joint.meeting.edge_ids)


def test_fit_joints_and_assembly_are_shown(shelf):
    _, _, plates = shelf
    assert any("slot: 12 x 3 mm" in line for line in plates.Fit)
    assert len(plates.Joints) >= 8
    assert plates.Assembly[0].startswith("begin with")
    assert len(plates.Assembly) == plates.PlateCount


def test_a_joint_can_be_chosen_by_its_edge(shelf, document):
    _, _, plates = shelf
    edge = some_joint(plates).meeting.edge_ids[0]
    volume = plates.Shape.Volume
    plates.JointChoices = [f"{edge}=none"]
    document.recompute()
    assert plates.Status == "made"
    assert plates.Shape.Volume < volume
    assert any("none between" in line for line in plates.Joints)


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("JointChoices", ["e99=butt"], "no two plates meet there (e99)"),
        ("JointChoices", ["e1=glue"], "there is no joint 'glue' (e1)"),
        ("Preset", "fast", "there is no preset 'fast'"),
        ("PdfPage", "A9", "there is no page 'A9'"),
        ("ToolDiameter", 0, "tool's diameter is 0 mm"),
        ("SheetWidth", 5, "sheet size is 5 mm"),
    ],
)
def test_a_mistake_is_told_and_the_last_plates_stay(shelf, document, name, value, words):
    _, _, plates = shelf
    volume = plates.Shape.Volume
    setattr(plates, name, value)
    document.recompute()
    assert plates.Status == "not_made"
    assert words in plates.Message
    assert plates.Shape.Volume == volume


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"Kerf": 3.5}, " x 3 mm is narrower than the kerf of 3.5 mm"),
        ({"CornerRelief": "dogbone", "ToolDiameter": 12}, "no room for a cutter of 12 mm"),
        ({"SheetWidth": 50, "SheetHeight": 50}, "does not fit on a sheet of 50 x 50 mm"),
        ({"SheetWidth": 600, "SheetHeight": 400, "Margin": 190}, "with a margin of 190 mm"),
    ],
)
def test_what_cannot_be_cut_is_told_when_it_is_set(shelf, document, tmp_path, settings, words):
    _, _, plates = shelf
    for name, value in settings.items():
        setattr(plates, name, value)
    document.recompute()
    assert plates.Status == "not_cut"
    assert words in plates.Message
    assert plates.Shape.isValid()
    with pytest.raises(FabricationError) as caught:
        export_plates(plates, tmp_path, "parts")
    assert plates.Message.startswith(str(caught.value))
    assert not list(tmp_path.iterdir())


def test_exploded_plates_are_the_same_plates_apart(shelf, document):
    _, _, plates = shelf
    volume, length = plates.Shape.Volume, plates.Shape.BoundBox.DiagonalLength
    plates.Exploded = True
    document.recompute()
    assert plates.Shape.Volume == pytest.approx(volume, rel=1e-9)
    assert plates.Shape.BoundBox.DiagonalLength > 1.2 * length
    plates.Exploded = False
    document.recompute()
    assert plates.Shape.BoundBox.DiagonalLength == pytest.approx(length)


def test_cutting_settings_change_files_and_no_plate(shelf, document, tmp_path):
    _, _, plates = shelf
    before = plates.Shape.Volume
    export_plates(plates, tmp_path, "plain")
    plates.CornerRelief, plates.ToolDiameter, plates.Preset = "dogbone", 2, "lightburn"
    document.recompute()
    assert plates.Shape.Volume == before
    assert any("dog bone" in line for line in plates.Fit)
    export_plates(plates, tmp_path, "boned")
    plain, boned = ((tmp_path / f"{n}.dxf").read_text() for n in ("plain", "boned"))
    assert "CUT_OUTER" in plain
    assert "C02" in boned
    assert len(boned) > len(plain)


def test_more_files_where_they_are_asked_for(shelf, tmp_path):
    _, _, plates = shelf
    plates.WithPartsList = plates.WithCoupon = True
    plates.PdfPage, plates.SheetPrice = "A4", 4.5
    names = {path.name for path in export_plates(plates, tmp_path, "shelf")}
    more = {"shelf.pdf", "shelf.parts.csv", "shelf.coupon.dxf", "shelf.coupon.svg"}
    assert more < names
    assert (tmp_path / "shelf.pdf").read_bytes().startswith(b"%PDF-1.4")
    assert "4.5" in (tmp_path / "shelf.parts.csv").read_text()


def test_a_solid_without_hollow_and_a_bed(shelf, document):
    solid = make_shelled_solid(document, shelf[1])
    solid.Bed = (100, 100, 100)
    document.recompute()
    hollow = solid.Shape.Volume
    assert solid.Status == "made"
    assert "larger than the printer's 100 x 100 x 100 mm" in solid.Message
    solid.Solid = True
    document.recompute()
    assert solid.Shape.Volume > 3 * hollow
    solid.Solid, solid.LeastWall = False, 3
    document.recompute()
    assert solid.Status == "not_made"
    assert "thinner than the least wall of 3 mm" in solid.Message


def test_a_print_is_written_for_the_slicer(shelf, document, tmp_path):
    import Mesh

    solid = make_shelled_solid(document, shelf[1])
    document.recompute()
    names = {path.name for path in export_print(solid, tmp_path / "new", "shelf")}
    assert names == {"shelf.stl", "shelf.3mf", "shelf.step"}
    mesh = Mesh.Mesh(str(tmp_path / "new" / "shelf.stl"))
    assert mesh.isSolid()
    assert mesh.Volume == pytest.approx(solid.Shape.Volume, rel=1e-5)
    assert Part.read(str(tmp_path / "new" / "shelf.step")).Volume == pytest.approx(
        solid.Shape.Volume, rel=1e-9
    )
