"""A missing package: one window, one button, and the command to copy."""

from __future__ import annotations

import importlib.util
import sys

import FreeCADGui
import pytest
from PySide import QtGui

from incontext.tests.freecad.hands import pump, wait_until
from incontext.workbench import host, packages
from incontext.workbench.panels import asking, installing
from incontext.workbench.panels.installing import InstallDialog

TYPED = "python3 -m pip install --target /somewhere cadquery"


@pytest.fixture
def dialog():
    """Makes a dialog whose command is a shell's."""
    made = []

    def make(script):
        made.append(InstallDialog(["cadquery"], ["sh", "-c", script], TYPED))
        made[-1].show()
        pump(0.2)
        return made[-1]

    yield make
    for one in made:
        one.close()
        one.deleteLater()
    pump(0.1)


def wait(dialog):
    """Until the process has ended, and its end was heard of."""
    wait_until(lambda: not dialog.is_working)
    pump(0.1)


def test_it_says_what_is_missing_and_what_to_type(dialog):
    window = dialog("exit 0")
    assert "cadquery" in window.words
    assert [field.text() for field in window.findChildren(QtGui.QLineEdit)] == [TYPED]
    (copy,) = (b for b in window.findChildren(QtGui.QPushButton) if b.text() == "Copy")
    copy.click()
    assert QtGui.QApplication.clipboard().text() == TYPED


def test_one_button_installs_and_the_last_line_is_shown(dialog):
    window = dialog("echo Collecting cadquery; cat")
    window.install_button.click()
    wait_until(lambda: window.words == "Collecting cadquery")
    assert window.findChild(QtGui.QProgressBar).isVisible()
    assert not window.install_button.isEnabled()
    window._process.closeWriteChannel()
    wait(window)
    assert window.result() == QtGui.QDialog.Accepted


def test_it_can_be_stopped_and_tried_again(dialog):
    window = dialog("exec sleep 30")
    window.install_button.click()
    wait_until(lambda: window.is_working)
    window.close_button.click()
    wait(window)
    assert not window.is_working
    assert "nothing is installed" in window.words
    assert window.isVisible()
    assert window.install_button.isEnabled()


def test_what_pip_says_is_shown_where_it_fails(dialog):
    window = dialog("echo ERROR: no such package; exit 1")
    window.install_button.click()
    wait(window)
    assert "ERROR: no such package" in window.words
    assert window.isVisible()


def test_a_python_that_is_not_there_is_told():
    window = InstallDialog(["cadquery"], ["/nowhere/python3"], TYPED)
    window.install_button.click()
    wait_until(lambda: "/nowhere/python3" in window.words)
    assert window.install_button.isEnabled()
    window.deleteLater()


def test_a_command_offers_and_then_runs(shelf, monkeypatch):
    there = importlib.util.find_spec
    missing = {"shapely"}
    asked = []

    def offer(error):
        asked.append(error.name)
        missing.clear()
        return True

    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name: None if name in missing else there(name)
    )
    monkeypatch.setattr(installing, "offer_to_install", offer)
    FreeCADGui.activateWorkbench("InContextWorkbench")
    count = len(shelf[0].Document.Objects)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(shelf[1])
    FreeCADGui.runCommand("InContext_MakePlates")
    assert asked == ["shapely"]
    assert len(shelf[0].Document.Objects) == count + 1


def test_a_command_that_is_not_to_install_does_nothing(shelf, monkeypatch):
    there = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name: None if name == "cadquery" else there(name)
    )
    shown = []
    monkeypatch.setattr(asking, "shown", lambda window: shown.append(window.words) or False)
    FreeCADGui.activateWorkbench("InContextWorkbench")
    count = len(shelf[0].Document.Objects)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(shelf[1])
    FreeCADGui.runCommand("InContext_MakeShell")
    assert len(shown) == 1
    assert "cadquery" in shown[0]
    assert len(shelf[0].Document.Objects) == count


def test_what_is_missing_is_what_is_installed(monkeypatch):
    assert packages.missing_requirements() == ()
    there = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name: None if name in ("PIL", "ezdxf") else there(name)
    )
    wanted = packages.missing_requirements()
    assert [packages.package_name(one) for one in wanted] == ["ezdxf", "pillow"]
    command = packages.install_command(wanted)
    assert command[1:4] == ["-m", "pip", "install"]
    assert command[-2:] == list(wanted)
    assert command[command.index("--target") + 1] == host.packages_folder()
    assert f"python3.{sys.version_info.minor}" in command[0]


def test_installed_packages_come_first_only_while_ours_are_imported(monkeypatch, tmp_path):
    monkeypatch.setattr(host, "packages_folder", lambda: str(tmp_path))
    before = list(sys.path)
    with host.own_packages_first():
        assert sys.path == before
    monkeypatch.setattr(sys, "path", [*before, str(tmp_path)])
    with host.own_packages_first():
        assert sys.path == [str(tmp_path), *before]
    assert sys.path == [*before, str(tmp_path)]
