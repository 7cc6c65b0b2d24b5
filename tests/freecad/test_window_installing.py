"""A missing package: one window, one button, and the command to copy."""

from __future__ import annotations

import importlib
import importlib.util
import os
import sys
import zipfile

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


PROBE = "incontext-probe"


@pytest.fixture
def shop(tmp_path, monkeypatch):
    """A folder with one package, which is all that pip knows of: no network is asked."""
    folder = tmp_path / "shop"
    folder.mkdir()
    info = "incontext_probe-1.0.dist-info"
    files = {
        "incontext_probe.py": "WORDS = 'installed by pip'\n",
        f"{info}/METADATA": f"Metadata-Version: 2.1\nName: {PROBE}\nVersion: 1.0\n",
        f"{info}/WHEEL": "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    }
    files[f"{info}/RECORD"] = "".join(f"{name},,\n" for name in (*files, f"{info}/RECORD"))
    with zipfile.ZipFile(folder / "incontext_probe-1.0-py3-none-any.whl", "w") as wheel:
        for name, text in files.items():
            wheel.writestr(name, text)
    monkeypatch.setenv("PIP_CONFIG_FILE", os.devnull)
    monkeypatch.setenv("PIP_NO_INDEX", "1")
    monkeypatch.setenv("PIP_FIND_LINKS", str(folder))
    yield folder
    sys.modules.pop("incontext_probe", None)


def offered(monkeypatch, wanted):
    """The window for a package that is missing, as a command opens it, with its real command."""
    made = []

    def shown(window):
        made.append(window)
        window.show()
        pump(0.2)
        window.install_button.click()
        wait_until(lambda: not window.is_working, 120)
        pump(0.2)
        return window.result() == QtGui.QDialog.Accepted

    monkeypatch.setattr(asking, "shown", shown)
    monkeypatch.setattr(packages, "requirements_for", lambda name: (wanted,))
    error = ModuleNotFoundError("No module named 'incontext_probe'", name="incontext_probe")
    return installing.offer_to_install(error), made[0]


@pytest.fixture
def own_packages(tmp_path, monkeypatch):
    """An empty folder where FreeCAD looks for packages."""
    folder = tmp_path / "packages"
    monkeypatch.setattr(host, "packages_folder", lambda: str(folder))
    monkeypatch.setattr(sys, "path", [*sys.path])
    return folder


def test_real_pip_installs_and_it_can_be_imported_at_once(shop, own_packages, monkeypatch):
    installed, window = offered(monkeypatch, PROBE)
    assert installed, window.words
    assert (own_packages / "incontext_probe.py").is_file()
    assert importlib.import_module("incontext_probe").WORDS == "installed by pip"
    window.deleteLater()


def test_real_pip_says_what_it_cannot_find(shop, own_packages, monkeypatch):
    installed, window = offered(monkeypatch, "incontext-nowhere")
    assert not installed
    assert "incontext-nowhere" in window.words
    assert window.isVisible()
    assert not own_packages.exists() or not any(own_packages.iterdir())
    window.close()
    window.deleteLater()
