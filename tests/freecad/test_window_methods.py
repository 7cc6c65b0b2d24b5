"""Waiting for a slow method: how far it is, and Cancel."""

import time

import numpy as np
import pytest
from PySide import QtCore, QtGui

from incontext.solver import solve
from incontext.solver.serialise import sketch_to_text
from incontext.solver.synthetic import organizer, photograph
from incontext.tests.freecad.hands import pump, wait_until
from incontext.workbench import host
from incontext.workbench.features.lifted_model import make_lifted_model
from incontext.workbench.features.photo_sketch import make_photo_sketch
from incontext.workbench.panels.working import work


@pytest.fixture
def seen():
    """What the waiting window shows, twenty times a second; a word in `press` presses Cancel."""
    seen, press = [], []

    def look():
        for window in QtGui.QApplication.topLevelWidgets():
            if isinstance(window, QtGui.QProgressDialog) and window.isVisible():
                seen.append((window.labelText(), window.value()))
                if press and window.value() >= press[0]:
                    (button,) = window.findChildren(QtGui.QPushButton)
                    button.click()

    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(50)
    yield seen, press
    timer.stop()
    pump(0.1)


def counting(stop, progress):
    """Two seconds of work in twenty parts."""
    for k in range(20):
        if stop():
            return None
        progress(k / 20, "counting")
        time.sleep(0.1)
    return "counted"


def test_it_shows_how_far_it_is(seen):
    assert work("Counting ...", counting) == "counted"
    values = [value for _, value in seen[0]]
    assert {words for words, _ in seen[0]} == {"Counting ..."}
    assert values == sorted(values)
    assert values[0] < 600 <= values[-1] < 1000


def test_cancel_ends_it(seen):
    seen[1].append(500)
    assert work("Counting ...", counting) is None
    assert max(value for _, value in seen[0]) < 900


def test_what_is_done_at_once_shows_nothing(seen):
    assert work("Counting ...", lambda stop, progress: 7) == 7
    pump(0.3)
    assert seen[0] == []


def test_what_goes_wrong_goes_on():
    def job(stop, progress):
        raise ValueError("no such thing")

    with pytest.raises(ValueError, match="no such thing"):
        work("Counting ...", job)


def test_the_window_is_the_one_that_waits():
    assert host.work("Counting ...", lambda stop, progress: host._workers) == [work]


def test_a_slow_lift_can_be_stopped(document, seen):
    text = sketch_to_text(photograph(organizer(), np.random.default_rng(1)).graph)
    model = make_lifted_model(document, make_photo_sketch(document, text))
    document.recompute()
    area = model.Shape.Area
    seen[1].append(0)
    model.Method = "Lau 2010"
    document.recompute()
    assert "Lau 2010" in seen[0][0][0]
    assert model.Status == "stopped"
    assert model.Shape.Area == pytest.approx(area)
    model.Method = "Modified Lipson"
    document.recompute()
    assert model.Status == "converged"


@pytest.fixture
def button(document, window):
    """The panel's menu of methods, a slow sketch's model behind it."""
    from incontext.workbench.panels.annotation_dock import the_panel
    from incontext.workbench.panels.tabs import show_tab

    text = sketch_to_text(photograph(organizer(), np.random.default_rng(1)).graph)
    sketch = make_photo_sketch(document, text)
    document.recompute()
    show_tab(sketch)
    wait_until(lambda: the_panel().isVisible())
    button = the_panel()._method
    assert not button.isVisible()
    model = make_lifted_model(document, sketch)
    document.recompute()
    wait_until(button.isVisible)
    return button, model


def test_the_panel_names_the_method_and_takes_another_one(button, document, monkeypatch):
    from incontext.solver.reference import METHODS

    button, model = button
    assert button.text().startswith("Method: Modified Lipson")
    monkeypatch.setitem(METHODS, "lipson1996", lambda graph, **_: solve(graph))
    button._choices["Lipson 1996"].trigger()
    assert (str(model.Method), model.Status) == ("Lipson 1996", "converged")
    assert button.text().startswith("Method: Lipson 1996")
    assert document.UndoNames[0] == "Change method"
    document.undo()
    wait_until(lambda: button.text().startswith("Method: Modified Lipson"))


def test_a_method_that_is_stopped_is_not_taken(button, document, seen):
    button, model = button
    steps = list(document.UndoNames)
    seen[1].append(0)
    button._choices["Lau 2010"].trigger()
    assert "Lau 2010" in seen[0][0][0]
    assert (str(model.Method), model.Status) == ("Modified Lipson", "converged")
    assert button.text().startswith("Method: Modified Lipson")
    assert button._choices["Modified Lipson"].isChecked()
    assert not button._choices["Lau 2010"].isChecked()
    assert document.UndoNames == steps
