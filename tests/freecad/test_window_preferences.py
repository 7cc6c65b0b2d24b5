"""The preferences page: what stands in it is what new objects begin with."""

from __future__ import annotations

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

from incontext.workbench import host
from incontext.workbench.features.plate_set import make_plate_set
from incontext.workbench.features.properties import PREFERRED_LENGTHS, PREFERRED_TEXTS
from incontext.workbench.features.shelled_solid import make_shelled_solid


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
def page():
    loaded = FreeCADGui.PySideUic.loadUi(host.resource("ui", "preferences.ui"))
    yield loaded
    loaded.deleteLater()


def test_the_page_begins_with_the_properties_own_values(page, shelf, document, chosen):
    shell = make_shelled_solid(document, shelf[1])
    for name in PREFERRED_LENGTHS:
        widget = page.findChild(QtGui.QWidget, f"value{name}")
        obj = shell if name == "Wall" else shelf[2]
        assert widget.property("rawValue") == getattr(obj, name).Value
    assert page.findChild(QtGui.QLineEdit, "valuePreset").text() == shelf[2].Preset


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


def test_the_page_speaks_inches_where_freecad_does(inches, page, shelf):
    for name in PREFERRED_LENGTHS:
        widget = page.findChild(QtGui.QWidget, f"value{name}")
        assert widget.property("text").endswith(('"', "in", "''")), name
    thickness = page.findChild(QtGui.QWidget, "valueThickness")
    # FreeCAD keeps what it shows, to as many decimals as its own preferences say: usually two.
    assert thickness.property("rawValue") == pytest.approx(3, abs=0.005 * 25.4)
    thickness.setProperty("rawValue", 3.175)
    assert float(thickness.property("text").strip('" in')) == pytest.approx(0.125, abs=0.006)
    # The objects' own sizes as well: they are lengths to FreeCAD.
    said = shelf[2].Thickness.UserString
    assert float(said.strip('" in')) == pytest.approx(3 / 25.4, abs=0.006)


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
