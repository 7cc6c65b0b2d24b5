"""These tests run inside FreeCAD; `python tests/stages.py console window` starts them there."""

from __future__ import annotations

import importlib.util
import subprocess
from pathlib import Path

import pytest

collect_ignore = ["decoy_addon", "decoy_again"]
if importlib.util.find_spec("FreeCAD") is None:
    collect_ignore_glob = ["test_*.py"]
else:
    import FreeCAD

    if not FreeCAD.GuiUp:
        collect_ignore_glob = ["test_window_*.py"]

DATA = Path(__file__).parent.parent / "data"


@pytest.fixture
def shelf_path():
    """A sketch of a shelf with a board and an open front, over a photo of 800 x 600 px."""
    return DATA / "shelf.sketch.json"


@pytest.fixture
def document():
    """An empty document with undo, closed afterwards."""
    import FreeCAD

    document = FreeCAD.newDocument("Test")
    document.UndoMode = 1
    yield document
    FreeCAD.closeDocument(document.Name)


@pytest.fixture
def shelf(document, shelf_path):
    """Photo sketch, lifted model and plate set of the shelf."""
    from incontext.workbench.features.examples import import_sketch
    from incontext.workbench.features.lifted_model import make_lifted_model
    from incontext.workbench.features.plate_set import make_plate_set

    sketch = import_sketch(document, shelf_path)
    model = make_lifted_model(document, sketch)
    plates = make_plate_set(document, model)
    document.recompute()
    return sketch, model, plates


@pytest.fixture(scope="session")
def hands():
    """A person's hands: real mouse and keys, through the X server."""
    from incontext.tests.freecad.hands import Hands

    manager = subprocess.Popen(["openbox"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    yield Hands()
    manager.terminate()
    manager.wait()


@pytest.fixture
def window(hands):
    """FreeCAD's window over the whole screen, as at its start, with our workbench."""
    import FreeCADGui
    from PySide import QtGui

    from incontext.tests.freecad.hands import pump

    window = FreeCADGui.getMainWindow()
    if not window.isMaximized():
        window.showMaximized()
        pump(1)
    FreeCADGui.activateWorkbench("InContextWorkbench")
    # An error opens it, and then it takes a third of the room from all tests to come.
    report = window.findChild(QtGui.QDockWidget, "Report view")
    if report is not None:
        report.hide()
    return window


@pytest.fixture
def photo_path(shelf_path):
    """The photo that a person chooses."""
    return shelf_path.parent / "shelf.jpg"


@pytest.fixture
def person(window, hands, document, photo_path, monkeypatch):
    """A person before the tab of a new sketch over a photo."""
    from incontext.tests.freecad.hands import Person, pump, wait_until
    from incontext.workbench.panels import asking
    from incontext.workbench.panels.open_tabs import open_tabs

    monkeypatch.setattr(asking, "ask_for_file", lambda title, kinds: photo_path)
    person = Person(hands)
    person.push("InContext_NewSketch")
    # The file's name, clicked twice.
    person.gestures += 1
    wait_until(open_tabs)
    pump(0.5)
    person.view = open_tabs()[0].tab.view
    return person
