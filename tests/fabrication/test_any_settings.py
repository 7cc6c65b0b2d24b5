"""Whatever is set: plates that keep the laws, or one line that says which plate, edge or number."""

import io
import math
import re
from collections.abc import Callable
from typing import Any

import ezdxf
import pytest
from fabrication import shapes, slanted
from fabrication.bodies import overlaps
from fabrication.catalogue import CATALOGUE
from hypothesis import given, settings
from hypothesis import strategies as st

from incontext.workbench.fabrication import (
    FabricationError,
    JointChoice,
    PlateSettings,
    ShellSettings,
    joined_plates,
    shell_solid,
)
from incontext.workbench.fabrication.cut_paths import cut_path
from incontext.workbench.fabrication.dxf import dxf_bytes
from incontext.workbench.fabrication.errors import SettingsError
from incontext.workbench.fabrication.fits import coupon_sheets, effects
from incontext.workbench.fabrication.marks import edge_marks
from incontext.workbench.fabrication.settings import GRAINS, OPEN_ENDS, RELIEFS, SIDES, bed_note
from incontext.workbench.fabrication.sheets import lay_out

SHAPES = ("box", "unequal box", "bookshelf", "table tray", "chevron", "leaning pyramid", "crossed")
WHERE = ("e1", "e2", "e5", "e9", "e99", "bottom:left", "front:s1", "top:nothing")


def number(low: float, high: float, *often: float) -> st.SearchStrategy[float]:
    """Mostly what a person might type; now and then what nobody should."""
    usual = st.floats(low, high).map(lambda x: round(x, 3))
    return st.one_of(usual, usual, st.sampled_from(often or (low, high)), st.just(-1.0))


JOINTS = st.builds(
    dict,
    where=st.sampled_from(WHERE),
    kind=st.sampled_from((None, "finger", "butt", "half_lap", "tab_slot", "none")),
    finger_mm=st.none() | number(2, 80),
    play_mm=st.none() | number(0, 1),
    owner=st.sampled_from((None, None, "bottom", "left", "s1", "f77")),
)
SETTINGS = st.fixed_dictionaries(
    {},
    optional={
        "side": st.sampled_from(SIDES),
        "finger_mm": number(2, 150, math.inf, math.nan),
        "play_mm": number(0, 2, 0.1),
        "kerf_mm": number(0, 5, 0.15),
        "sheet_mm": st.tuples(number(50, 900), number(50, 900)),
        "margin_mm": number(0, 60),
        "spacing_mm": number(0, 40),
        "relief": st.sampled_from(RELIEFS),
        "tool_mm": number(0.5, 12),
        "grain": st.sampled_from(GRAINS),
        "joints": st.lists(JOINTS, max_size=2),
    },
)


def in_words(error: FabricationError) -> bool:
    """Whether an error says what is wrong, where or how much, and what to try."""
    text = str(error)
    where = bool(error.ids) or bool(re.search(r"\d|nan|inf|'", text))
    return "\n" not in text and "; try: " in text and where


def outcome_of(make: Callable[[], Any]) -> Any:
    """What is made, or the error that refuses it; all others are faults."""
    try:
        return make()
    except FabricationError as error:
        return error


def made(name: str, thickness: float, said: dict):
    joints = tuple(JointChoice(**joint) for joint in said.pop("joints", ()))
    chosen = PlateSettings(thickness_mm=thickness, joints=joints, **said)
    model = (
        CATALOGUE[name].make(thickness=thickness)
        if "unequal" not in name
        else (CATALOGUE[name].make())
    )
    joined = joined_plates(model, chosen)
    sheets = lay_out(joined.plates, chosen, edge_marks(joined.plates, joined.joints))
    return chosen, joined, sheets


@settings(max_examples=25, deadline=None, derandomize=True)
@given(st.sampled_from(SHAPES), number(0.5, 40, 3.0, 3.0), SETTINGS)
def test_plates_are_lawful_or_refused_in_words(name, thickness, said):
    outcome = outcome_of(lambda: made(name, thickness, dict(said)))
    if isinstance(outcome, FabricationError):
        assert in_words(outcome), outcome
        return
    chosen, joined, sheets = outcome
    assert max(overlaps(joined.plates).values()) <= 1e-6
    rings = 0
    for plate in joined.plates:
        assert plate.polygon.is_valid
        assert plate.polygon.area > 0
        path = cut_path(plate, chosen.kerf_mm)
        rings += 1 + len(path.inner)
        # No hole is lost in a wide beam without a word.
        assert len(path.inner) == len(plate.holes)
    document = ezdxf.read(io.StringIO(dxf_bytes(sheets).decode("cp1252")))
    cut = document.modelspace().query('LWPOLYLINE[layer ? "CUT_.*"]')
    assert len(cut) == rings
    assert effects(chosen)
    assert coupon_sheets(chosen)


