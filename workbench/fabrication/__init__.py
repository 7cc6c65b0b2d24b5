"""From a model to parts: plates for a laser cutter, shelled solids for a printer.

Nothing here knows Qt or FreeCAD. Names are loaded when they are first asked for, because the
libraries behind them are slow to start.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .errors import FabricationError
    from .joints import JointChoice
    from .plates import Plate, joined_plates, make_plates
    from .settings import PlateSettings, ShellSettings
    from .shell import shell_solid
    from .solids import assemble

_HOMES = {
    "FabricationError": "errors",
    "JointChoice": "joints",
    "Plate": "plates",
    "joined_plates": "plates",
    "PlateSettings": "settings",
    "ShellSettings": "settings",
    "assemble": "solids",
    "make_plates": "plates",
    "shell_solid": "shell",
}

__all__ = [
    "FabricationError",
    "JointChoice",
    "Plate",
    "PlateSettings",
    "ShellSettings",
    "assemble",
    "joined_plates",
    "make_plates",
    "shell_solid",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f".{_HOMES[name]}", __name__), name)
