"""The preferences page: what stands in it is what new objects begin with."""

from __future__ import annotations

import FreeCAD
import pytest

from incontext.workbench import host
from incontext.workbench.features.plate_set import make_plate_set
from incontext.workbench.features.properties import PREFERRED_LENGTHS, PREFERRED_TEXTS
from incontext.workbench.features.shelled_solid import make_shelled_solid
from incontext.workbench.panels.values_page import ValuesPage, length_mm


@pytest.fixture
def chosen():
    """The preferences, emptied again afterwards."""
    preferences = host.preferences()
    yield preferences
    for name in PREFERRED_LENGTHS:
        preferences.RemFloat(name)
    for name in PREFERRED_TEXTS:
        preferences.RemString(name)


@pytest.fixture
def page(chosen):
    made = ValuesPage()
    made.loadSettings()
    yield made
    made.form.deleteLater()


def test_the_page_begins_with_the_properties_own_values(page, shelf, document, chosen):
    shell = make_shelled_solid(document, shelf[1])
    for name, field in page.lengths.items():
        obj = shell if name == "Wall" else shelf[2]
        assert length_mm(field.text()) == getattr(obj, name).Value
        assert field.text().endswith(" mm")
    assert page.texts["Preset"].text() == shelf[2].Preset


def test_what_is_typed_is_remembered_to_the_last_digit(page, chosen, monkeypatch):
    told = []
    monkeypatch.setattr(host, "warn", told.append)
    page.lengths["Kerf"].setText("0.127")
    page.lengths["Thickness"].setText("1/8 in")
    page.lengths["Wall"].setText("thick")
    page.saveSettings()
    assert chosen.GetFloat("Kerf", 9) == 0.127
    assert chosen.GetFloat("Thickness", 9) == 3.175
    assert chosen.GetFloat("Wall", 9) == 9
    assert len(told) == 1
    assert "thick" in told[0]


#: FreeCAD's number for inches with decimals.
INCHES, UNITS = 3, "User parameter:BaseApp/Preferences/Units"


@pytest.fixture
def inches():
    """A person who works in inches, whatever the units of a document."""
    preferences = FreeCAD.ParamGet(UNITS)
    before = preferences.GetInt("UserSchema", 0)
    # From 1.0 on a document that comes to the front brings its own units, unless this is said.
    preferences.SetBool("IgnoreProjectSchema", True)
    preferences.SetInt("UserSchema", INCHES)
    FreeCAD.Units.setSchema(INCHES)
    yield
    preferences.RemBool("IgnoreProjectSchema")
    preferences.SetInt("UserSchema", before)
    FreeCAD.Units.setSchema(before)


def test_the_page_speaks_inches_where_freecad_does(inches, chosen, shelf):
    chosen.SetFloat("Kerf", 0.15)
    page = ValuesPage()
    page.loadSettings()
    assert page.lengths["Thickness"].text() == "0.11811 in"
    # OK without a change changes nothing; a number alone is in inches.
    page.lengths["FingerWidth"].setText("0.5")
    page.saveSettings()
    assert chosen.GetFloat("Kerf", 9) == 0.15
    assert chosen.GetFloat("Thickness", 9) == 9
    assert chosen.GetFloat("FingerWidth", 9) == 12.7
    page.lengths["Kerf"].setText("0 in")
    page.saveSettings()
    assert chosen.GetFloat("Kerf", 9) == 0
    # The objects' own sizes as well: they are lengths to FreeCAD.
    said = shelf[2].Thickness.UserString
    assert float(said.strip('" in')) == pytest.approx(3 / 25.4, abs=0.006)
    page.form.deleteLater()


def test_new_objects_begin_with_what_is_preferred(shelf, document, chosen):
    for name, value in (("Thickness", 5.0), ("Kerf", 0.15), ("Wall", 1.2)):
        chosen.SetFloat(name, value)
    chosen.SetString("Preset", "ponoko")
    plates = make_plate_set(document, shelf[1])
    assert (plates.Thickness.Value, plates.Kerf.Value, plates.Preset) == (5.0, 0.15, "ponoko")
    assert plates.FingerWidth == shelf[2].FingerWidth
    assert make_shelled_solid(document, shelf[1]).Wall.Value == 1.2
    assert shelf[2].Thickness.Value == 3


def test_the_page_of_presets_remembers_what_is_chosen(window):
    from incontext.workbench.panels.preset_page import PresetPage

    page, preferences = PresetPage(), host.preferences()
    try:
        page.loadSettings()
        box = page.boxes["MachineForPlates"]
        assert box.currentText() == "-"
        box.setCurrentIndex(box.findText("CO2 laser 600 x 400 mm"))
        assert box.currentIndex() > 0
        page.saveSettings()
        assert preferences.GetString("MachineForPlates") == "CO2 laser 600 x 400 mm"
        again = PresetPage()
        again.loadSettings()
        assert again.boxes["MachineForPlates"].currentText() == "CO2 laser 600 x 400 mm"
        again.form.deleteLater()
    finally:
        for name in page.boxes:
            preferences.RemString(name)
        page.form.deleteLater()