@pytest.mark.parametrize(
    ("said", "ids", "words"),
    [
        ({"thickness_mm": 60.0}, ("bottom", "shelf"), "75 mm apart"),
        ({"kerf_mm": 5.0}, None, "5 mm"),
        (
            {"kerf_mm": 3.5},
            ("back", "e21"),
            "a hole of 11.41 x 3 mm is narrower than the kerf of 3.5 mm",
        ),
        ({"sheet_mm": (150.0, 100.0)}, None, "sheet of 150 x 100 mm"),
        ({"sheet_mm": (400.0, 300.0), "margin_mm": 110.0}, None, "or a smaller margin"),
        ({"sheet_mm": (210.0, 175.0), "grain": "x"}, None, "or another grain"),
        (
            {"relief": "dogbone", "tool_mm": 12.0},
            ("bottom", "e3"),
            "no room for a cutter of 12 mm: one of 11.43 mm just gets in",
        ),
        ({"thickness_mm": 90.0}, ("bottom", "top"), "160 mm apart"),
        ({"finger_mm": 0.0}, (), "the finger width is 0 mm"),
        ({"finger_mm": -3.0}, (), "the finger width is -3 mm"),
        ({"finger_mm": 1e9}, (), "a number from 0.5 to 1000 mm"),
        ({"play_mm": 5.0}, (), "the play is 5 mm"),
        ({"kerf_mm": -1.0}, (), "the kerf is -1 mm"),
        ({"spacing_mm": -1.0}, (), "the spacing is -1 mm"),
        ({"thickness_mm": 0.0}, (), "the thickness is 0 mm"),
        ({"joints": (JointChoice("e3", "half_lap"),)}, ("e3", "bottom", "back"), "no half lap"),
        ({"joints": (JointChoice("e3", "finger", 2.0, None, "f9"),)}, ("e3",), "f9 does not meet"),
        ({"joints": (JointChoice("e77", "butt"),)}, ("e77",), "no two plates meet there"),
    ],
)
def test_typical_mistakes(said, ids, words):
    def make():
        chosen = PlateSettings(**said)
        joined = joined_plates(shapes.bookshelf(thickness=chosen.thickness_mm), chosen)
        lay_out(joined.plates, chosen, None, joined.joints)

    with pytest.raises(FabricationError, match=words) as caught:
        make()
    assert in_words(caught.value)
    assert ids is None or caught.value.ids == ids


@pytest.mark.parametrize("value", ["abc", "", None, True, [], (1, 2)])
@pytest.mark.parametrize("name", ["thickness_mm", "kerf_mm", "spacing_mm", "tool_mm"])
def test_what_is_no_number_is_refused_by_name(name, value):
    with pytest.raises(SettingsError, match="no number; try: a number from") as caught:
        PlateSettings(**{name: value})
    assert name.split("_")[0] in str(caught.value)


@pytest.mark.parametrize("value", [5.0, (), (600.0,), (600.0, "x"), "600x400", (1, 2, 3)])
def test_a_sheet_has_two_sizes(value):
    with pytest.raises(SettingsError, match="the sheet size is"):
        PlateSettings(sheet_mm=value)


SHELLS = st.fixed_dictionaries(
    {},
    optional={
        "wall_mm": number(0.2, 60, 2.0),
        "side": st.sampled_from(SIDES),
        "open_end": st.sampled_from(OPEN_ENDS),
        "solid": st.booleans(),
        "least_wall_mm": number(0, 3),
        "tolerance_mm": number(0.001, 5),
    },
)


@settings(max_examples=12, deadline=None, derandomize=True)
@given(st.sampled_from(("l box", "hexagon")), SHELLS)
def test_solids_are_lawful_or_refused_in_words(name, said):
    model = (
        shapes.l_box(left_out=("top",))
        if name == "l box"
        else shapes.model(shapes.prism(slanted.HEXAGON, 70), left_out=("top",))
    )
    outcome = outcome_of(lambda: shell_solid(model, ShellSettings(**said)))
    if isinstance(outcome, FabricationError):
        assert in_words(outcome), outcome
        return
    assert outcome.isValid()
    assert outcome.Volume() > 0


@pytest.mark.parametrize(
    ("said", "ids", "words"),
    [
        ({"wall_mm": 0.0}, (), "the wall is 0 mm"),
        ({"wall_mm": 31.0}, ("bottom", "top"), "too thick: the shape measures 60 mm here"),
        ({"wall_mm": 0.2}, (), "thinner than the least wall of 0.4 mm"),
        ({"tolerance_mm": 0.0}, (), "the tolerance is 0 mm"),
        ({"bed_mm": (0.0, 100.0, 100.0)}, (), "the size of the bed is 0 mm"),
        ({"side": "left"}, (), "there is no side 'left'"),
    ],
)
def test_typical_mistakes_about_prints(said, ids, words):
    with pytest.raises(FabricationError, match=words) as caught:
        shell_solid(shapes.box(), ShellSettings(**said))
    assert in_words(caught.value)
    assert caught.value.ids == ids


def test_a_print_without_a_face_is_refused_by_name():
    model = shapes.box(left_out=tuple(shapes.box_loops(1, 1, 1)))
    with pytest.raises(FabricationError, match="no face to make anything of") as caught:
        shell_solid(model, ShellSettings())
    assert set(caught.value.ids) == set(model.faces)


def test_what_fits_the_bed_on_another_side_is_told_so():
    assert "lay it on another side" in bed_note((120.0, 80.0, 60.0 + 1e-7), (60.0, 80.0, 120.0))
    assert "a larger printer" in bed_note((120.0, 80.0, 60.0), (100.0, 60.0, 60.0))
    assert bed_note((120.0 + 1e-7, 80.0, 60.0), (80.0, 120.0, 60.0)) == ""


def test_settings_errors_are_fabrication_errors():
    assert issubclass(SettingsError, FabricationError)
