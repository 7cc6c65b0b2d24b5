"""The Python packages that this addon needs: which are missing, and how they are installed.

They go into the folder of FreeCAD's own for such packages; the person's other Python is left
alone. What is needed stands in `pyproject.toml`, and nowhere else.
"""

from __future__ import annotations

import importlib
import importlib.util
import re
import shutil
import sys
import tomllib
from pathlib import Path
from typing import Any

from . import host

#: Packages whose import name is another one.
_IMPORT_NAMES = {"pillow": "PIL", "opencv-python-headless": "cv2"}
#: What is asked for only where it is used, as `pyproject.toml` calls these groups.
_OPTIONAL = ("marker",)


def missing_requirements() -> tuple[str, ...]:
    """What pip has to install, such as ``cadquery>=2.8``: the packages that are not there."""
    return tuple(wanted for wanted in _project()["dependencies"] if not _is_there(wanted))


def requirements_for(import_name: str) -> tuple[str, ...]:
    """What pip has to install so that something can be imported: all that is missing, or what is
    needed for this alone.
    """
    groups = _project()["optional-dependencies"]
    for wanted in (w for group in _OPTIONAL for w in groups[group]):
        if _import_name(wanted) == import_name:
            return (wanted,)
    return missing_requirements() or (import_name,)


def _project() -> dict[str, Any]:
    text = (host.ROOT / "pyproject.toml").read_text(encoding="utf-8")
    project: dict[str, Any] = tomllib.loads(text)["project"]
    return project


def package_name(requirement: str) -> str:
    """The name alone: ``cadquery`` of ``cadquery>=2.8``."""
    match = re.match(r"[\w.-]+", requirement)
    return match[0] if match else requirement


def _import_name(requirement: str) -> str:
    name = package_name(requirement)
    return _IMPORT_NAMES.get(name, name)


def _is_there(requirement: str) -> bool:
    return importlib.util.find_spec(_import_name(requirement)) is not None


def require(import_names: tuple[str, ...]) -> None:
    """Raise ModuleNotFoundError for the first package that is not there."""
    for name in import_names:
        if importlib.util.find_spec(name) is None:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)


def install_command(requirements: tuple[str, ...]) -> list[str]:
    """The program and its arguments that install packages where FreeCAD looks for them."""
    options = ["--disable-pip-version-check", "--no-input", "--target", host.packages_folder()]
    return [python_program(), "-m", "pip", "install", *options, *requirements]


def command_to_type(requirements: tuple[str, ...]) -> str:
    """The same for a person to copy."""
    words = [host.python_command(), "-m", "pip", "install", "--target", host.packages_folder()]
    return " ".join(
        f'"{w}"' if re.search(r"[^\w./:=\\-]", w) else w for w in (*words, *requirements)
    )


def python_program() -> str:
    """A Python of FreeCAD's own version; inside FreeCAD `sys.executable` is FreeCAD itself."""
    name = host.python_command()
    beside = [
        Path(sys.prefix, *parts)
        for parts in (("bin", name), ("python.exe",), ("bin", "python.exe"))
    ]
    found = next((str(path) for path in beside if path.is_file()), None)
    return found or shutil.which(name) or name


def look_again() -> None:
    """Find what was just installed, without starting FreeCAD again."""
    folder = host.packages_folder()
    if folder not in sys.path:
        sys.path.append(folder)
    importlib.invalidate_caches()
