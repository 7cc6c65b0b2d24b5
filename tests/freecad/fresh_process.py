"""What a second FreeCAD does for a test: started by `launch`, answers in a JSON file."""

import json
import sys
from pathlib import Path


def loaded_modules(arguments: list[str]) -> int:
    """Write the names of the modules that are loaded after the start."""
    names = sorted(sys.modules)
    Path(arguments[0]).write_text(json.dumps(names), encoding="utf-8")
    return 0


def reopen(arguments: list[str]) -> int:
    """Open a document; write proxies and volumes, before and after recomputing everything."""
    import FreeCAD

    answer, path = arguments
    document = FreeCAD.openDocument(path)
    found = {"proxies": [type(obj.Proxy).__name__ for obj in document.Objects]}
    found["modules"] = [type(obj.Proxy).__module__ for obj in document.Objects]
    found["stored"] = _measure(document)
    for obj in document.Objects:
        obj.touch()
    document.recompute()
    found["recomputed"] = _measure(document)
    document.getObject("PlateSet").Thickness = 5
    document.recompute()
    found["thicker"] = _measure(document)
    Path(answer).write_text(json.dumps(found), encoding="utf-8")
    return 0


def _measure(document) -> dict[str, float]:
    plates, model = document.getObject("PlateSet"), document.getObject("LiftedModel")
    photo = Path(document.getObject("PhotoSketch").Photo)
    return {
        "volume": plates.Shape.Volume,
        "solids": len(plates.Shape.Solids),
        "area": model.Shape.Area,
        "photo_bytes": photo.stat().st_size,
    }


def draw_and_be_killed(arguments: list[str]) -> int:
    """Draw over a photo with the mouse, write what the document has, and end without a word."""
    import os
    import signal

    import FreeCAD
    import FreeCADGui
    from PySide import QtCore

    from incontext.solver.graph import Photo, SketchGraph
    from incontext.solver.serialise import sketch_to_text
    from incontext.tests.freecad.hands import Hands, pump
    from incontext.workbench.features.photo_sketch import make_photo_sketch
    from incontext.workbench.panels.tabs import show_tab

    answer, photo = arguments
    FreeCADGui.getMainWindow().showMaximized()
    pump(1)
    document = FreeCAD.newDocument("Killed")
    text = sketch_to_text(SketchGraph(photo=Photo("shelf.jpg", 800, 600)))
    sketch = make_photo_sketch(document, text, photo)
    document.UndoMode = 1
    view = show_tab(sketch).tab.view
    pump(1)
    hands, photo_size = Hands(), Path(sketch.Photo).stat().st_size
    for key, (start, end) in (("r", ((200, 150), (400, 300))), ("l", ((500, 100), (700, 400)))):
        hands.press(key)
        on_screen = [view.mapFromScene(QtCore.QPointF(*place)) for place in (start, end)]
        hands.drag(*map(view.viewport().mapToGlobal, on_screen))
    found = {"sketch": sketch.Sketch, "photo_bytes": photo_size, "undo": list(document.UndoNames)}
    Path(answer).write_text(json.dumps(found), encoding="utf-8")
    os.kill(os.getpid(), signal.SIGKILL)
    return 1


def recover(arguments: list[str]) -> int:
    """Press the buttons of FreeCAD's own window for recovery; write what is there then."""
    import FreeCAD
    from PySide import QtGui

    from incontext.tests.freecad.hands import pump, wait_until

    def dialogs():
        shown = [w for w in QtGui.QApplication.topLevelWidgets() if w.isVisible()]
        return [w for w in shown if w.metaObject().className().endswith("DocumentRecovery")]

    wait_until(dialogs)
    (dialog,) = dialogs()
    (box,) = dialog.findChildren(QtGui.QDialogButtonBox)
    button = box.button(QtGui.QDialogButtonBox.Ok)
    for _ in ("Start recovery", "Finish"):
        button.click()
        pump(0.5)
    (document,) = FreeCAD.listDocuments().values()
    (sketch,) = document.Objects
    found = {"sketch": sketch.Sketch, "photo_bytes": Path(sketch.Photo).stat().st_size}
    found |= {"proxy": type(sketch.Proxy).__name__, "label": document.Label}
    Path(arguments[0]).write_text(json.dumps(found), encoding="utf-8")
    return 0
