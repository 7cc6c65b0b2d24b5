"""The window before an export: the sheets, the cuts' length, formats and a folder."""

from __future__ import annotations

import pytest
from PySide import QtCore, QtGui

from incontext.tests.freecad.hands import pump
from incontext.workbench.commands.export_plates import dialog_for
from incontext.workbench.fabrication.parts import parts_list
from incontext.workbench.features.exports import sheets_of
from incontext.workbench.features.plate_set import plates_of, shop_settings_of
from incontext.workbench.panels.sheet_preview import SheetPreview


@pytest.fixture
def dialog(shelf):
    shown = dialog_for(shelf[2])
    shown.show()
    pump(0.3)
    yield shown
    shown.close()
    shown.deleteLater()
    pump(0.1)


def test_it_tells_the_length_of_the_cuts(dialog, shelf):
    plates = shelf[2]
    sheets = sheets_of(plates)
    total = parts_list(plates_of(plates), sheets, shop_settings_of(plates))[-1]
    words = " ".join(label.text() for label in dialog.findChildren(QtGui.QLabel))
    assert f"{total.cut_mm / 1000:.2f} m" in words
    assert f"6 plates on {len(sheets)} sheet" in words
    assert "for the stock" not in words


def test_it_tells_the_price_and_what_kerf_and_play_come_to(shelf, document):
    plates = shelf[2]
    plates.SheetPrice, plates.Kerf, plates.Play = 4.5, 0.2, 0.1
    document.recompute()
    shown = dialog_for(plates)
    words = " ".join(label.text() for label in shown.findChildren(QtGui.QLabel))
    shown.deleteLater()
    assert f", {4.5 * len(sheets_of(plates)):.2f} for the stock" in words
    assert "paths lie 0.1 mm outside" in words
    assert "there are 0.05 mm on each side" in words


def test_it_shows_each_plate_in_its_place(dialog):
    preview = dialog.findChild(SheetPreview)
    image = preview.grab().toImage()
    colours = {
        image.pixelColor(x, y).name()
        for x in range(0, image.width(), 3)
        for y in range(0, image.height(), 3)
    }
    assert len(colours) > 3


def test_nothing_can_be_written_without_a_format_or_a_name(dialog):
    assert dialog.export_button.isEnabled()
    name = dialog.findChildren(QtGui.QLineEdit)[0]
    name.setText("a/b")
    assert not dialog.export_button.isEnabled()
    name.setText("shelf")
    assert dialog.export_button.isEnabled()
    for box in dialog.findChildren(QtGui.QCheckBox):
        box.setChecked(False)
    assert not dialog.export_button.isEnabled()


def test_the_command_writes_what_is_ticked(window, shelf, tmp_path):
    import FreeCADGui

    from incontext.workbench.panels.export_dialog import ExportDialog

    def answer():
        found = [one for one in window.findChildren(ExportDialog) if one.isVisible()]
        if not found:
            QtCore.QTimer.singleShot(200, answer)
            return
        dialog = found[0]
        name, folder = dialog.findChildren(QtGui.QLineEdit)
        name.setText("shelf")
        folder.setText(str(tmp_path))
        for box in dialog.findChildren(QtGui.QCheckBox):
            box.setChecked(box.text().startswith(("DXF", "PDF")))
        dialog.export_button.click()

    QtCore.QTimer.singleShot(500, answer)
    FreeCADGui.runCommand("InContext_ExportPlates")
    assert {path.name for path in tmp_path.iterdir()} == {"shelf.dxf", "shelf.pdf"}
