"""Every command, as FreeCAD's window has it."""

from dataclasses import replace
from pathlib import Path

import FreeCAD
import FreeCADGui
import pytest

from incontext.tests.freecad.hands import pump
from incontext.workbench.canvas.qt import QtGui
from incontext.workbench.canvas.tools import TOOLS
from incontext.workbench.commands import COMMANDS
from incontext.workbench.commands.tools import TOOL_COMMANDS
from incontext.workbench.features.photo_sketch import is_photo_sketch


@pytest.fixture(autouse=True)
def workbench():
    FreeCADGui.activateWorkbench("InContextWorkbench")
    assert FreeCADGui.activeWorkbench().name() == "InContextWorkbench"


@pytest.mark.parametrize("command", [*COMMANDS, *TOOL_COMMANDS], ids=lambda command: command.NAME)
def test_command_is_registered_and_dressed(command):
    assert command.NAME.startswith("InContext_")
    assert command.NAME in FreeCADGui.listCommands()
    resources = command().GetResources()
    assert Path(resources["Pixmap"]).is_file()
    assert resources["MenuText"]
    assert resources["ToolTip"]


def test_shortcuts_differ():
    shortcuts = [command.SHORTCUT for command in COMMANDS if command.SHORTCUT]
    assert len(set(shortcuts)) == len(shortcuts)


def test_toolbar_and_menu_have_every_command():
    listed = set(FreeCADGui.activeWorkbench().getToolbarItems()["Modeling in Context"])
    assert {command.NAME for command in COMMANDS} <= listed
    listed = set(FreeCADGui.activeWorkbench().getToolbarItems()["Sketch tools"])
    assert {command.NAME for command in TOOL_COMMANDS} <= listed


def test_every_tool_has_its_command_and_its_key_in_the_tooltip():
    from incontext.workbench.panels.tool_buttons import command_name

    assert [command.TOOL for command in TOOL_COMMANDS] == list(TOOLS)
    for command in TOOL_COMMANDS:
        assert command_name(command.TOOL) == command.NAME
        assert TOOLS[command.TOOL].KEY == command.KEY
        assert f"key {command.KEY} " in command().GetResources()["ToolTip"]


def test_new_sketch_embeds_the_photo(document, shelf_path):
    from incontext.workbench.commands.new_sketch import new_sketch
    from incontext.workbench.features import pipeline

    obj = new_sketch(document, shelf_path.parent / "shelf.jpg")
    graph = pipeline.graph_of(obj.Sketch)
    assert (graph.photo.width_px, graph.photo.height_px) == (800, 600)
    assert Path(obj.Photo).is_file()
    document.undo()
    assert document.Objects == []


def test_from_a_sketch_file_to_files_to_cut(document, shelf_path, tmp_path, monkeypatch):
    from incontext.workbench.commands.import_sketch import imported
    from incontext.workbench.panels import export_dialog

    imported(document, shelf_path)
    FreeCADGui.runCommand("InContext_Lift")
    FreeCADGui.runCommand("InContext_MakePlates")
    assert [obj.Name for obj in document.Objects] == ["PhotoSketch", "LiftedModel", "PlateSet"]
    assert document.UndoNames == ["Make plates", "Lift to 3D", "Import sketch"]
    agree = lambda dialog: replace(dialog.choice, folder=tmp_path)  # noqa: E731
    monkeypatch.setattr(export_dialog, "ask_what_to_export", agree)
    FreeCADGui.runCommand("InContext_ExportPlates")
    assert (tmp_path / "Test.dxf").is_file()


def test_from_a_model_to_files_to_print(document, shelf_path, tmp_path, monkeypatch):
    from incontext.workbench.commands.import_sketch import imported
    from incontext.workbench.panels import export_dialog

    imported(document, shelf_path)
    FreeCADGui.runCommand("InContext_Lift")
    FreeCADGui.runCommand("InContext_MakeShell")
    agree = lambda dialog: replace(dialog.choice, folder=tmp_path)  # noqa: E731
    monkeypatch.setattr(export_dialog, "ask_what_to_export", agree)
    FreeCADGui.runCommand("InContext_ExportPrint")
    assert {path.name for path in tmp_path.iterdir()} == {"Test.stl", "Test.3mf", "Test.step"}


def test_photo_that_is_none_is_told(document, shelf_path, monkeypatch):
    from incontext.workbench.panels import asking, messages

    told = []
    monkeypatch.setattr(asking, "ask_for_file", lambda title, kinds: shelf_path)
    monkeypatch.setattr(messages, "tell", told.append)
    FreeCADGui.runCommand("InContext_NewSketch")
    assert "cannot read the photo" in told[0]
    assert document.Objects == []


def test_example_opens_side_by_side():
    from incontext.workbench.panels.open_tabs import open_tabs

    FreeCADGui.runCommand("InContext_OpenExample")
    pump(0.5)
    document = FreeCAD.ActiveDocument
    sketch, model, plates = document.Objects
    assert is_photo_sketch(sketch)
    assert (model.Status, plates.Status) == ("converged", "made")
    assert [tab.obj for tab in open_tabs()] == [sketch]
    FreeCAD.closeDocument(document.Name)
    pump()
    assert open_tabs() == ()


def test_every_example_has_its_place_in_the_menu():
    from incontext.workbench.commands.open_example import EXAMPLE_COMMANDS

    menus = FreeCADGui.getMainWindow().findChildren(QtGui.QMenu)
    shown = [[action.text() for action in menu.actions()] for menu in menus]
    assert [command.MENU_TEXT for command in EXAMPLE_COMMANDS] in shown


def test_printed_example_opens_from_the_menu():
    from incontext.workbench.panels.open_tabs import open_tabs

    FreeCADGui.runCommand("InContext_ExampleTeapotLid")
    pump(0.5)
    document = FreeCAD.ActiveDocument
    sketch, model, solid = document.Objects
    assert document.Label == "Teapot lid"
    assert (model.Status, solid.Status) == ("converged", "made")
    assert [tab.obj for tab in open_tabs()] == [sketch]
    FreeCAD.closeDocument(document.Name)
    pump()
    assert open_tabs() == ()
