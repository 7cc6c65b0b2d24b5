"""The benchmark of plates measures what it says."""

import io

import ezdxf
import pytest

from incontext.workbench.bench.plates import (
    cut_by_booleans,
    dxf_by_booleans,
    open_organizer,
    plates_bench,
    sheets_of_fifty,
)
from incontext.workbench.fabrication import PlateSettings, make_plates


@pytest.mark.parametrize("singly", [False, True])
def test_booleans_cut_the_same_plates(singly):
    model = open_organizer(2)
    plates = make_plates(model)
    wanted = sorted(plate.polygon.area * plate.thickness_mm for plate in plates)
    assert len(plates) == 7
    cut = cut_by_booleans(model, PlateSettings(), singly=singly)
    assert sorted(plate.Volume() for plate in cut) == pytest.approx(wanted, rel=1e-6)


def test_booleans_draw_the_same_outlines():
    model = open_organizer(2)
    text = dxf_by_booleans(model, PlateSettings()).decode()
    lines = ezdxf.read(io.StringIO(text)).modelspace().query("LINE")
    length = sum((line.dxf.end - line.dxf.start).magnitude for line in lines)
    assert length == pytest.approx(sum(p.polygon.length for p in make_plates(model)), rel=1e-6)


def test_the_table():
    lines = list(plates_bench(runs=1, columns=2))
    numbers = {line[:44].strip(): line[44:].split() for line in lines if line}
    assert numbers["outlines to DXF, no CAD kernel"][1] == "1"
    for way in ("one cut a plate", "a cut a finger"):
        assert float(numbers[f"booleans in OCCT, {way}"][1]) > 1
    assert numbers["50 plates on sheets of 600 x 400 mm"] == ["sheets", "by", "area"]


@pytest.mark.parametrize("high", [150.0, 200.0, 250.0, 300.0])
def test_sheets_are_near_the_area(high):
    count, bound = sheets_of_fifty(7, high)
    assert bound <= count <= bound + 1
