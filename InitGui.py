"""The workbench as FreeCAD's window knows it.

FreeCAD runs this text inside a function: names at this level are not visible in methods, so
they import what they need. Nothing here loads more than a few small modules.
"""

import FreeCADGui


class InContextWorkbench(FreeCADGui.Workbench):
    """Modeling in Context: from one photo to a new object that fits in."""

    def __init__(self):
        from incontext.workbench import host
        from incontext.workbench.panels.working import work

        host.load_translations()
        # A document is recomputed whatever the workbench at work.
        host.set_worker(work)
        cls = self.__class__
        cls.MenuText = "Modeling in Context"
        cls.ToolTip = host.translate(
            "InContext", "Draw a new object over one photo, get a 3D shape and plates to cut"
        )
        cls.Icon = host.icon("InContextWorkbench")

    def Initialize(self):  # noqa: N802  FreeCAD's name
        """Make the commands, the toolbar and the menu."""
        import FreeCADGui

        from incontext.workbench import host
        from incontext.workbench.commands import register_commands
        from incontext.workbench.commands.languages import follow_language
        from incontext.workbench.commands.open_example import register_examples
        from incontext.workbench.commands.tools import register_tools
        from incontext.workbench.panels.preset_page import PresetPage
        from incontext.workbench.panels.values_page import ValuesPage

        names, tools = register_commands(), register_tools()
        # FreeCAD translates these itself, whenever the language changes.
        ours, examples, sketching = "Modeling in &Context", "E&xamples", "Sketch &tools"
        self.appendToolbar("Modeling in Context", names)
        self.appendToolbar("Sketch tools", tools)
        self.appendMenu(ours, names)
        self.appendMenu([ours, sketching], tools)
        self.appendMenu([ours, examples], register_examples())
        FreeCADGui.addIconPath(host.resource("icons"))
        FreeCADGui.addPreferencePage(ValuesPage, "Modeling in Context")
        FreeCADGui.addPreferencePage(PresetPage, "Modeling in Context")
        follow_language()

    def Activated(self):  # noqa: N802
        """Nothing to do; FreeCAD asks for it."""

    def Deactivated(self):  # noqa: N802
        """Nothing to do; FreeCAD asks for it."""

    def GetClassName(self):  # noqa: N802
        """Tell FreeCAD that this workbench is written in Python."""
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(InContextWorkbench())
