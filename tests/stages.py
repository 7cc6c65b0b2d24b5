"""Runs every check in stages, names each, and fails if one fails or finds nothing to run.

python tests/stages.py            all stages
python tests/stages.py lint types some of them
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path

from incontext.workbench.launch import Launch, LaunchError, run

ROOT = Path(__file__).resolve().parent.parent
#: Another addon with folders named like ours, always there when we run inside FreeCAD.
DECOY = ROOT / "tests" / "freecad" / "decoy_addon"
#: pytest's status for "no tests were collected" is 5, so an empty stage fails as well.
PYTEST = ["-p", "no:cacheprovider", "--quiet"]
#: FreeCAD's own import hooks are older than Python's present way.
FREECADS_OWN = ["-W", "ignore::ImportWarning"]
INSIDE = ["tests/freecad", "tests/canvas"]


def lint() -> int:
    """Style and layout of the source."""
    return _python("ruff", "check", ".") or _python("ruff", "format", "--check", ".")


def types() -> int:
    """Types of the solver and of fabrication."""
    # mypy does not see through an editable install's import hook: show it a folder by our name.
    path = ROOT / "build" / "types"
    path.mkdir(parents=True, exist_ok=True)
    (path / "incontext").unlink(missing_ok=True)
    (path / "incontext").symlink_to(ROOT, target_is_directory=True)
    return _python("mypy", environment={"MYPYPATH": str(path)})


def python() -> int:
    """Tests in plain Python."""
    return _python("pytest", "--quiet")


def console() -> int:
    """Tests inside FreeCAD's console."""
    return _inside(window=False)


def window() -> int:
    """Tests inside FreeCAD's window, on a screen of its own."""
    return _inside(window=True)


STAGES: dict[str, Callable[[], int]] = {
    stage.__name__: stage for stage in (lint, types, python, console, window)
}


def _python(module: str, *arguments: str, environment: Mapping[str, str] | None = None) -> int:
    command = [sys.executable, "-m", module, *arguments]
    return subprocess.run(
        command, cwd=ROOT, env={**os.environ, **(environment or {})}, check=False
    ).returncode


def _inside(*, window: bool) -> int:
    folders = [str(ROOT / folder) for folder in INSIDE]
    with tempfile.TemporaryDirectory(prefix="incontext-freecad-") as home:
        launch = Launch(
            call="pytest:main",
            home=Path(home),
            arguments=[*PYTEST, *FREECADS_OWN, "--rootdir", str(ROOT), *folders],
            window=window,
            own_screen=window,
            addons=(DECOY,),
        )
        try:
            return run(launch)
        except LaunchError as error:
            print(error)
            return 1


def main(names: list[str]) -> int:
    """Run the named stages, or all, each whatever became of the others."""
    unknown = [name for name in names if name not in STAGES]
    if unknown:
        print(f"no such stage: {', '.join(unknown)}; there are: {', '.join(STAGES)}")
        return 2
    failed = []
    for name in names or STAGES:
        print(f"== {name}: {STAGES[name].__doc__}", flush=True)
        if STAGES[name]() != 0:
            failed.append(name)
    print(f"== failed: {', '.join(failed)}" if failed else "== all stages passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
