"""A few of the hunt's random shapes, each held to all laws: `tests/hunting.py` runs any number."""

import pytest
import shapely
from hunting import FAMILIES, broken, case, outcome

from incontext.workbench.fabrication import joined_plates

#: Those that take long are left to the hunt.
QUICK = [family for family in FAMILIES if family != "polycube"]


@pytest.mark.parametrize("family", QUICK)
def test_plates_of_random_shapes(family):
    end, laws = outcome(family, 500, printed=False)
    assert laws == []
    assert end == "made" or end.startswith("refused: ")


@pytest.mark.parametrize(
    ("family", "seed"),
    [("section", 3), ("convex", 3), ("halfspaces", 3), ("house", 3), ("halved", 0), ("spire", 3)],
)
def test_prints_of_random_shapes(family, seed):
    end, laws = outcome(family, seed, printed=True)
    assert laws == []
    assert end == "printed"


def test_a_slot_near_a_border_is_told():
    model, settings = case("polycube", 11)
    joined = joined_plates(model, settings)
    assert not list(broken(model, settings, joined))
    (note,) = [note for note in joined.notes if "slot for" in note]
    assert note == (
        "f5: the slot for f29 (e18) is 4.5 mm from a border, less than the plate's 6 mm; "
        "it may break"
    )
    plate = next(plate for plate in joined.plates if plate.id == "f5")
    gaps = [
        shapely.LinearRing(plate.outline).distance(shapely.LinearRing(hole)) for hole in plate.holes
    ]
    assert min(gaps) == pytest.approx(4.5)
