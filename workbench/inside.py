"""What FreeCAD runs when `launch` starts it: calls one function and hands back its exit status.

FreeCAD loads this file as a plain module or, should that raise, as a script once more; hence
nothing here lets an exception out.
"""

import importlib
import json
import os
import sys
import traceback

#: FreeCAD 1.1 is still building its window when it runs this; closing tabs then crashed it.
SETTLING_MS = 2500


def _start() -> None:
    # Before dist-packages: Debian's pyparsing is too old for cadquery. FreeCAD's window erases
    # PYTHONPATH, so the folder comes by another name.
    sys.path.insert(0, os.environ["INCONTEXT_PACKAGES"])
    import FreeCAD

    if not FreeCAD.GuiUp:
        _call()
        return
    from PySide import QtCore

    slow = tuple(int(part) for part in FreeCAD.Version()[:2]) >= (1, 1)
    QtCore.QTimer.singleShot(SETTLING_MS if slow else 0, _call)


def _call() -> None:
    terminal = int(os.environ["INCONTEXT_TERMINAL"])
    freecad_streams = sys.stdout, sys.stderr
    # FreeCAD's window takes Python's own streams for its report view.
    sys.stdout = sys.stderr = os.fdopen(terminal, "w", buffering=1, encoding="utf-8")
    module, function = os.environ["INCONTEXT_CALL"].split(":")
    try:
        arguments = json.loads(os.environ["INCONTEXT_ARGUMENTS"])
        status = getattr(importlib.import_module(module), function)(arguments)
    except BaseException:
        traceback.print_exc()
        status = 1
    with open(os.environ["INCONTEXT_RESULT"], "w", encoding="ascii") as file:
        file.write(str(int(status or 0)))
    if status is not None:
        sys.stdout.flush()
        os._exit(int(status))
    sys.stdout, sys.stderr = freecad_streams


_start()
