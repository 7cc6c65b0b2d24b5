"""A few of the hunt's random shapes, each held to all laws: `tests/hunting.py` runs any number."""

from dataclasses import replace

import pytest
from hunting import FAMILIES, broken, case, outcome

from incontext.workbench.fabrication import (
    joined_plates,
    outlines,
)
from incontext.workbench.fabrication.notes import notes_of

#: Those that take long are left to the hunt.
QUICK = [family for family in FAMILIES if family != "polycube"]


@pytest.mark.parametrize("family", QUICK)
def test_plates_of_random_shapes(family):
    end, laws = outcome(family, 500, printed=False)
    assert laws == []
    assert end == "made" or end.startswith("refused: ")


@pytest.mark.parametrize(
    ("family", "seed"),
    [
        ("section", 3),
        ("convex", 3),
        ("halfspaces", 3),
        ("house", 3),
        ("halved", 0),
        ("spire", 3),
        ("pencil", 6101),
        ("pencil", 6104),
        ("pencil", 6105),
        ("halved", 6102),
        ("convex", 6105),
        ("convex", 12007),
        ("polycube", 12003),
        ("polycube", 12004),
        ("polycube", 12006),
        ("fan", 22002),
        ("fan", 22009),
        ("fan", 13011),
        ("polycube", 6118),
        ("polycube", 50006),
        ("polycube", 50007),
        ("slanted_lid", 50001),
        ("slanted_lid", 50002),
        ("spire", 50003),
        ("frustum", 50014),
        ("organizer", 50001),
        ("star", 50001),
    ],
)
def test_prints_of_random_shapes(family, seed):
    end, laws = outcome(family, seed, printed=True)
    assert laws == []
    assert end == "printed"


@pytest.mark.parametrize(
    ("family", "seed"),
    [
        ("slanted_lid", 7013),
        ("slanted_lid", 7038),
        ("convex", 7030),
        ("polycube", 8145),
        ("convex", 9328),
        ("house", 9319),
        ("polycube", 8141),
        ("polycube", 9318),
        ("fan", 40003),
        ("fan", 41101),
        ("spire", 41046),
    ],
)
def test_plates_that_hunts_have_found(family, seed):
    """A leaning opening over right-angled walls, twice; a side of 4e-7 mm; a mouth of 0.05 mm;
    a hole beside a tip that another plate's corner made; rings that touch themselves; slots near
    borders that a second look can move, twice; a sliver narrower than the grid; slots for card; a
    notch that ends in rounding."""
    assert outcome(family, seed, printed=False) == ("made", [])


@pytest.mark.parametrize(("family", "seed"), [("spire", 8120), ("convex", 8116), ("spire", 8123)])
def test_what_no_cutter_gets_into_is_told_by_number(family, seed):
    """Where gaps are as narrow as rounding, too; the last one's outline touches a limit."""
    end, laws = outcome(family, seed, printed=False)
    assert laws == []
    assert "just gets in" in end


@pytest.mark.parametrize("seed", [3, 11, 1005, 1085, 1145, 1175, 1177, 1268])
def test_slots_keep_one_thickness_from_borders(seed, monkeypatch):
    """Half-laps, tabs and corners that left less, one each: without a look at them they do."""
    model, settings = case("polycube", seed)
    settings = replace(settings, kerf_mm=0.0, relief="none")
    joined = joined_plates(model, settings)
    assert not list(broken(model, settings, joined))
    assert not [note for note in notes_of(joined) if "slot for" in note]
    monkeypatch.setattr(outlines, "clear_slots", lambda repair, *_: repair)
    assert [note for note in notes_of(joined_plates(model, settings)) if "slot for" in note]


def test_tabs_for_which_there_is_no_room_are_a_butt_joint_with_the_reason():
    model, settings = case("polycube", 1175)
    joints = [j for j in joined_plates(model, settings).joints if "border" in j.reason]
    assert [j.words for j in joints] == [
        "e47: butt between f23 and f14 at 90 degrees "
        "(slots would be less than 4.36 mm from a border of f23)"
    ]
