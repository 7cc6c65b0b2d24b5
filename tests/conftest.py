"""For all tests: steady examples, and FreeCAD's own modules loaded before warnings are errors."""

from __future__ import annotations

import importlib
import importlib.util
import warnings

from hypothesis import HealthCheck, settings

# The same examples everywhere, however slow the machine is.
settings.register_profile(
    "steady", deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("steady")

if importlib.util.find_spec("FreeCAD") is not None:
    # PySide2 and pivy on Python 3.13 warn while they load, and crash where that raises.
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for name in ("PySide.QtCore", "PySide.QtGui", "pivy.coin"):
            importlib.import_module(name)
