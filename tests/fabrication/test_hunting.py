"""A few of the hunt's random shapes, each held to all laws: `tests/hunting.py` runs any number."""

import pytest
from hunting import FAMILIES, outcome

#: Those that take long are left to the hunt.
QUICK = [family for family in FAMILIES if family != "polycube"]


@pytest.mark.parametrize("family", QUICK)
def test_plates_of_random_shapes(family):
    end, laws = outcome(family, 500, printed=False)
    assert laws == []
    assert end == "made" or end.startswith("refused: ")


@pytest.mark.parametrize("family", ["section", "convex", "halfspaces", "house"])
def test_prints_of_random_shapes(family):
    end, laws = outcome(family, 3, printed=True)
    assert laws == []
    assert end == "printed"
