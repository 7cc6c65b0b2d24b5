"""Widgets are tested inside FreeCAD's window, pure geometry everywhere."""

from __future__ import annotations

import importlib.util

WIDGETS = ["test_ghosts.py", "test_overlay.py", "test_photo.py", "test_view.py"]

collect_ignore: list[str] = []
if importlib.util.find_spec("FreeCAD") is None:
    collect_ignore = WIDGETS
else:
    import FreeCAD

    if not FreeCAD.GuiUp:
        collect_ignore = WIDGETS
