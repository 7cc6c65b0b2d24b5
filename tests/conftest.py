"""For all tests: steady examples, and Qt loaded before warnings are errors."""

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
    # PySide2 on Python 3.13 warns while it loads, and crashes where that raises.
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        importlib.import_module("PySide.QtCore")
        importlib.import_module("PySide.QtGui")
