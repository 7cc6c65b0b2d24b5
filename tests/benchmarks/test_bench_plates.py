"""The benchmark of plates measures what it says."""

import pytest

from incontext.workbench.bench.plates import (
    cut_by_booleans,
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
    assert sorted(cut_by_booleans(model, PlateSettings(), singly=singly)) == pytest.approx(
        wanted, rel=1e-6
    )


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
